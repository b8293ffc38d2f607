extends TestCase
## A wearer's trunk, head and arms on the legs of somebody who walks by a stick.

const CLIP: String = "res://assets/motion/Boxing_Toes.bvh"
const STEP_S: float = 1.0 / 60.0
const STEP_USEC: int = 16667
const BEGIN_USEC: int = 1_000_000_000
const ARM: int = Limbs.LEFT_LOWER_ARM
const LEG: int = Limbs.LEFT_UPPER_LEG


## Somebody who does not move.
class Still:
	extends MotionSource
	var pose: PoseSample = CalibrationGuide.countdown(ResetPose.Kind.N).pose_at(0.0)

	func _init() -> void:
		pose.root.y = get_hip_height()

	func _read(p_time_usec: int) -> PoseSample:
		var made: PoseSample = PoseSample.new()
		made.orientations = pose.orientations.duplicate()
		made.root = pose.root
		made.time_usec = p_time_usec
		return made

	## As on a chair.
	func sit() -> void:
		for limb: int in [Limbs.LEFT_UPPER_LEG, Limbs.RIGHT_UPPER_LEG]:
			pose.set_orientation(limb, Quaternion(Vector3.LEFT, PI / 2.0))
		pose.root.y = 0.5


var _course: SubViewport = null
var _bodies: WalkerBodies = null
var _legs: WalkedLegs = null
var _plain: MotionSource = null
var _own: PoseSample = null
var _now: int = BEGIN_USEC
# What the stick says: ahead and to the right, m/s, and a turn to the left, rad/s.
var _stick: Vector3 = Vector3.ZERO
var _hands: WalkerInput = WalkerInput.new()
# The greatest step of the root so far, m.
var _max_step: float = 0.0
var _before: PoseSample = null


func before_each() -> void:
	_course = SubViewport.new()
	_course.own_world_3d = true
	add_child(_course)
	_box(Vector3(200.0, 1.0, 200.0), Vector3(0.0, -0.5, 0.0))
	await physics_frames(2)
	_bodies = WalkerBodies.new()
	_carry(_clip(), _clip())


func after_each() -> void:
	_legs.ground.leave()
	_course.free()


func test_at_rest_the_sample_is_the_clip_s() -> void:
	for _time: int in 60:
		var made: PoseSample = _advance()
		var own: PoseSample = _own
		equal(made.orientations, own.orientations)
		equal(made.root, own.root)
		equal([made.time_usec, made.id], [own.time_usec, own.id])
	equal(_legs.share(), 0.0)


func test_the_stick_carries_who_goes_on_boxing() -> void:
	_run(0.5)
	_stick.x = 1.5
	_run(1.0)
	equal(_legs.share(), 1.0)
	var from: Vector3 = _before.root
	var ticks: int = 240
	var arm: float = 0.0
	var leg: float = 0.0
	for _time: int in ticks:
		var made: PoseSample = _advance()
		var own: PoseSample = _own
		arm = maxf(arm, Rotations.between_deg(made.orientation(ARM), own.orientation(ARM)))
		leg += Rotations.between_deg(made.orientation(LEG), own.orientation(LEG)) / ticks
	almost_equal(_flat(_before.root - from).length() / (ticks * STEP_S), 1.5, 0.1)
	is_true(arm < 0.1, "arms are the clip's, off by %.2f deg" % arm)
	is_true(leg > 10.0, "legs are not, off by %.1f deg" % leg)
	is_true(_max_step < 3.0 * STEP_S, "%.3f m" % _max_step)


func test_let_go_the_own_legs_stand_where_the_walker_stopped() -> void:
	_stick.x = 1.5
	_run(2.0)
	_stick.x = 0.0
	_run(WalkedLegs.BLEND_S + 2.0 * STEP_S)
	equal(_legs.share(), 0.0)
	var own: PoseSample = _own
	almost_equal(Rotations.between_deg(_before.orientation(LEG), own.orientation(LEG)), 0.0, 0.05)
	_run(0.5)
	var offset: Vector3 = _before.root - _own.root
	is_true(_flat(offset).length() > 2.0)
	almost_equal(offset.y, 0.0, 0.02)
	_run(1.0)
	almost_equal(_before.root - _own.root, offset, 1e-4, "travel stays")
	is_true(_max_step < 3.0 * STEP_S, "%.3f m" % _max_step)


func test_a_runner_slows_down_by_steps() -> void:
	_stick.x = 3.4
	_run(2.0)
	_stick.x = 0.0
	var slowed: float = 0.0
	while _legs.share() > 0.0 and slowed < 2.0:
		_run(STEP_S)
		slowed += STEP_S
	is_true(slowed < 1.0, "%.2f s" % slowed)
	is_true(_max_step < 4.5 * STEP_S, "%.3f m" % _max_step)


func test_who_lies_does_not_jump_up() -> void:
	var still: Still = Still.new()
	for limb: int in Limbs.COUNT:
		still.pose.set_orientation(limb, Quaternion(Vector3.RIGHT, PI / 2.0))
	still.pose.root.y = 0.15
	_carry(still, Still.new())
	_run(0.1)
	_stick.x = 0.5
	_run(1.0)
	equal(_legs.share(), 1.0)
	almost_equal(_before.root.y, 0.95, 0.05)
	is_true(_max_step < 2.5 * STEP_S, "%.3f m" % _max_step)


func test_a_turn_turns_the_wearer_and_where_ahead_is() -> void:
	_carry(Still.new(), Still.new())
	_run(0.1)
	_stick.z = PI / 2.0
	_run(1.0)
	_stick.z = 0.0
	_run(1.0)
	almost_equal(Rotations.facing_of(_before.orientation(Limbs.CHEST)), PI / 2.0, 0.03)
	almost_equal(Rotations.facing_of(_before.orientation(Limbs.HIPS)), PI / 2.0, 0.03)
	is_true(_flat(_before.root).length() < 0.1, "turns about the own hips")
	_stick.x = 1.5
	_run(2.0)
	is_true(_before.root.x > 2.0, str(_before.root))
	is_true(absf(_before.root.z) < 0.2, str(_before.root))


func test_who_turns_on_the_chair_steers() -> void:
	var still: Still = Still.new()
	_carry(still, Still.new())
	_stick.x = 1.5
	_run(2.0)
	for limb: int in Limbs.COUNT:
		still.pose.set_orientation(limb, Rotations.yaw(-PI / 2.0) * still.pose.orientation(limb))
	_run(2.0)
	var from: Vector3 = _before.root
	_run(1.0)
	var way: Vector3 = _before.root - from
	is_true(way.x < -1.4 and absf(way.z) < 0.1, str(way))


func test_walls_stop_it() -> void:
	_box(Vector3(20.0, 3.0, 0.4), Vector3(0.0, 1.5, 3.0))
	await physics_frames(2)
	_carry(Still.new(), Still.new())
	_stick.x = 1.5
	_run(4.0)
	is_true(_before.root.z < 2.7 and _before.root.z > 2.2, str(_before.root))


func test_steps_raise_it() -> void:
	for step: int in 4:
		_box(
			Vector3(4.0, 0.34 * (step + 1), 8.0), Vector3(0.0, 0.17 * (step + 1), 6.0 + step * 0.4)
		)
	await physics_frames(2)
	_carry(Still.new(), Still.new())
	_stick.x = 1.5
	_run(4.0)
	_stick.x = 0.0
	_run(2.0)
	equal(_legs.share(), 0.0)
	almost_equal(_before.root.y - _own.root.y, 4 * 0.34, 0.03)


func test_the_person_s_frame_may_be_anywhere_in_the_world() -> void:
	_carry(Still.new(), Still.new())
	_legs.frame = Transform3D(Basis(Vector3.UP, 1.0), Vector3(20.0, 0.0, -30.0))
	_legs.embody(1.14, _skeleton())
	_stick.x = 1.5
	_run(0.5)
	var from: Vector3 = _before.root
	var feet: Vector3 = _legs.ground.mover.get_position()
	_run(2.0)
	var way: Vector3 = _before.root - from
	almost_equal(way.normalized(), Vector3.BACK, 0.03, "ahead in the own frame")
	almost_equal(way.length() * _legs.ground.scale, 3.0, 0.1, "m of the world")
	var moved: Vector3 = _legs.ground.mover.get_position() - feet
	almost_equal(moved.normalized(), Vector3(sin(1.0), 0.0, cos(1.0)), 0.03)


func test_a_body_that_is_held_back_holds_the_walker() -> void:
	_carry(Still.new(), Still.new())
	_stick.x = 1.5
	for _time: int in 120:
		_run(STEP_S)
		# As behind a crate that the client's mover passes.
		var ahead: float = _before.root.z - 1.0
		_legs.frame.origin.z = minf(0.0, -ahead)
	is_true(_legs.ground.mover.get_position().z < 1.0 + 2.0 * TravelFrame.SLACK_M)
	_legs.frame.origin = Vector3(50.0, 0.0, 0.0)
	_run(0.5)
	is_true(_legs.ground.mover.get_position().x > 45.0, "who is put elsewhere walks there")
	is_true(_max_step < 3.0 * STEP_S, "%.3f m" % _max_step)


func test_who_has_fallen_does_not_walk() -> void:
	_carry(Still.new(), Still.new())
	_stick.x = 1.5
	_run(1.0)
	# The body lies where the motion still stands.
	_legs.frame.origin.y = -0.7
	_run(1.0)
	equal(_legs.share(), 0.0)
	var fallen: Vector3 = _before.root
	_run(1.0)
	almost_equal(_before.root, fallen, 1e-4)
	_legs.frame.origin.y = 0.0
	_run(1.0)
	is_true(_before.root.z > fallen.z + 1.0, "up again")


func test_only_who_walks_is_sampled_in_physics_frames() -> void:
	_run(0.5)
	is_false(_legs.needs_world())
	_stick.x = 1.5
	_run(0.5)
	is_true(_legs.needs_world())
	_stick.x = 0.0
	_run(2.0)
	is_false(_legs.needs_world())
	# The sampler's thread goes on where the main thread was, and takes nobody anywhere.
	_stick.x = 1.5
	_legs.listen(STEP_S)
	var thread: Thread = Thread.new()
	thread.start(_legs.sample.bind(_now + STEP_USEC))
	var made: PoseSample = thread.wait_to_finish()
	almost_equal(made.root, _before.root, 0.05)
	is_null(_legs.sample(_now + STEP_USEC - 500), "no moment twice")


func test_who_sits_on_a_chair_stands_on_the_walker_s_legs() -> void:
	var still: Still = Still.new()
	still.sit()
	_carry(still, Still.new())
	_run(1.5)
	equal(_legs.share(), 1.0)
	almost_equal(_before.root.y, 0.95, 0.06)
	_stick.x = 1.5
	_run(2.0)
	_stick.x = 0.0
	_run(1.5)
	equal(_legs.share(), 1.0, "not in mid-air beside a chair")
	_legs.raises_seated = false
	_run(1.0)
	equal(_legs.share(), 0.0, "in a seat of the world")
	almost_equal(_before.root.y, 0.5, 0.03)


func test_squats_and_lunges_are_no_chair() -> void:
	var still: Still = Still.new()
	for leg: Array in [[Limbs.LEFT_UPPER_LEG, -90.0], [Limbs.LEFT_LOWER_LEG, 35.0]]:
		for side: int in 2:
			var limb: int = leg[0] if side == 0 else Limbs.LEGS[2 + Limbs.LEGS.find(leg[0])]
			still.pose.set_orientation(limb, Quaternion(Vector3.RIGHT, deg_to_rad(leg[1])))
	is_true(SittingLegs.ahead_of(still.pose) < SittingLegs.SITS)
	is_true(SittingLegs.ahead_of(Still.new().pose) < SittingLegs.STANDS)
	var clip: BvhSource = _clip()
	for frame: int in 600:
		var ahead: float = SittingLegs.ahead_of(clip.pose_at(frame / 60.0))
		is_true(ahead < SittingLegs.SITS, "%.2f at frame %d" % [ahead, frame])


func test_samples_that_come_late_or_twice_move_nobody_too_far() -> void:
	_carry(Still.new(), Still.new())
	_stick.x = 1.5
	_run(1.0)
	var from: Vector3 = _before.root
	for _time: int in 30:
		# Two physics frames of a slow display, at nearly the same moment.
		_now += 2 * STEP_USEC
		_before = _legs.sample(_now)
		is_null(_legs.sample(_now + 50))
	almost_equal((_before.root - from).length(), 1.5, 0.05)


func test_the_room_goes_along() -> void:
	_carry(Still.new(), Still.new())
	_stick = Vector3(1.5, 0.0, 0.7)
	for _time: int in 120:
		_run(STEP_S)
		almost_equal(_legs.travel() * _own.root, _before.root, 1e-4)


func _clip() -> BvhSource:
	var made: BvhSource = BvhSource.new()
	made.open(CLIP)
	return made


func _carry(p_first: MotionSource, p_plain: MotionSource) -> void:
	if _legs != null:
		_legs.ground.leave()
	_plain = p_plain
	_legs = WalkedLegs.new(p_first)
	_legs.ground.enter(_course.find_world_3d(), _bodies)
	_legs.has_frame = true
	_legs.embody(p_first.get_hip_height(), _skeleton())
	_legs.read_input = _read_hands
	_now = BEGIN_USEC
	_stick = Vector3.ZERO
	_hands = WalkerInput.new()
	_max_step = 0.0
	_before = null


func _read_hands(p_delta_s: float) -> WalkerInput:
	_hands.heading = wrapf(_hands.heading + _stick.z * p_delta_s, -PI, PI)
	_hands.wish = WalkerInput.to_world(_stick.x, _stick.y, _hands.heading)
	return _hands


func _advance() -> PoseSample:
	_now += STEP_USEC
	_legs.listen(STEP_S)
	var made: PoseSample = _legs.sample(_now)
	_own = _plain.sample(_now)
	equal(made.find_fault(), "")
	if _before != null:
		_max_step = maxf(_max_step, (made.root - _before.root).length())
	_before = made
	return made


func _run(p_time_s: float) -> void:
	for _time: int in roundi(p_time_s / STEP_S):
		_advance()


func _skeleton() -> PersonSkeleton:
	var person: Ragdoll = (load("res://scenes/actor/person.tscn") as PackedScene).instantiate()
	var joints: PersonSkeleton = person.get_joints()
	person.free()
	return joints


static func _flat(p_vector: Vector3) -> Vector3:
	return Vector3(p_vector.x, 0.0, p_vector.z)


func _box(p_size: Vector3, p_at: Vector3) -> void:
	var body: StaticBody3D = StaticBody3D.new()
	var shape: CollisionShape3D = CollisionShape3D.new()
	var box: BoxShape3D = BoxShape3D.new()
	box.size = p_size
	shape.shape = box
	body.add_child(shape)
	body.position = p_at
	_course.add_child(body)
