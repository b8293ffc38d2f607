extends TestCase
## What scripts see of the smoother; gdextension/wire/tests has the rest.

const METHODS: int = 6

var _smoother: SnapshotSmoother = SnapshotSmoother.new()


func test_the_default_shows_a_walking_person_a_little_late_and_without_gaps() -> void:
	is_true(_add_person(3))
	is_false(_smoother.has_person(3))
	equal(_smoother.get_shown_tick(), -1.0)
	for tick: int in 120:
		is_true(_push(3, tick))
		_smoother.evaluate(tick / 60.0 + 0.002)
	is_true(_smoother.has_person(3))
	is_true(_smoother.get_shown_tick() > 115.0 and _smoother.get_shown_tick() <= 120.0)
	var floats: PackedFloat32Array = _smoother.person_transforms(3)
	equal(floats.size(), 14)
	almost_equal(floats[0], _smoother.get_shown_tick() / 60.0, 0.005)
	# The second limb hangs on the first by its end, turned by a quarter.
	almost_equal(Vector3(floats[7] - floats[0], floats[8], floats[9]), Vector3(0.5, 1.5, 0), 1e-4)
	var newest: PackedFloat32Array = _smoother.newest_person_transforms(3)
	almost_equal(newest[0], 119 / 60.0, 1e-5)


func test_a_body_goes_on_and_rests() -> void:
	var turned: Transform3D = Transform3D(Basis(Vector3.UP, 0.5), Vector3(1, 2, 3))
	is_true(_smoother.push_body(9, 60, 1.0, turned, Vector3.RIGHT, Vector3.ZERO, false))
	_smoother.method = SnapshotSmoother.ERROR_OFFSET
	_smoother.evaluate(1.0)
	almost_equal(_smoother.body_transform(9), turned, 1e-5)
	for frame: int in 30:
		_smoother.evaluate(1.0 + frame / 60.0)
	almost_equal(_smoother.body_transform(9).origin, Vector3(1 + 29 / 60.0, 2, 3), 0.01)
	almost_equal(_smoother.newest_body_transform(9), turned, 1e-5)
	is_true(_smoother.has_body(9))


func test_every_method_shows_something() -> void:
	for method: int in METHODS:
		_smoother = SnapshotSmoother.new()
		_smoother.method = method as SnapshotSmoother.Method
		equal(_smoother.method, method as SnapshotSmoother.Method)
		_add_person(0)
		for tick: int in 60:
			_push(0, tick)
			_smoother.evaluate(tick / 60.0)
		almost_equal(_smoother.person_transforms(0)[0], 0.95, 0.06, str(method))
		is_true(_smoother.get_delay() >= 0.0)
		almost_equal(_smoother.server_time(2.0), 2.0, 0.01)


func test_the_option_names_every_method() -> void:
	equal(WorldReplica.SMOOTHING.size(), METHODS)


func test_what_makes_no_sense_is_refused() -> void:
	is_false(_push(3, 1), "no skeleton")
	is_false(_smoother.set_skeleton(3, [0, 0], [Vector3.ZERO], [Vector3.ZERO]))
	is_false(_smoother.set_skeleton(3, [], [], []))
	is_true(_add_person(3))
	var two: PackedFloat32Array = [0, 0, 0, 1, 0, 0, 0, 1]
	is_false(_smoother.push_person(3, 1, 0.0, Vector3.ZERO, two.slice(0, 7)))
	is_false(_smoother.push_person(3, 1, 0.0, Vector3.ZERO, two.slice(0, 4)))
	is_false(_smoother.push_person(3, -1, 0.0, Vector3.ZERO, two))
	is_false(_smoother.push_person(-1, 1, 0.0, Vector3.ZERO, two))
	is_false(_smoother.push_person(3, 1, NAN, Vector3.ZERO, two))
	is_false(_smoother.push_person(3, 1, 0.0, Vector3(NAN, 0, 0), two))
	is_false(_smoother.push_body(70000, 1, 0.0, Transform3D(), Vector3.ZERO, Vector3.ZERO, true))
	is_false(
		_smoother.push_body(
			7, 1, 0.0, Transform3D(Basis(), Vector3.INF), Vector3.ZERO, Vector3.ZERO, true
		)
	)
	_smoother.evaluate(0.0)
	is_true(_smoother.person_transforms(3).is_empty())
	is_true(_smoother.person_transforms(-5).is_empty())
	equal(_smoother.server_time(1.0), -1.0)
	expect_error("no such method")
	_smoother.set_method(99 as SnapshotSmoother.Method)
	expect_error("a tick rate is above 0")
	_smoother.tick_rate = 0.0
	equal(_smoother.tick_rate, 60.0)


func test_feedback_shows_the_wearer_and_the_wall() -> void:
	var feedback: LocalFeedback = LocalFeedback.new()
	is_false(feedback.evaluate(0.0, 0.0))
	is_true(
		feedback.set_skeleton(
			[-1, 0], [Vector3.ZERO, Vector3(0.5, 0, 0)], [Vector3.ZERO, Vector3(-0.5, 0, 0)]
		)
	)
	var straight: PackedFloat32Array = [0, 0, 0, 1, 0, 0, 0, 1]
	var held: PackedFloat32Array = [0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, sin(0.25), 0, cos(0.25)]
	for frame: int in 60:
		is_true(feedback.push_local(frame / 60.0, Vector3.ZERO, straight))
		is_true(feedback.evaluate(frame / 60.0, frame / 60.0))
		almost_equal(
			feedback.transforms(),
			PackedFloat32Array([0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 1]),
			1e-5
		)
	for frame: int in range(60, 100):
		feedback.push_local(frame / 60.0, Vector3.ZERO, straight)
		is_true(feedback.push_truth(frame / 60.0, held))
		feedback.evaluate(frame / 60.0, frame / 60.0)
	almost_equal(feedback.deviation(1), 0.5, 0.005)
	almost_equal(feedback.newest_moment(), 99 / 60.0, 1e-9)
	is_false(feedback.push_truth(2.0, held.slice(0, 13)))
	is_false(feedback.push_local(2.0, Vector3.ZERO, straight.slice(0, 4)))
	expect_error("no limb of that number")
	feedback.deviation(7)
	feedback.clear()
	is_false(feedback.evaluate(2.0, 2.0))


func _add_person(p_id: int) -> bool:
	return _smoother.set_skeleton(
		p_id, [-1, 0], [Vector3.ZERO, Vector3(0.5, 0, 0)], [Vector3.ZERO, Vector3(-0.5, 0, 0)]
	)


func _push(p_id: int, p_tick: int) -> bool:
	var up: Quaternion = Quaternion(Vector3.BACK, PI / 2.0)
	return _smoother.push_person(
		p_id,
		p_tick,
		p_tick / 60.0,
		Vector3(p_tick / 60.0, 1.0, 0.0),
		[0, 0, 0, 1, up.x, up.y, up.z, up.w]
	)
