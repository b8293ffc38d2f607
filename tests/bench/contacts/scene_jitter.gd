extends ContactScene
## Poses of a clip that are held: how much the limbs tremble, in the air and with the soles pressed
## into the floor.
##
## The figure is the angle that limbs turn from step to step, as a speed; mean over all limbs, steps
## and poses from [constant _SETTLE_S] on.

const _GOAL_DEG_S: float = 0.1
const _POSES: int = 8
const _SETTLE_S: float = 1.0
const _MEASURE_S: float = 2.0
const _PRESSED_M: float = 0.01


func play(p_performer: ContactPerformer) -> void:
	for on_floor: bool in [false, true]:
		var speeds: Statistics = Statistics.new()
		for number: int in _POSES:
			var moment: float = p_performer.duration() * (number + 0.5) / _POSES
			await _hold(p_performer, moment, on_floor, speeds)
		var case: String = name_case("jitter on floor" if on_floor else "jitter", p_performer)
		report.at_most(case, "mean", speeds.mean(), "deg/s", _GOAL_DEG_S)
		report.add(case, "p99", speeds.percentile(0.99), "deg/s")


func _hold(
	p_performer: ContactPerformer, p_moment: float, p_on_floor: bool, p_speeds: Statistics
) -> void:
	var world: ContactWorld = make_world()
	var person: ContactPerson = p_performer.enter(world, root)
	var pose: PoseSample = p_performer.source.pose_at(p_moment)
	var hips: Vector3 = p_performer.hips_at(p_moment, person)
	if p_on_floor:
		world.add_floor(person.lowest(person.targets(pose, hips)) + _PRESSED_M)
	world.add_standing(person, pose, hips)
	await world.run(_SETTLE_S)
	await world.run(_MEASURE_S, jitter_meter(world, p_speeds))
	await end_world(world)


## Notes the turn of every limb of the first person from step to step, as deg/s.
static func jitter_meter(p_world: ContactWorld, p_speeds: Statistics) -> Callable:
	var last: Array[Array] = [p_world.people[0].bodies()]
	return func() -> bool:
		var bodies: Array[Transform3D] = p_world.people[0].bodies()
		for i: int in bodies.size():
			var turn: float = ContactPerson.angle_deg(last[0][i].basis, bodies[i].basis)
			p_speeds.add(turn / p_world.delta_s)
		last[0] = bodies
		return false
