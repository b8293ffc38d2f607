extends TestCase
## Walking with a headset on: sticks, the head and the room, by trackers of the engine's own server.

const STEP_S: float = 1.0 / 90.0
const TICK_S: float = 1.0 / 60.0
const FOOT: Vector3 = Vector3(5.0, 0.0, -3.0)

var _course: SubViewport = null
var _bodies: WalkerBodies = null
var _prediction: WalkerPrediction = null
var _display: HmdDisplay = null
var _headset: ClientHeadset = null
var _controls: WalkerControls = null
var _walk: HeadsetWalk = null
var _head: XRPositionalTracker = null
var _hands: Array[XRControllerTracker] = []
var _place: WearerTransform = null
var _ticked_s: float = 0.0
var _now: int = 1_000_000


func before_each() -> void:
	_course = SubViewport.new()
	_course.own_world_3d = true
	add_child(_course)
	_floor()
	await physics_frames(2)
	_prediction = WalkerPrediction.new()
	_bodies = WalkerBodies.new()
	_bodies.add_mover(_prediction.mover, _course.find_world_3d())
	_prediction.mover.place(FOOT, 0.5)
	_prediction.restart_at(0)
	_head = XRPositionalTracker.new()
	_head.type = XRServer.TRACKER_HEAD
	_head.name = XrDevices.HEAD
	XRServer.add_tracker(_head)
	for hand: StringName in XrDevices.CONTROLLERS:
		var tracker: XRControllerTracker = XRControllerTracker.new()
		tracker.name = hand
		XRServer.add_tracker(tracker)
		_hands.append(tracker)
	_wear(["--turn=snap:45"])
	_look(0.0, Vector3(0.0, 1.7, 0.0))
	_run(0.1)


func after_each() -> void:
	XRServer.remove_tracker(_head)
	for hand: XRControllerTracker in _hands:
		XRServer.remove_tracker(hand)
	_hands.clear()
	_bodies.remove_mover(_prediction.mover)
	_controls.free()
	_headset.free()
	_display.free()
	_course.free()


func test_the_eyes_are_above_the_walker_s_feet_and_look_ahead() -> void:
	almost_equal(_eyes(), FOOT + Vector3(0.0, 1.7, 0.0), 1e-3)
	almost_equal(_gaze(), 0.5, 1e-3)
	almost_equal(_controls.heading, 0.5, 1e-3)


func test_the_left_stick_walks_where_the_head_looks() -> void:
	_push(0, Vector2(0.0, 1.0))
	_run(2.0)
	var gone: Vector3 = _prediction.shown() - FOOT
	almost_equal(atan2(gone.x, gone.z), 0.5, 0.02)
	is_true(gone.length() > 0.9 * WalkerControls.JOG * 1.5, "%.2f m" % gone.length())
	# The view goes along without lagging behind.
	is_true((_eyes() - _prediction.shown()).slide(Vector3.UP).length() < 0.1)
	# The head turned to the left turns the way.
	_look(1.0, Vector3(0.0, 1.7, 0.0))
	_run(1.0)
	var from: Vector3 = _prediction.shown()
	_run(1.0)
	gone = _prediction.shown() - from
	almost_equal(atan2(gone.x, gone.z), 1.5, 0.02)
	almost_equal(_controls.heading, 1.5, 1e-3)


func test_half_a_stick_walks_slowly_and_its_rest_zone_not_at_all() -> void:
	_push(0, Vector2(0.0, 0.14))
	equal(_read().wish, Vector2.ZERO)
	_push(0, Vector2(0.0, 0.575))
	almost_equal(_read().wish.length(), 0.5 * WalkerControls.JOG, 1e-3)
	_push(0, Vector2(1.0, 1.0))
	almost_equal(_read().wish.length(), WalkerControls.JOG, 1e-3, "no faster aslant")
	_push(0, Vector2(NAN, 1.0))
	equal(_read().wish, Vector2.ZERO)
	_controls.hands_off = true
	_push(0, Vector2(0.0, 1.0))
	equal(_read().wish, Vector2.ZERO)


func test_the_view_moves_evenly_between_ticks() -> void:
	_push(0, Vector2(0.0, 1.0))
	_run(1.5)
	var before: Vector3 = _eyes()
	for _frame: int in 90:
		_run(STEP_S)
		var moved: float = (_eyes() - before).length()
		almost_equal(moved, WalkerControls.JOG * STEP_S, 0.003)
		before = _eyes()


func test_a_step_of_the_stick_turns_about_the_head() -> void:
	# Leaning to the side, within what the body does not follow.
	_look(0.3, Vector3(0.12, 1.6, -0.05))
	_run(0.2)
	var before: Vector3 = _eyes()
	var gaze: float = _gaze()
	_display.recentring.turn(_display.turning.advance(Vector2(1.0, 0.0), STEP_S), _head_pose())
	_run(STEP_S)
	almost_equal(angle_difference(_gaze(), gaze), deg_to_rad(45.0), 1e-3, "to the right")
	almost_equal(_eyes(), before, 1e-3)
	almost_equal(_controls.heading, _gaze(), 1e-3)
	_run(0.5)
	almost_equal(_eyes(), before, 0.02)


func test_the_body_comes_below_a_head_that_goes_and_the_view_stays() -> void:
	for step: int in 90:
		_look(0.0, Vector3(0.01 * step, 1.7, 0.0))
		_run(STEP_S)
	var eyes: Vector3 = _eyes()
	_run(1.5)
	almost_equal(_eyes(), eyes, 0.05, "the view is where the wearer went")
	var off: Vector3 = (_eyes() - _prediction.shown()).slide(Vector3.UP)
	is_true(off.length() < HeadsetWalk.SLACK_M, "%.2f m" % off.length())
	is_true((_prediction.shown() - FOOT).length() > 0.6)


func test_who_crouches_or_presses_the_stick_down_is_low() -> void:
	_look(0.0, Vector3(0.0, 1.0, 0.0))
	equal(_read().stance, WalkerMover.CROUCH)
	_run(1.0)
	almost_equal(_eyes().y, 1.0, 0.02, "the own knees are bent, not lowered twice")
	_look(0.0, Vector3(0.0, 1.7, 0.0))
	_run(1.0)
	equal(_read().stance, WalkerMover.STAND)
	_push(1, Vector2(0.0, -1.0))
	_run(0.1)
	_push(1, Vector2.ZERO)
	_run(2.0)
	equal(_prediction.mover.get_stance(), WalkerMover.CROUCH)
	almost_equal(_eyes().y, 1.05, 0.03)
	# Up stands up first, then jumps.
	for jumps: bool in [false, true]:
		_push(1, Vector2(0.0, 1.0))
		equal(_read().jumps, jumps)
		_push(1, Vector2.ZERO)
		is_false(_read().jumps)
	equal(_read().stance, WalkerMover.STAND)


func test_somebody_who_sits_stands_in_the_world() -> void:
	_headset.free()
	_display.free()
	_controls.free()
	_wear(["--seated"])
	_look(0.0, Vector3(0.0, 1.15, 0.0))
	_display.recentring.recentre(_head.get_pose(&"default").transform)
	_display.recentred.emit()
	_walk.recentre(0.5)
	_run(0.2)
	almost_equal(_eyes().y, Recentring.STANDING_EYES_M, 1e-3)
	equal(_read().stance, WalkerMover.STAND)


func test_recentring_makes_ahead_what_is_looked_at_and_turns_no_view() -> void:
	_look(-0.8, Vector3(0.1, 1.7, 0.0))
	_run(0.2)
	var gaze: float = _gaze()
	_display.recentring.recentre(_head_pose())
	_walk.recentre(_controls.heading)
	_run(0.1)
	almost_equal(_gaze(), gaze, 1e-3)
	almost_equal((_eyes() - _prediction.shown()).slide(Vector3.UP), Vector3.ZERO, 1e-3)


func _wear(p_options: PackedStringArray) -> void:
	_display = HmdDisplay.new()
	_headset = ClientHeadset.new()
	equal(_headset.open(_display, ProgramOptions.parse(p_options, "trainee")), "")
	_controls = WalkerControls.new()
	_walk = HeadsetWalk.new(_headset, false)
	_walk.begin(0.5)


## Frames of the display, with the ticks that fall into them.
func _run(p_seconds: float) -> void:
	for _frame: int in maxi(roundi(p_seconds / STEP_S), 1):
		_now += roundi(STEP_S * 1e6)
		_ticked_s += STEP_S
		_devices()
		while _ticked_s >= TICK_S:
			_ticked_s -= TICK_S
			_prediction.advance(_prediction.tick + 1, _controls.read(TICK_S), TICK_S)
		_place = WearerTransform.new()
		_place.actor = 1
		_walk.find_room(_place, _prediction)
		_headset.follow_body(_place)
		_headset.place(_now, STEP_S)


func _devices() -> void:
	_headset.read_devices(_now, _now)
	_walk.read(_controls, null)


func _read() -> WalkerInput:
	_devices()
	return _controls.read(TICK_S)


func _look(p_left: float, p_at: Vector3) -> void:
	var pose: Transform3D = Transform3D(Basis(Vector3.UP, p_left), p_at)
	_head.set_pose(&"default", pose, Vector3.ZERO, Vector3.ZERO, XRPose.XR_TRACKING_CONFIDENCE_HIGH)


func _push(p_hand: int, p_stick: Vector2) -> void:
	_hands[p_hand].set_input(XrDevices.STICK, p_stick)


func _head_pose() -> Transform3D:
	return _head.get_pose(&"default").transform


func _eyes() -> Vector3:
	return (_display.tracking_in_world() * _head_pose()).origin


## Where the eyes look, rad about +Y from +Z.
func _gaze() -> float:
	return Recentring.facing_of(_display.tracking_in_world().basis * _head_pose().basis)


func _floor() -> void:
	var body: StaticBody3D = StaticBody3D.new()
	var shape: CollisionShape3D = CollisionShape3D.new()
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3(100.0, 1.0, 100.0)
	shape.shape = box
	body.position.y = -0.5
	body.add_child(shape)
	_course.add_child(body)
