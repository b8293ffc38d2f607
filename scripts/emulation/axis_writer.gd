class_name AxisWriter
extends StreamWriter
## Writes somebody's poses as Axis Studio does: see [AxisReader].

## Whether frames are lines of text, and whether all bones have positions.
var is_text: bool = false
var has_places: bool = true
## Whether a reference comes first.
var has_reference: bool = false
## The avatar's number and name.
var avatar: int = 0
var name: String = "chr00"

var _counter: int = 0


func set_person(p_number: int, _p_name: String) -> void:
	avatar = p_number


func write(p_pose: PoseSample) -> Array[PackedByteArray]:
	var values: PackedFloat32Array = _values(p_pose)
	_counter += 1
	if is_text:
		var words: PackedStringArray = [str(avatar), name]
		for value: float in values:
			words.append("%.4f" % value)
		return [(" ".join(words) + " ||").to_ascii_buffer()]
	var bytes: PackedByteArray = PackedByteArray()
	bytes.resize(AxisReader.HEADER)
	bytes.encode_u16(0, AxisReader.BEGIN)
	# Version 1.1.0.1: build, revision, minor, major.
	bytes.encode_u32(2, 0x01010001)
	bytes.encode_u16(6, values.size())
	bytes[8] = 1 if has_places else 0
	bytes[9] = 1 if has_reference else 0
	bytes.encode_u32(10, avatar)
	var letters: PackedByteArray = name.to_ascii_buffer()
	for at: int in mini(letters.size(), 31):
		bytes[14 + at] = letters[at]
	bytes.encode_u32(46, _counter)
	bytes.encode_u16(62, AxisReader.END)
	bytes.append_array(values.to_byte_array())
	return [bytes]


func _values(p_pose: PoseSample) -> PackedFloat32Array:
	var values: PackedFloat32Array = []
	if has_reference:
		values.append_array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
	var turns: Array[Quaternion] = []
	for bone: int in AxisReader.BONES:
		var above: int = AxisReader.PARENTS[bone]
		var turn: Quaternion = _turn_of(bone, p_pose, turns)
		turns.append(turn)
		var place: Vector3 = p_pose.root
		if above >= 0:
			turn = turns[above].inverse() * turn
			place = _rest(bone) - _rest(above)
		if has_places or bone == 0:
			values.append_array([place.x * 100.0, place.y * 100.0, place.z * 100.0])
		var degrees: Vector3 = Basis(turn).get_euler(EULER_ORDER_YXZ) * (180.0 / PI)
		values.append_array([degrees.y, degrees.x, degrees.z])
	return values


static func _turn_of(p_bone: int, p_pose: PoseSample, p_turns: Array[Quaternion]) -> Quaternion:
	var joint: int = AxisReader.joint_of(p_bone)
	var limb: int = HumanoidAxes.JOINTS.find(joint)
	if joint == XRBodyTracker.JOINT_UPPER_CHEST:
		return p_pose.orientation(Limbs.CHEST).normalized()
	if joint >= 0 and limb >= 0:
		return p_pose.orientation(limb).normalized()
	if p_pose.details != null and p_pose.details.joints.has(joint):
		return p_pose.details.joints[joint]
	return p_turns[AxisReader.PARENTS[p_bone]]


## Where a bone begins in the reset pose, m.
func _rest(p_bone: int) -> Vector3:
	var joint: int = AxisReader.joint_of(p_bone)
	if joint >= 0 and FingerJoints.hand_of(joint) < 0:
		return _figure.rest_of(joint)
	if p_bone < AxisReader.RIGHT_ARM:
		return _figure.rest_tail(Limbs.CHEST)
	var hand: int = Limbs.LEFT_HAND if p_bone > AxisReader.LEFT_ARM else Limbs.RIGHT_HAND
	return _figure.rest_base(hand).lerp(_figure.rest_tail(hand), 0.5)
