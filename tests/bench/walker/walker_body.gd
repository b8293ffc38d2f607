extends RefCounted
## A walker's body at the server, in physics: a person of [ServerPeople], driven by a
## [ServerWalker], whose client agrees with the server. Godot's frame; m, s, rad.

const PERSON: PackedScene = preload("res://scenes/actor/person.tscn")
const TICK_S: float = 1.0 / 60.0
## Ticks before which a body has not settled, and of a stride of two steps, about.
const SETTLING: int = 90
const STRIDE_TICKS: int = 42

## The walker, and its person.
var walker: ServerWalker = null
var person: ServerPerson = null
## How far the body's hips are from the walker's feet, over the ground, m, in each tick.
var distances: Statistics = Statistics.new()
## How far the chest faces from where the walker does, rad, on average over a stride.
var headings: Statistics = Statistics.new()
## Whether soles slide on level ground.
var slide: SoleSlide = SoleSlide.new()
## Ticks in which physics had the body.
var down_ticks: int = 0
## The tick that was made last.
var tick: int = 0

var _people: ServerPeople = ServerPeople.new()
var _window: PackedFloat32Array = []


## Somebody who stands at a place of a world.
func _init(p_view: SubViewport, p_at: Vector3) -> void:
	_people.scene = PERSON
	_people.root_mode = RagdollMotor.ROOT_GROUNDED
	_people.setup(EntityTable.new())
	p_view.add_child(_people)
	_people.enter([Transform3D(Basis.IDENTITY, p_at)])
	_people.enlist(PersonCard.of("walker", 0.95), "walker")
	_people.settle()
	person = _people.list()[0]
	person.stand_at(Transform3D(Basis.IDENTITY, p_at))
	walker = ServerWalker.new(person)
	var world: World3D = p_view.find_world_3d()
	walker.mover.enter(world.space, world, WalkerBodies.MASK)


## A tick, before the physics step, by what the user wishes.
func advance(p_input: WalkerInput) -> void:
	p_input.check = walker.mover.get_check()
	walker.take(p_input.to_values())
	advance_silent()


## A tick in which nothing comes from the client.
func advance_silent() -> void:
	tick += 1
	var now_s: float = tick * TICK_S
	_people.measure()
	_measure()
	walker.advance(tick, now_s, TICK_S)
	_people.advance()
	_people.drive(now_s, TICK_S)


## Ends it.
func free_all() -> void:
	_people.queue_free()


func _measure() -> void:
	var is_down: bool = walker.mover.get_mode() == WalkerMover.BODY
	down_ticks += int(is_down)
	if is_down or tick < SETTLING:
		slide.begin()
		_window.clear()
		return
	var apart: Vector3 = person.hips() - walker.mover.get_position()
	distances.add(Vector2(apart.x, apart.z).length())
	slide.look(_find_soles(), TICK_S)
	_measure_heading()


func _measure_heading() -> void:
	var limbs: Array[PhysicsBody3D] = person.ragdoll.get_limb_nodes()
	# The shoulders say where one faces.
	var left: Vector3 = (
		limbs[Limbs.LEFT_UPPER_ARM].global_position - limbs[Limbs.RIGHT_UPPER_ARM].global_position
	)
	var facing: Vector3 = left.cross(Vector3.UP)
	_window.append(angle_difference(walker.mover.get_heading(), atan2(facing.x, facing.z)))
	if _window.size() < STRIDE_TICKS:
		return
	var sum: float = 0.0
	for angle: float in _window:
		sum += angle
	headings.add(absf(sum / STRIDE_TICKS))
	_window.remove_at(0)


## The points of both soles, as [SoleSlide] looks at them, m.
func _find_soles() -> PackedVector3Array:
	var soles: PackedVector3Array = []
	for bone: int in [Limbs.LEFT_FOOT, Limbs.RIGHT_FOOT]:
		var foot: RagdollLimb = person.ragdoll.profile.find(Limbs.BONES[bone])
		var at: Transform3D = person.ragdoll.get_limb_nodes()[bone].global_transform
		for point: Vector3 in foot.contact_points:
			soles.append(at * (foot.rest_orientation.inverse() * (point - foot.position)))
	return soles
