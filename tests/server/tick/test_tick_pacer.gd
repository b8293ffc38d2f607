extends TestCase
## A server's ticks begin when they are due, whatever a frame costs.


func test_frames_lead_up_to_the_next_tick() -> void:
	for rate: float in [30.0, 60.0, 120.0, 240.0]:
		for percent: int in 100:
			var left: float = (1.0 - percent / 100.0) * 1e6 / rate + TickPacer.MARGIN_USEC
			var frame: int = TickPacer.frame_usec(percent / 100.0, rate)
			var frames: float = roundf(left / frame)
			is_true(frame > 0 and frame <= TickPacer.MAX_FRAME_USEC + 1.0)
			is_true(absf(frames * frame - left) <= frames, "%f: %d of %f" % [rate, frame, left])


func test_ticks_are_even_though_frames_begin_late() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 2
	var period: float = 1e6 / 60.0
	var now: float = 0.0
	var ticks: int = 0
	var worst: float = 0.0
	var frames: int = 0
	while ticks < 600:
		var due: int = floori(now / period)
		worst = maxf(worst, now - due * period) if due > ticks else worst
		ticks = due
		frames += 1
		now += TickPacer.frame_usec(fposmod(now / period, 1.0), 60.0) + random.randf() * 300.0
	is_true(worst < 400.0, "a tick began %.0f µs late" % worst)
	is_true(frames <= 5 * 600 + 5, "%d frames for 600 ticks" % frames)


func test_a_broken_fraction_makes_no_endless_frame() -> void:
	for fraction: float in [-1.0, 1.0, 7.0]:
		var frame: int = TickPacer.frame_usec(fraction, 60.0)
		is_true(frame > 0 and frame <= TickPacer.MAX_FRAME_USEC + 1.0)
