extends TestCase
## Users are told which part of a frame is waiting and which is drawing.


func test_parts_add_up_to_the_time_of_a_frame() -> void:
	var times: FrameTimes = FrameTimes.new()
	var now: int = 0
	for _frame: int in 200:
		times.begin(now)
		times.placed(now + 2000)
		times.drawn(now + 42000)
		now += 66000
	almost_equal(times.scene.mean(), 2.0, 0.01)
	almost_equal(times.drawing.mean(), 40.0, 0.01)
	almost_equal(times.waiting.mean(), 24.0, 0.01)
	equal(times.describe(), "a frame waits 24 ms, is set up in 2 ms and drawn in 40 ms")


func test_frames_that_are_not_drawn_count_nowhere() -> void:
	var times: FrameTimes = FrameTimes.new()
	for frame: int in 10:
		times.begin(frame * 16000)
		times.placed(frame * 16000 + 1000)
	equal(times.drawing.count(), 0)
	equal(times.waiting.count(), 0)
	times.drawn(200000)
	equal(times.drawing.count(), 1)
	times.drawn(300000)
	equal(times.drawing.count(), 1)
