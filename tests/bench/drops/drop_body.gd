class_name DropBody
extends RefCounted
## Somebody who falls onto a thin floor in the benchmark of drops.

## Fall whose speed the body has where it begins, m, and where that is above the floor, m.
const HEIGHT_M: float = 50.0
const BEGIN_M: float = 3.0

var person: ContactPerson = null
## Where it falls, m.
var origin: Vector3 = Vector3.ZERO
## Whether the limbs are limp.
var is_limp: bool = true

var _pose: PoseSample = null
var _turn: Quaternion = Quaternion.IDENTITY
var _spin: Vector3 = Vector3.ZERO


## Chooses a pose of a clip, how it lies in the air and how it spins.
func choose(p_source: BvhSource, p_random: RandomNumberGenerator) -> void:
	_pose = p_source.pose_at(p_random.randf() * p_source.get_period())
	var axis: Vector3 = Vector3(p_random.randfn(), p_random.randfn(), p_random.randfn())
	_turn = Quaternion(axis.normalized(), p_random.randf() * TAU)
	_spin = Vector3(p_random.randfn(), p_random.randfn(), p_random.randfn()) * 4.0
	for limb: int in Limbs.COUNT:
		_pose.set_orientation(limb, _turn * _pose.orientation(limb))


func pose_at(_p_time_s: float) -> PoseSample:
	return _pose


func place_at(_p_time_s: float) -> Vector3:
	return origin + Vector3.UP * BEGIN_M


## Lets it fall, as fast as it would after the whole fall.
func let_go() -> void:
	if is_limp:
		person.ragdoll.motor.set_actuation(RagdollMotor.LIMP)
	var speed: Vector3 = Vector3.DOWN * sqrt(2.0 * 9.81 * HEIGHT_M)
	for body: RID in person.ragdoll.get_bodies():
		var at: Transform3D = PhysicsServer3D.body_get_state(
			body, PhysicsServer3D.BODY_STATE_TRANSFORM
		)
		var moves: Vector3 = speed + _spin.cross(at.origin - origin - Vector3.UP * BEGIN_M)
		PhysicsServer3D.body_set_state(body, PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY, moves)
		PhysicsServer3D.body_set_state(body, PhysicsServer3D.BODY_STATE_ANGULAR_VELOCITY, _spin)


## How many limbs are below a floor whose top is at height 0: their middles are in it or under it.
func count_through() -> int:
	var found: int = 0
	for body: Transform3D in person.bodies():
		found += 1 if body.origin.y < 0.0 else 0
	return found


## How deep the deepest limb is in the floor, m.
func depth() -> float:
	return maxf(-person.lowest(person.bodies()), 0.0)
