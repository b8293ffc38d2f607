extends TestCase
## A runtime that has ended is noticed, and none that lives.

const _FRAME_USEC: int = 40_000


func test_a_clock_that_stands_still_without_a_rate_is_an_end() -> void:
	for predicted: int in [0, 123_456_789]:
		var watch: RuntimeWatch = RuntimeWatch.new()
		watch.restart(0)
		var ended_at: int = -1
		for frame: int in 30:
			if watch.has_ended(predicted, 0.0, frame * _FRAME_USEC) and ended_at < 0:
				ended_at = frame
		is_true(ended_at >= RuntimeWatch.FRAMES - 1 and ended_at < 15, "ended at %d" % ended_at)


func test_frames_without_a_pause_between_them_are_no_end() -> void:
	var watch: RuntimeWatch = RuntimeWatch.new()
	watch.restart(0)
	for frame: int in 100:
		is_false(watch.has_ended(5, 0.0, frame * 1000))


func test_a_running_clock_or_a_known_rate_is_life() -> void:
	var watch: RuntimeWatch = RuntimeWatch.new()
	watch.restart(0)
	for frame: int in 100:
		is_false(watch.has_ended(1000 + frame, 0.0, frame * _FRAME_USEC))
	for frame: int in 100:
		is_false(watch.has_ended(7, 90.0, (100 + frame) * _FRAME_USEC))
