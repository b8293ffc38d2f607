class_name HmdRuntime
extends RefCounted
## The OpenXR runtime of this process: its clock and its rate.

## Refreshes that a runtime wakes a program ahead of what it shows, where its clock is not ours.
const _LEAD_FRAMES: float = 2.0
## A rate for runtimes that have told none yet, Hz.
const _USUAL_HZ: float = 90.0
## A clock that differs by less than this is the system's own, µs.
const _SAME_CLOCK_USEC: int = 1_000_000
## Frames of which the earliest is looked for.
const _WINDOW: int = 30

## The engine's interface; null where it has none.
var interface: OpenXRInterface = null

var _api: OpenXRAPIExtension = null
var _is_same_clock: bool = false
var _ahead_usec: int = 0
var _predicted_ns: int = 0
var _shortest_ns: int = 0
var _window: PackedInt64Array = []


## The runtime of this process, or null where it was started without one or found none.
static func find() -> HmdRuntime:
	var found: OpenXRInterface = XRServer.find_interface("OpenXR") as OpenXRInterface
	if found == null or not found.is_initialized():
		return null
	var runtime: HmdRuntime = HmdRuntime.new()
	runtime.interface = found
	runtime._api = OpenXRAPIExtension.new()
	return runtime


## The moment for which the runtime wants pictures now, ns of its own clock; 0: none.
func predicted_ns() -> int:
	return _api.get_predicted_display_time()


## The rate that the runtime says, Hz; 0 where it does not, or is no more.
func told_rate_hz() -> float:
	return interface.get_display_refresh_rate()


## The rate of the headset, Hz: as the runtime says, else the shortest step of its clock; 0 before
## the first frames.
func rate_hz() -> float:
	var told: float = told_rate_hz()
	if told > 0.0 or _shortest_ns == 0:
		return told
	return 1e9 / _shortest_ns


## Whether the runtime wants pictures: not while nobody wears the headset.
func is_running() -> bool:
	return _api.is_running()


## Notes a frame: its predicted time against now, µs of [method Time.get_ticks_usec].
func note_frame(p_now_usec: int) -> void:
	var predicted: int = predicted_ns() / 1000
	if predicted == 0:
		return
	var step_ns: int = predicted_ns() - _predicted_ns
	_predicted_ns += step_ns
	# No headset shows more than 1000 pictures a second.
	if step_ns > 1_000_000 and (_shortest_ns == 0 or step_ns < _shortest_ns):
		_shortest_ns = step_ns
	var own_usec: int = ThreadClock.get_monotonic_usec()
	_is_same_clock = absi(predicted - own_usec) < _SAME_CLOCK_USEC
	var ahead: int = predicted - (own_usec if _is_same_clock else p_now_usec)
	_window.append(ahead)
	if _window.size() > _WINDOW:
		_window.remove_at(0)
	_ahead_usec = ahead


## When this frame will be seen, µs of [method Time.get_ticks_usec]; 0 where it is not known.
##
## Exact where the runtime tells time by the system's clock (most on Linux do). Another one's is
## guessed: of the last frames that which came earliest was woken two refreshes ahead.
func due_usec(p_now_usec: int) -> int:
	if _window.is_empty():
		return 0
	if _is_same_clock:
		return p_now_usec + _ahead_usec
	var earliest: int = _window[0]
	for ahead: int in _window:
		earliest = maxi(earliest, ahead)
	var rate: float = rate_hz()
	var lead: float = _LEAD_FRAMES * 1e6 / (rate if rate > 0.0 else _USUAL_HZ)
	return p_now_usec + maxi(0, _ahead_usec - earliest + roundi(lead))


## Whether [method due_usec] is exact, not guessed.
func is_exact() -> bool:
	return _is_same_clock


## Who makes runtime and headset, for reports.
func describe() -> String:
	var info: Dictionary = interface.get_system_info()
	var maker: String = info.get("XRRuntimeName", "a runtime without a name")
	return "%s %s" % [maker, info.get("XRRuntimeVersion", "")]
