extends TestCase
## Walkers among the bodies of a physics space: stairs, slopes, corners, what moves, and the same
## ticks while physics does not run.

const WalkerCourse: GDScript = preload("res://tests/bench/walker/walker_course.gd")
const TICK_S: float = 1.0 / 60.0

var _course: WalkerCourse = null


func before_each() -> void:
	_course = WalkerCourse.new(5, self)
	await physics_frames(2)


func after_each() -> void:
	PhysicsServer3D.set_active(true)
	_course.view.free()


func test_ticks_are_the_same_where_physics_does_not_run() -> void:
	var inputs: Array[WalkerInput] = WalkerCourse.inputs(11, 900)
	var there: Array[PackedByteArray] = []
	var mover: WalkerMover = _at(Vector3(20.0, 1.0, 0.0))
	for tick: int in inputs.size():
		if tick % 30 == 0:
			await physics_frames(1)
		inputs[tick].apply(mover, TICK_S)
		there.append(mover.get_state())
	PhysicsServer3D.set_active(false)
	mover = _at(Vector3(20.0, 1.0, 0.0))
	for tick: int in inputs.size():
		inputs[tick].apply(mover, TICK_S)
		if mover.get_state() != there[tick]:
			equal(tick, -1, "the first tick that differs")
			return
	is_true(mover.get_position().distance_to(Vector3(20.0, 1.0, 0.0)) > 0.5, "it has walked")


func test_stairs_lead_up_and_down_without_a_jolt() -> void:
	for speed: float in [1.5, 5.0]:
		var mover: WalkerMover = _at(WalkerCourse.STAIRS)
		var steepest: float = _walk(mover, Vector2(0.0, speed), 500, WalkerCourse.STAIRS.z + 9.5)
		almost_equal(mover.get_position().y, WalkerCourse.STEP_M * WalkerCourse.STEPS, 0.02)
		steepest = maxf(steepest, _walk(mover, Vector2(0.0, -speed), 600, WalkerCourse.STAIRS.z))
		almost_equal(mover.get_position().y, 0.0, 0.02)
		is_true(steepest < 0.03, "%.3f m in a tick at %.1f m/s" % [steepest, speed])


func test_nobody_gets_through_the_walls_of_a_room_or_is_stuck_in_it() -> void:
	var chance: RandomNumberGenerator = RandomNumberGenerator.new()
	chance.seed = 3
	var mover: WalkerMover = _at(WalkerCourse.CORNERS + Vector3(0.0, 0.1, 0.0))
	var travelled: float = 0.0
	for push: int in 200:
		var wish: Vector2 = Vector2.from_angle(chance.randf() * TAU) * 5.5
		var before: Vector3 = mover.get_position()
		for _tick: int in 20:
			mover.tick(wish, 0.0, WalkerMover.STAND, chance.randf() < 0.01, TICK_S)
		travelled += before.distance_to(mover.get_position())
		var at: Vector3 = mover.get_position() - WalkerCourse.CORNERS
		is_true(maxf(absf(at.x), absf(at.z)) < WalkerCourse.ROOM_M and at.y > -0.05, str(at))
	is_true(travelled > 50.0, "%.0f m" % travelled)


func test_a_turntable_takes_who_stands_on_it_along() -> void:
	_course.set_tick(0)
	var mover: WalkerMover = _at(Vector3(14.0, 0.5, 0.0))
	for tick: int in 120:
		_course.set_tick(tick)
		mover.tick(Vector2.ZERO, mover.get_heading(), WalkerMover.STAND, false, TICK_S)
	equal(mover.get_carrier(), WalkerCourse.TURNTABLE)
	var middle: Vector3 = Vector3(12.0, 0.0, 0.0)
	var away: Vector3 = mover.get_position() - middle
	almost_equal(Vector2(away.x, away.z).length(), 2.0, 0.03)
	is_true(absf(away.z) > 1.0, "it has turned: %s" % away)


func test_ladders_of_a_level_are_climbed() -> void:
	var ladder: Ladder = Ladder.new()
	ladder.height = 2.5
	ladder.position = Vector3(0.0, 0.0, -20.0)
	_course.view.add_child(ladder)
	await physics_frames(3)
	var mover: WalkerMover = _at(Vector3(0.0, 0.0, -18.0))
	mover.set_ladder(ladder.get_rid(), true)
	for _tick: int in 130:
		mover.tick(Vector2(0.0, -1.5), PI, WalkerMover.STAND, false, TICK_S)
	equal(mover.get_mode(), WalkerMover.LADDER as int)
	is_true(mover.get_position().y > 0.3)


func test_light_crates_are_passed_and_heavy_ones_are_not() -> void:
	var bodies: WalkerBodies = WalkerBodies.new()
	for weight: float in [20.0, 200.0]:
		var crate: RigidBody3D = RigidBody3D.new()
		var shape: CollisionShape3D = CollisionShape3D.new()
		shape.shape = BoxShape3D.new()
		crate.add_child(shape)
		crate.mass = weight
		crate.freeze = true
		crate.collision_layer = PhysicsLayers.PROPS
		crate.position = Vector3(weight / 20.0, 0.5, -20.0)
		_course.view.add_child(crate)
		bodies.add_body(1000 + int(weight), crate)
	await physics_frames(2)
	for weight: float in [20.0, 200.0]:
		var mover: WalkerMover = _at(Vector3(weight / 20.0, 0.0, -22.0))
		bodies.add_mover(mover, _course.view.find_world_3d())
		_walk(mover, Vector2(0.0, 1.5), 180, -18.0)
		equal(mover.get_position().z > -19.5, weight < 60.0, "%.0f kg" % weight)


func test_states_come_back_and_noise_is_none() -> void:
	var mover: WalkerMover = _at(Vector3(20.0, 1.0, 0.0))
	_walk(mover, Vector2(1.0, 1.0), 30, 100.0)
	var state: PackedByteArray = mover.get_state()
	equal(state.size(), WalkMessage.STATE_BYTES)
	var other: WalkerMover = _at(Vector3.ZERO)
	is_true(other.set_state(state))
	equal(other.get_state(), state)
	equal(other.get_check(), mover.get_check())
	is_false(other.set_state(PackedByteArray()))
	var broken: PackedByteArray = state.duplicate()
	broken.encode_float(0, NAN)
	is_false(other.set_state(broken))
	equal(other.get_state(), state)
	other.tick(Vector2(INF, NAN), NAN, 99, true, TICK_S)
	is_true(other.get_position().is_finite())


func _at(p_place: Vector3) -> WalkerMover:
	var mover: WalkerMover = _course.mover()
	mover.place(p_place, 0.0)
	return mover


## Walks until it has come to a place along the Z axis; returns the picture's largest step, m.
func _walk(p_mover: WalkerMover, p_wish: Vector2, p_ticks: int, p_to: float) -> float:
	var steepest: float = 0.0
	var heading: float = atan2(p_wish.x, p_wish.y)
	var before: float = p_mover.get_position().y - p_mover.get_lift()
	for tick: int in p_ticks:
		p_mover.tick(p_wish, heading, WalkerMover.STAND, false, TICK_S)
		var shown: float = p_mover.get_position().y - p_mover.get_lift()
		steepest = maxf(steepest, absf(shown - before)) if tick > 5 else steepest
		before = shown
		if (p_mover.get_position().z - p_to) * signf(p_wish.y) > 0.0:
			break
	return steepest
