class_name NatnetWriter
extends StreamWriter
## Writes somebody's poses as Motive does by NatNet, and answers what clients ask: see
## [NatnetReader]. With Motive's own 21 bones.

## Bones with the one above each, counted from 1, and their joints.
const BONES: Array[Array] = [
	["Hip", 0, XRBodyTracker.JOINT_HIPS],
	["Ab", 1, XRBodyTracker.JOINT_SPINE],
	["Chest", 2, XRBodyTracker.JOINT_CHEST],
	["Neck", 3, XRBodyTracker.JOINT_NECK],
	["Head", 4, XRBodyTracker.JOINT_HEAD],
	["LShoulder", 3, XRBodyTracker.JOINT_LEFT_SHOULDER],
	["LUArm", 6, XRBodyTracker.JOINT_LEFT_UPPER_ARM],
	["LFArm", 7, XRBodyTracker.JOINT_LEFT_LOWER_ARM],
	["LHand", 8, XRBodyTracker.JOINT_LEFT_HAND],
	["RShoulder", 3, XRBodyTracker.JOINT_RIGHT_SHOULDER],
	["RUArm", 10, XRBodyTracker.JOINT_RIGHT_UPPER_ARM],
	["RFArm", 11, XRBodyTracker.JOINT_RIGHT_LOWER_ARM],
	["RHand", 12, XRBodyTracker.JOINT_RIGHT_HAND],
	["LThigh", 1, XRBodyTracker.JOINT_LEFT_UPPER_LEG],
	["LShin", 14, XRBodyTracker.JOINT_LEFT_LOWER_LEG],
	["LFoot", 15, XRBodyTracker.JOINT_LEFT_FOOT],
	["RThigh", 1, XRBodyTracker.JOINT_RIGHT_UPPER_LEG],
	["RShin", 17, XRBodyTracker.JOINT_RIGHT_LOWER_LEG],
	["RFoot", 18, XRBodyTracker.JOINT_RIGHT_FOOT],
	["LToe", 16, XRBodyTracker.JOINT_LEFT_TOES],
	["RToe", 19, XRBodyTracker.JOINT_RIGHT_TOES],
]

## Version of the stream: 300, 400, 401.
var version: int = 401
## Whether bones are on the ones above them, as Motive's usual setting has it.
var is_local: bool = true
## The skeleton's number and name.
var skeleton: int = 1
var name: String = "Dismount"

var _counter: int = 0
var _began_usec: int = -1


func answer(p_bytes: PackedByteArray) -> Array[PackedByteArray]:
	if p_bytes.size() < 4:
		return []
	match p_bytes.decode_u16(0):
		NatnetReader.CONNECT:
			return [_write_info()]
		NatnetReader.REQUEST_MODELDEF:
			return [_write_models()]
	return []


func write(p_pose: PoseSample) -> Array[PackedByteArray]:
	if _began_usec < 0:
		_began_usec = p_pose.time_usec
	_counter += 1
	var out: StreamPeerBuffer = StreamPeerBuffer.new()
	out.put_u32(_counter)
	# Marker sets, markers, rigid bodies: none.
	for _part: int in 3:
		_put_part(out, 0, PackedByteArray())
	_put_part(out, 1, _skeleton_bytes(p_pose))
	# Assets came with version 4.1; markers with labels, force plates, devices: none.
	for _part: int in 4 if version >= 401 else 3:
		_put_part(out, 0, PackedByteArray())
	out.put_u32(0)
	out.put_u32(0)
	out.put_double((p_pose.time_usec - _began_usec) / 1e6)
	for _stamp: int in 3:
		out.put_u64(p_pose.time_usec)
	if version >= 401:
		out.put_u64(0)
	out.put_u16(0)
	# The end of the data.
	out.put_u32(0)
	return [_message(NatnetReader.FRAME, out.data_array)]


func _write_info() -> PackedByteArray:
	var content: PackedByteArray = "Motive".to_ascii_buffer()
	content.resize(256)
	@warning_ignore("integer_division")
	content.append_array([3, 1, 0, 0, version / 100, version % 100, 0, 0])
	return _message(NatnetReader.SERVERINFO, content)


func _write_models() -> PackedByteArray:
	var part: StreamPeerBuffer = StreamPeerBuffer.new()
	_put_text(part, name)
	part.put_u32(skeleton)
	part.put_u32(BONES.size())
	for at: int in BONES.size():
		_put_text(part, "%s_%s" % [name, BONES[at][0]])
		part.put_u32(at + 1)
		part.put_u32(BONES[at][1])
		var place: Vector3 = _rest(at) - (_rest(BONES[at][1] - 1) if at > 0 else _rest(0))
		for value: float in [place.x, place.y, place.z]:
			part.put_float(value)
		part.put_u32(0)
	var out: StreamPeerBuffer = StreamPeerBuffer.new()
	out.put_u32(1)
	out.put_u32(2)
	if version >= 401:
		out.put_u32(part.data_array.size())
	out.put_data(part.data_array)
	return _message(NatnetReader.MODELDEF, out.data_array)


func _skeleton_bytes(p_pose: PoseSample) -> PackedByteArray:
	var out: StreamPeerBuffer = StreamPeerBuffer.new()
	out.put_u32(skeleton)
	out.put_u32(BONES.size())
	var turns: Array[Quaternion] = []
	var places: PackedVector3Array = []
	for at: int in BONES.size():
		var above: int = BONES[at][1] - 1
		var turn: Quaternion = _turn_of(at, p_pose, turns)
		var place: Vector3 = p_pose.root
		if above >= 0:
			place = places[above] + turns[above] * (_rest(at) - _rest(above))
		turns.append(turn)
		places.append(place)
		if is_local and above >= 0:
			turn = turns[above].inverse() * turn
			place = _rest(at) - _rest(above)
		out.put_u32((skeleton << 16) | (at + 1))
		for value: float in [place.x, place.y, place.z, turn.x, turn.y, turn.z, turn.w, 0.001]:
			out.put_float(value)
		out.put_u16(1)
	return out.data_array


static func _turn_of(p_bone: int, p_pose: PoseSample, p_turns: Array[Quaternion]) -> Quaternion:
	var joint: int = BONES[p_bone][2]
	var limb: int = HumanoidAxes.JOINTS.find(joint)
	if limb >= 0:
		return p_pose.orientation(limb).normalized()
	if p_pose.details != null and p_pose.details.joints.has(joint):
		return p_pose.details.joints[joint]
	return p_turns[BONES[p_bone][1] - 1]


## Where a bone begins in the reset pose, m.
func _rest(p_bone: int) -> Vector3:
	return _figure.rest_of(BONES[p_bone][2])


func _put_part(r_out: StreamPeerBuffer, p_count: int, p_content: PackedByteArray) -> void:
	r_out.put_u32(p_count)
	if version >= 401:
		r_out.put_u32(p_content.size())
	if not p_content.is_empty():
		r_out.put_data(p_content)


static func _put_text(r_out: StreamPeerBuffer, p_text: String) -> void:
	r_out.put_data(p_text.to_ascii_buffer())
	r_out.put_u8(0)


static func _message(p_kind: int, p_content: PackedByteArray) -> PackedByteArray:
	var bytes: PackedByteArray = [0, 0, 0, 0]
	bytes.encode_u16(0, p_kind)
	bytes.encode_u16(2, p_content.size())
	bytes.append_array(p_content)
	return bytes
