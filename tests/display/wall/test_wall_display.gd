extends TestCase
## Where a station stands in the world, and which eyes it believes.

var _display: WallDisplay = null
var _told: PackedStringArray = []


func before_each() -> void:
	_told.clear()
	_display = WallDisplay.new()
	_display.told.connect(_on_told)
	var text: String = "[screen s]\nbottom-left = -1 0 -1\nbottom-right = 1 0 -1\n"
	text += "top-left = -1 2 -1\nsize = 10 10\n"
	_display.layout = WallLayout.parse(text.to_utf8_buffer(), "s.cfg")


func after_each() -> void:
	_display.free()


func _on_told(p_text: String) -> void:
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


func test_without_a_display_it_says_what_to_do() -> void:
	contains(_display.open(), "start without --headless")
	contains(_display.set_up("/nowhere.cfg"), "cannot be read")
