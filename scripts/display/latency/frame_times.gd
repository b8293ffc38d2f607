class_name FrameTimes
extends RefCounted
## Where the time of frames goes: waiting before a frame begins, putting everything where it is, and
## drawing.
##
## What is waited for is the limit of frames, the screen, and whatever else the program does between
## two frames. A frame that is drawn by the processor takes most of its time in drawing; no setting
## helps then but a lower quality or a smaller window.

## From when the frame before was drawn to when this one began, ms.
var waiting: LatencyHistogram = LatencyHistogram.new()
## From the beginning until everything was where this frame shows it, ms.
var scene: LatencyHistogram = LatencyHistogram.new()
## From then until the frame was drawn, ms.
var drawing: LatencyHistogram = LatencyHistogram.new()

var _begun_usec: int = -1
var _placed_usec: int = -1
var _drawn_usec: int = -1


## A frame begins, at a time in µs.
func begin(p_now_usec: int) -> void:
	if _drawn_usec >= 0:
		waiting.add((p_now_usec - _drawn_usec) / 1000.0)
	_begun_usec = p_now_usec
	_drawn_usec = -1
	_placed_usec = -1


## Everything is where the frame shows it, at a time in µs.
func placed(p_now_usec: int) -> void:
	_placed_usec = p_now_usec


## The frame was drawn, at a time in µs.
func drawn(p_now_usec: int) -> void:
	if _placed_usec >= 0:
		scene.add((_placed_usec - _begun_usec) / 1000.0)
		drawing.add((p_now_usec - _placed_usec) / 1000.0)
	_placed_usec = -1
	_drawn_usec = p_now_usec


## The medians in words.
func describe() -> String:
	var parts: Array = [waiting.percentile(0.5), scene.percentile(0.5), drawing.percentile(0.5)]
	return "a frame waits %.0f ms, is set up in %.0f ms and drawn in %.0f ms" % parts


## Stats for a report, by part.
func stats() -> Dictionary:
	return {"waiting": waiting.stats(), "scene": scene.stats(), "drawing": drawing.stats()}
