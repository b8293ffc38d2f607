extends TestCase
## What devices say: nonsense is dropped, and between two moments lies what is known of both.


func test_nonsense_is_not_tracked() -> void:
	for pose: Transform3D in [
		Transform3D(Basis.IDENTITY, Vector3(NAN, 0, 0)),
		Transform3D(Basis.IDENTITY, Vector3(0, INF, 0)),
		Transform3D(Basis.from_scale(Vector3(0, 0, 0)), Vector3.ZERO),
		Transform3D(Basis(Vector3(NAN, 0, 0), Vector3.UP, Vector3.BACK), Vector3.ZERO),
		Transform3D(Basis.IDENTITY, Vector3(1e9, 0, 0)),
	]:
		var frame: XrFrame = _frame()
		frame.head = pose
		frame.hands[1] = pose
		frame.pins[XrFrame.Pin.WAIST] = pose
		frame.drop_faults()
		is_false(frame.has_head or frame.has_place, str(pose))
		equal(frame.has_hands, PackedByteArray([1, 0]))
		equal(frame.has_pins[XrFrame.Pin.WAIST], 0)


func test_a_headset_that_looks_ahead_is_a_head_that_faces_minus_z() -> void:
	var frame: XrFrame = _frame()
	almost_equal(frame.head_turn() * Vector3.BACK, Vector3.FORWARD, 1e-6)
	frame.head.basis = Basis(Vector3.UP, 0.5) * Basis(Vector3.RIGHT, 0.3)
	almost_equal(frame.head_turn() * Vector3.BACK, -frame.head.basis.z, 1e-6)
	almost_equal(frame.head_turn() * Vector3.UP, frame.head.basis.y, 1e-6)


func test_between_two_moments() -> void:
	var from: XrFrame = _frame()
	var to: XrFrame = _frame()
	to.time_usec = from.time_usec + 1000
	to.head = Transform3D(Basis(Vector3.UP, 1.0), Vector3(1, 0, 0))
	to.has_hands[1] = 0
	var between: XrFrame = XrFrame.new()
	between.blend(from, to, 0.25)
	equal(between.time_usec, from.time_usec + 250)
	almost_equal(between.head.origin, from.head.origin.lerp(to.head.origin, 0.25), 1e-6)
	almost_equal(between.head.basis, Basis(Vector3.UP, 0.25), 1e-4)
	equal(between.has_hands, PackedByteArray([1, 1]))
	between.blend(from, to, 0.75)
	equal(between.has_hands, PackedByteArray([1, 0]))


func test_another_frame_of_the_same_size() -> void:
	var frame: XrFrame = _frame()
	frame.fingers = {XRBodyTracker.JOINT_LEFT_INDEX_FINGER_TIP: Quaternion.IDENTITY}
	frame.hands[0].origin = Vector3(0.3, 1.0, -0.4)
	frame.pins[XrFrame.Pin.WAIST].origin = Vector3(0.0, 1.0, 0.1)
	var fingers: Dictionary[int, Quaternion] = frame.fingers
	var into: Transform3D = Transform3D(Basis(Vector3.UP, PI), Vector3(1, 0, 0))
	frame.move(into)
	almost_equal(frame.head.origin, Vector3(1, 1.6, 0), 1e-5)
	almost_equal(frame.head_turn() * Vector3.BACK, Vector3.BACK, 1e-5, "ahead is +Z then")
	almost_equal(frame.hands[0].origin, Vector3(0.7, 1.0, 0.4), 1e-5)
	almost_equal(frame.pins[XrFrame.Pin.WAIST].origin, Vector3(1, 1, -0.1), 1e-5)
	almost_equal(frame.fingers.values()[0], Quaternion(Vector3.UP, PI), 1e-5)
	almost_equal(fingers.values()[0], Quaternion.IDENTITY, 1e-5, "those of others stay")


func _frame() -> XrFrame:
	var frame: XrFrame = XrFrame.new()
	frame.time_usec = 1_000_000
	frame.head.origin = Vector3(0, 1.6, 0)
	frame.has_head = true
	frame.has_place = true
	frame.has_hands.fill(1)
	frame.has_pins.fill(1)
	return frame
