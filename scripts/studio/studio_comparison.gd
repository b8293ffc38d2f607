@tool
class_name StudioComparison
extends RefCounted
## Measures what an effect costs: the time of a frame with nothing, with the effect, and with as
## many particles on the engine's CPU path ([CpuStandIn]), one after the other.

## Frames of each, and those before it that do not count.
const FRAMES: int = 40
const SETTLING: int = 15

var _preview: StudioPreview = null
var _stand_in: CpuStandIn = null
var _times: Array[PackedFloat64Array] = [
	PackedFloat64Array(), PackedFloat64Array(), PackedFloat64Array()
]
var _stage: int = 0
var _frames: int = 0
var _last_usec: int = 0


func _init(p_preview: StudioPreview) -> void:
	_preview = p_preview
	_preview.effect.visible = false


## A frame has been drawn. Returns whether all has been measured.
func note_frame() -> bool:
	var now: int = Time.get_ticks_usec()
	_frames += 1
	if _frames > SETTLING:
		_times[_stage].append((now - _last_usec) / 1000.0)
	_last_usec = now
	if _frames < SETTLING + FRAMES:
		return false
	_frames = 0
	_stage += 1
	_preview.effect.visible = _stage != 2
	if _stage == 2:
		_stand_in = CpuStandIn.make(_preview.effect)
		_preview.view.add_child(_stand_in)
	elif _stage == 3:
		_stand_in.queue_free()
	return _stage == 3


## What was measured.
func describe() -> String:
	var empty: float = _median(0)
	return (
		(
			"a frame takes %.1f ms without it, %.1f ms more with it (GPU path), %.1f ms more with as many "
			% [empty, _median(1) - empty, _median(2) - empty]
		)
		+ "CPU particles"
	)


func _median(p_stage: int) -> float:
	var sorted: PackedFloat64Array = _times[p_stage].duplicate()
	sorted.sort()
	return sorted[sorted.size() / 2] if not sorted.is_empty() else 0.0
