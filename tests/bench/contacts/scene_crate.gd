extends ContactScene
## A crate of 40 kg that falls from 2 m above onto the head, and onto a shoulder, of a person who
## stands on a floor.
##
## The time to recover is that from the first step in which the crate is slowed until all limbs are
## within 5 degrees of the pose again, and stay there as long as it is watched. A value as long as
## the watch ([constant _WATCH_S]) means that they were not at its end.

const _MASS: float = 40.0
const _SIZE: float = 0.5
const _HEIGHT: float = 2.0
const _SETTLE_S: float = 0.5
const _WATCH_S: float = 5.0
const _LIMIT_DEG: float = 5.0

var _last_speed: float = 0.0
var _hit_s: float = -1.0
var _late_s: float = -1.0


func play(p_performer: ContactPerformer) -> void:
	await _drop(p_performer, "head", 0.05)
	await _drop(p_performer, "shoulder", 0.3)


func _drop(p_performer: ContactPerformer, p_target: String, p_aside: float) -> void:
	var world: ContactWorld = make_world()
	world.add_floor(0.0)
	var person: ContactPerson = p_performer.enter(world, root)
	var pose: PoseSample = ContactPoses.standing(person)
	world.add_standing(person, pose, person.standing_hips())
	await world.run(_SETTLE_S)
	var top: float = 0.0
	var bodies: Array[Transform3D] = person.bodies()
	for i: int in person.count:
		top = maxf(top, person.reach(i, bodies[i], Vector3.UP))
	var from: Vector3 = bodies[person.find(&"Head")].origin + Vector3(p_aside, 0.0, 0.0)
	from.y = top + _HEIGHT + _SIZE / 2.0
	var crate: RigidBody3D = world.add_crate(Vector3.ONE * _SIZE, from, _MASS)
	_last_speed = 0.0
	_hit_s = -1.0
	_late_s = -1.0
	await world.run(_WATCH_S + 1.0, _watch.bind(world, crate))
	var case: String = name_case("crate on %s" % p_target, p_performer)
	var recovery_s: float = minf(maxf(_late_s - _hit_s, 0.0), _WATCH_S)
	report.add(case, "time until < 5 deg", recovery_s * 1000.0, "ms")
	report.add(case, "joint gap", world.widest_gap * 1000.0, "mm")
	await end_world(world)


func _watch(p_world: ContactWorld, p_crate: RigidBody3D) -> bool:
	var speed: float = -p_crate.linear_velocity.y
	if _hit_s < 0.0 and speed < _last_speed:
		_hit_s = p_world.time_s - p_world.delta_s
		_late_s = _hit_s
	_last_speed = speed
	if _hit_s < 0.0:
		return false
	var person: ContactPerson = p_world.people[0]
	var wanted: Array[Transform3D] = person.targets_at(p_world.time_s)
	if person.worst_error_deg(person.bodies(), wanted) >= _LIMIT_DEG:
		_late_s = p_world.time_s + p_world.delta_s
	return p_world.time_s > _hit_s + _WATCH_S
