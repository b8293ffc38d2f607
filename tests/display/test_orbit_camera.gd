extends TestCase
## The camera: where it looks from, how it follows, and what it makes of mouse and text.

var _camera: OrbitCamera = null


func before_each() -> void:
	_camera = OrbitCamera.new()
	add_child(_camera)


func after_each() -> void:
	_camera.free()


func test_looks_at_its_target_from_the_right_place() -> void:
	var cases: Dictionary[String, Vector3] = {
		"0,0,4": Vector3(0, 0, 4),
		"90,0,4": Vector3(4, 0, 0),
		"-90,0,2": Vector3(-2, 0, 0),
		"180,0,4": Vector3(0, 0, -4),
		"0,30,4": Vector3(0, 2, 3.4641),
		"90,30,4": Vector3(3.4641, 2, 0),
		"0,-30,4": Vector3(0, -2, 3.4641),
	}
	for text: String in cases:
		equal(_camera.set_from_text(text), "", text)
		_camera.target = Vector3(5.0, 1.0, -3.0)
		_camera.snap()
		_camera._process(0.016)
		almost_equal(_camera.position, _camera.target + cases[text], 1e-3, text)
		var ahead: Vector3 = -_camera.global_basis.z
		almost_equal(ahead, -cases[text].normalized(), 1e-3, text)
		is_true(_camera.global_basis.y.y > 0.0, "upright")


func test_text_that_is_no_camera() -> void:
	for text: String in ["", "1,2", "1,2,3,4", "a,b,c", "1,2,", ",,", "35;12;4"]:
		var before: Array = [_camera.azimuth, _camera.elevation, _camera.distance]
		contains(_camera.set_from_text(text), "or around, behind or eyes, found '%s'" % text)
		equal([_camera.azimuth, _camera.elevation, _camera.distance], before, text)


func test_a_view_by_its_name() -> void:
	equal(_camera.set_from_text("eyes"), "")
	equal(_camera.view, OrbitCamera.View.EYES)
	equal(_camera.set_from_text("behind"), "")
	equal(_camera.view, OrbitCamera.View.BEHIND)


func test_text_beyond_the_limits() -> void:
	equal(_camera.set_from_text("700,200,1000"), "")
	almost_equal(rad_to_deg(_camera.elevation), 85.0, 1e-3)
	equal(_camera.distance, 50.0)
	equal(_camera.set_from_text("0,-200,0"), "")
	almost_equal(rad_to_deg(_camera.elevation), -80.0, 1e-3)
	equal(_camera.distance, 0.5)
	for text: String in ["inf,0,4", "nan,0,4", "0,nan,4", "0,0,inf", "1e999,0,4"]:
		_camera.set_from_text(text)
		_camera.snap()
		_camera._process(0.016)
		is_true(_camera.global_transform.is_finite(), text)


func test_follows_softly_and_arrives() -> void:
	_camera.target = Vector3.ZERO
	_camera.snap()
	_camera._process(0.016)
	var start: Vector3 = _camera.position
	_camera.target = Vector3(10.0, 0.0, 0.0)
	_camera._process(0.016)
	var first: float = (_camera.position - start).x
	is_true(first > 0.1 and first < 3.0, "%f m in the first frame" % first)
	for _frame: int in 120:
		_camera._process(0.016)
	almost_equal(_camera.position - start, Vector3(10.0, 0.0, 0.0), 0.01)


func test_following_does_not_depend_on_the_frame_rate() -> void:
	var places: Array[Vector3] = []
	for frames: int in [10, 100]:
		_camera.target = Vector3.ZERO
		_camera.snap()
		_camera.target = Vector3(10.0, 0.0, 0.0)
		for _frame: int in frames:
			_camera._process(0.2 / frames)
		places.append(_camera.position)
	almost_equal(places[0], places[1], 0.01)


func test_wheel_and_drag() -> void:
	_camera.distance = 4.0
	_wheel(MOUSE_BUTTON_WHEEL_UP)
	almost_equal(_camera.distance, 3.6)
	_wheel(MOUSE_BUTTON_WHEEL_DOWN)
	is_true(_camera.distance > 3.6)
	for _turn: int in 200:
		_wheel(MOUSE_BUTTON_WHEEL_UP)
	equal(_camera.distance, 0.5)
	for _turn: int in 200:
		_wheel(MOUSE_BUTTON_WHEEL_DOWN)
	equal(_camera.distance, 50.0)
	var azimuth: float = _camera.azimuth
	_drag(Vector2(100.0, 0.0), 0)
	equal(_camera.azimuth, azimuth, "without a button")
	_drag(Vector2(100.0, 0.0), MOUSE_BUTTON_MASK_LEFT)
	almost_equal(_camera.azimuth, azimuth - 0.5)
	for _drag_number: int in 50:
		_drag(Vector2(0.0, 1000.0), MOUSE_BUTTON_MASK_RIGHT)
	almost_equal(rad_to_deg(_camera.elevation), 85.0, 1e-3)


func test_from_near_it_looks_at_the_face() -> void:
	_camera.target = Vector3(0.0, 1.0, 0.0)
	_camera.head = Transform3D(Basis.IDENTITY, Vector3(0.0, 1.7, 0.0))
	_camera.has_head = true
	for distance: float in [0.5, 1.0, 4.0]:
		_camera.set_from_text("0,0,%f" % distance)
		_camera.snap()
		_camera._process(0.016)
		var height: float = 1.8 if distance < 1.2 else 1.0
		almost_equal(_camera.position, Vector3(0.0, height, distance), 1e-3, str(distance))


func test_from_behind_it_turns_with_the_person() -> void:
	_camera.target = Vector3(0.0, 1.0, 0.0)
	_camera.set_from_text("0,0,4")
	_camera.view = OrbitCamera.View.BEHIND
	for degrees: float in [0.0, 90.0, -135.0]:
		_camera.heading = deg_to_rad(degrees)
		_camera.snap()
		_camera._process(0.016)
		var faces: Vector3 = Vector3.BACK.rotated(Vector3.UP, _camera.heading)
		almost_equal(-_camera.global_basis.z, faces, 1e-3, str(degrees))


func test_out_of_the_eyes_it_looks_where_the_head_does() -> void:
	_camera.view = OrbitCamera.View.EYES
	_camera.has_head = true
	for turn: Basis in [Basis.IDENTITY, Basis(Vector3.UP, 1.0), Basis(Vector3.RIGHT, 0.6)]:
		_camera.head = Transform3D(turn, Vector3(1.0, 1.7, 2.0))
		_camera._process(0.016)
		almost_equal(-_camera.global_basis.z, turn * Vector3.BACK, 1e-3)
		is_true(_camera.global_position.distance_to(_camera.head.origin) < 0.3)


func test_without_a_person_there_are_no_eyes() -> void:
	_camera.view = OrbitCamera.View.EYES
	_camera.set_from_text("0,0,4")
	_camera.target = Vector3(0.0, 1.0, 0.0)
	_camera.snap()
	_camera._process(0.016)
	almost_equal(_camera.position, Vector3(0.0, 1.0, 4.0), 1e-3)


func test_views_come_one_after_the_other() -> void:
	equal(_camera.view, OrbitCamera.View.AROUND)
	_camera.change_view()
	equal(_camera.view, OrbitCamera.View.BEHIND)
	_camera.change_view()
	equal(_camera.view, OrbitCamera.View.EYES)
	_camera.change_view()
	equal(_camera.view, OrbitCamera.View.AROUND)


func _wheel(p_button: MouseButton) -> void:
	var event: InputEventMouseButton = InputEventMouseButton.new()
	event.button_index = p_button
	event.pressed = true
	_camera._unhandled_input(event)


func _drag(p_way: Vector2, p_buttons: int) -> void:
	var event: InputEventMouseMotion = InputEventMouseMotion.new()
	event.relative = p_way
	event.button_mask = p_buttons
	_camera._unhandled_input(event)
