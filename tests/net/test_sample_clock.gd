extends TestCase
## The moment of a wearer's motion at the server, under jitter, drift and jumps.

const DELTA: float = 1.0 / 60.0
const DELAY_S: float = 0.01

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _clock: SampleClock = null


func before_each() -> void:
	_random.seed = 6
	_clock = SampleClock.new()


func test_steady_under_jitter() -> void:
	var stats: Dictionary = _play(30.0, {"jitter": 0.02})
	is_true(stats["step_error_s"] < 0.001, "steps differ by %f s" % stats["step_error_s"])
	is_true(stats["lag_error_s"] < _most_lag(), "off by %f s" % stats["lag_error_s"])
	is_true(stats["in_time"] > 0.8, "%f of the ticks have their sample" % stats["in_time"])


func test_waits_for_nothing_where_samples_are_in_time() -> void:
	for step: int in 600:
		var now: float = 100.0 + step * DELTA
		_clock.arrived(20.0 + step * DELTA, now)
		var age: float = SampleClock.FREE_S * 0.9
		var moment: float = _clock.advance(now + age, DELTA)
		if step > 300:
			almost_equal(moment, 20.0 + step * DELTA + age, 1e-4)


func test_a_late_tick_is_no_other_moment() -> void:
	for step: int in 600:
		var now: float = 100.0 + step * DELTA
		_clock.arrived(20.0 + step * DELTA, now)
		# Every second one tick begins 30 ms late, and the two after it at once.
		var late: float = maxf(0.03 - (step % 60) * DELTA, 0.0)
		var moment: float = _clock.advance(now + late, DELTA)
		if step > 300:
			almost_equal(moment, 20.0 + step * DELTA, 0.0015)


func test_steady_under_jitter_and_loss_at_a_low_rate() -> void:
	var stats: Dictionary = _play(30.0, {"jitter": 0.03, "rate": 20.0, "loss": 0.05})
	is_true(stats["step_error_s"] < 0.002, "steps differ by %f s" % stats["step_error_s"])
	is_true(stats["lag_error_s"] < _most_lag(), "off by %f s" % stats["lag_error_s"])


func test_follows_drifting_clocks() -> void:
	for drift: float in [-1e-4, 1e-4]:
		_clock = SampleClock.new()
		var stats: Dictionary = _play(300.0, {"jitter": 0.01, "drift": drift})
		is_true(stats["lag_error_s"] < _most_lag(), "off by %f s" % stats["lag_error_s"])
		is_true(stats["step_error_s"] < 0.001, "steps differ by %f s" % stats["step_error_s"])


func test_follows_a_way_that_becomes_slower() -> void:
	# 0.1 s more for good: the ragdoll must not wait for samples that are always late.
	var stats: Dictionary = _play(30.0, {"jitter": 0.005, "later": 0.1})
	is_true(stats["lag_error_s"] < 0.004, "off by %f s" % stats["lag_error_s"])


func test_jumps_of_the_wearer() -> void:
	var now: float = 100.0
	var sample: float = 5000.0
	for jump: float in [0.0, 10.0, -30.0, 1e6, -1e6]:
		sample += jump
		for step: int in 60:
			_clock.arrived(sample, now)
			var moment: float = _clock.advance(now, DELTA)
			if step >= 2:
				almost_equal(moment, sample, 0.01)
			sample += DELTA
			now += DELTA


func test_goes_on_during_a_pause() -> void:
	for step: int in 60:
		_clock.arrived(20.0 + step * DELTA, 100.0 + step * DELTA)
		_clock.advance(100.0 + step * DELTA, DELTA)
	almost_equal(_clock.advance(101.0, DELTA), 21.0, 0.002)


func test_before_the_first_sample() -> void:
	_clock.advance(100.0, DELTA)
	_clock.advance(100.1, DELTA)
	_clock.arrived(20.0, 100.1)
	almost_equal(_clock.advance(100.1, DELTA), 20.0, 1e-3)


## How far the moment may be from that of the quickest sample, s.
static func _most_lag() -> float:
	return SampleClock.MAX_WAIT_S + 0.004


## Plays a stream and measures its last half: how unequal the steps are, how far the moment is from
## that of the quickest sample, and the share of ticks whose sample has come by then.
func _play(p_length_s: float, p_how: Dictionary) -> Dictionary:
	var drift: float = 1.0 + p_how.get("drift", 0.0)
	var arrivals: Array = []
	for i: int in int(p_length_s * p_how.get("rate", 60.0)):
		var taken: float = i / p_how.get("rate", 60.0)
		var delay: float = DELAY_S + _random.randf() * p_how["jitter"]
		delay += p_how.get("later", 0.0) if taken > p_length_s / 4.0 else 0.0
		if _random.randf() >= p_how.get("loss", 0.0):
			arrivals.append([taken + delay, 1.7e9 + taken * drift])
	arrivals.sort_custom(func(a: Array, b: Array) -> bool: return a[0] < b[0])
	var next: int = 0
	var before: float = NAN
	var worst: Dictionary = {"step_error_s": 0.0, "lag_error_s": 0.0}
	var newest: float = -INF
	var in_time: Statistics = Statistics.new()
	var now: float = 0.2
	while now < p_length_s:
		while next < arrivals.size() and arrivals[next][0] <= now:
			_clock.arrived(arrivals[next][1], now)
			newest = maxf(newest, arrivals[next][1])
			next += 1
		var moment: float = _clock.advance(now, DELTA)
		if now > p_length_s / 2.0:
			var wanted: float = 1.7e9 + (now - DELAY_S - p_how.get("later", 0.0)) * drift
			worst["lag_error_s"] = maxf(worst["lag_error_s"], absf(moment - wanted) - DELTA / 2.0)
			worst["step_error_s"] = maxf(worst["step_error_s"], absf(moment - before - DELTA))
			in_time.add(1.0 if moment < newest + SampleClock.FREE_S + 1e-3 else 0.0)
		before = moment
		now += DELTA
	worst["in_time"] = in_time.mean()
	return worst
