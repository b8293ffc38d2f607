class_name XrSource
extends MotionSource
## A motion source that a wearer's headset takes part in: [FusedSource] with a suit, [XrBodySource]
## without one.
##
## The main thread hands over an [XrFrame] in every frame; any one thread samples.

var _frames: XrFrames = XrFrames.new()
var _frame: XrFrame = XrFrame.new()
var _recentred: int = 0
# What follows is shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _shown: ShownFigure = null


## Takes what the devices say now, in the main thread.
func push(p_frame: XrFrame) -> void:
	_frames.push(p_frame)


## The tracking space was moved: the body goes along at once.
func recentre() -> void:
	_frames.recentre()


## Takes the body that the wearer is shown as, and the height of its hips, m. Returns why not, or an
## empty text.
func show_on(p_skeleton: PersonSkeleton, p_hips: float) -> String:
	var figure: ShownFigure = ShownFigure.of_skeleton(p_skeleton, p_hips, get_hip_height())
	if figure == null:
		return "the body that is shown has no joints of a person"
	_mutex.lock()
	_shown = figure
	_mutex.unlock()
	return ""


## What the devices said at a moment, µs of Unix time. For the thread that samples.
func _read_frame(p_time_usec: int) -> XrFrame:
	_frames.read(p_time_usec, _frame)
	return _frame


## Whether the tracking space was moved since the last call. For the thread that samples.
func _was_moved() -> bool:
	var times: int = _frames.recentred()
	var was_moved: bool = times != _recentred
	_recentred = times
	return was_moved


## The body that is shown, if one was said since the last call, else null.
func _take_shown() -> ShownFigure:
	_mutex.lock()
	var shown: ShownFigure = _shown
	_shown = null
	_mutex.unlock()
	return shown
