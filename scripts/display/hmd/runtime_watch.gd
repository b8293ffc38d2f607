class_name RuntimeWatch
extends RefCounted
## Notices that the headset's runtime has ended.
##
## The engine does not report it: its session stays as it was, poses freeze and are still called
## certain. The sign is a predicted display time that stands still while no refresh rate is known.

## The time stands still for at least this many frames and this long.
const FRAMES: int = 10
const PATIENCE_USEC: int = 250_000

var _predicted_ns: int = -1
var _frames: int = 0
var _since_usec: int = 0


## A frame. Takes the predicted display time (ns of the runtime; 0: none), the refresh rate that
## the runtime says (Hz; 0: none) and now (µs). Returns whether the runtime has ended.
func has_ended(p_predicted_ns: int, p_rate_hz: float, p_now_usec: int) -> bool:
	var stands: bool = p_predicted_ns == 0 or p_predicted_ns == _predicted_ns
	_predicted_ns = p_predicted_ns
	if not stands or p_rate_hz > 0.0:
		_frames = 0
		_since_usec = p_now_usec
		return false
	_frames += 1
	return _frames >= FRAMES and p_now_usec - _since_usec >= PATIENCE_USEC


## Begins anew, such as when a session begins.
func restart(p_now_usec: int) -> void:
	_predicted_ns = -1
	_frames = 0
	_since_usec = p_now_usec
