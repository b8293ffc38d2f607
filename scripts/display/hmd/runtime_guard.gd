class_name RuntimeGuard
extends RefCounted
## Watches that a headset's runtime does not keep the program waiting: a stalled one keeps it in a
## call for ever, and then the program starts again as a plain window.

## Time without an answer of the runtime after which it counts as stalled, s.
const PATIENCE_S: float = 5.0
## The same while pipelines are still compiled, s: for the first frames, and after a long one.
const _COLD_PATIENCE_S: float = 40.0
const _WARM_FRAMES: int = 30
## Duration from which on the work of scripts counts as loading, µs.
const _LONG_USEC: int = 1_000_000

var _guard: StallGuard = null
var _begin_usec: int = 0
var _warm_frames: int = 0


## Begins to watch; a frame is in its midst.
func begin() -> void:
	_guard = StallGuard.new()
	_warm_frames = 0
	# The guard's thread must not touch the engine: the arguments of the next process are prepared
	# now.
	OS.set_environment(HmdCommand.LOST, "The headset's runtime stalled: the window goes on.")
	_set_patience(_COLD_PATIENCE_S)


## A frame begins: the client's own work may take as long as it does.
func hold() -> void:
	_begin_usec = Time.get_ticks_usec()
	_guard.hold()


## The client's own work is done: from here to the next frame only engine and runtime can wait.
func beat() -> void:
	if _begin_usec != 0 and Time.get_ticks_usec() - _begin_usec > _LONG_USEC:
		_warm_frames = 0
		_set_patience(_COLD_PATIENCE_S)
	_warm_frames += 1
	if _warm_frames == _WARM_FRAMES:
		_set_patience(PATIENCE_S)
	_guard.beat()


## Watches no more.
func end() -> void:
	_guard.stop()
	OS.unset_environment(HmdCommand.LOST)


## Whether a runtime that stalls now is noticed within [constant PATIENCE_S].
func is_warm() -> bool:
	return _warm_frames >= _WARM_FRAMES


func _set_patience(p_patience_s: float) -> void:
	_guard.stop()
	_guard.hold()
	_guard.start(p_patience_s, HmdCommand.of_this_process().with_window())
