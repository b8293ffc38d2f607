class_name DisplayForecast
extends RefCounted
## When the frame that is being drawn will be seen in a headset, and at which rate, from the
## runtime's predictions.
##
## A frame's prediction is noted once, at its beginning, and holds for all of it: what is worked out
## twice in a frame is worked out for one moment. It never goes back.

## Refreshes between the waking of a program and the picture, where the runtime's clock is not ours.
const _LEAD_FRAMES: float = 2.0
## Longest time that a guess lies ahead, µs: the first steps may have been pauses.
const _LEAD_USEC: float = 100_000.0
## Rate to assume until the runtime gives one, Hz.
const _USUAL_HZ: float = 90.0
## Difference below which the runtime's clock counts as the system's own, µs.
const _SAME_CLOCK_USEC: int = 1_000_000
## Number of frames of which the earliest is used.
const _WINDOW: int = 30
## Shortest possible refresh, ns: 1000 pictures a second.
const _MIN_STEP_NS: int = 1_000_000

## When the frame will be seen, µs of [method Time.get_ticks_usec]; 0 where it is not known.
##
## Exact where the runtime tells time by the system's clock (most on Linux do). Another one's is
## guessed: of the last frames that which came earliest was woken two refreshes ahead.
var due_usec: int = 0
## Whether that is exact, not guessed.
var is_exact: bool = false

var _predicted_ns: int = 0
var _step_ns: int = 0
var _window: PackedInt64Array = []


## A frame begins. Takes the moment for which the runtime wants its picture (ns of the runtime's
## clock; 0: none), now by the system's monotonic clock (µs), now by [method Time.get_ticks_usec]
## (µs), and the rate that the runtime says (Hz; 0: none).
func note(
	p_predicted_ns: int, p_monotonic_usec: int, p_now_usec: int, p_reported_hz: float
) -> void:
	if p_predicted_ns <= 0:
		return
	var step_ns: int = p_predicted_ns - _predicted_ns
	if step_ns == 0:
		return
	var is_first: bool = _predicted_ns == 0
	_predicted_ns = p_predicted_ns
	if not is_first and step_ns > _MIN_STEP_NS and (_step_ns == 0 or step_ns < _step_ns):
		_step_ns = step_ns
	var ahead: int = p_predicted_ns / 1000 - p_monotonic_usec
	is_exact = absi(ahead) < _SAME_CLOCK_USEC
	if not is_exact:
		ahead = _guess(p_predicted_ns / 1000 - p_now_usec, p_reported_hz)
	due_usec = maxi(due_usec, p_now_usec + ahead)


## The shortest step of the runtime's clock as a rate, Hz; 0 before the second frame.
func rate_hz() -> float:
	return 1e9 / _step_ns if _step_ns > 0 else 0.0


func _guess(p_apart_usec: int, p_reported_hz: float) -> int:
	_window.append(p_apart_usec)
	if _window.size() > _WINDOW:
		_window.remove_at(0)
	var earliest: int = _window[0]
	for apart: int in _window:
		earliest = maxi(earliest, apart)
	var rate: float = p_reported_hz if p_reported_hz > 0.0 else rate_hz()
	var lead: float = _LEAD_FRAMES * 1e6 / (rate if rate > 0.0 else _USUAL_HZ)
	return maxi(0, p_apart_usec - earliest + roundi(minf(lead, _LEAD_USEC)))
