class_name SensorFrame
extends RefCounted
## One moment of all sensors of a [SensorFeed], in the order of its list.
##
## Axes are Godot's already ([SourceFrames]); it is not calibrated yet.

## When it was measured, µs of Unix time on this machine.
var time_usec: int = 0
## The device's own count of its samples, or -1 where it has none.
var counter: int = -1
## Time between two samples of the slowest device that is in it, s; 0 where that is not known.
var period_s: float = 0.0
## 4 floats (x, y, z, w) a sensor: from the sensor's axes to its own global frame, Y up,
## +Z its north. Undefined where [member present] is 0.
var orientations: PackedFloat32Array = PackedFloat32Array()
## 1 for each sensor with a reading, else 0.
var present: PackedByteArray = PackedByteArray()
## Rates of turn in the sensors' axes, rad/s; empty if they are not known.
var rates: PackedVector3Array = PackedVector3Array()
## Accelerations in the sensors' axes with gravity (a sensor at rest has 9.81 upwards), m/s²; empty
## if they are not known.
var accelerations: PackedVector3Array = PackedVector3Array()
## The magnetic field in the sensors' axes, in any unit in which the earth's is about 1; empty if it
## is not known.
var magnetics: PackedVector3Array = PackedVector3Array()


## How many sensors it can hold.
func count() -> int:
	return present.size()


## Makes room for this many sensors, all without readings.
func resize(
	p_count: int, p_rates: bool = false, p_accelerations: bool = false, p_magnetics: bool = false
) -> void:
	orientations.resize(p_count * 4)
	present.resize(p_count)
	if p_rates:
		rates.resize(p_count)
	if p_accelerations:
		accelerations.resize(p_count)
	if p_magnetics:
		magnetics.resize(p_count)


## The orientation of one sensor.
func orientation(p_sensor: int) -> Quaternion:
	var at: int = p_sensor * 4
	return Quaternion(
		orientations[at], orientations[at + 1], orientations[at + 2], orientations[at + 3]
	)


## Sets a sensor's orientation.
func set_orientation(p_sensor: int, p_rotation: Quaternion) -> void:
	var at: int = p_sensor * 4
	orientations[at] = p_rotation.x
	orientations[at + 1] = p_rotation.y
	orientations[at + 2] = p_rotation.z
	orientations[at + 3] = p_rotation.w
	present[p_sensor] = 1


## Why this cannot be a frame, or an empty text if it can.
func find_fault() -> String:
	var sensors: int = present.size()
	if orientations.size() != sensors * 4:
		return "%d floats for %d sensors" % [orientations.size(), sensors]
	if not rates.is_empty() and rates.size() != sensors:
		return "%d rates for %d sensors" % [rates.size(), sensors]
	if not accelerations.is_empty() and accelerations.size() != sensors:
		return "%d accelerations for %d sensors" % [accelerations.size(), sensors]
	if not magnetics.is_empty() and magnetics.size() != sensors:
		return "%d magnetic fields for %d sensors" % [magnetics.size(), sensors]
	for sensor: int in sensors:
		var norm: float = orientation(sensor).length()
		# A comparison that NaN fails, too.
		if present[sensor] != 0 and not (norm > 0.9 and norm < 1.1):
			return "sensor %d has no rotation (norm %f)" % [sensor, norm]
	return ""
