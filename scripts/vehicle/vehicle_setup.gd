class_name VehicleSetup
extends RefCounted
## Builds the drivetrain and the running gear of a vehicle from its parameters.


## A drivetrain.
static func make_drivetrain(p_parameters: VehicleParameters) -> VehicleDrivetrain:
	var of: VehicleParameters = p_parameters
	var made: VehicleDrivetrain = VehicleDrivetrain.new()
	made.set_vehicle(of.mass, of.gearbox_wheel_radius, of.brake_force, of.brake_parking_force)
	made.set_engine(
		of.engine_curve,
		of.engine_idle_rpm,
		of.engine_max_rpm,
		of.engine_inertia,
		of.engine_friction,
		of.engine_response
	)
	made.set_gearbox(
		of.gearbox_forward,
		of.gearbox_reverse,
		of.gearbox_efficiency,
		of.gearbox_shift_time,
		of.gearbox_up_share,
		of.gearbox_down_share
	)
	made.set_converter(of.gearbox_stall_ratio, of.gearbox_stall_rpm, of.gearbox_lock_share)
	if of.steering_kind == VehicleParameters.Steering.TRACKS:
		made.set_track_steering(
			of.steering_tread,
			of.steering_pivot_speed,
			of.steering_most_sideways,
			of.steering_force,
			of.steering_response
		)
	else:
		made.set_wheel_steering(
			of.steering_wheelbase,
			of.steering_max_angle,
			of.steering_rate,
			of.steering_most_sideways
		)
	return made


## A running gear that still has to be set up.
static func make_gear(
	p_parameters: VehicleParameters, p_kind: VehicleParameters.GearKind
) -> RunningGear:
	var made: RunningGear = null
	if p_kind == VehicleParameters.GearKind.SPHERES:
		made = SphereRunningGear.new()
	else:
		made = RayRunningGear.new()
	made.rolling_resistance = p_parameters.rolling_resistance
	made.drag_area = p_parameters.drag_area
	return made
