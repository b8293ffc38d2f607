class_name MvnBody
extends RefCounted
## A wearer's size, from MVN's scale data (type 13), or from the positions of a pose's segments.

## Height of the hips above the ground when standing, m.
var hip_height: float = 0.95
## Lengths of the limbs of [Limbs], m; 0 where they are not known.
var lengths: PackedFloat32Array = PackedFloat32Array()
## Whether it comes from scale data.
var is_measured: bool = false


func _init() -> void:
	lengths.resize(Limbs.COUNT)


## Takes scale data. Returns false if they describe no body.
func take_scale(p_scale: Dictionary) -> bool:
	var names: PackedStringArray = p_scale["names"]
	var known: PackedStringArray = MvnEncoder.get_segment_names()
	var origins: PackedVector3Array = p_scale["origins"]
	var positions: PackedVector3Array = []
	positions.resize(MvnSegments.COUNT)
	for segment: int in MvnSegments.COUNT:
		var at: int = _find(names, known[segment])
		if at < 0:
			at = segment
		if at >= origins.size():
			return false
		positions[segment] = SourceFrames.position(origins[at])
	if not _take_positions(positions):
		return false
	var lowest: float = positions[0].y
	for position: Vector3 in positions:
		lowest = minf(lowest, position.y)
	var segments: PackedInt32Array = p_scale["point_segments"]
	for at: int in segments.size():
		if segments[at] >= 1 and segments[at] <= MvnSegments.COUNT:
			var point: Vector3 = SourceFrames.position(p_scale["point_positions"][at])
			lowest = minf(lowest, positions[segments[at] - 1].y + point.y)
	# The null pose stands on the ground, at 0; without it the lowest point is used.
	var height: float = positions[0].y if positions[0].y > 0.3 else positions[0].y - lowest
	if height > 0.3 and height < 1.8:
		hip_height = height
		is_measured = true
	return is_measured


## Takes where the limbs of a pose are ([member MotionDetails.positions]), as long as there are no
## scale data.
func take_pose(p_positions: PackedVector3Array) -> void:
	if is_measured or p_positions.size() != Limbs.COUNT:
		return
	var segments: PackedVector3Array = []
	segments.resize(MvnSegments.COUNT)
	segments.fill(Vector3(NAN, NAN, NAN))
	for limb: int in Limbs.COUNT:
		segments[MvnSegments.OF_LIMBS[limb]] = p_positions[limb]
	_take_positions(segments)
	# The ankle is about 0.08 of the leg above the sole, the hips' middle at the hip joints.
	var leg: float = (lengths[10] + lengths[11] + lengths[13] + lengths[14]) / 2.0
	if leg > 0.3 and leg < 1.6:
		hip_height = leg * 1.08


func _take_positions(p_positions: PackedVector3Array) -> bool:
	for limb: int in Limbs.COUNT:
		var segment: int = MvnSegments.OF_LIMBS[limb]
		var tail: int = _tail(segment)
		if tail < 0:
			continue
		var length: float = p_positions[segment].distance_to(p_positions[tail])
		if length >= 1.0:
			return false
		# Where the tail is not known, its length is not a number.
		lengths[limb] = length if length > 0.0 else 0.0
	return true


## The segment at which another ends, or -1.
static func _tail(p_segment: int) -> int:
	match p_segment:
		0:
			return 2
		2:
			return 4
		4:
			return 5
		8, 9, 12, 13, 15, 16, 17, 19, 20, 21:
			return p_segment + 1
	return -1


## MVN writes "Right Upper Arm" as well as "RightUpperArm".
static func _find(p_names: PackedStringArray, p_name: String) -> int:
	for at: int in p_names.size():
		if p_names[at].replace(" ", "").to_lower() == p_name.to_lower():
			return at
	return -1
