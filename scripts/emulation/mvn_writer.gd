class_name MvnWriter
extends StreamWriter
## Writes a person's poses as MVN would: for trying and testing without a suit.
##
## Limbs are the segments that [MvnSegments] names; the others lie between them. What MVN measures
## (accelerations, fields) follows from the motion.

## Types that it can write.
const TYPES: Array[int] = [1, 2, 3, 5, 12, 13, 20, 21, 22, 23, 24, 25]
## Gravity, m/s², and the earth's field in MVN's frame (its length is 1).
const GRAVITY: float = 9.81
const FIELD: Vector3 = Vector3(0.39, 0.0, -0.92)

## Types that change seldom are sent once a second.
const SELDOM: Array[int] = [12, 13]

## What it writes of each pose, of [constant TYPES].
var types: PackedInt32Array = [2, 12, 13, 23]
## The character's number, 0 to 255, and its name.
var character: int = 0
var name: String = "Dismount"

var _rest: PackedVector3Array = PackedVector3Array()
var _turns: Array[Quaternion] = []
var _positions: PackedVector3Array = PackedVector3Array()
var _velocities: PackedVector3Array = PackedVector3Array()
var _accelerations: PackedVector3Array = PackedVector3Array()
var _rates: PackedVector3Array = PackedVector3Array()
var _rate_changes: PackedVector3Array = PackedVector3Array()
var _time_s: float = NAN
var _began_usec: int = -1
var _number: int = 0
# The second in which types that change seldom were sent last.
var _second: int = -1


## For somebody of a size.
func _init(p_size: BodySize = BodySize.new()) -> void:
	super(p_size)
	var joints: PackedVector3Array = p_size.joints()
	_rest.resize(MvnSegments.COUNT)
	for limb: int in Limbs.COUNT:
		_rest[MvnSegments.OF_LIMBS[limb]] = joints[limb]
	_rest[1] = joints[0].lerp(joints[1], 0.5)
	_rest[3] = joints[1].lerp(joints[2], 0.5)
	_rest[5] = joints[2].lerp(joints[3], 0.8)
	for arm: int in [8, 12]:
		_rest[arm - 1] = Vector3(_rest[arm].x * 0.3, _rest[arm].y, _rest[arm].z)
	for foot: int in [17, 21]:
		var sole: float = -p_size.length(&"foot_height") * 0.8
		_rest[foot + 1] = _rest[foot] + Vector3(0.0, sole, p_size.length(&"foot_length") * 0.7)
	_rates.resize(MvnSegments.COUNT)
	_velocities.resize(MvnSegments.COUNT)
	_accelerations.resize(MvnSegments.COUNT)
	_rate_changes.resize(MvnSegments.COUNT)


func set_person(p_number: int, p_name: String) -> void:
	character = p_number
	name = p_name


func write(p_pose: PoseSample) -> Array[PackedByteArray]:
	if _began_usec < 0:
		_began_usec = p_pose.time_usec
	var time_s: float = (p_pose.time_usec - _began_usec) / 1e6
	take(p_pose, time_s)
	var datagrams: Array[PackedByteArray] = []
	for type: int in types:
		if not SELDOM.has(type) or floori(time_s) != _second:
			datagrams.append_array(MvnEncoder.encode(sample(type, _number, roundi(time_s * 1e3))))
	_second = floori(time_s)
	_number += 1
	return datagrams


## Takes a pose at a time, s.
func take(p_pose: PoseSample, p_time_s: float) -> void:
	var turns: Array[Quaternion] = _segment_turns(p_pose)
	var positions: PackedVector3Array = []
	positions.resize(MvnSegments.COUNT)
	positions[0] = p_pose.root
	for segment: int in range(1, MvnSegments.COUNT):
		var parent: int = MvnSegments.PARENTS[segment]
		positions[segment] = positions[parent] + turns[parent] * (_rest[segment] - _rest[parent])
	var step: float = p_time_s - _time_s
	if step > 0.0:
		for segment: int in MvnSegments.COUNT:
			var velocity: Vector3 = (positions[segment] - _positions[segment]) / step
			var rate: Vector3 = Rotations.vector(turns[segment] * _turns[segment].inverse()) / step
			_accelerations[segment] = (velocity - _velocities[segment]) / step
			_rate_changes[segment] = (rate - _rates[segment]) / step
			_velocities[segment] = velocity
			_rates[segment] = rate
	_turns = turns
	_positions = positions
	_time_s = p_time_s


## The sample of a type, for [method MvnEncoder.encode].
func sample(p_type: int, p_number: int, p_time_code_ms: int) -> Dictionary:
	var written: Dictionary = {
		"type": p_type,
		"sample": p_number & 0xFFFFFFFF,
		"time_code_ms": p_time_code_ms & 0xFFFFFFFF,
		"character": character,
	}
	match p_type:
		1, 2, 3, 5:
			_write_pose(p_type, written)
		12:
			written["tags"] = {"name": name, "xmid": str(character + 1), "color": "FF8000"}
		13:
			_write_scale(written)
		20:
			_write_joints(written)
		21, 22, 23:
			_write_motion(p_type, written)
		24:
			written["centre_of_mass"] = _out(_centre_of_mass())
		25:
			written["time_code"] = _time_text(p_time_code_ms)
	return written


func _segment_turns(p_pose: PoseSample) -> Array[Quaternion]:
	var turns: Array[Quaternion] = []
	turns.resize(MvnSegments.COUNT)
	for limb: int in Limbs.COUNT:
		turns[MvnSegments.OF_LIMBS[limb]] = p_pose.orientation(limb).normalized()
	turns[1] = turns[0].slerp(turns[2], 0.5)
	turns[3] = turns[2].slerp(turns[4], 0.5)
	turns[5] = turns[4].slerp(turns[6], 0.5)
	turns[7] = turns[4]
	turns[11] = turns[4]
	turns[18] = turns[17]
	turns[22] = turns[21]
	return turns


func _write_pose(p_type: int, r_written: Dictionary) -> void:
	var ids: PackedInt32Array = []
	var positions: PackedVector3Array = []
	var euler: PackedVector3Array = []
	var wxyz: PackedFloat32Array = []
	for item: int in MvnSegments.COUNT:
		var segment: int = MvnSegments.UNITY_ORDER[item] if p_type == 5 else item
		var position: Vector3 = _positions[segment]
		var turn: Quaternion = _turns[segment]
		ids.append(item + 1 if p_type != 3 else (item + 1) * 256)
		match p_type:
			1, 3:
				positions.append(position * 100.0)
				var angles: Vector3 = Basis(turn).get_euler(EULER_ORDER_ZYX)
				euler.append(angles * (180.0 / PI))
			2:
				positions.append(_out(position))
				wxyz.append_array([turn.w, turn.z, turn.x, turn.y])
			5:
				var parent: int = MvnSegments.PARENTS[segment]
				if parent >= 0:
					position = _turns[parent].inverse() * (position - _positions[parent])
					turn = _turns[parent].inverse() * turn
				positions.append(Vector3(-position.x, position.y, position.z))
				wxyz.append_array([turn.w, turn.x, -turn.y, -turn.z])
	r_written["segments"] = ids
	r_written["positions"] = positions
	if p_type == 1:
		r_written["euler"] = euler
	elif p_type != 3:
		r_written["orientations"] = wxyz


func _write_scale(r_written: Dictionary) -> void:
	var origins: PackedVector3Array = []
	for position: Vector3 in _rest:
		origins.append(_out(position))
	r_written["names"] = MvnEncoder.get_segment_names()
	r_written["origins"] = origins
	r_written["point_segments"] = PackedInt32Array([18, 22])
	r_written["point_numbers"] = PackedInt32Array([1, 1])
	r_written["point_names"] = PackedStringArray(["pRightHeelFoot", "pLeftHeelFoot"])
	r_written["point_flags"] = PackedInt32Array([0, 0])
	var soles: PackedVector3Array = []
	for foot: int in [17, 21]:
		soles.append(Vector3(0.0, 0.0, -_rest[foot].y))
	r_written["point_positions"] = soles


func _write_joints(r_written: Dictionary) -> void:
	var parents: PackedInt32Array = []
	var children: PackedInt32Array = []
	var angles: PackedVector3Array = []
	for segment: int in range(1, MvnSegments.COUNT):
		var parent: int = MvnSegments.PARENTS[segment]
		var turn: Quaternion = _turns[parent].inverse() * _turns[segment]
		var own: Vector3 = Basis(_quaternion_out(turn)).get_euler(EULER_ORDER_ZYX)
		parents.append((parent + 1) * 256)
		children.append((segment + 1) * 256)
		angles.append(own * (180.0 / PI))
	r_written["parents"] = parents
	r_written["children"] = children
	r_written["angles"] = angles


func _write_motion(p_type: int, r_written: Dictionary) -> void:
	var ids: PackedInt32Array = []
	var wxyz: PackedFloat32Array = []
	var own: Array[PackedVector3Array] = [[], [], [], []]
	for segment: int in MvnSegments.COUNT:
		if p_type == 23 and MvnSegments.MOUNTS[segment] == &"":
			continue
		var turn: Quaternion = _turns[segment]
		var back: Quaternion = turn.inverse()
		ids.append(segment + 1)
		wxyz.append_array([turn.w, turn.z, turn.x, turn.y])
		match p_type:
			21:
				own[0].append(_out(_positions[segment]))
				own[1].append(_out(_velocities[segment]))
				own[2].append(_out(_accelerations[segment]))
			22:
				own[0].append(_out(_rates[segment]))
				own[1].append(_out(_rate_changes[segment]))
			23:
				var felt: Vector3 = _accelerations[segment] + Vector3(0.0, GRAVITY, 0.0)
				own[0].append(_out(_accelerations[segment]))
				own[1].append(_out(back * felt))
				own[2].append(_out(back * _rates[segment]))
				own[3].append(_out(back * Vector3(FIELD.y, FIELD.z, FIELD.x)))
	var keys: Dictionary[int, Array] = {
		21: ["positions", "velocities", "accelerations"],
		22: ["angular_velocities", "angular_accelerations"],
		23: ["free_accelerations", "accelerations", "rates", "magnetic_fields"],
	}
	r_written["segments"] = ids
	if p_type != 21:
		r_written["orientations"] = wxyz
	for at: int in keys[p_type].size():
		r_written[keys[p_type][at]] = own[at]


func _centre_of_mass() -> Vector3:
	var centre: Vector3 = Vector3.ZERO
	var mass: float = 0.0
	for limb: int in Limbs.COUNT:
		centre += _positions[MvnSegments.OF_LIMBS[limb]] * Limbs.MASS_FRACTIONS[limb]
		mass += Limbs.MASS_FRACTIONS[limb]
	return centre / mass


static func _time_text(p_ms: int) -> String:
	var ms: int = p_ms % 86400000
	@warning_ignore("integer_division")
	var seconds: int = ms / 1000
	@warning_ignore("integer_division")
	var parts: Array = [seconds / 3600, seconds / 60 % 60, seconds % 60, ms % 1000]
	return "%02d:%02d:%02d.%03d" % parts


## From Godot's frame to MVN's: the inverse of [method SourceFrames.vector].
static func _out(p_vector: Vector3) -> Vector3:
	return Vector3(p_vector.z, p_vector.x, p_vector.y)


static func _quaternion_out(p_turn: Quaternion) -> Quaternion:
	return Quaternion(p_turn.z, p_turn.x, p_turn.y, p_turn.w)
