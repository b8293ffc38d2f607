class_name GroundWalks
extends RefCounted
## People with a known position on ground that is not as their own: slopes, stairs, a wall in the
## way, platforms.

const Walker: GDScript = preload("../gait/walker.gd")
const _RISE: float = 0.17
const _TREAD: float = 0.29

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


## Walks on level ground in the wearer's room, on a slope in the world.
func slopes() -> void:
	for degrees: float in [0.0, 5.0, -5.0, 10.0, -10.0, 20.0, -20.0]:
		var world: ContactWorld = _enter_world()
		var tilt: Basis = Basis(Vector3.RIGHT, deg_to_rad(-degrees))
		world.add_block(Vector3(20.0, 1.0, 60.0), Transform3D(tilt, -tilt.y * 0.5))
		var rise: float = tan(deg_to_rad(degrees))
		await _walk("slope %+d deg" % degrees, world, func(z: float) -> float: return rise * z)


## Climbs 16 stairs up and down, which the wearer's room has too.
func stairs() -> void:
	for rise: float in [_RISE, -_RISE]:
		var world: ContactWorld = _enter_world()
		var person: ContactPerson = _enter_person(world)
		var walker: Walker = Walker.new(person.ragdoll.profile)
		walker.climb(16, rise, _TREAD, 0.6)
		walker.build_ground(world)
		await _walk(
			"stairs %s" % ("up" if rise > 0.0 else "down"), world, walker.ground_at, person, walker
		)


## Walks three metres into a wall.
func wall() -> void:
	var world: ContactWorld = _enter_world()
	world.add_floor(0.0)
	world.add_block(Vector3(6.0, 4.0, 0.3), Transform3D(Basis(), Vector3(0.0, 2.0, 3.15)))
	var person: ContactPerson = _enter_person(world)
	var walker: Walker = _walker(person)
	_play(world, person, walker)
	var deepest: Array[float] = [0.0]
	var seen: Dictionary = {"falls": 0, "phase": 0}
	await world.run(
		walker.duration,
		func() -> bool:
			var bodies: Array[Transform3D] = person.bodies()
			for limb: int in person.count:
				deepest[0] = maxf(deepest[0], person.reach(limb, bodies[limb], Vector3.BACK) - 3.0)
			_count_falls(person, seen)
			return false
	)
	_report.at_most("wall", "deepest limb", 1000.0 * deepest[0], "mm", 30.0)
	_report.at_most("wall", "falls", seen.falls, "", 0.0)
	world.queue_free()


## Walks through a doorway whose door is shut, stands half open towards the person, or away.
func doors() -> void:
	for ajar: float in [0.0, 40.0, -40.0]:
		for right: bool in [false, true]:
			var world: ContactWorld = _enter_world()
			world.add_floor(0.0)
			for side: float in [-1.0, 1.0]:
				var place: Vector3 = Vector3(side * 2.075, 1.5, 3.0)
				world.add_block(Vector3(3.0, 3.0, 0.35), Transform3D(Basis(), place))
			var door: Door = Door.new()
			door.ajar = ajar
			door.right_hinge = right
			door.size = Vector2(1.02, 2.1)
			# Its front looks to who comes.
			door.rotation.y = PI
			door.position = Vector3(-0.51 if right else 0.51, 0.0, 3.0)
			world.add_child(door)
			var name: String = "door %d deg ajar, hinge %s" % [ajar, "right" if right else "left"]
			await _walk(name, world, func(_z: float) -> float: return 0.0)
			_report.at_least(name, "pushed open", door.angle(), "deg", 60.0)


## Stands and walks on what moves.
func platforms() -> void:
	for kind: String in GroundPlatform.KINDS:
		for away: float in [1.0, 3.0]:
			var platform: GroundPlatform = _enter_platform(kind)
			await platform.stand(away)
			platform.tell(_report, "platform, %s, %.0f m from its middle" % [kind, away])
		var deck: GroundPlatform = _enter_platform(kind)
		await deck.walk(_walker(deck.person))
		deck.tell(_report, "platform, %s, walking" % kind)


func _enter_platform(p_kind: String) -> GroundPlatform:
	var world: ContactWorld = _enter_world()
	return GroundPlatform.new(world, _enter_person(world), p_kind)


func _walk(
	p_case: String,
	p_world: ContactWorld,
	p_ground: Callable,
	p_person: ContactPerson = null,
	p_walker: Walker = null
) -> void:
	var person: ContactPerson = p_person if p_person != null else _enter_person(p_world)
	var walker: Walker = p_walker if p_walker != null else _walker(person)
	_play(p_world, person, walker)
	var seen: Dictionary = {"high": -INF, "low": INF, "end": Vector3.ZERO, "falls": 0, "phase": 0}
	var own: float = walker.pose_at(0.0).root.y
	await p_world.run(
		walker.duration,
		func() -> bool:
			var hips: Vector3 = person.joint(0, person.bodies())
			var over: float = hips.y - _ground_under(person, hips, p_ground.call(hips.z)) - own
			seen.high = maxf(seen.high, over)
			seen.low = minf(seen.low, over)
			seen.end = hips
			_count_falls(person, seen)
			return false
	)
	var wrong: Vector2 = Vector2(seen.end.x, seen.end.z - walker.way)
	var off: float = 100.0 * wrong.length() / walker.way
	_report.at_most(p_case, "off the way at the end", off, "% of the way", 8.0)
	_report.at_most(p_case, "hips too high at most", seen.high, "m", 0.4)
	_report.add(p_case, "hips too low at most", -seen.low, "m")
	_report.at_most(p_case, "falls", seen.falls, "", 0.0)
	p_world.queue_free()


## Height of what is under the hips, crates too, m.
func _ground_under(p_person: ContactPerson, p_hips: Vector3, p_else: float) -> float:
	var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		p_hips, p_hips + Vector3.DOWN * 3.0, PhysicsLayers.STATIC | PhysicsLayers.PROPS
	)
	var hit: Dictionary = p_person.ragdoll.get_world_3d().direct_space_state.intersect_ray(query)
	return maxf(hit.position.y, p_else) if not hit.is_empty() else p_else


## Counts how often a person begins to fall.
static func _count_falls(p_person: ContactPerson, r_seen: Dictionary) -> void:
	var phase: int = p_person.ragdoll.motor.get_balance().get("phase", 0)
	if phase == RagdollMotor.BALANCE_FALLING and r_seen.phase != phase:
		r_seen.falls += 1
	r_seen.phase = phase


func _enter_world() -> ContactWorld:
	var world: ContactWorld = ContactWorld.new(_hz)
	_tree.root.add_child(world)
	return world


func _enter_person(p_world: ContactWorld) -> ContactPerson:
	return _performer.enter(p_world, _root)


func _walker(p_person: ContactPerson) -> Walker:
	var walker: Walker = Walker.new(p_person.ragdoll.profile)
	walker.walk(12, 0.6, 0.55)
	return walker


func _play(p_world: ContactWorld, p_person: ContactPerson, p_walker: Walker) -> void:
	p_world.add_person(
		p_person, p_walker.pose_at, func(t: float) -> Vector3: return p_walker.pose_at(t).root
	)
