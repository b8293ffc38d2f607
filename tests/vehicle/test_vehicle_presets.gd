extends TestCase
## The presets drive, steer the way that their driver means, and stay on their wheels.

const PRESETS: Dictionary[String, VehicleParameters.GearKind] = {
	"tank": VehicleParameters.GearKind.SPHERES,
	"carrier": VehicleParameters.GearKind.SPHERES,
	"truck": VehicleParameters.GearKind.RAYS,
	"scootmobile": VehicleParameters.GearKind.RAYS,
}

var _ground: VehicleGround = null


func before_each() -> void:
	_ground = VehicleGround.new(self)
	_ground.add_floor()


func after_each() -> void:
	_ground.free_all()


func test_each_turns_to_the_left_when_it_is_steered_to_the_left() -> void:
	var driven: Array[Vehicle] = await _add_all()
	for vehicle: Vehicle in driven:
		vehicle.input.throttle = 0.5
		vehicle.input.steer = 0.6
	await _ground.run(3.0)
	for vehicle: Vehicle in driven:
		is_true(vehicle.rotation.y > 0.2, "%s: %.2f rad" % [vehicle.name, vehicle.rotation.y])
		is_true(VehicleGround.speed_of(vehicle) > 1.0, vehicle.name)
		is_true(vehicle.global_basis.y.y > 0.97, vehicle.name)


func test_each_drives_back_when_the_pedal_is_drawn_back() -> void:
	var driven: Array[Vehicle] = await _add_all()
	for vehicle: Vehicle in driven:
		vehicle.input.throttle = -0.6
	await _ground.run(3.0)
	for vehicle: Vehicle in driven:
		is_true(VehicleGround.speed_of(vehicle) < -0.5, vehicle.name)
		equal(vehicle.state.gear, -1, vehicle.name)


func test_each_holds_itself_where_nobody_drives() -> void:
	var slope: StaticBody3D = _ground.add_slope(0.15, Vector3.RIGHT)
	slope.position += Vector3.UP * 20.0
	var at: Array[Vector3] = []
	var standing: Array[Vehicle] = []
	for preset: String in PRESETS:
		var place: Vector3 = Vector3(12.0 * standing.size(), 20.0, 0.0) + slope.basis.y * 0.05
		standing.append(
			_ground.add_vehicle(preset, PRESETS[preset], Transform3D(slope.basis, place))
		)
	await _ground.run(2.0)
	for vehicle: Vehicle in standing:
		at.append(vehicle.position)
	await _ground.run(3.0)
	for index: int in standing.size():
		almost_equal(standing[index].position, at[index], 0.02, standing[index].name)


func test_wheels_that_are_steered_turn_with_the_handlebar() -> void:
	var truck: Vehicle = _ground.add_vehicle("truck", VehicleParameters.GearKind.RAYS)
	truck.input.steer = 1.0
	await _ground.run(1.0)
	is_true(truck.state.steer > 0.4, "%.2f rad" % truck.state.steer)
	var front: Basis = truck.wheel_transform(0).basis
	is_true(front.get_euler(EULER_ORDER_YXZ).y > 0.3, str(front.get_euler(EULER_ORDER_YXZ)))
	var rear: Basis = truck.wheel_transform(1).basis
	almost_equal(rear.get_euler(EULER_ORDER_YXZ).y, 0.0, 0.01)


func _add_all() -> Array[Vehicle]:
	var made: Array[Vehicle] = []
	for preset: String in PRESETS:
		var at: Vector3 = Vector3(40.0 * made.size(), 0.02, 0.0)
		made.append(_ground.add_vehicle(preset, PRESETS[preset], Transform3D(Basis.IDENTITY, at)))
	await _ground.run(1.0)
	return made
