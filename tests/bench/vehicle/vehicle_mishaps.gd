class_name VehicleMishaps
extends RefCounted
## Falls, rams, a vehicle on its back, what is run over: all comes to rest, and can be put upright.

## Nothing may be faster than what it fell from or was driven at by more than this factor.
const SPEED_FACTOR: float = 1.3

const _NONE: BenchReport.Goal = BenchReport.Goal.NONE


static func run(
	p_tree: SceneTree,
	p_report: BenchReport,
	p_preset: String,
	p_gear: String,
	p_kind: VehicleParameters.GearKind
) -> void:
	var name: String = "%s, %s" % [p_preset, p_gear]
	var falls: Dictionary[String, Basis] = {
		"on its wheels": Basis.IDENTITY,
		"on its nose": Basis(Vector3.RIGHT, -1.2),
		"on its side": Basis(Vector3.BACK, 1.4),
		"on its back": Basis(Vector3.BACK, PI),
	}
	for way: String in falls:
		await _fall(
			p_tree, p_report, "%s: falls 10 m %s" % [name, way], p_preset, p_kind, falls[way]
		)
	await _ram(p_tree, p_report, name + ": two ram at 10 m/s each", p_preset, p_kind)
	await _run_over(p_tree, p_report, name + ": drives through crates", p_preset, p_kind)
	for way: String in ["stands", "is limp"]:
		var name_of_case: String = "%s: runs over a person who %s" % [name, way]
		await _meet(p_tree, p_report, name_of_case, p_preset, p_kind, way == "is limp")


static func _is_heavy(p_preset: String) -> bool:
	return p_preset == "tank" or p_preset == "carrier"


static func _fall(
	p_tree: SceneTree,
	p_report: BenchReport,
	p_case: String,
	p_preset: String,
	p_kind: VehicleParameters.GearKind,
	p_turned: Basis
) -> void:
	var ground: VehicleGround = VehicleGround.new(p_tree.root)
	ground.add_floor()
	var vehicle: Vehicle = ground.add_vehicle(
		p_preset, p_kind, Transform3D(p_turned, Vector3(0.0, 10.0, 0.0))
	)
	var fastest: float = 0.0
	var lowest: float = INF
	for _tick: int in 600:
		await p_tree.physics_frame
		fastest = maxf(fastest, vehicle.linear_velocity.length())
		lowest = minf(lowest, vehicle.to_global(vehicle.center_of_mass).y)
	var at_most: BenchReport.Goal = BenchReport.Goal.AT_MOST
	p_report.at_most(p_case, "fastest", fastest, "m/s", SPEED_FACTOR * sqrt(2.0 * 9.81 * 10.0))
	p_report.at_least(p_case, "lowest middle", lowest, "m", 0.0)
	p_report.at_most(p_case, "speed after 10 s", vehicle.linear_velocity.length(), "m/s", 0.1)
	vehicle.reset_upright()
	for _tick: int in 180:
		await p_tree.physics_frame
	var upright: float = rad_to_deg(vehicle.global_basis.y.angle_to(Vector3.UP))
	p_report.at_most(p_case, "tilt after it was put upright", upright, "deg", 2.0)
	ground.free_all()


static func _ram(
	p_tree: SceneTree,
	p_report: BenchReport,
	p_case: String,
	p_preset: String,
	p_kind: VehicleParameters.GearKind
) -> void:
	var ground: VehicleGround = VehicleGround.new(p_tree.root)
	ground.add_floor()
	var pair: Array[Vehicle] = []
	for side: float in [1.0, -1.0]:
		var at: Transform3D = Transform3D(
			Basis(Vector3.UP, 0.0 if side > 0.0 else PI), Vector3(0.4 * side, 0.05, 60.0 * side)
		)
		pair.append(ground.add_vehicle(p_preset, p_kind, at))
	var fastest: float = 0.0
	var energy: float = 0.0
	for tick: int in 900:
		for vehicle: Vehicle in pair:
			var is_driven: bool = tick < 480 and VehicleGround.speed_of(vehicle) < 10.0
			vehicle.input.throttle = 1.0 if is_driven else 0.0
			vehicle.input.brake = 1.0 if tick >= 480 else 0.0
			fastest = maxf(fastest, vehicle.linear_velocity.length())
		await p_tree.physics_frame
	for vehicle: Vehicle in pair:
		energy += vehicle.linear_velocity.length()
	p_report.at_most(p_case, "fastest", fastest, "m/s", 14.0)
	p_report.at_most(p_case, "speed at the end", energy, "m/s", 0.2)
	var apart: float = pair[0].position.distance_to(pair[1].position)
	p_report.at_least(p_case, "distance at the end", apart, "m", 1.0)
	ground.free_all()


static func _run_over(
	p_tree: SceneTree,
	p_report: BenchReport,
	p_case: String,
	p_preset: String,
	p_kind: VehicleParameters.GearKind
) -> void:
	var ground: VehicleGround = VehicleGround.new(p_tree.root)
	ground.add_floor()
	VehicleWander.add_crates(ground, Vector3(0.0, 0.0, -30.0), 30)
	var start: Transform3D = Transform3D(Basis.IDENTITY, Vector3(0.0, 0.05, 0.0))
	var vehicle: Vehicle = ground.add_vehicle(p_preset, p_kind, start)
	vehicle.input.throttle = 1.0
	var tilt: float = 0.0
	for _tick: int in 900:
		await p_tree.physics_frame
		tilt = maxf(tilt, rad_to_deg(vehicle.global_basis.y.angle_to(Vector3.UP)))
	p_report.at_most(p_case, "largest tilt", tilt, "deg", 45.0)
	var kind: BenchReport.Goal = BenchReport.Goal.AT_LEAST if _is_heavy(p_preset) else _NONE
	p_report.add(p_case, "way", -vehicle.position.z, "m", kind, 40.0)
	ground.free_all()


## A person who stands in the way, or lies down as the vehicle comes.
static func _meet(
	p_tree: SceneTree,
	p_report: BenchReport,
	p_case: String,
	p_preset: String,
	p_kind: VehicleParameters.GearKind,
	p_is_limp: bool
) -> void:
	var ground: VehicleGround = VehicleGround.new(p_tree.root)
	ground.add_floor()
	var start: Transform3D = Transform3D(Basis.IDENTITY, Vector3(0.0, 0.02, 40.0))
	var vehicle: Vehicle = ground.add_vehicle(p_preset, p_kind, start)
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/01_01.bvh")
	var sample: PoseSample = source.pose_at(0.5)
	var person: Ragdoll = (load("res://scenes/actor/soldier.tscn") as PackedScene).instantiate()
	person.root_mode = RagdollMotor.ROOT_GROUNDED
	ground.view.add_child(person)
	person.start()
	# In the way of the right wheels.
	var aside: float = absf(vehicle.parameters.wheels_of(p_kind)[0].position.x)
	var fastest: float = 0.0
	var tilt: float = 0.0
	for tick: int in 900:
		await p_tree.physics_frame
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
	p_report.at_most(p_case, "fastest limb", fastest, "m/s", 25.0)
	# A truck may stand on two wheels for a moment, a scootmobile falls over.
	var kind: BenchReport.Goal = BenchReport.Goal.AT_MOST if _is_heavy(p_preset) else _NONE
	p_report.add(p_case, "largest tilt", tilt, "deg", kind, 20.0)
	ground.free_all()
