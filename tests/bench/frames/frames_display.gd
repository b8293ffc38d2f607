extends RefCounted
## A client's display of any rate, and the LAN between it and the server, in simulated time.
##
## The clocks of server and display run freely: their phase drifts. A trainee samples before a tick
## begins; the step takes some time, and so does the network.

## Ticks of the server per second.
const TICK_RATE: int = 60
## From a sample to the begin of the tick that moves by it, s: see [ClientMotion].
const LEAD_S: float = 1.0 / 240.0
## From a tick's begin to the sending of what became of it, s.
const STEP_S: float = 0.0025
## The least time of a datagram on the network, how late it is on average, and at most how late one
## of twenty is, s.
const TRANSIT_S: float = 0.0003
const LATE_S: float = 0.0004
const LATER_S: float = 0.006
## Lost datagrams, %.
const LOSS: float = 1.0
## What is shown before it counts, s.
const SETTLING_S: float = 2.0

## Frames per second.
var rate: float = 60.0
## By how much frames begin later than the screen's beat at most, s; 0 where no screen paces them.
var lateness_s: float = 0.0
## How old the motion was that each frame showed, at the time of the frame.
var ages: FrameAges = FrameAges.new()

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


## Takes a display, and a seed of all that is by chance.
func _init(p_rate: float, p_lateness_s: float, p_seed: int) -> void:
	rate = p_rate
	lateness_s = p_lateness_s
	_random.seed = p_seed


## When the sample was taken that a tick moves by, s.
static func sampled_s(p_tick: int) -> float:
	return float(p_tick) / TICK_RATE - LEAD_S


## Runs for so many seconds: calls p_push with a tick and the time of its arrival (s), evaluates,
## calls p_show with the time that a frame is for, s.
func play(
	p_smoother: SnapshotSmoother, p_seconds: float, p_push: Callable, p_show: Callable
) -> void:
	p_smoother.tick_rate = TICK_RATE
	var clock: FrameClock = FrameClock.new(rate if lateness_s > 0.0 else 0.0)
	var arrivals: Array[Vector2] = _arrivals(p_seconds)
	var next: int = 0
	for frame: int in range(int(rate * 0.1), int(rate * p_seconds)):
		var beat: float = (frame + 0.33) / rate
		# Most begin soon, few late.
		var begin: float = beat + lateness_s * pow(_random.randf(), 3.0)
		while next < arrivals.size() and arrivals[next].x <= begin:
			var tick: int = int(arrivals[next].y)
			p_push.call(tick, arrivals[next].x)
			_mark(tick)
			next += 1
		p_smoother.evaluate(clock.begin(roundi(begin * 1e6)) / 1e6)
		if beat > SETTLING_S:
			p_show.call(beat)
			ages.drawn(p_smoother.get_motion_tick(), TICK_RATE, roundi(beat * 1e6))


func _mark(p_tick: int) -> void:
	var mark: LatencyMark = LatencyMark.new()
	mark.tick = p_tick
	mark.sampled_usec = roundi(sampled_s(p_tick) * 1e6)
	ages.arrived(mark)


## When which tick arrives, in the order of arrival.
func _arrivals(p_seconds: float) -> Array[Vector2]:
	var arrivals: Array[Vector2] = []
	for tick: int in range(1, int(TICK_RATE * p_seconds)):
		var late: float = -log(1.0 - _random.randf()) * LATE_S
		late += LATER_S * _random.randf() if _random.randf() < 0.05 else 0.0
		if _random.randf() * 100.0 >= LOSS:
			arrivals.append(Vector2(float(tick) / TICK_RATE + STEP_S + TRANSIT_S + late, tick))
	arrivals.sort()
	return arrivals
