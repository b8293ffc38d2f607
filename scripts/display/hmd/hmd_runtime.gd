class_name HmdRuntime
extends RefCounted
## The OpenXR runtime of this process: its clock and its rate.
##
## What it takes of the action map: an action with one path that a runtime does not know is refused
## as a whole, and so are all suggestions for a profile with such a path. SteamVR refuses the
## trackers' roles handheld_object, wrists and ankles, and with them every pose and tracker would be
## gone: the map has the others.

## The engine's interface; null where it has none.
var interface: OpenXRInterface = null

var _api: OpenXRAPIExtension = null
var _reported_hz: float = 0.0
var _forecast: DisplayForecast = DisplayForecast.new()


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


## The rate that the runtime says in this frame, Hz; 0 where it does not, or is no more.
func reported_rate_hz() -> float:
	return _reported_hz


## The rate of the headset, Hz: as the runtime says, else the shortest step of its clock; 0 before
## the first frames.
func rate_hz() -> float:
	var told: float = reported_rate_hz()
	return told if told > 0.0 else _forecast.rate_hz()


## Width and height of each eye's picture as the runtime wants it, pixels: before any step of
## [RateKeeper].
func eye_size() -> Array[int]:
	var size: Vector2 = interface.get_render_target_size()
	return [roundi(size.x), roundi(size.y)]


## Whether the runtime wants pictures: not while nobody wears the headset.
func is_running() -> bool:
	return _api.is_running()


## A frame begins: notes when the runtime will show it.
func note_frame() -> void:
	_reported_hz = interface.get_display_refresh_rate()
	var now: int = Time.get_ticks_usec()
	_forecast.note(predicted_ns(), ThreadClock.get_monotonic_usec(), now, _reported_hz)


## When this frame will be seen, µs of [method Time.get_ticks_usec]; 0 where it is not known: see
## [member DisplayForecast.due_usec].
func due_usec() -> int:
	return _forecast.due_usec


## Whether [method due_usec] is exact, not guessed.
func is_exact() -> bool:
	return _forecast.is_exact


## Who makes runtime and headset, for reports.
func describe() -> String:
	var info: Dictionary = interface.get_system_info()
	var maker: String = info.get("XRRuntimeName", "a runtime without a name")
	return "%s %s" % [maker, info.get("XRRuntimeVersion", "")]
