extends TestCase
## The picture of a webcam in the device panel, with skeletons.

var _panel: DevicePanel = null
var _view: WebcamView = null


func before_each() -> void:
	get_window().size = Vector2i(1280, 720)
	_panel = (load("res://scenes/mocap/panel/device_panel.tscn") as PackedScene).instantiate()
	_panel.folder = "user://test-webcam-%d" % OS.get_process_id()
	add_child(_panel)
	_view = _panel.get_node("%Webcam")
	await process_frames(1)


func after_each() -> void:
	_panel.queue_free()
	await process_frames(2)


func test_it_is_hidden_until_a_picture_comes() -> void:
	var picture: WebcamPicture = WebcamPicture.new()
	var pictures: Array[WebcamPicture] = [picture]
	_view.show_pictures(pictures)
	await process_frames(2)
	is_true(not _view.visible)
	var large: Image = Image.create(4000, 8, false, Image.FORMAT_RGB8)
	for bytes: PackedByteArray in [[0xFF, 0xD8, 1, 2, 3], large.save_jpg_to_buffer()]:
		picture.take_picture(bytes)
		await process_frames(2)
		is_true(not _view.visible, "what is no small picture is not shown")
	var image: Image = Image.create(320, 180, false, Image.FORMAT_RGB8)
	picture.take_picture(image.save_jpg_to_buffer())
	var points: PackedVector3Array = []
	points.resize(WebcamReader.POINTS)
	points.fill(Vector3(0.5, 0.25, 0.9))
	picture.take_person("0", points, roundi(Time.get_unix_time_from_system() * 1e6))
	await process_frames(3)
	is_true(_view.visible)
	equal(_view.count_people(), 1)
	var at: Rect2 = _view.picture_rect()
	is_true(at.size.x > 200.0 and absf(at.size.x / at.size.y - 16.0 / 9.0) < 0.01, str(at))
	is_true(Rect2(Vector2.ZERO, _view.size).grow(0.5).encloses(at), "%s in %s" % [at, _view.size])
