extends TestCase
## Frames come to begin just after there is something new to show, and stay there.

const RATE: int = 60


func test_frames_drift_to_the_right_phase_from_anywhere() -> void:
	for start: int in 20:
		var shown: float = 1000.0 + start / 20.0
		var pacer: FramePacer = FramePacer.new(RATE)
		for _frame: int in 60 * 3:
			shown += float(RATE) / pacer.limit_for(shown, RATE)
		var late_s: float = _late(shown)
		is_true(absf(late_s) < 2.0 * FramePacer.TOLERANCE_S, "from %d: %f s late" % [start, late_s])


func test_several_frames_to_a_tick_find_the_phase_too() -> void:
	for start: int in 20:
		var shown: float = 1000.0 + start / 20.0
		var pacer: FramePacer = FramePacer.new(2 * RATE)
		for _frame: int in 120 * 3:
			shown += float(RATE) / pacer.limit_for(shown, RATE)
		var since_s: float = fposmod(shown, 0.5) / RATE
		is_true(
			absf(since_s - FramePacer.LEAD_S) < 2.0 * FramePacer.TOLERANCE_S,
			"from %d: %f s after" % [start, since_s]
		)


func test_it_stays_there_while_clocks_differ() -> void:
	# The server's clock is quicker by 0.02 %: twenty times what quartz does.
	var pacer: FramePacer = FramePacer.new(RATE)
	var shown: float = 1000.0 + FramePacer.LEAD_S * RATE
	for _frame: int in 60 * 60:
		shown += 1.0002 * RATE / pacer.limit_for(shown, RATE)
		if absf(_late(shown)) > 2.0 * FramePacer.TOLERANCE_S:
			fail("%f s late" % _late(shown))
			return
	is_true(absf(_late(shown)) <= 2.0 * FramePacer.TOLERANCE_S)


func test_the_direction() -> void:
	var pacer: FramePacer = FramePacer.new(RATE)
	var right: float = FramePacer.LEAD_S * RATE
	equal(pacer.limit_for(7.0 + right, RATE), RATE)
	equal(pacer.limit_for(7.0 + right + 0.2, RATE), RATE + FramePacer.NUDGE, "late: hurry")
	equal(pacer.limit_for(7.0 + right - 0.2, RATE), RATE - FramePacer.NUDGE, "early: wait")


func test_it_leaves_alone_what_it_cannot_pace() -> void:
	var pacer: FramePacer = FramePacer.new(RATE)
	equal(pacer.limit_for(-1.0, RATE), RATE, "nothing is shown yet")
	equal(pacer.limit_for(7.5, 0.0), RATE, "the rate is not known")
	equal(pacer.limit_for(7.5, 50.0), RATE, "the server ticks otherwise")
	for limit: int in [30, 59, 144]:
		equal(FramePacer.new(limit).limit_for(7.5, RATE), limit, "the display runs otherwise")
	equal(FramePacer.new(0).limit_for(7.5, RATE), 0, "the screen decides")


func test_without_a_window_the_program_paces_itself() -> void:
	is_true(FramePacer.is_free() or DisplayServer.get_name() != "headless")


## How late a frame begins after the moment that it should, s.
func _late(p_shown: float) -> float:
	var late: float = fposmod(p_shown, 1.0) / RATE - FramePacer.LEAD_S
	return late - 1.0 / RATE if late > 0.5 / RATE else late
