extends TestCase
## What is known of a vehicle goes through fields, and comes from commands that make sense.

const PRESETS: Array[String] = ["tank", "carrier", "truck", "scootmobile"]

var _ground: VehicleGround = null


func before_each() -> void:
	_ground = VehicleGround.new(self)
	_ground.add_floor()


func after_each() -> void:
	_ground.free_all()


func test_every_preset_has_what_it_needs() -> void:
	for preset: String in PRESETS:
		var vehicle: Vehicle = VehicleGround.create(preset)
		var entity: Entity = Entity.find_in(vehicle)
		equal(entity.type.find_fault(), "", preset)
		var replication: VehicleReplication = vehicle.get_node(^"Replication")
		equal(replication._get_configuration_warnings(), PackedStringArray(), preset)
		is_true(ResourceLoader.exists(replication.view_scene), replication.view_scene)
		var indices: Array[int] = []
		for node: Node in vehicle.find_children("*", "", true, false):
			var seat: Seat = node as Seat
			if seat != null:
				equal(seat._get_configuration_warnings(), PackedStringArray(), str(seat.name))
				indices.append(seat.index)
		indices.sort()
		equal(indices, Array(range(indices.size()), TYPE_INT, &"", null), preset)
		vehicle.free()


func test_fields_say_what_the_vehicle_does() -> void:
	var tank: Vehicle = await _start("tank")
	var entity: Entity = Entity.find_in(tank)
	tank.input.throttle = 1.0
	await _ground.run(3.0)
	almost_equal(entity.get_value(&"left_speed"), tank.state.left_speed, 0.011)
	almost_equal(entity.get_value(&"rpm"), tank.state.rpm, 11.0)
	equal(entity.get_value(&"gear"), float(tank.state.gear))
	entity.take_command(1, entity.type.find_command(&"lamps"), [1.0])
	await _ground.run(0.1)
	equal([entity.get_value(&"lamps"), tank.state.lamps], [1.0, true])
	entity.take_command(1, entity.type.find_command(&"open_hatch"), [1.0])
	await _ground.run(1.0)
	equal(entity.get_value(&"hatch"), 1.0)
	entity.take_command(1, entity.type.find_command(&"engine"), [0.0])
	await _ground.run(0.1)
	equal(entity.get_value(&"engine_on"), 0.0)


func test_a_hatch_opens_for_whoever_takes_its_seat_and_shuts_on_nobody() -> void:
	var tank: Vehicle = await _start("tank")
	var entity: Entity = Entity.find_in(tank)
	is_true((tank.get_node(^"Turret/CommanderSeat") as Seat).take(LocalSession.SESSION))
	await _ground.run(1.0)
	equal([tank.state.hatch, tank.state.loader_hatch], [1.0, 0.0])
	var refusals: Array[String] = []
	var possession: Possession = entity.get_host().possession()
	possession.refused.connect(func(_session: int, why: String) -> void: refusals.append(why))
	possession.has_people = func(_session: int) -> bool: return true
	var shut: int = entity.type.find_command(&"open_hatch")
	entity.take_command(LocalSession.SESSION, shut, [0.0])
	await _ground.run(1.0)
	equal(tank.state.hatch, 1.0)
	contains(refusals[0], "cannot shut the hatch")
	# A session without a body may.
	possession.has_people = func(_session: int) -> bool: return false
	entity.take_command(LocalSession.SESSION, shut, [0.0])
	await _ground.run(1.0)
	equal(tank.state.hatch, 0.0)


func test_a_gunner_who_falls_silent_lets_go_of_the_aim() -> void:
	var tank: Vehicle = await _start("tank")
	var entity: Entity = Entity.find_in(tank)
	var turret: VehicleTurret = tank.get_node(^"Turret")
	is_true((tank.get_node(^"Turret/GunnerSeat") as Seat).take(LocalSession.SESSION))
	for _repeat: int in 10:
		entity.take_command(1, entity.type.find_command(&"aim"), [1.0, 0.0])
		await _ground.run(0.1)
	equal(turret.aim, Vector2(1.0, 0.0))
	await _ground.run(1.0)
	equal(turret.aim, Vector2.ZERO)
	var before: float = turret.rotation.y
	await _ground.run(1.0)
	almost_equal(turret.rotation.y, before, 1e-3)


func test_a_tank_on_its_back_is_put_upright_by_command() -> void:
	var tank: Vehicle = await _start("tank")
	var entity: Entity = Entity.find_in(tank)
	tank.teleport(Transform3D(Basis(Vector3.BACK, PI), Vector3(0.0, 3.0, 0.0)))
	await _ground.run(2.0)
	is_true(tank.global_basis.y.y < -0.8)
	entity.take_command(1, entity.type.find_command(&"upright"), [])
	await _ground.run(2.0)
	is_true(tank.global_basis.y.y > 0.95, "%.2f" % tank.global_basis.y.y)


func test_upright_is_for_instructors() -> void:
	var type: EntityType = load("res://scenes/vehicle/tank/tank_type.tres")
	var command: EntitySchema = type.commands[type.find_command(&"upright")]
	equal(command.capability, Roles.Capability.DIRECT)


func _start(p_preset: String) -> Vehicle:
	var vehicle: Vehicle = VehicleGround.create(p_preset)
	vehicle.add_child(LocalSession.new())
	_ground.view.add_child(vehicle)
	await _ground.run(0.5)
	return vehicle
