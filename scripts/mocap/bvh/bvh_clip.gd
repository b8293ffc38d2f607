class_name BvhClip
extends RefCounted
## A skeleton and its motion, as a BVH file holds them, and its conversion to Godot's frame.
##
## [member joints] and [member values] are the file's own: its axes, its units, degrees. All methods
## answer in Godot's frame: right-handed, Y up, metres, orientations from the rest pose as
## quaternions. A file with Z up is turned by -90 degrees about X, so its (x, y, z) becomes (x, z,
## -y); [SourceFrames] has the other axes. Which way the person faces is left as it is; most files
## face +Z.
##
## The first question for an orientation computes those of all frames, about 20 us a frame; ask
## [method prepare] to do it earlier or in another thread. After it, any thread may read.


## Where all joints of a clip are at one time, in Godot's frame.
class Pose:
	## Rotation of each joint in the world from the rest pose, in which all are the identity. An end
	## site has its parent's.
	var orientations: Array[Quaternion] = []
	## Position of each joint in the world, m.
	var positions: PackedVector3Array = PackedVector3Array()


## Name of the file.
var source_name: String = ""
## The joints and end sites, each after its parent; the root is the first.
var joints: Array[BvhJoint] = []
## Time from one frame to the next, s.
var frame_time: float = 1.0 / 60.0
## Number of frames; may be 0, then there is only the rest pose.
var frame_count: int = 0
## Numbers in each frame.
var channel_count: int = 0
## The frames, one after the other, each [member channel_count] numbers: positions in file units,
## rotations in degrees. Change it only by [method set_data].
var values: PackedFloat64Array = PackedFloat64Array()
## Length of the file's unit, m.
var unit_metres: float = 0.01
## Why [member unit_metres] is what it is: "guess: ..." or "as given".
var unit_reason: String = ""
## The file's axis that points up, never [constant BvhOptions.GUESS].
var up_axis: BvhOptions.UpAxis = BvhOptions.UpAxis.Y:
	set(p_axis):
		up_axis = p_axis
		_orientations.clear()
## Why [member up_axis] is what it is: "guess: ..." or "as given".
var up_reason: String = ""
## Oddities of the file that could be corrected, one sentence each, with file and line.
var notes: PackedStringArray = PackedStringArray()
## See [member BvhOptions.positions_add_offset]. Set it before [method set_data].
var positions_add_offset: bool = false

var _kinematics: BvhKinematics = null
var _parents: PackedInt32Array = PackedInt32Array()
## Orientations in Godot's frame of all joints of all frames; the signs of one joint's quaternions
## are chosen so that they never jump.
var _orientations: PackedVector4Array = PackedVector4Array()


## Sets the skeleton and its rows of numbers. Renumbers the channels.
func set_data(p_joints: Array[BvhJoint], p_values: PackedFloat64Array, p_frame_time: float) -> void:
	joints = p_joints
	values = p_values
	frame_time = p_frame_time
	channel_count = 0
	_parents.clear()
	for joint: BvhJoint in joints:
		_parents.append(joint.parent)
		joint.first_channel = channel_count
		channel_count += joint.channels.size()
	frame_count = 0 if channel_count == 0 else values.size() / channel_count
	_kinematics = BvhKinematics.new(joints, positions_add_offset)
	_orientations.clear()


## Time of the last frame, s; the first is at 0.
func duration() -> float:
	return maxi(frame_count - 1, 0) * frame_time


## Number of joints without end sites.
func joint_count() -> int:
	return joints.size() - end_site_count()


## Number of end sites.
func end_site_count() -> int:
	var count: int = 0
	for joint: BvhJoint in joints:
		count += 1 if joint.is_end_site else 0
	return count


## Index of the first joint of that name, not an end site; -1 if there is none.
func find_joint(p_name: String) -> int:
	for index: int in joints.size():
		if not joints[index].is_end_site and joints[index].name == p_name:
			return index
	return -1


## One number of the file: position in file units, rotation in degrees.
func value(p_frame: int, p_joint: int, p_channel_position: int) -> float:
	return values[p_frame * channel_count + joints[p_joint].first_channel + p_channel_position]


## Where a joint hangs on its parent in the rest pose, m.
func rest_offset(p_joint: int) -> Vector3:
	return to_godot(joints[p_joint].offset)


## Where the joints are in the rest pose, m, the root being at its OFFSET.
func rest_positions() -> PackedVector3Array:
	var positions: PackedVector3Array = PackedVector3Array()
	for joint: BvhJoint in joints:
		var base: Vector3 = Vector3.ZERO if joint.parent < 0 else positions[joint.parent]
		positions.append(base + to_godot(joint.offset))
	return positions


## Where the root is, m.
func root_position(p_frame: int) -> Vector3:
	return to_godot(_offsets(_clamped(p_frame))[0])


## Rotation of a joint in the world from the rest pose.
func global_orientation(p_frame: int, p_joint: int) -> Quaternion:
	prepare()
	return _orientation(_clamped(p_frame) * joints.size() + p_joint)


## All joints in one frame; before the first and after the last frame these two stay. Fills
## [param p_into] if given, to save memory being allocated.
func sample_global(p_frame: int, p_into: Pose = null) -> Pose:
	return _sample(_clamped(p_frame), _clamped(p_frame), 0.0, p_into)


## All joints at a time in s, between two frames; before the start and after the end the first and
## last frame stay. Fills [param p_into] if given, to save memory being allocated.
func sample_at(p_time: float, p_into: Pose = null) -> Pose:
	var last: float = maxi(frame_count - 1, 0)
	var at: float = clampf(p_time / frame_time, 0.0, last)
	var first: int = int(at)
	return _sample(first, _clamped(first + 1), at - first, p_into)


## Computes the orientations of all frames, unless that was done.
func prepare() -> void:
	var count: int = joints.size()
	if _orientations.size() == frame_count * count:
		return
	var found: PackedVector4Array = PackedVector4Array()
	found.resize(frame_count * count)
	var frame_of_file: SourceFrames.Frame = BvhOptions.FRAMES[up_axis]
	for frame: int in frame_count:
		_kinematics.solve(values, frame * channel_count)
		var rotations: Array[Quaternion] = _kinematics.rotations
		var at: int = frame * count
		for joint: int in count:
			var rotation: Quaternion = rotations[joint]
			if frame_of_file != SourceFrames.Frame.GODOT:
				rotation = SourceFrames.rotation(
					rotation.w, rotation.x, rotation.y, rotation.z, frame_of_file
				)
			var entry: Vector4 = Vector4(rotation.x, rotation.y, rotation.z, rotation.w)
			if frame > 0 and entry.dot(found[at + joint - count]) < 0.0:
				entry = -entry
			found[at + joint] = entry
	_orientations = found


## Turns a position or direction of the file into Godot's frame and m.
func to_godot(p_position: Vector3) -> Vector3:
	return SourceFrames.vector(p_position, BvhOptions.FRAMES[up_axis]) * unit_metres


func _clamped(p_frame: int) -> int:
	return clampi(p_frame, 0, maxi(frame_count - 1, 0))


func _sample(p_first: int, p_second: int, p_weight: float, p_into: Pose) -> Pose:
	prepare()
	var pose: Pose = p_into if p_into != null else Pose.new()
	var count: int = joints.size()
	pose.orientations.resize(count)
	pose.positions.resize(count)
	var offsets: PackedVector3Array = _offsets(p_first)
	var later: PackedVector3Array = offsets if p_weight == 0.0 else _offsets(p_second)
	for joint: int in count:
		var orientation: Quaternion = _orientation(p_first * count + joint)
		var offset: Vector3 = offsets[joint]
		if p_weight != 0.0:
			orientation = orientation.slerp(_orientation(p_second * count + joint), p_weight)
			offset = offset.lerp(later[joint], p_weight)
		pose.orientations[joint] = orientation
		var position: Vector3 = to_godot(offset)
		var parent: int = _parents[joint]
		if parent >= 0:
			position = pose.positions[parent] + pose.orientations[parent] * position
		pose.positions[joint] = position
	return pose


func _orientation(p_at: int) -> Quaternion:
	if frame_count == 0:
		return Quaternion.IDENTITY
	var found: Vector4 = _orientations[p_at]
	return Quaternion(found.x, found.y, found.z, found.w)


func _offsets(p_frame: int) -> PackedVector3Array:
	if frame_count == 0:
		return _kinematics.rest_offsets()
	return _kinematics.offsets_at(values, p_frame * channel_count)
