class_name BvhTravel
extends RefCounted
## Finds files whose person is right but whose travel is mirrored, and mirrors the travel back.
##
## Programs that change axes can change rotations and forget positions, or the other way round. The
## person then walks backwards or sideways while the feet slide. The foot that stands tells: of all
## ways to mirror the travel along the level axes the true one makes it slide the least.

## Seconds between two poses that are compared, and maximum of places in the clip where that is
## done.
const STEP_S: float = 1.0 / 30.0
const MAX_PLACES: int = 200
## Least way, m, and least speed, m/s, that tell.
const MIN_WAY: float = 1.5
const MIN_SPEED: float = 0.3
## How much less feet must slide, as a share of what they do. Of 150 clips that travel none slides
## less than 0.99 as much mirrored, and clips with mirrored travel 0.3 to 0.6 as much.
const LESS: float = 0.75


## Mirrors the travel of a clip back if it is mirrored, and says so in its notes. Its unit and its
## up axis must be known.
static func settle(p_clip: BvhClip, p_map: HumanoidMap) -> void:
	var step: int = maxi(roundi(STEP_S / p_clip.frame_time), 1)
	var places: int = mini(MAX_PLACES, p_clip.frame_count - step)
	if places < 2:
		return
	var kinematics: BvhKinematics = BvhKinematics.new(p_clip.joints, p_clip.positions_add_offset)
	var slides: PackedFloat32Array = [0.0, 0.0, 0.0, 0.0]
	var way: float = 0.0
	for place: int in places:
		var first: int = place * (p_clip.frame_count - step - 1) / (places - 1)
		var before: PackedVector3Array = _hips_and_feet(p_clip, p_map, kinematics, first)
		var after: PackedVector3Array = _hips_and_feet(p_clip, p_map, kinematics, first + step)
		var foot: int = 1 if before[1].y + after[1].y < before[2].y + after[2].y else 2
		var hips: Vector3 = (after[0] - before[0]) * Vector3(1.0, 0.0, 1.0)
		var swing: Vector3 = (after[foot] - before[foot]) * Vector3(1.0, 0.0, 1.0) - hips
		way += hips.length()
		for signs: int in slides.size():
			slides[signs] += (hips * _mirror(signs) + swing).length()
	var whole: float = way * p_clip.frame_count / (places * step)
	if whole < MIN_WAY or way < MIN_SPEED * places * step * p_clip.frame_time:
		return
	var best: int = slides.find(Array(slides).min())
	if slides[best] < LESS * slides[0]:
		_turn_back(p_clip, p_map, _mirror(best))


## One of the four ways to mirror what is level.
static func _mirror(p_signs: int) -> Vector3:
	return Vector3(-1.0 if p_signs & 1 else 1.0, 1.0, -1.0 if p_signs & 2 else 1.0)


static func _hips_and_feet(
	p_clip: BvhClip, p_map: HumanoidMap, p_kinematics: BvhKinematics, p_frame: int
) -> PackedVector3Array:
	p_kinematics.solve(p_clip.values, p_frame * p_clip.channel_count)
	var positions: PackedVector3Array = p_kinematics.positions()
	var found: PackedVector3Array = []
	for limb: int in [Limbs.HIPS, Limbs.LEFT_FOOT, Limbs.RIGHT_FOOT]:
		found.append(p_clip.to_godot(positions[p_map.bases[limb]]))
	return found


static func _turn_back(p_clip: BvhClip, p_map: HumanoidMap, p_mirror: Vector3) -> void:
	var values: PackedFloat64Array = p_clip.values
	var joint: int = p_map.joints[Limbs.HIPS]
	while joint >= 0:
		for position: int in p_clip.joints[joint].channels.size():
			var channel: int = p_clip.joints[joint].channels[position]
			if not BvhJoint.is_position(channel):
				continue
			var along: Vector3 = p_clip.to_godot(BvhKinematics.AXES[channel])
			if p_mirror[along.abs().max_axis_index()] > 0.0:
				continue
			var column: int = p_clip.joints[joint].first_channel + position
			for frame: int in p_clip.frame_count:
				values[frame * p_clip.channel_count + column] *= -1.0
		joint = p_clip.joints[joint].parent
	p_clip.set_data(p_clip.joints, values, p_clip.frame_time)
	p_clip.notes.append(
		(
			"%s: feet slide, as the positions in the file are mirrored; the way was mirrored back"
			% p_clip.source_name
		)
	)
