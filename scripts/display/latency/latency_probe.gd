class_name LatencyProbe
extends RefCounted
## Measures the delay from a sample to its display, stage by stage (thesis section 7.4).
##
## Marks arrive with snapshots. A mark is on the screen with the first frame that shows its tick or
## a later one, and counts when that frame is drawn. Memory is bounded however long it runs.

## Marks that wait for their tick at most; beyond it the oldest are given up.
const MAX_WAITING: int = 1024
## What is longer than this is a stream that had stopped, not a delay, ms.
const MAX_MS: float = 2000.0

## Delays from sample to display.
var total: LatencyHistogram = LatencyHistogram.new()
## Durations of each of [constant LatencyMark.STAGES].
var stages: Array[LatencyHistogram] = []
## The newest delay from sample to display, ms; 0 before the first.
var latest_ms: float = 0.0
## How old the motion is that each frame shows.
var frames: FrameAges = FrameAges.new()

var _waiting: Array[LatencyMark] = []
var _shown: Array[LatencyMark] = []
var _newest: Dictionary[int, int] = {}
var _file: LatencyFile = null


func _init() -> void:
	for _stage: StringName in LatencyMark.STAGES:
		stages.append(LatencyHistogram.new())


## Also writes a line for each mark to a CSV file. Returns what is wrong, or an empty text.
func write_to(p_path: String) -> String:
	_file = LatencyFile.new()
	return _file.open(p_path)


## Takes a mark that came with a snapshot. Snapshots name a sample until there is a newer one: each
## counts once.
func arrived(p_mark: LatencyMark) -> void:
	frames.arrived(p_mark)
	if _newest.get(p_mark.person, -1) == p_mark.sample:
		return
	_newest[p_mark.person] = p_mark.sample
	_waiting.append(p_mark)
	if _waiting.size() > MAX_WAITING:
		_waiting.pop_front()


## Notes that the next frame shows the world as it was at a tick of the server.
func shows(p_tick: float) -> void:
	var later: Array[LatencyMark] = []
	for mark: LatencyMark in _waiting:
		if mark.tick <= p_tick:
			_shown.append(mark)
		else:
			later.append(mark)
	_waiting = later


## Notes that the frame was drawn at a time of the server's clock, µs.
func drawn(p_now_usec: int) -> void:
	for mark: LatencyMark in _shown:
		mark.displayed_usec = p_now_usec
		_count(mark)
	_shown.clear()
	if _file != null:
		_file.keep()


## Forgets what has not been shown: another server begins its ticks anew.
func restart() -> void:
	_waiting.clear()
	_shown.clear()
	_newest.clear()
	frames.restart()


## Ends the file.
func close() -> void:
	if _file != null:
		_file.close()
		_file = null


## The stats for a report: of the total, and of each stage by its name.
func stats() -> Dictionary:
	var result: Dictionary = {"total": total.stats()}
	for stage: int in stages.size():
		result[String(LatencyMark.STAGES[stage])] = stages[stage].stats()
	return result


func _count(p_mark: LatencyMark) -> void:
	var ms: float = p_mark.total_ms()
	if ms > MAX_MS:
		return
	if not is_nan(ms):
		latest_ms = ms
	total.add(ms)
	for stage: int in stages.size():
		stages[stage].add(p_mark.stage_ms(stage))
	if _file != null:
		_file.add(p_mark)
