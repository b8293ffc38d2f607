class_name MotionPlatform
extends Resource
## What a motion platform under a seat can do: how far, how fast and how hard it moves along and
## about each axis.
##
## Axes are the seat's: to the right and left, up and down, ahead and back; pitch (about the axis to
## the right), yaw (about the one up), roll (about the one ahead and back). All values are to either
## side of neutral. An axis with a travel or angle of 0 is one that the platform lacks.
## [member share] keeps a hexapod from its edge: its legs cannot reach the ends of several axes at
## once, and makers give the travel of each axis alone.
##
## The presets are classes of platforms with rounded values. Makers give other ones for each model
## and load: set those of the manual.

## Names of the presets: [method preset].
const PRESETS: PackedStringArray = ["small_hexapod", "large_hexapod", "seat_mover"]

## Travel to the right, up and back, each to either side.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var travel: Vector3 = Vector3(0.1, 0.08, 0.1)
## Greatest speed along each of these axes.
@export_custom(PROPERTY_HINT_NONE, "suffix:m/s") var speed: Vector3 = Vector3(0.3, 0.3, 0.3)
## Greatest acceleration along each of these axes.
@export_custom(PROPERTY_HINT_NONE, "suffix:m/s²") var acceleration: Vector3 = Vector3(5.0, 5.0, 5.0)
## Greatest pitch, yaw and roll, each to either side.
@export_custom(PROPERTY_HINT_NONE, "suffix:°") var angle: Vector3 = Vector3(15.0, 15.0, 15.0)
## Greatest rate of pitch, yaw and roll.
@export_custom(PROPERTY_HINT_NONE, "suffix:°/s") var rate: Vector3 = Vector3(30.0, 30.0, 30.0)
## Greatest angular acceleration of pitch, yaw and roll.
@export_custom(PROPERTY_HINT_NONE, "suffix:°/s²")
var angular_acceleration: Vector3 = Vector3(250.0, 250.0, 250.0)
## Part of [member travel] and [member angle] that may be used, 0.1 to 1.
@export_range(0.1, 1.0, 0.01) var share: float = 0.7


## The parameters of one of [constant PRESETS]; null if there is none of this name.
##
## [code]small_hexapod[/code]: six electric legs with strokes of 0.15 m, as for one seat.
## [code]large_hexapod[/code]: six electric legs with strokes of 0.6 m, as for a cabin.
## [code]seat_mover[/code]: three legs under a seat: heave, pitch and roll only.
static func preset(p_name: String) -> MotionPlatform:
	var platform: MotionPlatform = MotionPlatform.new()
	match p_name:
		"small_hexapod":
			return platform
		"large_hexapod":
			platform.travel = Vector3(0.45, 0.35, 0.5)
			platform.speed = Vector3(0.6, 0.5, 0.6)
			platform.acceleration = Vector3(6.0, 7.0, 6.0)
			platform.angle = Vector3(22.0, 24.0, 22.0)
			platform.rate = Vector3(35.0, 40.0, 35.0)
			return platform
		"seat_mover":
			platform.travel = Vector3(0.0, 0.05, 0.0)
			platform.angle = Vector3(10.0, 0.0, 10.0)
			platform.rate = Vector3(40.0, 0.0, 40.0)
			platform.share = 0.6
			return platform
	return null


## What is wrong with it, for people; an empty text if nothing is.
func find_fault() -> String:
	var parts: Dictionary[String, Vector3] = {
		"travel": travel,
		"speed": speed,
		"acceleration": acceleration,
		"angle": angle,
		"rate": rate,
		"angular acceleration": angular_acceleration,
	}
	for part: String in parts:
		for axis: int in 3:
			if not (parts[part][axis] >= 0.0 and parts[part][axis] <= 1000.0):
				return "a platform's %s is 0 to 1000, found %s" % [part, parts[part]]
	if not (share >= 0.1 and share <= 1.0):
		return "a platform's share is 0.1 to 1, found %s" % share
	return ""


## Sets the limits of a filter.
func apply(p_cueing: MotionCueing) -> void:
	p_cueing.set_translation_limits(travel * share, speed, acceleration)
	var radians: float = PI / 180.0
	p_cueing.set_rotation_limits(
		angle * share * radians, rate * radians, angular_acceleration * radians
	)
