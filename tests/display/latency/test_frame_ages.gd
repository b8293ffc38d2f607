extends TestCase
## How old motion is at each frame: counted by what was sampled, not by what a frame claims.

const TICK_USEC: int = 20000
const RATE: float = 50.0

var _frames: FrameAges = FrameAges.new()


func test_between_two_marks_samples_are_as_far_apart_as_their_marks_say() -> void:
	_frames.arrived(_mark(100, 1000000))
	_frames.arrived(_mark(102, 1060000))
	_frames.drawn(100.0, RATE, 1010000)
	almost_equal(_frames.ages.mean(), 10.0, 1e-6)
	_frames.drawn(101.0, RATE, 1050000)
	almost_equal(_frames.recent_ms, 10.0 + FrameAges.RECENT_GAIN * 10.0, 1e-6)
	equal(_frames.ages.count(), 2)
	almost_equal(_frames.ages.mean(), 15.0, 1e-6)


func test_beyond_the_newest_mark_time_goes_on_at_the_tick_rate() -> void:
	_frames.arrived(_mark(100, 1000000))
	_frames.drawn(100.5, RATE, 1025000)
	almost_equal(_frames.ages.mean(), 15.0, 1e-6)


func test_while_nothing_comes_motion_grows_old() -> void:
	_frames.arrived(_mark(100, 1000000))
	# What is shown does not go on.
	for frame: int in 10:
		_frames.drawn(101.0, RATE, 1030000 + frame * 10000)
	almost_equal(_frames.ages.percentile(1.0), 100.0, LatencyHistogram.BIN_MS)


func test_what_no_mark_speaks_of_is_not_counted() -> void:
	_frames.drawn(100.0, RATE, 1000000)
	_frames.arrived(_mark(100, 1000000))
	_frames.drawn(-1.0, RATE, 1000000)
	_frames.drawn(99.0, RATE, 1000000)
	_frames.drawn(100.0, 0.0, 1000000)
	_frames.drawn(100.0 + 3.0 * RATE, RATE, 4000000)
	var unknown: LatencyMark = _mark(200, LatencyMark.UNKNOWN)
	_frames.arrived(unknown)
	equal(_frames.ages.count(), 0)
	_frames.drawn(100.0, RATE, 1010000)
	equal(_frames.ages.count(), 1)


func test_one_person_is_followed_until_gone() -> void:
	_frames.arrived(_mark(100, 1000000))
	# Somebody else's samples take longer.
	var other: LatencyMark = _mark(101, 500000)
	other.person = 2
	_frames.arrived(other)
	_frames.drawn(101.0, RATE, 1030000)
	almost_equal(_frames.ages.mean(), 10.0, 1e-6)
	other = _mark(300, 5000000)
	other.person = 2
	_frames.arrived(other)
	_frames.drawn(300.0, RATE, 5010000)
	equal(_frames.ages.count(), 2)


func test_marks_out_of_order_and_another_server() -> void:
	_frames.arrived(_mark(100, 1000000))
	_frames.arrived(_mark(99, 2000000))
	_frames.drawn(100.0, RATE, 1010000)
	almost_equal(_frames.ages.mean(), 10.0, 1e-6)
	_frames.restart()
	_frames.drawn(100.0, RATE, 1010000)
	equal(_frames.ages.count(), 1)
	_frames.arrived(_mark(3, 1000000))
	_frames.drawn(3.0, RATE, 1010000)
	equal(_frames.ages.count(), 2)


func test_memory_is_bounded() -> void:
	for tick: int in 10 * FrameAges.MAX_KEPT:
		_frames.arrived(_mark(tick, tick * TICK_USEC))
	# The oldest mark that is left.
	var oldest: int = 9 * FrameAges.MAX_KEPT
	_frames.drawn(oldest - 1.0, RATE, oldest * TICK_USEC)
	equal(_frames.ages.count(), 0)
	_frames.drawn(oldest, RATE, oldest * TICK_USEC)
	equal(_frames.ages.count(), 1)


static func _mark(p_tick: int, p_sampled_usec: int) -> LatencyMark:
	var mark: LatencyMark = LatencyMark.new()
	mark.person = 1
	mark.tick = p_tick
	mark.sampled_usec = p_sampled_usec
	return mark
