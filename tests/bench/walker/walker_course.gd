extends RefCounted
## What a walker is tried on: boxes, stairs, slopes and corners that never move, and a door, a
## turntable and a truck that do, by the tick, whether physics runs or not. Godot's frame; m, rad.

## Heights of the steps and how deep they are, m, and how many.
const STEP_M: float = 0.17
const TREAD_M: float = 0.3
const STEPS: int = 16
## Where things are, m.
const STAIRS: Vector3 = Vector3(70.0, 0.0, 0.0)
const SLOPE: Vector3 = Vector3(90.0, 0.0, 0.0)
const CORNERS: Vector3 = Vector3(-80.0, 0.0, 0.0)
## Where nothing is around.
const OPEN: Vector3 = Vector3(120.0, 0.0, -60.0)
## Half the side of the room with the corners, m.
const ROOM_M: float = 4.0
## Numbers of what moves.
const TURNTABLE: int = 2000
const TRUCK: int = 2001
const DOOR: int = 2002

## The world it is in.
var view: SubViewport = SubViewport.new()

var _moving: Dictionary[int, StaticBody3D] = {}
var _chance: RandomNumberGenerator = RandomNumberGenerator.new()


## Builds it by a seed, below a node.
func _init(p_seed: int, p_parent: Node) -> void:
	_chance.seed = p_seed
	view.own_world_3d = true
	p_parent.add_child(view)
	_box(Vector3(300.0, 1.0, 300.0), Transform3D(Basis.IDENTITY, Vector3(0.0, -0.5, 0.0)))
	for index: int in 150:
		_add_clutter(index)
	for index: int in STEPS:
		var height: float = STEP_M * (index + 1)
		var at: Vector3 = Vector3(0.0, height / 2.0, 3.0 + index * TREAD_M)
		_box(Vector3(2.0, height, TREAD_M), Transform3D(Basis.IDENTITY, STAIRS + at))
	var top: Vector3 = Vector3(0.0, STEP_M * STEPS / 2.0, 3.0 + STEPS * TREAD_M + 3.85)
	_box(Vector3(2.0, STEP_M * STEPS, 8.0), Transform3D(Basis.IDENTITY, STAIRS + top))
	var lean: Basis = Basis(Vector3.RIGHT, deg_to_rad(-45.0))
	_box(Vector3(4.0, 1.0, 12.0), Transform3D(lean, SLOPE + lean * Vector3(0.0, -0.5, 6.0)))
	_add_room()
	_add_moving(TURNTABLE, Vector3(8.0, 0.4, 8.0), Vector3(12.0, 0.2, 0.0))
	_add_moving(TRUCK, Vector3(3.0, 0.6, 8.0), Vector3(-12.0, 0.3, 0.0))
	_add_moving(DOOR, Vector3(1.0, 2.1, 0.06), Vector3(0.0, 1.05, 3.0))


## Moves what moves to where it is in a tick.
func set_tick(p_tick: int) -> void:
	var s: float = p_tick / 60.0
	var turned: Basis = Basis(Vector3.UP, 0.5 * s)
	_place(TURNTABLE, Transform3D(turned, Vector3(12.0, 0.2, 0.0)))
	var along: Basis = Basis(Vector3.UP, 0.3 * sin(s / 3.0))
	_place(TRUCK, Transform3D(along, Vector3(-12.0, 0.3, 12.0 * sin(s / 3.0))))
	var opened: Basis = Basis(Vector3.UP, 1.2 + 1.2 * sin(s))
	_place(DOOR, Transform3D(opened, Vector3(0.0, 1.05, 3.0) + opened * Vector3(0.5, 0.0, 0.0)))


## Somebody who walks in it.
func mover() -> WalkerMover:
	var made: WalkerMover = WalkerMover.new()
	var world: World3D = view.find_world_3d()
	made.enter(world.space, world, WalkerBodies.MASK)
	for number: int in _moving:
		made.set_carrier(_moving[number].get_rid(), number)
	return made


## Inputs of somebody who changes his mind, by a seed: runs, stops, crouches, lies and jumps.
static func inputs(p_seed: int, p_ticks: int) -> Array[WalkerInput]:
	var chance: RandomNumberGenerator = RandomNumberGenerator.new()
	chance.seed = p_seed
	var schema: EntitySchema = walk_schema()
	var made: Array[WalkerInput] = []
	var now: WalkerInput = WalkerInput.new()
	for tick: int in p_ticks:
		if tick % 40 == 0:
			now = WalkerInput.new()
			now.wish = Vector2.from_angle(chance.randf() * TAU) * chance.randf() * 6.0
			now.heading = chance.randf_range(-PI, PI)
			now.stance = ((chance.randi() % 3 if chance.randf() < 0.3 else 0) as WalkerMover.Stance)
		now.jumps = chance.randf() < 0.02
		made.append(now.rounded(schema))
	return made


## The form of the command.
static func walk_schema() -> EntitySchema:
	var type: EntityType = load("res://examples/03_health/person_type.tres")
	return type.commands[type.find_command(WalkerInput.COMMAND)]


func _add_clutter(p_index: int) -> void:
	var size: Vector3 = Vector3(
		_chance.randf_range(0.5, 6.0), _chance.randf_range(0.2, 3.0), _chance.randf_range(0.5, 6.0)
	)
	var turn: Basis = Basis(Vector3.UP, _chance.randf() * TAU)
	if p_index % 4 == 0:
		turn = turn * Basis(Vector3.RIGHT, _chance.randf_range(-0.5, 0.5))
	var angle: float = _chance.randf() * TAU
	var at: Vector3 = Vector3(cos(angle), 0.0, sin(angle)) * _chance.randf_range(18.0, 45.0)
	_box(size, Transform3D(turn, at + Vector3(0.0, size.y / 2.0, 0.0)))


## Walls with corners of 90 degrees and sharper ones, and pillars close to them.
func _add_room() -> void:
	for side: int in 4:
		var turn: Basis = Basis(Vector3.UP, side * PI / 2.0)
		var at: Vector3 = CORNERS + turn * Vector3(0.0, 1.5, ROOM_M + 0.25)
		_box(Vector3(2.0 * ROOM_M + 1.0, 3.0, 0.5), Transform3D(turn, at))
	for index: int in 10:
		var turn: Basis = Basis(Vector3.UP, _chance.randf() * TAU)
		var at: Vector3 = Vector3(
			_chance.randf_range(-ROOM_M, ROOM_M), 1.0, _chance.randf_range(-ROOM_M, ROOM_M)
		)
		_box(Vector3(_chance.randf_range(0.3, 2.0), 2.0, 0.3), Transform3D(turn, CORNERS + at))


func _add_moving(p_number: int, p_size: Vector3, p_at: Vector3) -> void:
	_moving[p_number] = _box(p_size, Transform3D(Basis.IDENTITY, p_at))


func _place(p_number: int, p_at: Transform3D) -> void:
	PhysicsServer3D.body_set_state(
		_moving[p_number].get_rid(), PhysicsServer3D.BODY_STATE_TRANSFORM, p_at
	)


func _box(p_size: Vector3, p_at: Transform3D) -> StaticBody3D:
	var body: StaticBody3D = StaticBody3D.new()
	body.add_child(BenchBodies.box(p_size))
	body.transform = p_at
	view.add_child(body)
	return body
