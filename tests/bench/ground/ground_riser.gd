class_name GroundRiser
extends RefCounted
## Somebody who lies and gets up on a floor that weighs: what helps from outside, what bears, how it
## looks.

## Who is up has the hips within so much of where they are when standing, m.
const _UP: float = 0.15
## Nobody's feet are both higher than this over the hips, nor the head lower than this under
## them, m.
const _LEGS_UP: float = 0.25
const _HEAD_DOWN: float = 0.1
## How long [member whole_impulse] is counted, s: until everybody is to stand.
const _WHOLE_S: float = 4.0
## A limb that is closer to the floor than this touches it, m.
const _TOUCHES: float = 0.015

var person: ContactPerson = null
var plate: GroundPlate = null
## Upright again after so long, s.
var up_s: float = INF
## Torque from outside while getting up, N·m, and the sum of it times the time, N·m·s.
var torques: PackedFloat64Array = []
var impulse: float = 0.0
## The same of the first seconds, whether it still gets up or stands already, N·m·s: who is only up
## as he is held up has not got up.
var whole_impulse: float = 0.0
## The greatest part of the weight on the hands for a tenth of a second, %.
var hands: float = 0.0
## How long the legs were in the air, the head down, s.
var legs_up_s: float = 0.0
var head_down_s: float = 0.0

var _hips: float = 0.0
var _residual: GroundResidual = null
var _shares: PackedFloat64Array = []


func _init(p_person: ContactPerson, p_plate: GroundPlate) -> void:
	person = p_person
	plate = p_plate
	_residual = GroundResidual.new(p_person, p_plate)
	_hips = p_person.standing_hips().y


## Puts something on the person.
func bear(p_crate: RigidBody3D) -> void:
	_residual.crate = p_crate


## Lies down where it is told to: lets itself fall, with a push (N·s) and a turn (N·m·s).
func fall(p_push: Vector3, p_turn: float) -> void:
	person.ragdoll.motor.set_actuation(RagdollMotor.LIMP, "", 0.2)
	var chest: RID = person.ragdoll.get_bodies()[person.find(&"Chest")]
	PhysicsServer3D.body_apply_central_impulse(chest, p_push)
	PhysicsServer3D.body_apply_torque_impulse(chest, Vector3.UP * p_turn)


## Gets up from now on.
func rise() -> void:
	person.ragdoll.motor.set_actuation(RagdollMotor.VELOCITY_MOTOR, "", 0.3)
	plate.read(1.0)


## After a step, [param p_time_s] after it began to get up.
func note(p_time_s: float, p_delta_s: float) -> void:
	var is_known: bool = _residual.note(p_delta_s)
	var phase: int = person.ragdoll.motor.get_balance()["phase"]
	if is_known and p_time_s < _WHOLE_S:
		whole_impulse += _residual.torque.length() * p_delta_s
	var bodies: Array[Transform3D] = person.bodies()
	if phase >= RagdollMotor.BALANCE_TUCKING and is_known:
		torques.append(_residual.torque.length())
		impulse += torques[-1] * p_delta_s
		_note_posture(bodies, p_delta_s)
	var low: bool = person.joint(0, bodies).y < _hips - _UP
	if low or phase != RagdollMotor.BALANCE_STANDING:
		up_s = INF
	elif is_inf(up_s):
		up_s = p_time_s


func _note_posture(p_bodies: Array[Transform3D], p_delta_s: float) -> void:
	var hips: float = person.joint(0, p_bodies).y
	var feet: float = INF
	for foot: StringName in [&"LeftFoot", &"RightFoot"]:
		feet = minf(feet, p_bodies[person.find(foot)].origin.y)
	legs_up_s += p_delta_s if feet > hips + _LEGS_UP else 0.0
	var head: float = p_bodies[person.find(&"Head")].origin.y
	head_down_s += p_delta_s if head < hips - _HEAD_DOWN else 0.0
	_shares.append(_hand_share(p_bodies))
	var recent: int = mini(_shares.size(), roundi(0.1 / p_delta_s))
	var sum: float = 0.0
	for share: float in _shares.slice(-recent):
		sum += share
	hands = maxf(hands, 100.0 * sum / recent)


## The part of the weight on the hands where they and the legs alone touch the floor: by the lever
## between them at which the floor pushes.
func _hand_share(p_bodies: Array[Transform3D]) -> float:
	var front: PackedVector3Array = []
	var back: PackedVector3Array = []
	for limb: int in person.count:
		var bone: StringName = person.shape_of(limb).bone
		if -person.reach(limb, p_bodies[limb], Vector3.DOWN) > _TOUCHES:
			continue
		if bone.contains("Hand") or bone.contains("LowerArm"):
			front.append(p_bodies[limb].origin)
		elif bone.contains("Leg") or bone.contains("Foot"):
			back.append(p_bodies[limb].origin)
		else:
			return 0.0
	if front.is_empty() or back.is_empty():
		return 0.0
	var way: Vector3 = _mean(front) - _mean(back)
	way.y = 0.0
	var from: Vector3 = plate.find_centre_of_pressure() - _mean(back)
	return clampf(from.dot(way) / way.length_squared(), 0.0, 1.0)


func _mean(p_points: PackedVector3Array) -> Vector3:
	var sum: Vector3 = Vector3.ZERO
	for point: Vector3 in p_points:
		sum += point
	return sum / p_points.size()
