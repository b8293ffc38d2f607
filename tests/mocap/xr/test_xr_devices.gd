extends TestCase
## Devices of the runtime become a frame: headset, controllers, tracked hands, trackers on the body.

var _devices: XrDevices = XrDevices.new()
var _trackers: Array[XRTracker] = []


func after_each() -> void:
	for tracker: XRTracker in _trackers:
		XRServer.remove_tracker(tracker)


func test_nothing_is_tracked_without_devices() -> void:
	var frame: XrFrame = _devices.read(77)
	equal(frame.time_usec, 77)
	is_false(frame.has_head or frame.has_place)
	equal(frame.has_hands, PackedByteArray([0, 0]))


func test_headset_controllers_and_trackers() -> void:
	var head: Transform3D = Transform3D(Basis(Vector3.UP, 0.4), Vector3(1, 1.7, 2))
	_add(&"head", XRServer.TRACKER_HEAD, &"default", head)
	# Arms that hang, thumbs ahead, is how a grip without a turn is held.
	var grip: Transform3D = Transform3D(Basis.IDENTITY, Vector3(0.3, 0.8, 0.0))
	_add(&"left_hand", XRServer.TRACKER_CONTROLLER, &"grip", grip)
	_add(&"right_hand", XRServer.TRACKER_CONTROLLER, &"grip", grip)
	var prop: Transform3D = Transform3D(Basis(Vector3.RIGHT, 1.0), Vector3(0.2, 1.1, -0.4))
	for pin: int in XrFrame.PINS:
		_add(StringName(XrDevices.PINS[pin]), XRServer.TRACKER_CONTROLLER, &"default", prop)
	var frame: XrFrame = _devices.read(1)
	is_true(frame.has_head and frame.has_place)
	almost_equal(frame.head, head, 1e-6)
	for side: int in 2:
		var out: Vector3 = Vector3.RIGHT if side == 0 else Vector3.LEFT
		var hand: Quaternion = frame.hands[side].basis.get_rotation_quaternion()
		almost_equal(hand * out, Vector3.DOWN, 1e-5, "fingers")
		almost_equal(hand * Vector3.DOWN, out, 1e-5, "palms face the body, seen from behind")
		almost_equal(hand * Vector3.BACK, Vector3.FORWARD, 1e-5, "thumbs")
		almost_equal(frame.hands[side].origin, grip.origin + Vector3(0, 0.085, 0), 1e-5)
	equal(frame.has_pins.count(1), XrFrame.PINS)
	almost_equal(frame.pins[XrFrame.Pin.HANDHELD], prop, 1e-6)


func test_a_tracked_hand_is_used_before_a_controller_and_has_fingers() -> void:
	_add(&"left_hand", XRServer.TRACKER_CONTROLLER, &"grip", Transform3D.IDENTITY)
	var hand: XRHandTracker = XRHandTracker.new()
	hand.name = XrDevices.HANDS[0]
	hand.hand = XRPositionalTracker.TRACKER_HAND_LEFT
	hand.has_tracking_data = true
	var turn: Quaternion = Quaternion(Vector3.UP, 0.6)
	for joint: int in XRHandTracker.HAND_JOINT_MAX:
		var bone: StringName = &"LeftHand"
		if FingerJoints.of_hand(0).has(XRBodyTracker.JOINT_LEFT_HAND + 1 + joint):
			bone = FingerJoints.bone_of(XRBodyTracker.JOINT_LEFT_HAND + 1 + joint)
		var basis: Basis = Basis(turn * HumanoidAxes.of_bone(bone))
		hand.set_hand_joint_transform(joint, Transform3D(basis, Vector3(0, 1, joint)))
		hand.set_hand_joint_flags(joint, 15)
	XRServer.add_tracker(hand)
	_trackers.append(hand)
	var frame: XrFrame = _devices.read(1)
	almost_equal(frame.hands[0].basis.get_rotation_quaternion(), turn, 1e-5)
	almost_equal(frame.hands[0].origin, Vector3(0, 1, 1), 1e-6)
	equal(frame.fingers.size(), FingerJoints.of_hand(0).size())
	for joint: int in frame.fingers:
		almost_equal(frame.fingers[joint], turn, 1e-5)
	hand.has_tracking_data = false
	frame = _devices.read(2)
	almost_equal(frame.hands[0].origin, Vector3(0, 0.085, 0), 1e-5, "the controller again")
	equal(frame.fingers.size(), 0)


func test_nonsense_of_a_runtime_is_not_tracked() -> void:
	for wrong: Transform3D in [
		Transform3D(Basis.IDENTITY, Vector3(NAN, 0, 0)),
		Transform3D(Basis.from_scale(Vector3.ZERO), Vector3.ZERO),
		Transform3D(Basis(Vector3(NAN, 0, 0), Vector3.UP, Vector3.BACK), Vector3.ZERO),
	]:
		_add(&"head", XRServer.TRACKER_HEAD, &"default", wrong)
		_add(&"left_hand", XRServer.TRACKER_CONTROLLER, &"grip", wrong)
		_add(StringName(XrDevices.PINS[0]), XRServer.TRACKER_CONTROLLER, &"default", wrong)
		var frame: XrFrame = _devices.read(1)
		frame.move(Transform3D(Basis(Vector3.UP, PI), Vector3.ZERO))
		is_false(frame.has_head or frame.has_place, str(wrong))
		equal(frame.has_hands[0] + frame.has_pins[0], 0)
		var source: XrBodySource = XrBodySource.new()
		source.push(frame)
		is_null(source.sample(1))
		after_each()
		_trackers.clear()


func _add(
	p_name: StringName, p_type: XRServer.TrackerType, p_pose: StringName, p_at: Transform3D
) -> void:
	var tracker: XRControllerTracker = null
	var positional: XRPositionalTracker = XRPositionalTracker.new()
	if p_type == XRServer.TRACKER_CONTROLLER:
		tracker = XRControllerTracker.new()
		positional = tracker
	positional.type = p_type
	positional.name = p_name
	positional.set_pose(
		p_pose, p_at, Vector3.ZERO, Vector3.ZERO, XRPose.XR_TRACKING_CONFIDENCE_HIGH
	)
	XRServer.add_tracker(positional)
	_trackers.append(positional)
