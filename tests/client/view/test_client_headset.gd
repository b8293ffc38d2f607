extends TestCase
## A headset's wearer in a session: the room lies where the body is, and buttons do what keys do.
##
## Without a headset: what devices say comes from trackers of the engine's own server.

const STEP_S: float = 1.0 / 90.0

var _display: HmdDisplay = null
var _headset: ClientHeadset = null


func before_each() -> void:
	_display = HmdDisplay.new()
	_headset = ClientHeadset.new()
	_headset.open(_display, ProgramOptions.parse(["--turn=snap:45", "--seated"]))


func after_each() -> void:
	_headset.free()
	_display.free()


func test_options_reach_the_display() -> void:
	almost_equal(rad_to_deg(_display.turning.angle), 45.0, 1e-3)
	is_true(_display.recentring.is_seated)


func test_who_looks_ahead_faces_as_people_do() -> void:
	var place: WearerTransform = WearerTransform.new()
	place.actor = 3
	place.frame = Transform3D(Basis(Vector3.UP, 0.5), Vector3(4.0, 0.2, -1.0))
	_headset.follow_body(place)
	_headset.place(1, STEP_S)
	var room: Transform3D = _display.tracking_in_world()
	almost_equal(room.origin, place.frame.origin, 1e-4)
	# A headset looks along -Z, people along +Z.
	almost_equal(-room.basis.z, place.frame.basis.z, 1e-4)


func test_recentring_moves_the_wearer_and_not_the_world() -> void:
	var place: WearerTransform = WearerTransform.new()
	place.actor = 3
	_headset.follow_body(place)
	var head: Transform3D = Transform3D(Basis(Vector3.UP, 1.1), Vector3(0.7, 1.6, 0.4))
	_display.recentring.is_seated = false
	_display.recentring.recentre(head)
	_headset.place(1, STEP_S)
	var seen: Transform3D = _display.tracking_in_world() * head
	almost_equal(seen.origin, Vector3(0.0, 1.6, 0.0), 1e-4)
	almost_equal(-seen.basis.z, Vector3.BACK, 1e-4)


func test_a_platform_that_moves_leaves_the_view_where_the_cabin_is() -> void:
	var place: WearerTransform = WearerTransform.new()
	place.actor = 3
	_headset.follow_body(place)
	var head: Transform3D = Transform3D(Basis.IDENTITY, Vector3(0.0, 1.2, 0.1))
	var first: Transform3D = Transform3D.IDENTITY
	for frame: int in 100:
		var now: int = 1000000 + frame * 11111
		var heave: Vector3 = Vector3(0.0, 0.1 * sin(frame * 0.3), 0.0)
		var tilt: Vector3 = Vector3(0.1 * sin(frame * 0.2), 0.0, 0.05 * sin(frame * 0.17))
		_headset.platform.push_cue(now, heave, tilt)
		_headset.place(now, STEP_S)
		# The head is moved by the platform and does not move on it.
		var tracked: Transform3D = PlatformFrame.of_cue(heave, tilt) * head
		var seen: Transform3D = _display.tracking_in_world() * tracked
		if frame == 0:
			first = seen
		almost_equal(seen.origin, first.origin, 1e-4)
		almost_equal(seen.basis.z, first.basis.z, 1e-4)


func test_somebody_without_a_body_stands_where_the_camera_is() -> void:
	var camera: Transform3D = Transform3D(Basis(Vector3.UP, -0.8), Vector3(2.0, 3.0, 5.0))
	_headset.follow_camera(camera)
	_headset.place(1, STEP_S)
	var eyes: Transform3D = _display.tracking_in_world().translated_local(Vector3(0.0, 1.65, 0.0))
	almost_equal(eyes.origin, camera.origin, 1e-4)
	almost_equal(-eyes.basis.z, -camera.basis.z, 1e-4)


func test_buttons_are_the_actions_of_keys() -> void:
	for hand: int in 2:
		for button: StringName in ClientHeadset.ACTIONS[hand]:
			var action: StringName = ClientHeadset.ACTIONS[hand][button]
			is_true(InputMap.has_action(action), "%s of hand %d" % [action, hand])
	_display.pressed.emit(&"trigger_click", 1)
	Input.flush_buffered_events()
	is_true(Input.is_action_pressed(&"fire"))
	_display.released.emit(&"trigger_click", 1)
	Input.flush_buffered_events()
	is_false(Input.is_action_pressed(&"fire"))


func test_a_marker_is_four_numbers_and_a_name() -> void:
	for text: String in ["1,2,3", "a,b,c,d", "1,2,3,nan", "1,2,3,4,5,6", ",,,"]:
		var options: Options = ProgramOptions.parse(["--marker=" + text])
		contains(_headset._set_marker(options.text("marker")), text)
	equal(_headset._set_marker("1.5,1.6,-4,90,door"), "")


func test_a_suit_is_fitted_once_and_others_are_left_alone() -> void:
	var first: MotionSource = MotionSource.new()
	var second: MotionSource = MotionSource.new()
	var fitted: MotionSource = _headset.fit(first)
	is_true(fitted is FusedSource)
	equal((fitted as FusedSource).source, first)
	equal(_headset.fit(second), second)
