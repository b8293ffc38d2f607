extends TestCase
## Guns load, fire when they are loaded and may be, kick the hull, and let go of their trigger.

var _range: FiringRange = null


func before_each() -> void:
	_range = FiringRange.new(self)
	await _range.settle()


func after_each() -> void:
	_range.free_all()


func test_a_gun_fires_once_and_loads_for_six_seconds() -> void:
	var shots: Array[Vector3] = []
	_range.gun.fired.connect(
		func(_kind: Ammunition, _at: Vector3, p_velocity: Vector3) -> void: shots.append(p_velocity)
	)
	_range.command(&"fire")
	equal(shots.size(), 1)
	almost_equal(shots[0].length(), 1650.0, 2.0)
	is_true(shots[0].angle_to(Vector3.FORWARD) < 0.02, str(shots[0]))
	equal(_range.entity.get_value(&"loaded"), 0.0)
	equal(_range.entity.get_value(&"rounds"), 23.0)
	for _command: int in 1000:
		_range.command(&"fire")
	await _range.ground.run(5.8)
	_range.command(&"fire")
	equal(shots.size(), 1, "it is not loaded")
	await _range.ground.run(0.3)
	equal(_range.entity.get_value(&"loaded"), 1.0)
	_range.command(&"fire")
	equal(shots.size(), 2)


func test_a_shot_rocks_the_hull_by_one_or_two_degrees() -> void:
	var rest: float = _range.tank.rotation.x
	_range.command(&"fire")
	var most: float = 0.0
	for _tick: int in 60:
		await _range.ground.run(1.0 / 60.0)
		most = maxf(most, rad_to_deg(absf(_range.tank.rotation.x - rest)))
	is_true(most > 0.5 and most < 2.5, "%.2f deg" % most)
	await _range.ground.run(3.0)
	almost_equal(rad_to_deg(_range.tank.rotation.x - rest), 0.0, 0.1, "and it comes to rest")


func test_another_round_is_loaded_anew() -> void:
	_range.command(&"load", [1.0])
	equal(_range.entity.get_value(&"loaded"), 0.0)
	equal(_range.entity.get_value(&"ammunition"), 1.0)
	equal(_range.entity.get_value(&"rounds"), 18.0)
	is_true(not _range.gun.fire())
	is_true(not _range.gun.load_kind(7), "what there is not")
	is_true(not _range.gun.load_kind(-1))
	await _range.ground.run(6.2)
	is_true(_range.gun.fire())


func test_an_empty_gun_does_not_fire() -> void:
	_range.gun.left = [1, 0]
	is_true(_range.gun.fire())
	await _range.ground.run(7.0)
	is_true(not _range.gun.fire())
	equal(_range.gun.left[0], 0)


func test_nobody_outside_the_seat_fires() -> void:
	# The server refuses it by the type; the gun does too.
	equal(_seat_of(&"fire"), &"gunner")
	equal(_seat_of(&"load"), &"gunner")
	equal(_seat_of(&"fire_coax"), &"gunner")
	_range.gun.seat.vacate()
	_range.command(&"fire")
	_range.command(&"fire_coax", [1.0])
	await _range.ground.run(0.5)
	equal(_range.gun.left[0], 24)
	equal(_range.coax.left[0], 4700)


func test_a_machine_gun_fires_while_its_trigger_is_held() -> void:
	_range.command(&"fire_coax", [1.0])
	await _range.ground.run(1.0)
	equal(_range.entity.get_value(&"coax_firing"), 1.0)
	almost_equal(float(4700 - _range.coax.left[0]), 10.0, 1.01)
	_range.command(&"fire_coax", [0.0])
	await _range.ground.run(0.1)
	var left: int = _range.coax.left[0]
	equal(_range.entity.get_value(&"coax_firing"), 0.0)
	await _range.ground.run(0.5)
	equal(_range.coax.left[0], left)


func test_a_trigger_that_is_pressed_again_and_again_fires_no_faster() -> void:
	for _tick: int in 60:
		for _command: int in 20:
			_range.command(&"fire_coax", [0.0])
			_range.command(&"fire_coax", [1.0])
		await _range.ground.run(1.0 / 60.0)
		_range.command(&"fire_coax", [0.0])
	is_true(4700 - _range.coax.left[0] <= 11, "%d rounds" % (4700 - _range.coax.left[0]))


func test_a_trigger_that_nobody_releases_is_let_go() -> void:
	_range.command(&"fire_coax", [1.0])
	await _range.ground.run(0.3)
	_range.gun.seat.vacate()
	await _range.ground.run(0.1)
	equal(_range.entity.get_value(&"coax_firing"), 0.0, "the seat is left")
	await _range.ground.run(0.5)
	_range.gun.seat.take(LocalSession.SESSION)
	_range.command(&"fire_coax", [1.0])
	await _range.ground.run(VehicleGun.MAX_BURST_S - 0.5)
	equal(_range.entity.get_value(&"coax_firing"), 1.0)
	await _range.ground.run(1.0)
	equal(_range.entity.get_value(&"coax_firing"), 0.0, "no command for too long")


func test_the_same_shots_scatter_alike() -> void:
	var first: PackedVector3Array = await _burst()
	_range.free_all()
	_range = FiringRange.new(self)
	await _range.settle()
	var second: PackedVector3Array = await _burst()
	equal(first.size(), second.size())
	var spread: float = 0.0
	for index: int in first.size():
		almost_equal(first[index].normalized(), second[index].normalized(), 1e-4)
		spread = maxf(spread, first[index].angle_to(first[0]))
	is_true(spread > 2e-4 and spread < 8e-3, "%.5f rad" % spread)


func test_a_gun_without_sense_says_so() -> void:
	var gun: VehicleGun = VehicleGun.new()
	equal(gun._get_configuration_warnings().size(), 1)
	gun.vehicle = _range.tank
	gun.entity = _range.entity
	gun.shells = _range.shells
	is_true("Ammunition" in gun._get_configuration_warnings()[0])
	var broken: Ammunition = Ammunition.new()
	broken.mass = 0.0
	gun.ammunition = [broken]
	is_true("mass" in gun._get_configuration_warnings()[0])
	gun.free()
	equal(_range.gun._get_configuration_warnings().size(), 0)
	equal(_range.shells._get_configuration_warnings().size(), 0)
	equal(_range.armour._get_configuration_warnings().size(), 0)


func test_a_carriers_machine_gun_is_its_commanders() -> void:
	_range.free_all()
	_range = FiringRange.new(self, "carrier")
	await _range.settle()
	equal(_seat_of(&"fire_coax"), &"commander")
	var gun: VehicleGun = _range.tank.get_node("MachineGun")
	gun.seat.take(LocalSession.SESSION)
	_range.command(&"fire_coax", [1.0])
	await _range.ground.run(1.0)
	is_true(gun.left[0] < 995, "%d left" % gun.left[0])


func _burst() -> PackedVector3Array:
	var shots: PackedVector3Array = []
	var note: Callable = func(_kind: Ammunition, _at: Vector3, p_velocity: Vector3) -> void:
		shots.append(p_velocity)
	_range.coax.fired.connect(note)
	_range.command(&"fire_coax", [1.0])
	await _range.ground.run(1.0)
	return shots


func _seat_of(p_command: StringName) -> StringName:
	var type: EntityType = _range.entity.type
	return type.commands[type.find_command(p_command)].seat
