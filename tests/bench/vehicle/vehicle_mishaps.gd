class_name VehicleMishaps
extends VehicleCase
## Falls, rams, a vehicle on its back, what is run over: all comes to rest, and can be put upright.

## Nothing may be faster than what it fell from or was driven at by more than this factor.
const SPEED_FACTOR: float = 1.3


func run() -> void:
	var name: String = "%s, %s" % [preset, gear]
	var falls: Dictionary[String, Basis] = {
		"on its wheels": Basis.IDENTITY,
		"on its nose": Basis(Vector3.RIGHT, -1.2),
		"on its side": Basis(Vector3.BACK, 1.4),
		"on its back": Basis(Vector3.BACK, PI),
	}
	for way: String in falls:
		await _fall("%s: falls 10 m %s" % [name, way], falls[way])
	await _ram(name + ": two ram at 10 m/s each")
	await _run_over(name + ": drives through crates")
	for way: String in ["stands", "is limp"]:
		var name_of_case: String = "%s: runs over a person who %s" % [name, way]
		await _meet(name_of_case, way == "is limp")


func _is_heavy() -> bool:
	return preset == "tank" or preset == "carrier"


func _fall(p_case: String, p_turned: Basis) -> void:
	var ground: VehicleGround = flat_ground()
	var vehicle: Vehicle = ground.add_vehicle(
		preset, kind, Transform3D(p_turned, Vector3(0.0, 10.0, 0.0))
	)
	var fastest: float = 0.0
	var lowest: float = INF
	for _tick: int in 600:
		await tree.physics_frame
		fastest = maxf(fastest, vehicle.linear_velocity.length())
		lowest = minf(lowest, vehicle.to_global(vehicle.center_of_mass).y)
	report.at_most(p_case, "fastest", fastest, "m/s", SPEED_FACTOR * sqrt(2.0 * 9.81 * 10.0))
	report.at_least(p_case, "lowest middle", lowest, "m", 0.0)
	report.at_most(p_case, "speed after 10 s", vehicle.linear_velocity.length(), "m/s", 0.1)
	vehicle.reset_upright()
	for _tick: int in 180:
		await tree.physics_frame
	var upright: float = rad_to_deg(vehicle.global_basis.y.angle_to(Vector3.UP))
	report.at_most(p_case, "tilt after it was put upright", upright, "deg", 2.0)
	ground.free_all()


func _ram(p_case: String) -> void:
	var ground: VehicleGround = flat_ground()
	var pair: Array[Vehicle] = []
	for side: float in [1.0, -1.0]:
		var at: Transform3D = Transform3D(
			Basis(Vector3.UP, 0.0 if side > 0.0 else PI), Vector3(0.4 * side, 0.05, 60.0 * side)
		)
		pair.append(ground.add_vehicle(preset, kind, at))
	var fastest: float = 0.0
	var energy: float = 0.0
	for tick: int in 900:
		for vehicle: Vehicle in pair:
			var is_driven: bool = tick < 480 and VehicleGround.speed_of(vehicle) < 10.0
			vehicle.input.throttle = 1.0 if is_driven else 0.0
			vehicle.input.brake = 1.0 if tick >= 480 else 0.0
			fastest = maxf(fastest, vehicle.linear_velocity.length())
		await tree.physics_frame
	for vehicle: Vehicle in pair:
		energy += vehicle.linear_velocity.length()
	report.at_most(p_case, "fastest", fastest, "m/s", 14.0)
	report.at_most(p_case, "speed at the end", energy, "m/s", 0.2)
	var apart: float = pair[0].position.distance_to(pair[1].position)
	report.at_least(p_case, "distance at the end", apart, "m", 1.0)
	ground.free_all()


func _run_over(p_case: String) -> void:
	var ground: VehicleGround = flat_ground()
	VehicleWander.add_crates(ground, Vector3(0.0, 0.0, -30.0), 30)
	var start: Transform3D = Transform3D(Basis.IDENTITY, Vector3(0.0, 0.05, 0.0))
	var vehicle: Vehicle = ground.add_vehicle(preset, kind, start)
	vehicle.input.throttle = 1.0
	var tilt: float = 0.0
	for _tick: int in 900:
		await tree.physics_frame
		tilt = maxf(tilt, rad_to_deg(vehicle.global_basis.y.angle_to(Vector3.UP)))
	report.at_most(p_case, "largest tilt", tilt, "deg", 45.0)
	report.at_least(p_case, "way", -vehicle.position.z, "m", 40.0, _is_heavy())
	ground.free_all()


## A person who stands in the way, or lies down as the vehicle comes.
func _meet(p_case: String, p_is_limp: bool) -> void:
	var ground: VehicleGround = flat_ground()
	var start: Transform3D = Transform3D(Basis.IDENTITY, Vector3(0.0, 0.02, 40.0))
	var vehicle: Vehicle = ground.add_vehicle(preset, kind, start)
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/01_01.bvh")
	var sample: PoseSample = source.pose_at(0.5)
	var person: Ragdoll = BenchBodies.soldier(RagdollMotor.ROOT_GROUNDED)
	ground.view.add_child(person)
	person.start()
	# In the way of the right wheels.
	var aside: float = absf(vehicle.parameters.wheels_of(kind)[0].position.x)
	var fastest: float = 0.0
	var tilt: float = 0.0
	for tick: int in 900:
		await tree.physics_frame
		vehicle.input.throttle = 0.5 if VehicleGround.speed_of(vehicle) < 6.0 else 0.1
		if not p_is_limp or tick < 200:
			person.push_sample(tick / 60.0, sample, Vector3(aside, sample.root.y, 0.0))
			person.drive(tick / 60.0, 1.0 / 60.0)
		elif tick == 200:
			person.motor.set_actuation(RagdollMotor.LIMP, &"", 0.1)
		for body: RID in person.get_bodies():
			var state: PhysicsDirectBodyState3D = PhysicsServer3D.body_get_direct_state(body)
			fastest = maxf(fastest, state.linear_velocity.length())
		tilt = maxf(tilt, rad_to_deg(vehicle.global_basis.y.angle_to(Vector3.UP)))
	report.at_most(p_case, "fastest limb", fastest, "m/s", 25.0)
	# A truck may stand on two wheels for a moment, a scootmobile falls over.
	report.at_most(p_case, "largest tilt", tilt, "deg", 20.0, _is_heavy())
	ground.free_all()
