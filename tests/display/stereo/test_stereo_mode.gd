extends TestCase
## Where both eyes' pictures are in a window.


func test_names_and_kinds_belong_together() -> void:
	equal(StereoMode.NAMES.size(), StereoMode.Kind.size())
	for at: int in StereoMode.NAMES.size():
		var kind: String = StereoMode.Kind.keys()[at]
		equal(kind.to_lower().replace("_", "-"), StereoMode.NAMES[at])
	equal(StereoMode.find("nothing"), -1)


func test_parts_of_a_window() -> void:
	var window: Vector2i = Vector2i(640, 360)
	var beside: Array[Rect2i] = StereoMode.frames(StereoMode.Kind.SIDE_BY_SIDE, window)
	equal(beside, [Rect2i(0, 0, 320, 360), Rect2i(320, 0, 320, 360)] as Array[Rect2i])
	var above: Array[Rect2i] = StereoMode.frames(StereoMode.Kind.TOP_BOTTOM, window)
	equal(above, [Rect2i(0, 0, 640, 180), Rect2i(0, 180, 640, 180)] as Array[Rect2i])
	equal(StereoMode.frames(StereoMode.Kind.ROWS, window).size(), 1)
	equal(StereoMode.eye_size(StereoMode.Kind.SIDE_BY_SIDE, window), window, "squeezed")
	equal(StereoMode.eye_size(StereoMode.Kind.SIDE_BY_SIDE_FULL, window), Vector2i(320, 360))
