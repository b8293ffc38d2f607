extends TestCase
## Where a station stands in the world, and which eyes it believes.

var _display: WallDisplay = null
var _told: PackedStringArray = []


func before_each() -> void:
	_told.clear()
	_display = WallDisplay.new()
	_display.notified.connect(_on_notified)
	var text: String = "[screen s]\nbottom-left = -1 0 -1\nbottom-right = 1 0 -1\n"
	text += "top-left = -1 2 -1\nsize = 10 10\n"
	_display.layout = LayoutReader.parse(text.to_utf8_buffer(), "s.cfg")


func after_each() -> void:
	_display.free()


func _on_notified(p_text: String) -> void:
	_told.append(p_text)


func test_a_lost_eye_stays_where_it_was_and_is_told_once() -> void:
	_display.set_eye(Vector3(0.2, 1.5, 0.3))
	for bad: Vector3 in [Vector3(NAN, 1, 0), Vector3(0, 1, -3), Vector3(0, 1, -1), Vector3.INF]:
		_display.set_eye(bad)
		almost_equal(_display.eye(), Vector3(0.2, 1.5, 0.3), 1e-6)
	equal(_told.size(), 1)
	contains(_told[0], "last good place is kept")
	_display.set_eye(Vector3(0.0, 1.6, 0.0))
	almost_equal(_display.eye(), Vector3(0.0, 1.6, 0.0), 1e-6)
	equal(_told.size(), 2)


func test_the_station_keeps_its_horizon_and_takes_the_heading() -> void:
	var eye: Vector3 = Vector3(0.0, 1.7, 0.5)
	var camera: Transform3D = Transform3D(
		Basis.from_euler(Vector3(-0.4, 1.1, 0.2)), Vector3(5.0, 2.0, 3.0)
	)
	var level: Transform3D = WallDisplay.mount_at(camera, eye, false)
	almost_equal(level * eye, camera.origin, 1e-5)
	almost_equal(level.basis.y, Vector3.UP, 1e-5)
	var ahead: Vector3 = -camera.basis.z
	ahead.y = 0.0
	almost_equal(-level.basis.z, ahead.normalized(), 1e-5)
	var cabin: Transform3D = WallDisplay.mount_at(camera, eye, true)
	almost_equal(cabin * eye, camera.origin, 1e-5)
	almost_equal(cabin.basis.y, camera.basis.y, 1e-5)


func test_a_report_names_the_screens_also_of_a_closed_station() -> void:
	_display.close()
	equal(_display.report()["screens"], PackedStringArray(["s"]))


func test_without_a_display_it_says_what_to_do() -> void:
	contains(_display.open(), "start without --headless")
	contains(_display.set_up("/nowhere.cfg"), "cannot be read")
	contains(_display.set_up(""), "name it with --layout=FILE")


func test_the_eyes_of_a_tracked_body_are_in_its_head() -> void:
	var tracker: XRBodyTracker = XRBodyTracker.new()
	tracker.name = &"/test/wall_body"
	XRServer.add_tracker(tracker)
	_display.layout.track = "/test/wall_body"
	_display._follow_tracker()
	almost_equal(_display.eye(), Vector3.ZERO, 1e-6)
	# Somebody at the middle of the floor who looks to the right, -z being ahead.
	var hips: Transform3D = Transform3D(Basis(Vector3.UP, PI * 0.5), Vector3(0.0, 0.95, 0.0))
	var head: Transform3D = Transform3D(hips.basis, Vector3(0.05, 1.6, 0.1))
	tracker.set_pose(
		&"default", hips, Vector3.ZERO, Vector3.ZERO, XRPose.XR_TRACKING_CONFIDENCE_HIGH
	)
	tracker.has_tracking_data = true
	tracker.set_joint_transform(XRBodyTracker.JOINT_HEAD, head)
	tracker.set_joint_flags(
		XRBodyTracker.JOINT_HEAD,
		XRBodyTracker.JOINT_FLAG_POSITION_VALID | XRBodyTracker.JOINT_FLAG_ORIENTATION_VALID
	)
	_display._follow_tracker()
	almost_equal(_display.eye(), Vector3(0.175, 1.685, 0.1), 1e-3)
	almost_equal(_display._right, Vector3(0.0, 0.0, 1.0), 1e-4)
	tracker.set_joint_flags(XRBodyTracker.JOINT_HEAD, 0 as XRBodyTracker.JointFlags)
	tracker.set_joint_transform(XRBodyTracker.JOINT_HEAD, hips)
	_display._follow_tracker()
	almost_equal(_display.eye(), Vector3(0.175, 1.685, 0.1), 1e-3)
	XRServer.remove_tracker(tracker)
