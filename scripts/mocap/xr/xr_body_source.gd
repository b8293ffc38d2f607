class_name XrBodySource
extends XrSource
## The motion of somebody who wears a headset and holds controllers (or whose hands are tracked),
## with or without trackers on the body, and without a suit.
##
## The wearer's height is taken from the eyes' unless it is given: the highest position at which
## they were for [constant TALL_S].

## Time for which the eyes must be at a height, s.
const TALL_S: float = 0.4
## Plausible heights, m.
const MIN_HEIGHT: float = 1.2
const MAX_HEIGHT: float = 2.2
## Difference of heights that is ignored, m.
const _SAME_M: float = 0.02

## Whether the wearer sits on a chair.
var is_seated: bool = false

var _size: BodySize = null
var _body: XrBody = null
var _is_given: bool = false
var _is_measured: bool = false
var _tall_s: float = 0.0
var _tall_m: float = 0.0
var _last_usec: int = 0
# Shared between threads and guarded.
var _learns_pins: bool = false
var _times: int = 0


## Takes the wearer's height, m; 0: it is measured.
func _init(p_height: float = 0.0) -> void:
	_size = BodySize.new()
	if p_height > 0.0:
		error = _size.set_height(p_height)
		_is_given = error == ""
	_body = XrBody.new(_size)


## The wearer stands upright: how trackers sit on the body is learned anew.
func learn_pins() -> void:
	_mutex.lock()
	_learns_pins = true
	_mutex.unlock()


## Counts how often the wearer's size was found anew: then it has to be sent again.
func measured_times() -> int:
	_mutex.lock()
	var times: int = _times
	_mutex.unlock()
	return times


func get_hip_height() -> float:
	return get_body().length(&"hip_height")


func get_limb_lengths() -> PackedFloat32Array:
	return get_body().limb_lengths()


func get_body() -> BodySize:
	_mutex.lock()
	var size: BodySize = _size
	_mutex.unlock()
	return size


func describe() -> String:
	return "a headset and what is held, %.2f m tall" % get_body().height


func _read(p_time_usec: int) -> PoseSample:
	_read_frame(p_time_usec).time_usec = p_time_usec
	if not _frame.has_place:
		error = "the headset is not tracked: put it on, and look at where its cameras see the room"
		return null
	error = ""
	_mutex.lock()
	var learns: bool = _learns_pins
	_learns_pins = false
	_mutex.unlock()
	var shown: ShownFigure = _take_shown()
	if shown != null:
		_body.set_figure(shown)
	if learns:
		_body.pins.restart()
	var step_s: float = (p_time_usec - _last_usec) / 1e6
	# Asked in any case: it counts from the last time.
	var was_moved: bool = _was_moved()
	if was_moved or step_s <= 0.0 or step_s > 0.5:
		_body.restart()
		step_s = 0.0
	_last_usec = p_time_usec
	_measure(step_s)
	_body.is_seated = is_seated
	var pose: PoseSample = _body.solve(_frame, step_s)
	if not _frame.fingers.is_empty():
		pose.details = MotionDetails.new()
		pose.details.joints = _frame.fingers
	return pose


## Finds the height of somebody who stands.
func _measure(p_step_s: float) -> void:
	if _is_given or is_seated:
		return
	var eyes: float = _frame.head.origin.y
	var tall: float = clampf(eyes / BodySize.EYE_HEIGHT, MIN_HEIGHT, MAX_HEIGHT)
	if not _is_measured:
		_is_measured = true
		_take_height(tall)
		return
	# Only who looks about level has the eyes where they are highest; a jump is too short.
	var is_taller: bool = tall > _size.height + _SAME_M
	_tall_s = _tall_s + p_step_s if is_taller else 0.0
	_tall_m = minf(_tall_m, tall) if _tall_s > p_step_s else tall
	if _tall_s > TALL_S:
		_tall_s = 0.0
		_take_height(_tall_m)


func _take_height(p_height: float) -> void:
	var size: BodySize = BodySize.of_height(p_height)
	_mutex.lock()
	_size = size
	_times += 1
	_mutex.unlock()
	_body.set_size(size)
