class_name MocopiWriter
extends StreamWriter
## Writes somebody's poses as Sony's mocopi app does: see [MocopiReader]. How the bones lie at rest
## comes once a second.

const _REST_USEC: int = 1000000

var _rest: PackedVector3Array = PackedVector3Array()
var _counter: int = 0
var _rest_usec: int = -1
var _began_usec: int = -1


func _init(p_size: BodySize = BodySize.new()) -> void:
	super(p_size)
	_rest.resize(MocopiReader.BONES)
	for bone: int in MocopiReader.BONES:
		_rest[bone] = _place_at_rest(bone)


func write(p_pose: PoseSample) -> Array[PackedByteArray]:
	var datagrams: Array[PackedByteArray] = []
	if _began_usec < 0:
		_began_usec = p_pose.time_usec
	if _rest_usec < 0 or p_pose.time_usec - _rest_usec >= _REST_USEC:
		_rest_usec = p_pose.time_usec
		datagrams.append(_write_rest())
	datagrams.append(_write_frame(p_pose))
	return datagrams


## Where a bone begins in the reset pose, m.
func _place_at_rest(p_bone: int) -> Vector3:
	var chest: Vector3 = _figure.rest_base(Limbs.CHEST)
	var top: Vector3 = _figure.rest_tail(Limbs.CHEST)
	match p_bone:
		1, 2:
			return _figure.rest_base(Limbs.HIPS).lerp(_figure.rest_base(Limbs.SPINE), p_bone / 3.0)
		4:
			return _figure.rest_base(Limbs.SPINE).lerp(chest, 0.5)
		6, 7:
			return chest.lerp(top, 0.3 * (p_bone - 5))
		9:
			return top.lerp(_figure.rest_base(Limbs.HEAD), 0.5)
	return _figure.rest_of(MocopiReader.JOINTS[p_bone])


func _write_rest() -> PackedByteArray:
	var bones: PackedByteArray = PackedByteArray()
	for bone: int in MocopiReader.BONES:
		var above: int = MocopiReader.PARENTS[bone]
		var place: Vector3 = _rest[bone] - (_rest[above] if above >= 0 else Vector3.ZERO)
		var content: PackedByteArray = _box("bnid", _u16(bone))
		content.append_array(_box("pbid", _u16(above & 0xFFFF)))
		content.append_array(_box("tran", _tran(Quaternion.IDENTITY, place)))
		bones.append_array(_box("bndt", content))
	return _with_head(_box("skdf", _box("bons", bones)))


func _write_frame(p_pose: PoseSample) -> PackedByteArray:
	var turns: Array[Quaternion] = _turns(p_pose)
	var bones: PackedByteArray = PackedByteArray()
	for bone: int in MocopiReader.BONES:
		var above: int = MocopiReader.PARENTS[bone]
		var turn: Quaternion = turns[bone]
		var place: Vector3 = p_pose.root
		if above >= 0:
			turn = turns[above].inverse() * turn
			place = _rest[bone] - _rest[above]
		var content: PackedByteArray = _box("bnid", _u16(bone))
		content.append_array(_box("tran", _tran(turn, place)))
		bones.append_array(_box("btdt", content))
	_counter += 1
	var number: PackedByteArray = [0, 0, 0, 0]
	number.encode_u32(0, _counter)
	var frame: PackedByteArray = _box("fnum", number)
	var time_s: float = (p_pose.time_usec - _began_usec) / 1e6
	frame.append_array(_box("time", PackedFloat32Array([time_s]).to_byte_array()))
	var unix: PackedFloat64Array = [p_pose.time_usec / 1e6]
	frame.append_array(_box("uttm", unix.to_byte_array()))
	frame.append_array(_box("btrs", bones))
	return _with_head(_box("fram", frame))


## Rotations of all bones in the world.
static func _turns(p_pose: PoseSample) -> Array[Quaternion]:
	var known: Dictionary[int, Quaternion] = {}
	if p_pose.details != null:
		known = p_pose.details.joints
	var turns: Array[Quaternion] = []
	for bone: int in MocopiReader.BONES:
		var above: int = MocopiReader.PARENTS[bone]
		var turn: Quaternion = turns[above] if above >= 0 else Quaternion.IDENTITY
		var joint: int = MocopiReader.JOINTS[bone]
		var limb: int = HumanoidAxes.JOINTS.find(joint)
		if joint == XRBodyTracker.JOINT_UPPER_CHEST or joint == XRBodyTracker.JOINT_CHEST:
			turn = p_pose.orientation(Limbs.CHEST)
		elif joint == XRBodyTracker.JOINT_NECK:
			turn = p_pose.orientation(Limbs.CHEST).slerp(p_pose.orientation(Limbs.HEAD), 0.5)
		elif joint >= 0 and limb >= 0:
			turn = p_pose.orientation(limb)
		if limb < 0:
			turn = known.get(joint, turn)
		turns.append(turn.normalized())
	return turns


static func _with_head(p_part: PackedByteArray) -> PackedByteArray:
	var format: PackedByteArray = _box("ftyp", MocopiReader.FORMAT.to_ascii_buffer())
	format.append_array(_box("vrsn", PackedByteArray([1])))
	var datagram: PackedByteArray = _box("head", format)
	var address: PackedByteArray = PackedByteArray()
	address.resize(8)
	var sender: PackedByteArray = _box("ipad", address)
	sender.append_array(_box("rcvp", _u16(SourceAddress.PORTS["mocopi"])))
	datagram.append_array(_box("sndf", sender))
	datagram.append_array(p_part)
	return datagram


static func _box(p_name: String, p_content: PackedByteArray) -> PackedByteArray:
	var box: PackedByteArray = [0, 0, 0, 0]
	box.encode_u32(0, p_content.size())
	box.append_array(p_name.to_ascii_buffer())
	box.append_array(p_content)
	return box


static func _u16(p_value: int) -> PackedByteArray:
	var bytes: PackedByteArray = [0, 0]
	bytes.encode_u16(0, p_value)
	return bytes


static func _tran(p_turn: Quaternion, p_place: Vector3) -> PackedByteArray:
	var floats: PackedFloat32Array = [p_turn.x, p_turn.y, p_turn.z, p_turn.w]
	floats.append_array([p_place.x, p_place.y, p_place.z])
	return floats.to_byte_array()
