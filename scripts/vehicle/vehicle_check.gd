class_name VehicleCheck
extends RefCounted
## Finds parameters of a vehicle that make no sense.

# Parameters that must be above zero.
const _POSITIVE: Array[StringName] = [
	&"mass",
	&"engine_max_rpm",
	&"engine_inertia",
	&"gearbox_wheel_radius",
	&"gearbox_efficiency",
	&"gearbox_stall_rpm",
	&"steering_most_sideways",
	&"steering_tread",
	&"steering_response",
	&"steering_wheelbase",
	&"steering_rate",
]
# Parameters that must not be negative.
const _NOT_NEGATIVE: Array[StringName] = [
	&"drag_area",
	&"rolling_resistance",
	&"engine_idle_rpm",
	&"engine_friction",
	&"engine_response",
	&"gearbox_shift_time",
	&"gearbox_up_share",
	&"gearbox_down_share",
	&"gearbox_stall_ratio",
	&"gearbox_lock_share",
	&"brake_force",
	&"brake_parking_force",
	&"steering_pivot_speed",
	&"steering_force",
	&"steering_max_angle",
]
const _WHEEL_POSITIVE: Array[StringName] = [&"radius", &"mass", &"stiffness"]
const _WHEEL_NOT_NEGATIVE: Array[StringName] = [
	&"damping", &"sag", &"travel_up", &"travel_down", &"grip", &"side_grip"
]


## The first fault as a sentence that names the parameter, what was found and what was expected; an
## empty text if there is none. [param p_kind] is the running gear that is meant.
static func find_fault(
	p_parameters: VehicleParameters, p_kind: VehicleParameters.GearKind
) -> String:
	var fault: String = _check_numbers(p_parameters, "", _POSITIVE, _NOT_NEGATIVE)
	if fault == "" and not p_parameters.centre_of_mass.is_finite():
		fault = "centre_of_mass must be finite"
	var box: Vector3 = p_parameters.inertia_box
	if fault == "" and not (box.is_finite() and box.x > 0.0 and box.y > 0.0 and box.z > 0.0):
		fault = "inertia_box must be above zero in each axis, found %s" % box
	if fault == "":
		fault = _check_engine(p_parameters)
	if fault == "":
		fault = _check_wheels(p_parameters, p_kind)
	return fault


static func _check_numbers(
	p_of: Object, p_prefix: String, p_positive: Array[StringName], p_not_negative: Array[StringName]
) -> String:
	for name: StringName in p_positive + p_not_negative:
		var value: float = p_of.get(name)
		if not is_finite(value):
			return "%s%s must be a finite number, found %s" % [p_prefix, name, value]
		if p_positive.has(name) and value <= 0.0:
			return "%s%s must be above zero, found %s" % [p_prefix, name, value]
		if value < 0.0:
			return "%s%s must not be below zero, found %s" % [p_prefix, name, value]
	return ""


static func _check_engine(p_parameters: VehicleParameters) -> String:
	if p_parameters.engine_curve.size() < 2:
		return "engine_curve must have two points or more"
	var last: float = -1.0
	for point: Vector2 in p_parameters.engine_curve:
		if not point.is_finite() or point.y < 0.0:
			return "engine_curve must have finite points and no torque below zero, found %s" % point
		if point.x <= last:
			return (
				"engine_curve must be sorted by rising speed, found %s after %s" % [point.x, last]
			)
		last = point.x
	for gears: PackedFloat32Array in [p_parameters.gearbox_forward, p_parameters.gearbox_reverse]:
		if gears.is_empty():
			return "gearbox_forward and gearbox_reverse must have a gear each"
		for ratio: float in gears:
			# A comparison that NaN fails, too.
			if not (ratio > 0.0 and is_finite(ratio)):
				return "gearbox_forward and gearbox_reverse must be above zero, found %s" % ratio
	return ""


static func _check_wheels(
	p_parameters: VehicleParameters, p_kind: VehicleParameters.GearKind
) -> String:
	var wheels: Array[VehicleWheel] = p_parameters.wheels_of(p_kind)
	var list: String = "spheres" if p_kind == VehicleParameters.GearKind.SPHERES else "rays"
	if wheels.size() < 2:
		return "%s must have two wheels or more, found %d" % [list, wheels.size()]
	var total: float = 0.0
	for index: int in wheels.size():
		var prefix: String = "%s[%d]: " % [list, index]
		if wheels[index] == null:
			return prefix + "the wheel is missing"
		var fault: String = _check_numbers(
			wheels[index], prefix, _WHEEL_POSITIVE, _WHEEL_NOT_NEGATIVE
		)
		if fault == "" and not wheels[index].position.is_finite():
			fault = prefix + "position must be finite"
		if fault != "":
			return fault
		total += wheels[index].mass
	if p_kind == VehicleParameters.GearKind.SPHERES and total >= p_parameters.mass:
		return "mass must be above that of all spheres, %.0f kg" % total
	return ""
