extends TestCase
## Devices' frames at any moment, written by one thread and read by another.

const BEGIN: int = 5_000_000

var _frames: XrFrames = XrFrames.new()
var _read: XrFrame = XrFrame.new()


func test_a_moment_between_two_frames() -> void:
	is_false(_frames.read(BEGIN, _read), "nothing yet")
	for at: int in 100:
		_frames.push(_frame(BEGIN + at * 11_000, Vector3(at * 0.01, 1.6, 0.0)))
	for at: float in [98.5, 90.25, 70.0, 99.0]:
		is_true(_frames.read(BEGIN + roundi(at * 11_000), _read))
		almost_equal(_read.head.origin, Vector3(at * 0.01, 1.6, 0.0), 1e-4)
		equal(_read.time_usec, BEGIN + roundi(at * 11_000))


func test_a_runtime_that_stalls_knows_nothing_after_a_while() -> void:
	_frames.push(_frame(BEGIN, Vector3.UP))
	is_true(_frames.read(BEGIN + 200_000, _read))
	is_true(_read.has_head)
	is_false(_frames.read(BEGIN + 300_000, _read))
	is_false(_read.has_head or _read.has_place)


func test_a_clock_that_was_set_back_begins_anew() -> void:
	_frames.push(_frame(BEGIN, Vector3.UP))
	_frames.push(_frame(BEGIN - 1000, Vector3.ZERO))
	is_true(_frames.read(BEGIN - 2000, _read))
	almost_equal(_read.head.origin, Vector3.ZERO, 1e-6)
	_frames.recentre()
	equal(_frames.recentred(), 1)
	is_false(_frames.read(BEGIN - 1000, _read), "frames of the old space are forgotten")


func test_two_threads() -> void:
	var thread: Thread = Thread.new()
	thread.start(_write)
	var torn: int = 0
	for _round: int in 3000:
		if _frames.read(BEGIN + 1_000_000, _read) or _read.has_head:
			var place: Vector3 = _read.head.origin
			torn += 0 if is_equal_approx(place.x, place.y) and place.x == place.z else 1
	thread.wait_to_finish()
	equal(torn, 0)
	is_true(_frames.read(BEGIN + 3000, _read))


func _write() -> void:
	for at: int in 3000:
		_frames.push(_frame(BEGIN + at, Vector3.ONE * (at * 0.01)))


func _frame(p_usec: int, p_place: Vector3) -> XrFrame:
	var frame: XrFrame = XrFrame.new()
	frame.time_usec = p_usec
	frame.head.origin = p_place
	frame.has_head = true
	frame.has_place = true
	return frame
