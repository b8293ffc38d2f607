extends RefCounted
## A walker's body at the server, in physics: a person of [ServerPeople], driven by a
## [ServerWalker], whose client agrees with the server. Godot's frame; m, s, rad.

const PERSON: PackedScene = preload("res://scenes/actor/person.tscn")
const TICK_S: float = 1.0 / 60.0
## A stride of two steps, about.
const STRIDE_TICKS: int = 42

## The walker, and its person.
var walker: ServerWalker = null
var person: ServerPerson = null
## How far the body's hips are from the walker's feet, over the ground, m, in each tick.
var distances: Statistics = Statistics.new()
## How far the body faces from where the walker does, rad: on average over a stride, as shoulders
## turn to and fro with each step, and in each tick.
var headings: Statistics = Statistics.new()
var shoulders: Statistics = Statistics.new()
## How fast feet move that are on the ground, m/s.
var skates: Statistics = Statistics.new()
## Ticks in which physics had the body.
var down_ticks: int = 0
## The tick that was made last.
var tick: int = 0

var _people: ServerPeople = ServerPeople.new()
var _feet: PackedVector3Array = []
var _turns: PackedFloat32Array = []


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
	var limbs: Array[PhysicsBody3D] = person.ragdoll.get_limb_nodes()
	var feet: PackedVector3Array = [
		limbs[Limbs.LEFT_FOOT].global_position, limbs[Limbs.RIGHT_FOOT].global_position
	]
	if is_down or tick < 60:
		_feet = feet
		_turns.clear()
		return
	# The shoulders say where one faces.
	var left: Vector3 = (
		limbs[Limbs.LEFT_UPPER_ARM].global_position - limbs[Limbs.RIGHT_UPPER_ARM].global_position
	)
	var facing: Vector3 = left.cross(Vector3.UP)
	var heading: float = walker.mover.get_heading()
	_turns.append(angle_difference(atan2(facing.x, facing.z), heading))
	shoulders.add(absf(_turns[-1]))
	if _turns.size() == STRIDE_TICKS:
		var sum: float = 0.0
		for turn: float in _turns:
			sum += turn
		headings.add(absf(sum / STRIDE_TICKS))
		_turns.remove_at(0)
	var apart: Vector3 = person.hips() - walker.mover.get_position()
	distances.add(Vector2(apart.x, apart.z).length())
	for foot: int in 2:
		var low: float = feet[foot].y - walker.mover.get_position().y
		if low < 0.06 and not _feet.is_empty():
			var moved: Vector3 = (feet[foot] - _feet[foot]) / TICK_S
			skates.add(Vector2(moved.x, moved.z).length())
	_feet = feet
