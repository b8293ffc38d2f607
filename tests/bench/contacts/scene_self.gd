extends ContactScene
## People who touch themselves: crossed arms, hands on hips, praying, crossed legs ... Each pose is
## entered within a second from standing and held; each seed has others.
##
## Reported while it is held: how deep limbs lie in one another, how far limbs are off from where
## they are driven to, and how much chest, head and hands tremble. How deep the motion itself goes,
## and by how much its limbs were turned, tells what there was to be done.

const _SEEDS: int = 3
const _ENTER_S: float = 1.0
const _SETTLE_S: float = 2.5
const _MEASURE_S: float = 1.5
const _GOAL_MM: float = 15.0
const _GOAL_DEG: float = 6.0
const _GOAL_DEG_S: float = 2.0
const _CALM: Array[StringName] = [&"Chest", &"Head", &"LeftHand", &"RightHand"]
const _NAMES: Dictionary[String, String] = {"depth": "mm", "error": "deg", "tremble": "deg/s"}

var _wanted: Statistics = null
var _entering: Statistics = null
var _turned: Statistics = null
var _results: Dictionary[String, Statistics] = {}
var _fallen: int = 0


func play(p_performer: ContactPerformer) -> void:
	_wanted = Statistics.new()
	_entering = Statistics.new()
	_turned = Statistics.new()
	for name: String in _NAMES:
		_results[name] = Statistics.new()
	_fallen = 0
	for name: String in OwnPoses.names():
		for number: int in _SEEDS:
			await _hold(p_performer, name, number)
	var case: String = name_case("self", p_performer)
	report.add(case, "depth of the motion, median", _wanted.percentile(0.5), "mm")
	report.add(case, "depth of the motion, worst", _wanted.percentile(1.0), "mm")
	report.add(case, "targets turned, worst limb, median", _turned.percentile(0.5), "deg")
	report.add(case, "depth on the way, worst", _entering.percentile(1.0), "mm")
	var goals: Dictionary[String, float] = {
		"depth": _GOAL_MM, "error": _GOAL_DEG, "tremble": _GOAL_DEG_S
	}
	for name: String in _NAMES:
		report.add(case, name + ", median", _results[name].percentile(0.5), _NAMES[name])
		report.at_most(
			case, name + ", worst", _results[name].percentile(1.0), _NAMES[name], goals[name]
		)
	report.at_most(case, "fallen", _fallen, "", 0.0)


func _hold(p_performer: ContactPerformer, p_name: String, p_number: int) -> void:
	var world: ContactWorld = make_world()
	var person: ContactPerson = p_performer.enter(world, root)
	var own: OwnLimbs = OwnLimbs.new(person)
	if root == RagdollMotor.ROOT_GROUNDED:
		world.add_floor(0.0)
	var pose: Callable = func(time: float) -> PoseSample:
		var share: float = ContactPoses.smooth((time - 0.3) / _ENTER_S)
		return OwnPoses.pose(person, p_name, p_number, share)
	var place: Callable = func(time: float) -> Vector3:
		return Vector3(0.0, -person.lowest(person.targets(pose.call(time), Vector3.ZERO)), 0.0)
	world.add_person(person, pose, place)
	await world.run(
		_ENTER_S + _SETTLE_S,
		func() -> bool:
			_entering.add(own.depth(person.bodies()) * 1000.0)
			return false
	)
	await _measure(world, person, own)
	await end_world(world)


func _measure(p_world: ContactWorld, p_person: ContactPerson, p_own: OwnLimbs) -> void:
	var deepest: Array[float] = [0.0]
	var error: Array[float] = [0.0]
	var squares: PackedFloat64Array = []
	squares.resize(p_person.count)
	await p_world.run(
		_MEASURE_S,
		func() -> bool:
			deepest[0] = maxf(deepest[0], p_own.depth(p_person.bodies()))
			for angle: float in p_person.ragdoll.motor.get_limb_errors():
				error[0] = maxf(error[0], angle)
			for i: int in p_person.count:
				squares[i] += p_person.spin_of(i).length_squared()
			return false
	)
	var tremble: float = 0.0
	for bone: StringName in _CALM:
		var mean: float = squares[p_person.find(bone)] / roundf(_MEASURE_S / p_world.delta_s)
		tremble = maxf(tremble, rad_to_deg(sqrt(mean)))
	var turned: float = 0.0
	for angle: float in p_person.ragdoll.motor.get_limb_clearances():
		turned = maxf(turned, angle)
	var wanted: Array[Transform3D] = p_person.targets_at(p_world.time_s)
	_wanted.add(p_own.depth(wanted) * 1000.0)
	_turned.add(rad_to_deg(turned))
	_results["depth"].add(deepest[0] * 1000.0)
	_results["error"].add(rad_to_deg(error[0]))
	_results["tremble"].add(tremble)
	if p_person.bodies()[0].origin.y < wanted[0].origin.y - 0.3:
		_fallen += 1
