extends ContactScene
## Two people walk into each other, close their arms around each other, turn, let go and part.
##
## They are commanded to where their bodies would overlap; how far they are kept from there tells
## that they touch. Reported besides: how long after they are commanded to be apart again all limbs
## are within 3 degrees of the motion, and the widest gap of a joint.

const _APART_M: float = 1.8
const _TOGETHER_M: float = 0.12
const _TURN_RAD: float = 1.2
## When they are together, have closed the arms, have turned, opened the arms, and parted, s.
const _MEET_S: float = 1.2
const _CLOSED_S: float = 1.8
const _TURNED_S: float = 2.8
const _OPEN_S: float = 3.3
const _PARTED_S: float = 4.5
const _END_S: float = 6.5
const _LIMIT_DEG: float = 3.0
const _GOAL_MS: float = 500.0

var _late_s: float = 0.0
var _kept_m: float = 0.0


func play(p_performer: ContactPerformer) -> void:
	var world: ContactWorld = make_world()
	for number: int in 2:
		var person: ContactPerson = p_performer.enter(world, root)
		var pose: Callable = func(time: float) -> PoseSample:
			return ContactPoses.hug(person, _closed(time), _heading(time, number))
		var place: Callable = func(time: float) -> Vector3:
			var away: Vector3 = Vector3.FORWARD * _distance(time) / 2.0
			return person.standing_hips() + away.rotated(Vector3.UP, _heading(time, number))
		world.add_person(person, pose, place)
	_late_s = _PARTED_S
	_kept_m = 0.0
	await world.run(_END_S, _watch.bind(world))
	var case: String = name_case("hug", p_performer)
	report.at_most(case, "time until < 3 deg", (_late_s - _PARTED_S) * 1000.0, "ms", _GOAL_MS)
	report.add(case, "kept away", _kept_m * 1000.0, "mm")
	report.add(case, "joint gap", world.widest_gap * 1000.0, "mm")
	await end_world(world)


func _watch(p_world: ContactWorld) -> bool:
	for person: ContactPerson in p_world.people:
		var wanted: Array[Transform3D] = person.targets_at(p_world.time_s)
		var bodies: Array[Transform3D] = person.bodies()
		_kept_m = maxf(_kept_m, bodies[0].origin.distance_to(wanted[0].origin))
		var error: float = person.worst_error_deg(bodies, wanted)
		if p_world.time_s > _PARTED_S and error >= _LIMIT_DEG:
			_late_s = p_world.time_s + p_world.delta_s
	return false


func _distance(p_time_s: float) -> float:
	var near: float = ContactPoses.smooth(p_time_s / _MEET_S)
	near -= ContactPoses.smooth((p_time_s - _OPEN_S) / (_PARTED_S - _OPEN_S))
	return lerpf(_APART_M, _TOGETHER_M, near)


func _closed(p_time_s: float) -> float:
	var closed: float = ContactPoses.smooth((p_time_s - _MEET_S) / (_CLOSED_S - _MEET_S))
	return closed - ContactPoses.smooth((p_time_s - _TURNED_S) / (_OPEN_S - _TURNED_S))


func _heading(p_time_s: float, p_number: int) -> float:
	var turned: float = ContactPoses.smooth((p_time_s - _CLOSED_S) / (_TURNED_S - _CLOSED_S))
	return PI * p_number + _TURN_RAD * turned
