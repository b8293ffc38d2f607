@tool
class_name StudioComparison
extends RefCounted
## Measures what an effect costs: the time of a frame with nothing, with the effect, and with as
## many particles on the engine's CPU path ([CpuStandIn]), one after the other.

## Frames of each, and those before it that do not count.
const FRAMES: int = 60
const SETTLING: int = 20
## Clock ticks of the kernel in a second, in which it counts the time of a process.
const _CLOCK: float = 100.0

var _preview: StudioPreview = null
var _stand_in: CpuStandIn = null
## Processor time of a frame with nothing, the effect, the stand-in, ms.
var _times: PackedFloat64Array = []
var _frames: int = 0
var _begin_ms: float = 0.0


func _init(p_preview: StudioPreview) -> void:
	_preview = p_preview
	_preview.effect.visible = false


## A frame has been drawn. Returns whether all has been measured.
func note_frame() -> bool:
	_frames += 1
	if _frames == SETTLING:
		_begin_ms = _spent_ms()
	if _frames < SETTLING + FRAMES:
		return false
	_times.append((_spent_ms() - _begin_ms) / FRAMES)
	_frames = 0
	_preview.effect.visible = _times.size() != 2
	if _times.size() == 2:
		_stand_in = CpuStandIn.make(_preview.effect)
		_preview.view.add_child(_stand_in)
	elif _times.size() == 3:
		_stand_in.queue_free()
	return _times.size() == 3


## What was measured.
func describe() -> String:
	return (
		(
			"processor time of a frame: %.1f ms without it, %.1f more with it (GPU path), %.1f more with "
			% [_times[0], _times[1] - _times[0], _times[2] - _times[0]]
		)
		+ "as many CPU particles"
	)


## Processor time of all threads of this process; where the system does not tell it, the time of the
## clock on the wall.
static func _spent_ms() -> float:
	var file: FileAccess = FileAccess.open("/proc/self/stat", FileAccess.READ)
	if file == null:
		return Time.get_ticks_usec() / 1000.0
	var fields: PackedStringArray = file.get_line().get_slice(") ", 1).split(" ")
	return (fields[11].to_float() + fields[12].to_float()) * 1000.0 / _CLOCK
