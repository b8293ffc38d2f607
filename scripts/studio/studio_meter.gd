@tool
class_name StudioMeter
extends RefCounted
## Measures what the studio says in its status bar: how long a check takes, from the pressing of a
## key to its picture, and how long a frame takes.

## Frames of which the median is shown.
const WINDOW: int = 30

## The last check, ms.
var check_ms: float = 0.0
## From the last key to the first picture that shows what it has changed, ms and frames; -1 if
## nothing has been typed yet.
var key_ms: float = -1.0
var key_frames: int = -1
## Median time of a frame, ms.
var frame_ms: float = 0.0

var _frames: PackedFloat64Array = []
var _last_usec: int = 0
var _key_usec: int = 0
var _key_frame: int = 0
var _is_shown: bool = false


## A key was pressed.
func note_key() -> void:
	_key_usec = Time.get_ticks_usec()
	_key_frame = Engine.get_frames_drawn()
	_is_shown = false


## What the key has changed goes into the next picture.
func note_shown() -> void:
	_is_shown = _key_usec > 0


## A picture has been drawn.
func note_frame() -> void:
	var now: int = Time.get_ticks_usec()
	if _is_shown:
		key_ms = (now - _key_usec) / 1000.0
		key_frames = maxi(Engine.get_frames_drawn() - _key_frame, 1)
		_is_shown = false
		_key_usec = 0
	if _last_usec > 0:
		_frames.append((now - _last_usec) / 1000.0)
		if _frames.size() > WINDOW:
			_frames.remove_at(0)
		var sorted: PackedFloat64Array = _frames.duplicate()
		sorted.sort()
		frame_ms = sorted[sorted.size() / 2]
	_last_usec = now


## One line for the status bar.
func describe() -> String:
	var text: String = "check %.1f ms" % check_ms
	if key_frames >= 0:
		text += "   key to picture %.0f ms, %d frames" % [key_ms, key_frames]
	return text + "   frame %.1f ms" % frame_ms
