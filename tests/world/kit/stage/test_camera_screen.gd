extends TestCase
## The screen without a display: what it warns of, and that a server renders nothing. What it shows
## is looked at by tests/system/test_stage.py.


func test_it_warns_without_a_camera_and_of_many_pixels() -> void:
	var level: Node3D = Node3D.new()
	level.add_to_group(KitBlock.LEVEL_GROUP)
	add_child(level)
	var screen: CameraScreen = CameraScreen.new()
	level.add_child(screen)
	contains(screen._get_configuration_warnings()[0], "add a FilmCamera")
	var camera: FilmCamera = FilmCamera.new()
	level.add_child(camera)
	equal(screen._get_configuration_warnings(), PackedStringArray())
	equal(screen.find_camera(), camera)
	var other: FilmCamera = FilmCamera.new()
	level.add_child(other)
	screen.camera = other
	equal(screen.find_camera(), other)
	screen.lines = 1080
	contains(screen._get_configuration_warnings()[0], "choose fewer 'Lines'")
	level.free()


func test_its_picture_has_its_shape() -> void:
	var screen: CameraScreen = CameraScreen.new()
	screen.size = Vector2(6.4, 3.6)
	screen.lines = 180
	equal(screen.get_resolution(), Vector2i(320, 180))
	screen.size = Vector2(0.2, 40.0)
	equal(screen.get_resolution(), Vector2i(8, 180))
	screen.free()


func test_a_server_takes_no_pictures() -> void:
	var screen: CameraScreen = CameraScreen.new()
	screen.camera = FilmCamera.new()
	add_child(screen.camera)
	add_child(screen)
	equal(screen.find_children("*", "SubViewport", true, false), [])
	equal(screen.get_picture(), null)
	is_false(screen.is_processing())
	screen.take_picture()
	screen.camera.free()
	screen.free()
