extends TestCase
## What a client makes of fields and events: it shows shots and hits, and simulates none.

const ClientHost: GDScript = preload("res://tests/entity/client_host.gd")

var _ground: VehicleGround = null
var _tank: Vehicle = null
var _entity: Entity = null


func before_each() -> void:
	_ground = VehicleGround.new(self)
	_ground.add_floor()
	_tank = VehicleGround.create("tank")
	_tank.freeze = true
	_ground.view.add_child(_tank)
	_entity = _tank.get_node("Entity")
	var host: ClientHost = ClientHost.new()
	_entity.start(host, 2000, _entity.type.spawn_schema().defaults())


func after_each() -> void:
	_ground.free_all()


func test_the_guns_state_is_the_servers() -> void:
	var gun: VehicleGun = _tank.get_node("Turret/Gun/Muzzle/MainGun")
	equal(gun.loaded, 1.0)
	_take(&"loaded", 0.35)
	_take(&"ammunition", 1.0)
	_take(&"rounds", 7.0)
	almost_equal(gun.loaded, 0.35, 1e-5)
	equal(gun.chosen, 1)
	equal(gun.rounds(), 7)
	await _ground.run(1.0)
	almost_equal(gun.loaded, 0.35, 1e-5, "only the server loads")


func test_a_shot_is_shown_and_flown_by_nobody_here() -> void:
	var gun: VehicleGun = _tank.get_node("Turret/Gun/Muzzle/MainGun")
	var shells: Shells = _tank.get_node("Shells")
	var shots: Array[Vector3] = []
	gun.fired.connect(
		func(_kind: Ammunition, p_at: Vector3, p_velocity: Vector3) -> void:
			shots.append_array([p_at, p_velocity])
	)
	var hits: Array[StringName] = []
	shells.struck.connect(
		func(_at: Vector3, _normal: Vector3, p_surface: StringName, _by: Ammunition) -> void:
			hits.append(p_surface)
	)
	_happen(Shells.FIRED, [1.0, 0.0, 2.0, -7.0, 0.0, 0.0, 1140.0])
	equal(shots.size(), 2)
	almost_equal(shots[1], Vector3(0.0, 0.0, -1140.0), 0.1)
	equal(shells.flying().size(), 0)
	var sand: int = Shells.number_of(&"sand")
	_happen(Shells.IMPACT, [1.0, 5.0, 0.0, -90.0, 0.0, PI / 2.0, sand, Shells.Struck.GROUND])
	equal(hits, [&"sand"] as Array[StringName])
	# Of a server with another type.
	_entity.happened.emit(Shells.FIRED, [-1.0, 0.0, 2.0, -7.0, 0.0, 0.0, 1140.0])
	_entity.happened.emit(Shells.FIRED, [1.0])
	_entity.happened.emit(Shells.IMPACT, [99.0, 0.0, 2.0, -7.0, 0.0, 0.0, 1.0, 0.0])
	equal([shots.size(), hits.size()], [2, 1])


func test_a_machine_gun_is_shown_while_its_field_says_so() -> void:
	var coax: VehicleGun = _tank.get_node("Turret/Gun/Coax/CoaxGun")
	var rounds: Array[int] = [0]
	coax.fired.connect(
		func(_kind: Ammunition, _at: Vector3, _velocity: Vector3) -> void: rounds[0] += 1
	)
	_take(&"coax_firing", 1.0)
	await _ground.run(2.0)
	almost_equal(float(rounds[0]), 20.0, 3.0)
	_take(&"coax_firing", 0.0)
	var so_far: int = rounds[0]
	await _ground.run(1.0)
	equal(rounds[0], so_far)


func _take(p_field: StringName, p_value: float) -> void:
	_entity.take_value(_entity.type.find_field(p_field), p_value)


## An event as it comes from the wire.
func _happen(p_event: StringName, p_values: PackedFloat32Array) -> void:
	var index: int = _entity.type.find_event(p_event)
	var schema: EntitySchema = _entity.type.events[index]
	_entity.take_event(index, schema.decode(ByteReader.new(schema.encode(p_values))))
