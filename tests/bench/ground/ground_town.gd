class_name GroundTown
extends RefCounted
## People who walk through the doors of a town's houses, over their landings, through their rooms
## and up their stairs, while their wearers walk straight on over level ground.
##
## Each is in the town as a client's person is: turned to where the way goes, on what is there.

const Walker: GDScript = preload("../gait/walker.gd")
## Who is nearer than this to the end of the way has come through, m, and no further above or below.
const NEAR_M: float = 0.6
const LEVEL_M: float = 0.3
## Length of a step at most, m, and how long it takes, s.
const STEP_M: float = 0.6
const STEP_S: float = 0.6
## Only so many of those who failed are named, for each kind of way.
const NAMED: int = 40


## Somebody on a way.
class Person:
	extends RefCounted
	var way: TownWays.Way = null
	var body: ContactPerson = null
	var walker: RefCounted = null
	var falls: int = 0
	var phase: int = 0
	## Lowest that the hips were over where they are to be, m.
	var low: float = 0.0
	## Bodies that the person touched where the way ends.
	var touched: PackedStringArray = []


var _tree: SceneTree = null
var _report: BenchReport = null
var _hz: int = 60
var _root: RagdollMotor.RootMode = RagdollMotor.ROOT_GROUNDED
var _performer: ContactPerformer = null
var _prints: bool = false


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


## Walks all ways of a world's houses. [param p_prints]: who touches what, second by second.
func run(p_world: String, p_prints: bool) -> void:
	_prints = p_prints
	for kind: String in TownWays.KINDS:
		var world: ContactWorld = ContactWorld.new(_hz)
		_tree.root.add_child(world)
		var level: Level = LevelStore.instantiate(p_world)
		if level == null:
			_report.leave_out(p_world, LevelStore.describe_missing(p_world))
			world.queue_free()
			return
		world.add_child(level)
		await _walk(world, level, kind)
		world.queue_free()
		await _tree.process_frame


func _walk(p_world: ContactWorld, p_level: Level, p_kind: String) -> void:
	var people: Array[Person] = []
	var longest: float = 0.0
	for way: TownWays.Way in TownWays.of(p_level):
		if way.kind == p_kind:
			people.append(_enter(p_world, way))
			longest = maxf(longest, people[-1].walker.get(&"duration"))
	await p_world.run(longest, _note.bind(p_world, people))
	_tell(p_kind, people)


func _enter(p_world: ContactWorld, p_way: TownWays.Way) -> Person:
	var person: Person = Person.new()
	person.way = p_way
	person.body = _performer.enter(p_world, _root)
	var walker: Walker = Walker.new(person.body.ragdoll.profile)
	var steps: int = ceili(p_way.length / STEP_M)
	walker.walk(steps, p_way.length / steps, STEP_S)
	person.walker = walker
	p_world.add_person(
		person.body, walker.pose_at, func(t: float) -> Vector3: return walker.pose_at(t).root
	)
	person.body.ragdoll.motor.set_frame(p_way.start)
	return person


func _note(p_world: ContactWorld, p_people: Array[Person]) -> bool:
	for person: Person in p_people:
		var phase: int = person.body.ragdoll.motor.get_balance().get("phase", 0)
		if phase == RagdollMotor.BALANCE_FALLING and person.phase != phase:
			person.falls += 1
		person.phase = phase
		if _prints and roundi(p_world.time_s * _hz) % _hz == 0:
			var hips: Vector3 = person.way.start.affine_inverse() * _hips(person)
			var line: String = "%.1f s %s: %.2f m along, %.2f aside, %.2f high%s; %s"
			var fallen: String = ", falling" if phase == RagdollMotor.BALANCE_FALLING else ""
			var at: PackedStringArray = _touched(person)
			print(
				(
					line
					% [
						p_world.time_s,
						person.way.name,
						hips.z,
						hips.x,
						hips.y,
						fallen,
						", ".join(at)
					]
				)
			)
	return false


func _hips(p_person: Person) -> Vector3:
	return p_person.body.joint(0, p_person.body.bodies())


func _tell(p_kind: String, p_people: Array[Person]) -> void:
	var arrived: int = 0
	var falls: int = 0
	var worst: float = 0.0
	var failed: int = 0
	for person: Person in p_people:
		var off: Vector3 = _hips(person) - person.way.end
		off.y -= (person.walker.call(&"pose_at", 0.0) as PoseSample).root.y
		var far: float = Vector2(off.x, off.z).length()
		var is_there: bool = far <= NEAR_M and absf(off.y) <= LEVEL_M
		arrived += 1 if is_there else 0
		falls += person.falls
		worst = maxf(worst, far)
		if (is_there and person.falls == 0) or failed >= NAMED:
			continue
		failed += 1
		var near: String = ", ".join(_touched(person))
		var case: String = "%s (at the end near %s)" % [person.way.name, near]
		_report.add(case, "off the end of the way", far, "m")
		_report.add(case, "too high", off.y, "m")
		_report.add(case, "falls", person.falls, "")
	_report.add(p_kind, "people", p_people.size(), "")
	var share: float = 100.0 * arrived / maxi(p_people.size(), 1)
	_report.add(p_kind, "come through", share, "%", BenchReport.Goal.AT_LEAST, 100.0)
	_report.add(p_kind, "falls", falls, "", BenchReport.Goal.AT_MOST, 0.0)
	_report.add(p_kind, "furthest off the end", worst, "m")


## What is within reach around a person's hips and knees, by the names of the nodes.
func _touched(p_person: Person) -> PackedStringArray:
	var names: PackedStringArray = []
	var shape: CylinderShape3D = CylinderShape3D.new()
	shape.radius = 0.4
	shape.height = 1.5
	var query: PhysicsShapeQueryParameters3D = PhysicsShapeQueryParameters3D.new()
	query.shape = shape
	query.transform.origin = _hips(p_person)
	query.collision_mask = PhysicsLayers.STATIC | PhysicsLayers.PROPS
	var space: PhysicsDirectSpaceState3D = p_person.body.ragdoll.get_world_3d().direct_space_state
	for hit: Dictionary in space.intersect_shape(query):
		var node: Node = hit["collider"]
		var label: String = "%s:%d" % [node.name, hit["shape"]]
		if not names.has(label):
			names.append(label)
	return names
