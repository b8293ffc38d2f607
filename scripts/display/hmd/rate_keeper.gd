class_name RateKeeper
extends RefCounted
## Holds a headset's rate by drawing less: it steps the quality down where frames are missed, and up
## again where there has been room for long.
##
## A step down comes within a second; a step up only after a time without a missed frame that
## doubles whenever it was regretted: a picture that changes back and forth is worse than a small
## one.

## The quality is another.
signal stepped(p_step: int)

## What is drawn at each step: resolution (share of the runtime's in each direction), samples for
## smooth edges, directional shadows, and what others leave out (0 all, 3 the least).
const STEPS: Array[Dictionary] = [
	{"scale": 1.0, "msaa": Viewport.MSAA_4X, "shadows": true, "detail": 0},
	{"scale": 1.0, "msaa": Viewport.MSAA_2X, "shadows": true, "detail": 0},
	{"scale": 0.9, "msaa": Viewport.MSAA_2X, "shadows": true, "detail": 1},
	{"scale": 0.8, "msaa": Viewport.MSAA_2X, "shadows": true, "detail": 1},
	{"scale": 0.8, "msaa": Viewport.MSAA_DISABLED, "shadows": false, "detail": 2},
	{"scale": 0.65, "msaa": Viewport.MSAA_DISABLED, "shadows": false, "detail": 2},
	{"scale": 0.5, "msaa": Viewport.MSAA_DISABLED, "shadows": false, "detail": 3},
]
## A frame is missed where it takes longer than this share of the period more.
const _SLACK: float = 0.5
## Looked at together, s.
const _WINDOW_S: float = 1.0
## More missed frames than this share of a window: a step down.
const _MISSED: float = 0.05
## Quiet time before a step up, s: at first, and at most.
const _QUIET_S: float = 20.0
const _QUIET_LONGEST_S: float = 320.0
## A step down this soon after a step up was a regret, s.
const _REGRET_S: float = 10.0
## After a step the first frames are slow whatever they show, s.
const _SETTLE_S: float = 0.5

## Which of [constant STEPS] is drawn.
var step: int = 0
## Frames that were shown.
var frames: int = 0
## Refreshes of the headset that had no new frame.
var missed: int = 0

var _window_frames: int = 0
var _window_missed: int = 0
var _window_s: float = 0.0
var _quiet_s: float = 0.0
var _needed_s: float = _QUIET_S
var _since_up_s: float = INF
var _settling_s: float = 0.0


## A frame: how long it was since the last one and between two of the headset's refreshes, s. A
## frame that takes longer than [param p_longest_s] was a pause, not a slow picture.
func add(p_frame_s: float, p_period_s: float, p_longest_s: float = 1.0) -> void:
	if p_period_s <= 0.0 or not is_finite(p_frame_s) or p_frame_s <= 0.0:
		return
	if p_frame_s > p_longest_s:
		_begin_window()
		return
	var late: int = maxi(0, floori(p_frame_s / p_period_s - _SLACK + 0.001))
	frames += 1
	missed += late
	_since_up_s += p_frame_s
	if _settling_s > 0.0:
		_settling_s -= p_frame_s
		return
	_window_frames += 1 + late
	_window_missed += late
	_window_s += p_frame_s
	if _window_s >= _WINDOW_S:
		_judge()


## What is drawn now, in words: "80 %, without shadows".
func describe() -> String:
	var row: Dictionary = STEPS[step]
	var parts: PackedStringArray = ["at %d %%" % roundi(100.0 * float(row["scale"]))]
	if not row["shadows"]:
		parts.append("without the sun's shadows")
	if row["msaa"] == Viewport.MSAA_DISABLED:
		parts.append("without smoothed edges")
	elif row["msaa"] == Viewport.MSAA_2X:
		parts.append("with edges smoothed less")
	return ", ".join(parts)


## Share of refreshes without a new frame, 0 to 1.
func missed_share() -> float:
	return float(missed) / maxf(1.0, float(frames + missed))


func _judge() -> void:
	var share: float = float(_window_missed) / maxf(1.0, float(_window_frames))
	_quiet_s = _quiet_s + _window_s if _window_missed == 0 else 0.0
	_begin_window()
	if share > _MISSED and step < STEPS.size() - 1:
		if _since_up_s < _REGRET_S:
			_needed_s = minf(2.0 * _needed_s, _QUIET_LONGEST_S)
		_go(step + 1)
	elif _quiet_s >= _needed_s and step > 0:
		_since_up_s = 0.0
		_go(step - 1)


func _go(p_step: int) -> void:
	step = p_step
	_quiet_s = 0.0
	_settling_s = _SETTLE_S
	stepped.emit(step)


func _begin_window() -> void:
	_window_frames = 0
	_window_missed = 0
	_window_s = 0.0
