extends TestCase
## Whoever runs a server learns that its machine is too slow, and when it is well again.

const RATE: float = 60.0

var _now: float = 10.0
var _changes: int = 0


func test_a_world_at_full_speed_is_not_slow() -> void:
	var watch: TickWatch = TickWatch.new(RATE)
	_run(watch, 1.0, 20.0)
	is_false(watch.is_slow)
	almost_equal(watch.speed, 1.0, 0.02)
	equal([_changes, watch.slow_windows], [0, 0])


func test_slow_and_well_again_are_told_once_each() -> void:
	var watch: TickWatch = TickWatch.new(RATE)
	_run(watch, 1.0, 3.0)
	_run(watch, 0.5, 5.0)
	is_true(watch.is_slow)
	equal(_changes, 1, "five slow seconds are told once")
	almost_equal(watch.speed, 0.5, 0.05)
	is_true(watch.slow_windows >= 3, "%d slow windows" % watch.slow_windows)
	_run(watch, 1.0, 5.0)
	is_false(watch.is_slow)
	equal(_changes, 2)


func test_the_first_second_does_not_count() -> void:
	var watch: TickWatch = TickWatch.new(RATE)
	_run(watch, 0.2, TickWatch.GRACE_S * 0.95)
	_run(watch, 1.0, 5.0)
	equal([_changes, watch.slow_windows], [0, 0])


func test_what_is_slow_from_the_start_is_told_after_that() -> void:
	var watch: TickWatch = TickWatch.new(RATE)
	_run(watch, 0.5, TickWatch.GRACE_S + TickWatch.WINDOW_S + 0.2)
	is_true(watch.is_slow)
	equal(_changes, 1)


func test_it_takes_more_to_be_well_than_not_to_be_slow() -> void:
	var watch: TickWatch = TickWatch.new(RATE)
	_run(watch, 1.0, 2.5)
	_run(watch, 0.965, 10.0)
	is_false(watch.is_slow, "above %s" % TickWatch.SLOW)
	_run(watch, 0.9, 4.0)
	is_true(watch.is_slow)
	_run(watch, 0.965, 10.0)
	is_true(watch.is_slow, "below %s" % TickWatch.WELL)
	_run(watch, 1.0, 4.0)
	is_false(watch.is_slow)
	equal(_changes, 2)


func test_the_edges() -> void:
	# 64 steps a second, so that the times are exact: windows of exactly 64 ticks.
	var watch: TickWatch = TickWatch.new(64.0)
	for tick: int in 64 * 8:
		watch.ticked(tick / 64.0)
	equal(watch.speed, 1.0)
	# Exactly as many as make it just not slow: 95 of 100.
	watch = TickWatch.new(100.0)
	for tick: int in 95 * 8:
		watch.ticked(tick / 95.0)
		is_true(watch.speed > 0.94, "speed %f" % watch.speed)
	almost_equal(watch.speed, 0.95, 0.011)


func test_a_world_that_stood_still_is_slow() -> void:
	var watch: TickWatch = TickWatch.new(RATE)
	_run(watch, 1.0, 3.0)
	_now += 30.0
	is_true(watch.ticked(_now))
	is_true(watch.is_slow)
	is_true(watch.speed < 0.1)


func test_a_clock_that_stands_or_goes_back_does_no_harm() -> void:
	var watch: TickWatch = TickWatch.new(RATE)
	for _tick: int in 200:
		is_false(watch.ticked(5.0))
	is_false(watch.ticked(-100.0))
	equal(watch.speed, 1.0)


## Ticks at a speed for some seconds.
func _run(p_watch: TickWatch, p_speed: float, p_seconds: float) -> void:
	for _tick: int in roundi(p_seconds * RATE * p_speed):
		_now += 1.0 / (RATE * p_speed)
		_changes += 1 if p_watch.ticked(_now) else 0
