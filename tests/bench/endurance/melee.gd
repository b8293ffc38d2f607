extends Node3D
## Pairs of people who fight, hug, fall and get up again, everybody at another moment, while crates
## drop on them.

## Seconds of a round: boxing, then a hug, apart again, both go limp, get up.
const ROUND_S: float = 24.0
const _HUG_S: float = 10.0
const _PART_S: float = 14.0
const _FALL_S: float = 15.5
const _RISE_S: float = 17.5
## Seconds by which a pair is ahead of the one before.
const _AHEAD_S: float = 3.0
## Seconds in which one pose is blended into the next.
const _BLEND_S: float = 0.5
## Seconds in which people who were limp get their strength back.
const _GAIN_S: float = 1.5
## Between those of a pair, boxing and hugging, and between pairs, m.
const _BOXING_M: float = 0.8
const _HUGGING_M: float = 0.15
const _PAIRS_M: float = 2.0
const _CRATES: int = 24
## A crate drops so often, s, from so high, m.
const _DROP_EVERY_S: float = 2.0
const _DROP_M: float = 2.3
const _CRATE: PackedScene = preload("res://scenes/world/props/crate.tscn")

## Who takes part.
var people: Array[ContactPerson] = []
## What drops on them.
var crates: Array[RigidBody3D] = []

var _boxing: BvhSource = null
var _motors: Array[RagdollMotor] = []
var _times: PackedFloat64Array = []
var _limp: PackedByteArray = []
var _dropped: int = 0


## Adds everybody; has to be in the tree.
func begin(p_people: int, p_root: RagdollMotor.RootMode, p_boxing: BvhSource) -> void:
	_boxing = p_boxing
	add_child(BenchBodies.ground())
	for i: int in _CRATES:
		var crate: RigidBody3D = _CRATE.instantiate()
		crate.position = _place(i % p_people) + Vector3(1.0, 0.25 + 0.5 * (i / p_people), 0.0)
		add_child(crate)
		crates.append(crate)
	for i: int in p_people:
		var ragdoll: Ragdoll = BenchBodies.soldier(p_root)
		add_child(ragdoll)
		ragdoll.start()
		var turn: Basis = Basis(Vector3.UP, PI * (i % 2))
		ragdoll.motor.set_frame(Transform3D(turn, _place(i)))
		people.append(ContactPerson.new(ragdoll))
		_motors.append(ragdoll.motor)
	_times.resize(p_people)
	_limp.resize(p_people)


## Sets everything for the step that begins at a time.
func drive(p_time_s: float, p_delta_s: float) -> void:
	for i: int in people.size():
		var sample: PoseSample = _sample(i, p_time_s)
		people[i].ragdoll.push_sample(p_time_s, sample, sample.root)
		_times[i] = p_time_s
		var moment: float = _moment(i, p_time_s)
		var limp: int = 1 if moment >= _FALL_S and moment < _RISE_S else 0
		if limp != _limp[i]:
			var mode: RagdollMotor.Actuation = RagdollMotor.VELOCITY_MOTOR
			_motors[i].set_actuation(
				RagdollMotor.LIMP if limp else mode, "", 0.3 if limp else _GAIN_S
			)
			_limp[i] = limp
	if p_time_s >= _dropped * _DROP_EVERY_S:
		_drop()
	RagdollMotor.drive_all(_motors, _times, p_delta_s)


## A number that differs where any body's state does.
func fingerprint() -> int:
	var found: int = 0
	for motor: RagdollMotor in _motors:
		found = found * 31 + motor.get_state_hash()
	for crate: RigidBody3D in crates:
		found = found * 31 + hash(crate.transform) + hash(crate.linear_velocity)
	return found & 0xFFFFFFFFFFFF


func _drop() -> void:
	var crate: RigidBody3D = crates[_dropped % crates.size()]
	var person: Ragdoll = people[_dropped * 5 % people.size()].ragdoll
	var hips: Transform3D = PhysicsServer3D.body_get_state(
		person.get_bodies()[0], PhysicsServer3D.BODY_STATE_TRANSFORM
	)
	var above: Transform3D = Transform3D(Basis.IDENTITY, hips.origin)
	above.origin.y = _DROP_M
	var rid: RID = crate.get_rid()
	PhysicsServer3D.body_set_state(rid, PhysicsServer3D.BODY_STATE_TRANSFORM, above)
	for state: PhysicsServer3D.BodyState in [
		PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY, PhysicsServer3D.BODY_STATE_ANGULAR_VELOCITY
	]:
		PhysicsServer3D.body_set_state(rid, state, Vector3.ZERO)
	_dropped += 1


## Middle of the pair, moved back by half of the distance when boxing.
func _place(p_person: int) -> Vector3:
	var pair: int = p_person / 2
	var middle: Vector3 = Vector3(pair % 4, 0.0, pair / 4) * _PAIRS_M
	return middle + Vector3(0.0, 0.0, _BOXING_M / 2.0 * (1.0 if p_person % 2 else -1.0))


func _moment(p_person: int, p_time_s: float) -> float:
	return fposmod(p_time_s + _AHEAD_S * (p_person / 2), ROUND_S)


## A sample in the person's own frame, who looks at the partner.
func _sample(p_person: int, p_time_s: float) -> PoseSample:
	var moment: float = _moment(p_person, p_time_s)
	var person: ContactPerson = people[p_person]
	var boxing: PoseSample = _boxing.pose_at(p_time_s + 0.7 * p_person)
	var hugs: float = ContactPoses.smooth((moment - _HUG_S) / _BLEND_S)
	hugs -= ContactPoses.smooth((moment - _FALL_S) / _BLEND_S)
	var near: float = ContactPoses.smooth(moment - _HUG_S) - ContactPoses.smooth(moment - _PART_S)
	var closed: float = ContactPoses.smooth((moment - _HUG_S - 1.0) / _BLEND_S)
	closed -= ContactPoses.smooth((moment - _PART_S) / _BLEND_S)
	var hug: PoseSample = ContactPoses.hug(person, closed, 0.0)
	var sample: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		sample.set_orientation(limb, boxing.orientation(limb).slerp(hug.orientation(limb), hugs))
	var height: float = lerpf(boxing.root.y, person.standing_hips().y, hugs)
	sample.root = Vector3(0.0, height, (_BOXING_M - _HUGGING_M) / 2.0 * near)
	return sample
