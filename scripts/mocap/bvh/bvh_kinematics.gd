class_name BvhKinematics
extends RefCounted
## Turns a row of numbers into rotations and positions, in the file's own axes and units.
##
## Rotations are composed in the order of the channels, each about the axis as the ones before it
## left it (Zrotation Xrotation Yrotation means Rz * Rx * Ry), below those of the parent. A position
## channel replaces its component of the joint's OFFSET, or adds to it if the options say so.

const AXES: PackedVector3Array = [Vector3.RIGHT, Vector3.UP, Vector3.BACK]

## Rotation of each joint in the file's world, after [method solve].
var rotations: Array[Quaternion] = []
## Position of each joint in its parent's frame, file units, after [method solve].
var offsets: PackedVector3Array = PackedVector3Array()

var _parents: PackedInt32Array = PackedInt32Array()
var _rest_offsets: PackedVector3Array = PackedVector3Array()
var _adds_offset: bool = false
## Rotation channels of all joints; those of joint i end before _rotation_ends[i].
var _rotation_ends: PackedInt32Array = PackedInt32Array()
var _rotation_columns: PackedInt32Array = PackedInt32Array()
var _rotation_axes: PackedInt32Array = PackedInt32Array()
## Position channels of all joints.
var _position_joints: PackedInt32Array = PackedInt32Array()
var _position_columns: PackedInt32Array = PackedInt32Array()
var _position_axes: PackedInt32Array = PackedInt32Array()


## Prepares for a skeleton.
func _init(p_joints: Array[BvhJoint], p_adds_offset: bool) -> void:
	_adds_offset = p_adds_offset
	for index: int in p_joints.size():
		var joint: BvhJoint = p_joints[index]
		_parents.append(joint.parent)
		_rest_offsets.append(joint.offset)
		for position: int in joint.channels.size():
			var channel: int = joint.channels[position]
			if BvhJoint.is_rotation(channel):
				_rotation_columns.append(joint.first_channel + position)
				_rotation_axes.append(channel - BvhJoint.Channel.X_ROTATION)
			elif BvhJoint.is_position(channel):
				_position_joints.append(index)
				_position_columns.append(joint.first_channel + position)
				_position_axes.append(channel)
		_rotation_ends.append(_rotation_columns.size())
	rotations.resize(p_joints.size())
	offsets = _rest_offsets.duplicate()


## Computes [member rotations] and [member offsets] for the row that starts at [param p_start].
func solve(p_values: PackedFloat64Array, p_start: int) -> void:
	var next: int = 0
	for joint: int in _parents.size():
		var parent: int = _parents[joint]
		var rotation: Quaternion = Quaternion.IDENTITY if parent < 0 else rotations[parent]
		var end: int = _rotation_ends[joint]
		while next < end:
			var angle: float = p_values[p_start + _rotation_columns[next]]
			rotation *= Quaternion(AXES[_rotation_axes[next]], deg_to_rad(angle))
			next += 1
		rotations[joint] = rotation.normalized()
	offsets = offsets_at(p_values, p_start)


## Positions of all joints in their parents' frames, file units, for the row that starts at
## [param p_start]. Changes nothing here, so any thread may ask.
func offsets_at(p_values: PackedFloat64Array, p_start: int) -> PackedVector3Array:
	var found: PackedVector3Array = _rest_offsets.duplicate()
	for index: int in _position_joints.size():
		var joint: int = _position_joints[index]
		var axis: int = _position_axes[index]
		var base: float = _rest_offsets[joint][axis] if _adds_offset else 0.0
		found[joint][axis] = base + p_values[p_start + _position_columns[index]]
	return found


## Positions of all joints in their parents' frames in the rest pose, file units.
func rest_offsets() -> PackedVector3Array:
	return _rest_offsets.duplicate()


## Sets the skeleton to the rest pose: no rotation, every joint at its OFFSET.
func rest() -> void:
	rotations.fill(Quaternion.IDENTITY)
	offsets = _rest_offsets.duplicate()


## The joints' positions in the file's world, file units, of what was solved last.
func positions() -> PackedVector3Array:
	var found: PackedVector3Array = offsets.duplicate()
	for joint: int in _parents.size():
		var parent: int = _parents[joint]
		if parent >= 0:
			found[joint] = found[parent] + rotations[parent] * offsets[joint]
	return found
