extends TestCase
## Vehicles on simulated ground: they stand, drive, turn, brake, and survive what they are given.

const KINDS: Array[VehicleParameters.GearKind] = [
	VehicleParameters.GearKind.SPHERES,
	VehicleParameters.GearKind.RAYS,
]

var _ground: VehicleGround = null


func before_each() -> void:
	_ground = VehicleGround.new(self)


func after_each() -> void:
	_ground.free_all()


func test_a_tank_stands_still_where_it_is_put() -> void:
	_ground.add_floor()
	for kind: VehicleParameters.GearKind in KINDS:
		var tank: Vehicle = _ground.add_vehicle("tank", kind)
		await _ground.run(3.0)
		almost_equal(tank.position, Vector3.ZERO, 0.05)
		is_true(tank.state.engine_on)
		var carried: float = 0.0
		for force: float in tank.stats().spring_forces:
			carried += force
		is_true(carried > 0.75 * tank.parameters.mass * 9.81, "%.0f N" % carried)
		tank.free()


func test_a_tank_drives_straight_and_brakes() -> void:
	_ground.add_floor()
	for kind: VehicleParameters.GearKind in KINDS:
		var tank: Vehicle = _ground.add_vehicle("tank", kind)
		await _ground.run(1.0)
		tank.input.throttle = 1.0
		await _ground.run(6.0)
		is_true(VehicleGround.speed_of(tank) > 6.0, "%.1f m/s" % VehicleGround.speed_of(tank))
		is_true(absf(tank.position.x) < 0.3, "%.2f m aside" % tank.position.x)
		almost_equal(tank.state.left_speed, VehicleGround.speed_of(tank), 0.3)
		is_true(tank.state.gear >= 2)
		tank.input.throttle = 0.0
		tank.input.brake = 1.0
		await _ground.run(4.0)
		almost_equal(tank.linear_velocity, Vector3.ZERO, 0.02)
		tank.free()


func test_a_tank_turns_on_the_spot_both_ways() -> void:
	_ground.add_floor()
	for kind: VehicleParameters.GearKind in KINDS:
		for way: float in [1.0, -1.0]:
			var tank: Vehicle = _ground.add_vehicle("tank", kind)
			await _ground.run(1.0)
			tank.input.steer = way
			await _ground.run(3.0)
			is_true(way * tank.angular_velocity.y > 0.4, "%.2f rad/s" % tank.angular_velocity.y)
			is_true(tank.position.length() < 0.5, "%.2f m away" % tank.position.length())
			tank.free()


func test_input_that_is_no_number_does_nothing() -> void:
	_ground.add_floor()
	for kind: VehicleParameters.GearKind in KINDS:
		var tank: Vehicle = _ground.add_vehicle("tank", kind)
		await _ground.run(1.0)
		tank.input.throttle = NAN
		tank.input.steer = INF
		tank.input.brake = -INF
		tank.apply_recoil(Vector3(NAN, 0.0, 0.0), Vector3.ZERO)
		tank.teleport(Transform3D(Basis.IDENTITY, Vector3(INF, 0.0, 0.0)))
		await _ground.run(1.0)
		almost_equal(tank.position, Vector3.ZERO, 0.05)
		is_true(is_finite(tank.state.rpm))
		tank.free()


func test_recoil_rocks_the_hull() -> void:
	_ground.add_floor()
	for kind: VehicleParameters.GearKind in KINDS:
		var tank: Vehicle = _ground.add_vehicle("tank", kind)
		await _ground.run(2.0)
		# 120 mm: 9 kg at 1,650 m/s and the propellant's gas.
		tank.apply_recoil(Vector3(0.0, 0.0, 25e3), tank.to_global(Vector3(0.0, 2.0, 0.0)))
		var highest: float = 0.0
		for _tick: int in 60:
			await _ground.run(1.0 / 60.0)
			highest = maxf(highest, rad_to_deg(absf(tank.rotation.x)))
		is_true(highest > 0.3 and highest < 6.0, "%.2f deg" % highest)
		tank.free()


func test_a_vehicle_on_its_back_is_put_upright() -> void:
	_ground.add_floor()
	for kind: VehicleParameters.GearKind in KINDS:
		var turned: Transform3D = Transform3D(Basis(Vector3.BACK, PI), Vector3(0.0, 4.0, 0.0))
		var tank: Vehicle = _ground.add_vehicle("tank", kind, turned)
		await _ground.run(4.0)
		is_true(tank.global_basis.y.y < -0.5, "it should be on its back")
		is_true(tank.linear_velocity.length() < 0.5)
		tank.reset_upright()
		await _ground.run(3.0)
		is_true(tank.global_basis.y.y > 0.99)
		almost_equal(tank.position.y, 0.0, 0.1)
		tank.free()


func test_a_frozen_vehicle_has_no_wheels() -> void:
	_ground.add_floor()
	var tank: Vehicle = VehicleGround.create("tank")
	tank.freeze = true
	_ground.view.add_child(tank)
	await _ground.run(0.5)
	equal(tank.wheel_bodies().size(), 0)
	equal(tank.stats().compressions.size(), 0)
	tank.freeze = false
	await _ground.run(0.5)
	equal(tank.wheel_bodies().size(), 10)


func test_a_vehicle_that_has_gone_to_sleep_wakes_for_its_driver() -> void:
	_ground.add_floor()
	var tank: Vehicle = _ground.add_vehicle("tank", VehicleParameters.GearKind.SPHERES)
	for _second: int in 20:
		await _ground.run(1.0)
		if tank.sleeping:
			break
	is_true(tank.sleeping)
	is_true(tank.state.rpm > 500.0, "the engine idles on")
	tank.input.throttle = 1.0
	await _ground.run(2.0)
	is_true(VehicleGround.speed_of(tank) > 1.0)


func test_wheels_go_with_a_vehicle_that_is_moved() -> void:
	_ground.add_floor()
	var tank: Vehicle = _ground.add_vehicle("tank", VehicleParameters.GearKind.SPHERES)
	await _ground.run(1.0)
	var there: Transform3D = Transform3D(Basis(Vector3.UP, 1.0), Vector3(50.0, 0.1, -30.0))
	tank.teleport(there)
	await _ground.run(2.0)
	is_true(tank.position.distance_to(there.origin) < 0.3)
	# Whoever only sets the transform gets the wheels along as well.
	tank.global_transform = Transform3D(Basis.IDENTITY, Vector3(-20.0, 0.1, 10.0))
	await _ground.run(2.0)
	is_true(tank.position.distance_to(Vector3(-20.0, 0.0, 10.0)) < 0.5, str(tank.position))
	is_true(tank.global_basis.y.y > 0.99)
