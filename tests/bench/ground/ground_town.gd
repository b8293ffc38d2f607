class_name GroundTown
extends RefCounted
## People who walk through the doors of a town's houses, over their landings, through their rooms
## and up their stairs, while their wearers walk straight on over level ground.
##
## Each is in the town as a client's person is: turned to where the way goes, on what is there. A
## wearer who is held back walks on, up to twice the way: who sees that he is not there yet does.

const Walker: GDScript = preload("../gait/walker.gd")
## Who is nearer than this to the end of the way has come through, m, and no further above or below.
const NEAR_M: float = 0.6
const LEVEL_M: float = 0.3
## Length of a step at most, m, and how long it takes, s.
const STEP_M: float = 0.6
const STEP_S: float = 0.6
## How much further than the way wearers walk at most.
const FURTHER: float = 2.0
## So many people are there at once, as in a session.
const AT_ONCE: int = 8


## Somebody on a way.
class Person:
	extends RefCounted
	var way: TownWays.Way = null
	var body: ContactPerson = null
	var walker: RefCounted = null
	var falls: int = 0
	var phase: int = 0
	## When the end was reached, s; INF: not at all.
	var arrived_s: float = INF


var _tree: SceneTree = null
var _report: BenchReport = null
var _hz: int = 60
var _root: RagdollMotor.RootMode = RagdollMotor.ROOT_GROUNDED
var _performer: ContactPerformer = null


func _init(
	p_tree: SceneTree,
	p_report: BenchReport,
	p_hz: int,
	p_root: RagdollMotor.RootMode,
	p_performer: ContactPerformer
) -> void:
	_tree = p_tree
	_report = p_report
	_hz = p_hz
	_root = p_root
	_performer = p_performer


## Walks all ways of a kind through a world's houses.
func run(p_world: String, p_kind: String) -> void:
	var level: Level = LevelStore.instantiate(p_world)
	if level == null:
		_report.leave_out(p_world, LevelStore.describe_missing(p_world))
		return
	var world: ContactWorld = ContactWorld.new(_hz)
	_tree.root.add_child(world)
	world.add_child(level)
	await _walk(world, level, p_kind)
	world.queue_free()
	await _tree.process_frame


func _walk(p_world: ContactWorld, p_level: Level, p_kind: String) -> void:
	var ways: Array[TownWays.Way] = TownWays.of(p_level).filter(
		func(way: TownWays.Way) -> bool: return way.kind == p_kind
	)
	var people: Array[Person] = []
	for first: int in range(0, ways.size(), AT_ONCE):
		var group: Array[Person] = []
		var longest: float = 0.0
		for way: TownWays.Way in ways.slice(first, first + AT_ONCE):
			group.append(_enter(p_world, way))
			longest = maxf(longest, group[-1].walker.get(&"duration"))
		var begin_s: float = p_world.time_s
		await p_world.run(longest, _note.bind(p_world, group, begin_s))
		for person: Person in group:
			p_world.people.erase(person.body)
			person.body.ragdoll.free()
		people.append_array(group)
	_tell(p_kind.replace("_", " "), people)


func _enter(p_world: ContactWorld, p_way: TownWays.Way) -> Person:
	var person: Person = Person.new()
	person.way = p_way
	person.body = _performer.enter(p_world, _root)
	var walker: Walker = Walker.new(person.body.ragdoll.profile)
	var steps: int = ceili(p_way.length / STEP_M)
	walker.walk(ceili(steps * FURTHER), p_way.length / steps, STEP_S)
	person.walker = walker
	var begin_s: float = p_world.time_s
	p_world.add_person(
		person.body,
		func(t: float) -> PoseSample: return walker.pose_at(t - begin_s),
		func(t: float) -> Vector3: return walker.pose_at(t - begin_s).root
	)
	person.body.ragdoll.motor.set_frame(p_way.start)
	return person


func _note(p_world: ContactWorld, p_people: Array[Person], p_begin_s: float) -> bool:
	var now_s: float = p_world.time_s - p_begin_s
	var is_done: bool = true
	for person: Person in p_people:
		var balance: Dictionary = person.body.ragdoll.motor.get_balance()
		var phase: int = balance.get("phase", 0)
		if phase == RagdollMotor.BALANCE_FALLING and person.phase != phase:
			person.falls += 1
		person.phase = phase
		var hips: Vector3 = person.body.joint(0, person.body.bodies())
		_see(person, hips, now_s)
		is_done = is_done and not is_inf(person.arrived_s)
	return is_done


func _see(p_person: Person, p_hips: Vector3, p_now_s: float) -> void:
	var stands: float = (p_person.walker.call(&"pose_at", 0.0) as PoseSample).root.y
	var off: Vector3 = p_hips - p_person.way.end - Vector3.UP * stands
	if Vector2(off.x, off.z).length() <= NEAR_M and absf(off.y) <= LEVEL_M:
		p_person.arrived_s = minf(p_person.arrived_s, p_now_s)


func _tell(p_kind: String, p_people: Array[Person]) -> void:
	var arrived: int = 0
	var falls: int = 0
	var walked: float = 0.0
	for person: Person in p_people:
		falls += person.falls
		if not is_inf(person.arrived_s):
			arrived += 1
			var pose: PoseSample = person.walker.call(&"pose_at", person.arrived_s)
			walked += (pose.root.z + NEAR_M) / person.way.length
		if is_inf(person.arrived_s) or person.falls > 0:
			printerr(
				(
					"%s: falls %d, arrives after %.1f s"
					% [person.way.name, person.falls, person.arrived_s]
				)
			)
	var share: float = 100.0 * arrived / maxi(p_people.size(), 1)
	_report.at_least(p_kind, "ways", p_people.size(), "", 15.0)
	_report.at_least(p_kind, "come through", share, "%", 100.0)
	_report.at_most(p_kind, "falls", falls, "", 0.0)
	var more: float = 100.0 * walked / maxi(arrived, 1)
	_report.add(p_kind, "wearers walk for it, mean", more, "% of the way")
