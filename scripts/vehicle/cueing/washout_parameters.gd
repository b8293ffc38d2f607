class_name WashoutParameters
extends Resource
## How a vehicle's motion becomes a platform's: the parameters of the classical washout filter.
##
## With s the Laplace variable, a the scaled and limited specific force (less what is felt at rest)
## and r the scaled and limited rate:
## travel = a s / ((s² + 2 damping frequency s + frequency²) (s + third pole)),
## tilt = arcsin(low-pass(a) / g) at [member tilt_max_rate] at most,
## angle = r / (s + frequency) or r s / (s² + 2 damping frequency s + frequency²),
## attitude = tilt + angle. Measured responses: docs/motion-platform.md.

@export_group("Ahead, back and to the sides")
## Part of the specific force that the platform gives.
@export_range(0.0, 2.0, 0.01) var horizontal_scale: float = 0.5
## Greatest specific force, before scaling.
@export_range(0.0, 100.0, 0.1, "suffix:m/s²") var horizontal_limit: float = 10.0
## Frequency of the high-pass: a lower one gives more of the force and needs more travel.
@export_range(0.2, 50.0, 0.1, "suffix:rad/s") var horizontal_frequency: float = 4.0
## Damping ratio of the high-pass.
@export_range(0.3, 3.0, 0.01) var horizontal_damping: float = 1.0
## The third pole, which brings the platform back to neutral.
@export_range(0.2, 50.0, 0.01, "suffix:rad/s") var horizontal_third_pole: float = 0.25
@export_group("Up and down")
## The same of forces up and down.
@export_range(0.0, 2.0, 0.01) var vertical_scale: float = 0.5
## Greatest specific force besides gravity, before scaling.
@export_range(0.0, 100.0, 0.1, "suffix:m/s²") var vertical_limit: float = 15.0
## Frequency of the high-pass.
@export_range(0.2, 50.0, 0.1, "suffix:rad/s") var vertical_frequency: float = 5.0
## Damping ratio of the high-pass.
@export_range(0.3, 3.0, 0.01) var vertical_damping: float = 1.0
## The third pole.
@export_range(0.2, 50.0, 0.01, "suffix:rad/s") var vertical_third_pole: float = 0.25
@export_group("Tilt", "tilt_")
## Frequency of the low-pass, of order 2.
@export_range(0.2, 50.0, 0.1, "suffix:rad/s") var tilt_frequency: float = 2.5
## Damping ratio of the low-pass.
@export_range(0.3, 3.0, 0.01) var tilt_damping: float = 1.0
## Greatest rate of the tilt: above some 3 °/s people feel it as turning.
@export_range(0.0, 20.0, 0.1, "suffix:°/s") var tilt_max_rate: float = 3.0
## Greatest tilt.
@export_range(0.0, 45.0, 0.1, "suffix:°") var tilt_max_angle: float = 20.0
@export_group("Rotation", "rotation_")
## Part of the rates that the platform gives.
@export_range(0.0, 2.0, 0.01) var rotation_scale: float = 0.5
## Greatest rate, before scaling.
@export_range(0.0, 360.0, 1.0, "suffix:°/s") var rotation_limit: float = 60.0
## Frequency of the high-pass.
@export_range(0.2, 50.0, 0.1, "suffix:rad/s") var rotation_frequency: float = 1.0
## Damping ratio of the high-pass, of order 2.
@export_range(0.3, 3.0, 0.01) var rotation_damping: float = 1.0
## Order of the high-pass: 1 keeps an angle while the vehicle keeps turning, 2 leads back even then.
@export_range(1, 2, 1) var rotation_order: int = 2
@export_group("Ramps")
## Time without data of the vehicle after which the platform goes to neutral.
@export_range(0.01, 60.0, 0.01, "suffix:s") var dead_man: float = 0.2
## Time to go to neutral without data or in a pause.
@export_range(0.01, 60.0, 0.01, "suffix:s") var leave_time: float = 2.0
## Time from neutral to full motion.
@export_range(0.01, 60.0, 0.01, "suffix:s") var enter_time: float = 2.0
## Time to go to neutral after the vehicle was put elsewhere.
@export_range(0.01, 60.0, 0.01, "suffix:s") var teleport_time: float = 1.0


## Sets the parameters of a filter, which reports those without sense as errors.
func apply(p_cueing: MotionCueing) -> void:
	p_cueing.set_translation(
		MotionCueing.DIRECTION_HORIZONTAL,
		horizontal_scale,
		horizontal_limit,
		horizontal_frequency,
		horizontal_damping,
		horizontal_third_pole
	)
	p_cueing.set_translation(
		MotionCueing.DIRECTION_VERTICAL,
		vertical_scale,
		vertical_limit,
		vertical_frequency,
		vertical_damping,
		vertical_third_pole
	)
	p_cueing.set_tilt(
		tilt_frequency, tilt_damping, deg_to_rad(tilt_max_rate), deg_to_rad(tilt_max_angle)
	)
	p_cueing.set_rotation(
		rotation_scale,
		deg_to_rad(rotation_limit),
		rotation_frequency,
		rotation_damping,
		rotation_order
	)
	p_cueing.set_ramps(dead_man, leave_time, enter_time, teleport_time)
