extends TestCase
## Whoever sits on a platform and holds the head still sees the cabin still.

const STEP_S: float = 1.0 / 200.0

var _frame: PlatformFrame = PlatformFrame.new()


func before_each() -> void:
	_frame.neutral = Transform3D(Basis(Vector3.UP, 0.7), Vector3(0.4, 0.0, -1.0))


func test_a_head_on_a_moving_platform_does_not_move() -> void:
	var cueing: MotionCueing = MotionCueing.new()
	MotionPlatform.preset("large_hexapod").apply(cueing)
	WashoutParameters.new().apply(cueing)
	# The head of somebody on the seat, and of somebody who nods.
	var sits: Transform3D = Transform3D(Basis(Vector3.UP, 0.2), Vector3(0.0, 1.2, 0.1))
	_frame.delay_s = 0.04
	var moved: float = 0.0
	var poses: Array[Transform3D] = []
	for step: int in 2000:
		var time: float = step * STEP_S
		var force: Vector3 = Vector3(sin(time) * 3.0, 9.81 + sin(time * 5.0), sin(time * 0.7) * 4.0)
		cueing.step(force, Vector3(0.1, 0.3, 0.2) * sin(time * 1.3), STEP_S)
		_frame.push_cue(roundi(time * 1e6), cueing.get_position(), cueing.get_attitude())
		poses.append(PlatformFrame.of_cue(cueing.get_position(), cueing.get_attitude()))
		if step < 100:
			continue
		# The platform does what it was told 40 ms ago.
		var platform: Transform3D = _frame.neutral * poses[step - 8]
		var nod: Transform3D = sits * Transform3D(Basis(Vector3.RIGHT, sin(time)), Vector3.ZERO)
		for head: Transform3D in [sits, nod]:
			var seen: Transform3D = _frame.without_platform(platform * head, roundi(time * 1e6))
			almost_equal(seen, _frame.neutral * head, 2e-6)
		moved = maxf(moved, poses[step - 8].origin.length())
	is_true(moved > 0.05, "the platform moved by %f m" % moved)


func test_between_two_commands() -> void:
	_frame.push(0, Transform3D.IDENTITY)
	_frame.push(10_000, Transform3D(Basis(Vector3.RIGHT, 0.1), Vector3(0, 0.1, 0)))
	almost_equal(_frame.pose_at(2500).origin, Vector3(0, 0.025, 0), 1e-6)
	almost_equal(_frame.pose_at(2500).basis, Basis(Vector3.RIGHT, 0.025), 1e-5)
	almost_equal(_frame.pose_at(90_000).origin, Vector3(0, 0.1, 0), 1e-6)
	almost_equal(_frame.pose_at(-5).origin, Vector3.ZERO, 1e-6)


func test_without_a_platform_and_with_nonsense_nothing_is_taken_out() -> void:
	var head: Transform3D = Transform3D(Basis(Vector3.UP, 1.0), Vector3(1, 1.6, 2))
	almost_equal(_frame.without_platform(head, 1000), head, 1e-6)
	_frame.push(0, Transform3D(Basis.IDENTITY, Vector3(NAN, 0, 0)))
	_frame.push(1, Transform3D(Basis.from_scale(Vector3.ZERO), Vector3.ZERO))
	almost_equal(_frame.without_platform(head, 1000), head, 1e-6)
	for wrong: float in [NAN, -1.0, 99.0]:
		_frame.delay_s = wrong
		is_true(_frame.delay_s >= 0.0 and _frame.delay_s <= PlatformFrame.MAX_DELAY_S)
	_frame.push(2000, Transform3D(Basis.IDENTITY, Vector3.UP))
	_frame.clear()
	almost_equal(_frame.without_platform(head, 3000), head, 1e-6)


func test_a_session_of_hours_keeps_what_it_needs() -> void:
	for step: int in 5000:
		_frame.push(step * 5000, Transform3D(Basis.IDENTITY, Vector3(step * 0.001, 0, 0)))
	almost_equal(_frame.pose_at(4990 * 5000 + 2500).origin.x, 4.9905, 1e-4)
