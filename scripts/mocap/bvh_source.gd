class_name BvhSource
extends MotionSource
## Plays a BVH file in a loop, as if somebody in a suit made the motion now.

## Seconds over which the end of the clip passes into its beginning.
const BLEND_S: float = 0.5

## The clip that is played.
var rig: BvhRig = null

var _begin_usec: int = -1
var _floor: float = 0.0


## Opens a file. The unit is one of [constant BvhOptions.UNITS] or metres per unit, the axis "y" or
## "z"; empty texts leave both to be guessed. [member error] tells what is wrong.
func open(p_path: String, p_unit: String = "", p_up: String = "") -> void:
	var options: BvhOptions = BvhOptions.new()
	if p_unit != "":
		options.unit_metres = BvhOptions.parse_unit(p_unit)
		if options.unit_metres <= 0.0:
			error = "a unit is m, cm, mm, inch, cmu or metres, found '%s'" % p_unit
			return
	if p_up != "":
		var axes: Dictionary[String, BvhOptions.UpAxis] = {
			"y": BvhOptions.UpAxis.Y, "z": BvhOptions.UpAxis.Z
		}
		if not axes.has(p_up.to_lower()):
			error = "an up axis is y or z, found '%s'" % p_up
			return
		options.up_axis = axes[p_up.to_lower()]
	var result: BvhResult = BvhParser.parse_file(p_path, options)
	error = result.error
	if error == "":
		use(result.clip)


## Plays a clip that is already there.
func use(p_clip: BvhClip) -> void:
	rig = BvhRig.from_clip(p_clip)
	error = rig.error
	if error == "":
		p_clip.prepare()
		_floor = _find_floor()


func get_hip_height() -> float:
	return rig.hip_height


func describe() -> String:
	var parts: Array = [rig.clip.source_name, rig.clip.duration(), 1.0 / rig.clip.frame_time]
	return "%s, %.1f s at %.0f Hz" % parts


func _read(p_time_usec: int) -> PoseSample:
	if _begin_usec < 0:
		_begin_usec = p_time_usec
	return pose_at((p_time_usec - _begin_usec) / 1e6)


## The pose after so many seconds of playing.
func pose_at(p_time_s: float) -> PoseSample:
	var length: float = maxf(rig.clip.duration(), 0.001)
	var period: float = maxf(length - BLEND_S, length * 0.5)
	var time: float = fposmod(p_time_s, period)
	# The last moments of a round pass into the first ones of the next.
	var late: float = time + period
	var blend: float = 0.0
	if p_time_s >= period and late < length:
		blend = 1.0 - time / (length - period)
	var pose: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		var rotation: Quaternion = rig.limb_rotation(limb, time)
		if blend > 0.0:
			rotation = rotation.slerp(rig.limb_rotation(limb, late), blend)
		pose.set_orientation(limb, rotation)
	pose.root = rig.hips_position(time)
	if blend > 0.0:
		pose.root = pose.root.lerp(rig.hips_position(late), blend)
	pose.root.y -= _floor
	return pose


## Height of the ground that the clip was made on: standing feet are there most of the time.
func _find_floor() -> float:
	var heights: PackedFloat32Array = []
	for frame: int in range(0, rig.clip.frame_count, maxi(rig.clip.frame_count / 200, 1)):
		var lowest: float = INF
		for place: Vector3 in rig.clip.sample_global(frame).positions:
			lowest = minf(lowest, place.y)
		heights.append(lowest)
	heights.sort()
	return heights[heights.size() / 10]
