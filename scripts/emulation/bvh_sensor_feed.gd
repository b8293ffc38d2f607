class_name BvhSensorFeed
extends WornSensorFeed
## A BVH clip, worn as sensors.
##
## It begins with [member prelude]: the motion of a calibration, or nothing.

## The clip.
var source: BvhSource = null
## What the wearer does before the clip, or null.
var prelude: MotionSource = null
## How long that takes, s.
var prelude_s: float = 0.0
## Frames per second.
var rate_hz: float = 100.0

var _start_usec: int = -1
var _next: int = 0


## Opens a clip and puts sensors on the mounts, sitting and turned at random if
## [param p_random] is given.
func open(
	p_path: String, p_positions: PackedInt32Array, p_random: RandomNumberGenerator = null
) -> void:
	source = BvhSource.new()
	source.open(p_path)
	error = source.error
	for position: int in p_positions:
		var mounting: Quaternion = Quaternion.IDENTITY
		var heading: float = 0.0
		if p_random != null:
			mounting = _any_rotation(p_random)
			heading = p_random.randf_range(-PI, PI)
		add_sensor(position, mounting, heading)


## Measures all that is due up to a time (Unix time, µs).
func advance(p_time_usec: int) -> void:
	if error != "" or source == null:
		return
	if _start_usec < 0:
		_start_usec = p_time_usec
	while _start_usec + roundi(_next * 1e6 / rate_hz) <= p_time_usec:
		var passed: float = _next / rate_hz
		measure(pose_at(passed), _start_usec + roundi(_next * 1e6 / rate_hz))
		_next += 1


## What the wearer does after so many seconds.
func pose_at(p_time_s: float) -> PoseSample:
	if prelude != null and p_time_s < prelude_s:
		return prelude.sample(roundi(p_time_s * 1e6))
	return source.pose_at(p_time_s - (prelude_s if prelude != null else 0.0))


func describe() -> String:
	return "%d made-up sensors on %s" % [_ids.size(), source.describe()]


static func _any_rotation(p_random: RandomNumberGenerator) -> Quaternion:
	var turned: Quaternion = Quaternion(0.0, 0.0, 0.0, 0.0)
	while turned.length_squared() < 0.01:
		turned = Quaternion(
			p_random.randfn(), p_random.randfn(), p_random.randfn(), p_random.randfn()
		)
	return turned.normalized()
