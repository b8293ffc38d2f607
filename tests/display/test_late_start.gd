extends TestCase
## Frames begin as late as the screen allows, and no frame is lost for it.

const PERIOD: int = 16667


func test_short_frames_begin_late() -> void:
	var start: LateStart = _worked(3000, 200)
	var wait: int = start.wait_usec(0, PERIOD)
	equal(wait, PERIOD - 3000 - LateStart.SPARE_USEC)
	# It counts from then on, not from the sum of all waits.
	equal(start.wait_usec(PERIOD, PERIOD), wait)


func test_long_frames_do_not_wait() -> void:
	for work: int in [14200, 16000, 40000, 900000]:
		equal(_worked(work, 200).wait_usec(0, PERIOD), 0)


func test_nothing_waits_while_nothing_is_known() -> void:
	equal(_worked(3000, 20).wait_usec(0, PERIOD), 0)
	equal(_worked(3000, 200).wait_usec(0, 0), 0)


func test_missed_frames_make_it_careful_for_a_while() -> void:
	var start: LateStart = _worked(3000, 200)
	var usual: int = start.wait_usec(0, PERIOD)
	var now: int = 2 * PERIOD
	var careful: int = start.wait_usec(now, PERIOD)
	is_true(careful < usual - 1900, "%d after a miss, %d before" % [careful, usual])
	for _frame: int in 600:
		now += PERIOD
		careful = start.wait_usec(now, PERIOD)
	equal(careful, usual)


func test_in_a_simulated_session_no_more_frames_are_lost_than_without() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 11
	var start: LateStart = LateStart.new()
	var lost: int = 0
	var late_usec: int = 0
	var now: int = 0
	for frame: int in 6000:
		var wait: int = start.wait_usec(now, PERIOD)
		var work: int = random.randi_range(3000, 5000)
		start.worked(work)
		late_usec += PERIOD - wait
		var ready: int = now + wait + work
		var beats: int = ceili(float(ready - now) / PERIOD)
		lost += beats - 1
		now += beats * PERIOD
	equal(lost, 0)
	# From when the frame begins to when it is seen.
	is_true(late_usec / 6000 < 8000, "%d µs" % (late_usec / 6000))


static func _worked(p_usec: int, p_frames: int) -> LateStart:
	var start: LateStart = LateStart.new()
	for _frame: int in p_frames:
		start.worked(p_usec)
	return start
