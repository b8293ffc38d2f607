class_name FrameClock
extends RefCounted
## The moment that a frame shows, by a steady clock: where the screen paces the frames it is the
## moment of the refresh, however late the frame begins.
##
## A frame that begins late is seen no later: motion has to be evaluated for the beat, or it
## trembles. The beat is found from when frames begin, by a filter that follows phase and period.
## Where nothing paces the frames evenly (no vertical synchronisation, a machine that is too slow),
## the beat is when they begin. To it comes what drawing takes: motion is that of when the frame is
## there, not of when work on it began. So a slow renderer shows the world as late as a quick one,
## as far as motion can be carried on.

## Share of a phase error that each frame corrects; the period's share makes both settle without
## overshoot.
const PHASE_GAIN: float = 0.1
const PERIOD_GAIN: float = 0.005
## Greatest difference of the period from the screen's, as a fraction.
const PERIOD_ERROR: float = 0.02
## Mean error beyond which frames follow no beat, as a fraction of the period: where frames come at
## random it is a quarter.
const MAX_NOISE: float = 0.17
## Weight of a frame in that mean.
const NOISE_GAIN: float = 0.02
## Periods without a frame after which the beat is searched anew.
const MAX_MISSED: int = 30
## Greatest time of drawing that is compensated, µs: extrapolation further ahead would be worse.
const MAX_DRAWING_USEC: int = 100000
## Frames whose median gives the time of drawing: a frame that had to load something does not count.
const DRAWN_FRAMES: int = 9

var _nominal_usec: float = 0.0
var _period_usec: float = 0.0
var _time_usec: float = -INF
var _noise: float = 0.0
var _last_usec: int = 0
var _begun_usec: int = 0
var _drawing_usec: int = 0
var _drawn_usec: PackedInt64Array = []


## Takes the rate at which a screen paces the frames, 1/s; 0 or below where nothing does.
func _init(p_rate: float = 0.0) -> void:
	_nominal_usec = 1e6 / p_rate if p_rate > 0.0 else 0.0
	_period_usec = _nominal_usec


## The clock of this program's window.
static func of_window() -> FrameClock:
	if DisplayServer.get_name() == "headless":
		return FrameClock.new()
	var mode: DisplayServer.VSyncMode = DisplayServer.window_get_vsync_mode()
	if mode == DisplayServer.VSYNC_DISABLED or mode == DisplayServer.VSYNC_MAILBOX:
		return FrameClock.new()
	return FrameClock.new(DisplayServer.screen_get_refresh_rate())


## The time of the frame that begins at a time, both µs of one clock. It never goes back. Where
## somebody knows when the frame will be seen, such as a headset's runtime, it is for
## [param p_due_usec] instead.
func begin(p_now_usec: int, p_due_usec: int = 0) -> int:
	_begun_usec = p_now_usec
	if p_due_usec > p_now_usec:
		_last_usec = maxi(mini(p_due_usec, p_now_usec + MAX_DRAWING_USEC), _last_usec)
		return _last_usec
	var beat: float = p_now_usec
	if _nominal_usec > 0.0:
		_follow(p_now_usec)
		if _noise < MAX_NOISE:
			beat = _time_usec
	_last_usec = maxi(roundi(beat) + _drawing_usec, _last_usec)
	return _last_usec


## Notes when the frame that began last was drawn, µs.
func drawn(p_now_usec: int) -> void:
	_drawn_usec.append(clampi(p_now_usec - _begun_usec, 0, MAX_DRAWING_USEC))
	if _drawn_usec.size() > DRAWN_FRAMES:
		_drawn_usec.remove_at(0)
	var sorted: PackedInt64Array = _drawn_usec.duplicate()
	sorted.sort()
	_drawing_usec = sorted[sorted.size() / 2]


func _follow(p_now_usec: int) -> void:
	var since: float = p_now_usec - _time_usec
	# The first frame comes after endless time.
	if since > MAX_MISSED * _period_usec:
		_time_usec = p_now_usec
		_noise = 0.0
		return
	var periods: float = maxf(roundf(since / _period_usec), 1.0)
	var error: float = since - periods * _period_usec
	_noise = lerpf(_noise, absf(error) / _period_usec, NOISE_GAIN)
	if error < -0.5 * _period_usec:
		# Two frames of one beat: the screen does not pace them.
		_time_usec = p_now_usec
		return
	_time_usec += periods * _period_usec + PHASE_GAIN * error
	_period_usec = clampf(
		_period_usec + PERIOD_GAIN * error,
		_nominal_usec * (1.0 - PERIOD_ERROR),
		_nominal_usec * (1.0 + PERIOD_ERROR)
	)
