class_name FramePacer
extends RefCounted
## Locks the phase of a display to the server's ticks, where the program itself paces its frames:
## with a limit of frames per second and without vertical synchronisation.
##
## A state that comes just after a frame began waits for the next one: up to a whole frame, always
## the same, as there are as many frames as ticks, or a whole number of frames to each. By running a
## little faster or slower for a while, frames come to begin just after there is something new to
## show. With vertical synchronisation the screen decides.

## Frames per second without a window by default: as those of a fast display.
const HEADLESS_FPS: int = 144
## Time from a new state to the beginning of the frame that shows it, s.
const LEAD_S: float = 0.0015
## Error that is tolerated, s.
const TOLERANCE_S: float = 0.0008
## Frames per second more or less, while the phase is being moved.
const NUDGE: int = 2

var _limit: int = 0


## Takes the limit of frames per second; 0 for none, then nothing is paced.
func _init(p_limit: int) -> void:
	_limit = p_limit


## The limit for the next frame, when a tick (with its fraction) is shown of a server that makes so
## many a second.
func limit_for(p_shown_tick: float, p_tick_rate: float) -> int:
	if p_shown_tick < 0.0 or p_tick_rate <= 0.0:
		return _limit
	var frames_per_tick: float = _limit / p_tick_rate
	if frames_per_tick < 1.0 or not is_equal_approx(frames_per_tick, roundf(frames_per_tick)):
		return _limit
	var period: float = 1.0 / _limit
	# How long ago a frame was due, of which one begins when a new state could be shown for the first
	# time; half a period off is a late frame.
	var since: float = fposmod(p_shown_tick * frames_per_tick, 1.0) * period
	var late: float = since - LEAD_S
	if late > period / 2.0:
		late -= period
	if absf(late) < TOLERANCE_S:
		return _limit
	return _limit + NUDGE if late > 0.0 else _limit - NUDGE


## Whether this program paces its frames itself.
static func is_free() -> bool:
	if DisplayServer.get_name() == "headless":
		return true
	return DisplayServer.window_get_vsync_mode() == DisplayServer.VSYNC_DISABLED
