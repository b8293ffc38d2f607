extends TestCase
## Frames are evaluated for the even beat of the screen, not for when they happen to begin.

const RATES: Array[float] = [50.0, 59.0, 60.0, 72.0, 75.0, 90.0, 120.0, 144.0]

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 5


func test_late_frames_are_for_the_beat_at_every_rate() -> void:
	for rate: float in RATES:
		# The screen's own rate is never quite what it says.
		for off: float in [-0.003, 0.0, 0.003]:
			var spread: Vector2 = _spread(rate, rate * (1.0 + off), 0.0)
			is_true(spread.y < 0.4 * spread.x, "%.0f Hz: %s" % [rate, spread])


func test_frames_that_are_left_out_do_not_move_the_beat() -> void:
	for rate: float in RATES:
		var spread: Vector2 = _spread(rate, rate, 0.1)
		is_true(spread.y < 0.6 * spread.x, "%.0f Hz: %s" % [rate, spread])


func test_what_follows_no_beat_is_taken_as_it_comes() -> void:
	var clock: FrameClock = FrameClock.new(60.0)
	var now: int = 1000000
	var off: int = 0
	for frame: int in 600:
		now += _random.randi_range(12000, 60000)
		off += 1 if clock.begin(now) != now and frame > 200 else 0
	is_true(off < 20, "%d of 400 were moved" % off)


func test_without_a_screen_that_paces_them_frames_are_when_they_begin() -> void:
	for rate: float in [0.0, -1.0]:
		var clock: FrameClock = FrameClock.new(rate)
		for now: int in [1000, 5000, 22000, 900000]:
			equal(clock.begin(now), now)
	if DisplayServer.get_name() == "headless":
		equal(FrameClock.of_window().begin(12345), 12345)


func test_time_never_goes_back() -> void:
	var clock: FrameClock = FrameClock.new(60.0)
	var now: int = 0
	var before: int = 0
	for frame: int in 3000:
		# Even frames, then uneven ones, pauses, and drawing that takes more or less.
		var is_even: bool = frame % 1000 < 500
		now += 16667 if is_even else _random.randi_range(1000, 90000)
		now += 3000000 if frame % 700 == 0 else 0
		var time: int = clock.begin(now)
		clock.drawn(now + _random.randi_range(0, 20000))
		is_true(time >= before)
		is_true(absi(time - now) < 40000, "frame %d: %d µs off" % [frame, time - now])
		before = time


func test_after_a_pause_the_beat_is_found_anew() -> void:
	var clock: FrameClock = FrameClock.new(60.0)
	var now: int = 0
	for _frame: int in 100:
		now += 16667
		clock.begin(now)
	now += 5000000
	equal(clock.begin(now), now)


func test_what_drawing_takes_is_made_up_for_within_bounds() -> void:
	for takes: int in [0, 2000, 30000, 66000, 400000]:
		var clock: FrameClock = FrameClock.new()
		var now: int = 0
		for frame: int in 300:
			now += 500000
			clock.begin(now)
			# Now and then one has to load something.
			clock.drawn(now + takes + (700000 if frame % 7 == 6 else 0))
		var next: int = now + 500000
		equal(clock.begin(next) - next, mini(takes, FrameClock.MAX_DRAWING_USEC))


func test_who_knows_when_a_frame_is_seen_decides() -> void:
	var clock: FrameClock = FrameClock.new(90.0)
	equal(clock.begin(1000000, 1022000), 1022000)
	# A runtime that answers nothing, or nonsense.
	equal(clock.begin(1100000, 0), 1100000)
	equal(clock.begin(1200000, 5000000), 1200000 + FrameClock.MAX_DRAWING_USEC)
	is_true(clock.begin(1210000, 1215000) >= 1200000 + FrameClock.MAX_DRAWING_USEC)


## How far from the beat frames begin, and how far from it the clock has them: standard deviations,
## µs. The screen has another rate than it says; frames begin up to 4 ms late, some are left out.
func _spread(p_rate: float, p_true_rate: float, p_left_out: float) -> Vector2:
	var clock: FrameClock = FrameClock.new(p_rate)
	var begins: LatencyHistogram = LatencyHistogram.new()
	var times: LatencyHistogram = LatencyHistogram.new()
	for frame: int in 3000:
		if _random.randf() < p_left_out:
			continue
		var beat: float = (frame + 1) * 1e6 / p_true_rate
		var now: int = roundi(beat + 4000.0 * pow(_random.randf(), 3.0))
		var time: int = clock.begin(now)
		if frame > 1000:
			begins.add((now - beat) / 1000.0)
			times.add((time - beat) / 1000.0)
	return 1000.0 * Vector2(begins.deviation(), times.deviation())
