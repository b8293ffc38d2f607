class_name VehicleStabiliser
extends VehicleCase
## How well the gun of a tank that drives over bumps of 0.3 m at 30 km/h holds its aim in the world.

const SPEED: float = 30.0 / 3.6
const SETTLE_TICKS: int = 360
const GOAL_MRAD: float = 2.0


func run() -> void:
	for yaw: float in [0.0, 90.0]:
		await _ride(yaw)


func _ride(p_yaw_deg: float) -> void:
	var ground: VehicleGround = VehicleGround.new(tree.root)
	ground.view.add_child(VehicleBumps.create(VehicleBumps.END_M + SPEED * 60.0 * minutes))
	var vehicle: Vehicle = ground.add_vehicle("tank", kind)
	var turret: VehicleTurret = vehicle.get_node(^"Turret")
	await tree.physics_frame
	turret.place(deg_to_rad(p_yaw_deg), 0.0)
	var squares: float = 0.0
	var worst: float = 0.0
	var count: int = 0
	for tick: int in SETTLE_TICKS + roundi(minutes * 3600.0):
		drive_ahead(vehicle, SPEED)
		await tree.physics_frame
		if tick < SETTLE_TICKS:
			continue
		var state: Transform3D = PhysicsServer3D.body_get_state(
			vehicle.get_rid(), PhysicsServer3D.BODY_STATE_TRANSFORM
		)
		var gun: Basis = state.basis * turret.basis * turret.gun.basis
		var error: float = (-gun.z).angle_to(turret.get_aim_direction())
		squares += error * error
		worst = maxf(worst, error)
		count += 1
	var name: String = "stabiliser, %s: gun at %d deg over bumps" % [gear, roundi(p_yaw_deg)]
	var rms: float = 1000.0 * sqrt(squares / count)
	report.at_most(name, "off its aim", rms, "mrad RMS", GOAL_MRAD)
	report.add(name, "worst", 1000.0 * worst, "mrad")
	ground.free_all()
	await tree.physics_frame
