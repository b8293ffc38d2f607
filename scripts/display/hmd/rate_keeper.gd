class_name RateKeeper
extends RefCounted
## Holds a headset's rate by drawing less: it steps the quality down where frames are missed, and up
## again where there has been room for long.
##
## A step down comes within a second; a step up only after a quiet time that doubles whenever it was
## regretted: a picture that changes back and forth is worse than a small one. Where the card tells
## how long it draws, a step up waits for room as well, and comes sooner where there is room.
##
## What counts is how many frames are late, not how late: one that takes a second, such as when
## somebody joins, is no slow picture.

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
## A frame is missed if it takes longer than the period by this share of it.
const _SLACK: float = 0.5
## Length from which on a frame counts as a pause, s.
const _PAUSE_S: float = 1.0
## Length of a window of frames that are judged together, s.
const _WINDOW_S: float = 1.0
## Least number of frames of a window: with fewer it is longer.
const _WINDOW_FRAMES: int = 4
## Share of late frames, and least number of them, that cause a step down.
const _LATE: float = 0.05
const _LATE_LEAST: int = 3
## Late frames that a quiet window may have.
const _QUIET_LATE: int = 1
## Quiet time before a step up, s: at first, and at most.
const _QUIET_S: float = 20.0
const _QUIET_LONGEST_S: float = 320.0
## The same where the card has room: a share of it.
const _QUIET_WITH_ROOM: float = 0.25
## Share of the period below which a better picture must stay, by estimate, for the card to have
## room.
const _ROOM: float = 0.75
## What the card draws longer with samples for smooth edges and with shadows, by estimate.
const _COST_MSAA: Dictionary[Viewport.MSAA, float] = {
	Viewport.MSAA_DISABLED: 1.0, Viewport.MSAA_2X: 1.15, Viewport.MSAA_4X: 1.3
}
const _COST_SHADOWS: float = 1.25
## Time within which a step down after a step up counts as a regret, s.
const _REGRET_S: float = 10.0
## Time after a step in which frames do not count, s: the first are slow.
const _SETTLE_S: float = 0.5

## Which of [constant STEPS] is drawn.
var step: int = 0
## Frames that were shown.
var frames: int = 0
## Refreshes of the headset that had no new frame.
var missed: int = 0

var _window_frames: int = 0
var _window_late: int = 0
var _window_s: float = 0.0
var _window_card_s: float = 0.0
var _quiet_s: float = 0.0
var _needed_s: float = _QUIET_S
var _since_up_s: float = INF
var _settling_s: float = 0.0


## A frame: how long it was since the last one, between two of the headset's refreshes, and how long
## the card drew (0: it doesn't tell), s. One that was held up by something else, such as by
## compiling what draws, is counted and says nothing of the quality; nor does a pause.
func add(
	p_frame_s: float, p_period_s: float, p_card_s: float = 0.0, p_is_held_up: bool = false
) -> void:
	if p_period_s <= 0.0 or not is_finite(p_frame_s) or p_frame_s <= 0.0:
		return
	if p_frame_s > _PAUSE_S:
		_begin_window()
		return
	var late: int = maxi(0, floori(p_frame_s / p_period_s - _SLACK + 0.001))
	frames += 1
	missed += late
	_since_up_s += p_frame_s
	if p_is_held_up:
		_begin_window()
		return
	if _settling_s > 0.0:
		_settling_s -= p_frame_s
		return
	_window_frames += 1
	_window_late += mini(late, 1)
	_window_s += p_frame_s
	_window_card_s += p_card_s
	if _window_s >= _WINDOW_S and _window_frames >= _WINDOW_FRAMES:
		_judge(p_period_s)


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


func _judge(p_period_s: float) -> void:
	var is_late: bool = _window_late >= _LATE_LEAST and _window_late > _LATE * _window_frames
	_quiet_s = _quiet_s + _window_s if _window_late <= _QUIET_LATE else 0.0
	var card_s: float = _window_card_s / _window_frames
	_begin_window()
	if is_late and step < STEPS.size() - 1:
		if _since_up_s < _REGRET_S:
			_needed_s = minf(2.0 * _needed_s, _QUIET_LONGEST_S)
		_go(step + 1)
	elif step > 0 and _quiet_s >= _needed_s * _patience(card_s, p_period_s):
		_since_up_s = 0.0
		_go(step - 1)


## The share of the quiet time that a step up takes: infinite where the card has no room for it.
func _patience(p_card_s: float, p_period_s: float) -> float:
	if p_card_s <= 0.0:
		return 1.0
	var better_s: float = p_card_s * _cost(step - 1) / _cost(step)
	return _QUIET_WITH_ROOM if better_s < _ROOM * p_period_s else INF


## What a step costs the card, in terms of the last step's resolution without anything else.
static func _cost(p_step: int) -> float:
	var row: Dictionary = STEPS[p_step]
	var msaa: Viewport.MSAA = row["msaa"]
	return float(row["scale"]) ** 2 * _COST_MSAA[msaa] * (_COST_SHADOWS if row["shadows"] else 1.0)


func _go(p_step: int) -> void:
	step = p_step
	_quiet_s = 0.0
	_settling_s = _SETTLE_S
	stepped.emit(step)


func _begin_window() -> void:
	_window_frames = 0
	_window_late = 0
	_window_s = 0.0
	_window_card_s = 0.0
