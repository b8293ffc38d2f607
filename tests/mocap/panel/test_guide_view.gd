extends TestCase
## Whether what a wearer sees of a calibration can be read from three metres away.

const _WINDOW: Rect2 = Rect2(0.0, 0.0, 1280.0, 720.0)

var _guide: GuideView = GuideView.new()


func before_each() -> void:
	get_window().size = Vector2i(_WINDOW.size)
	_guide.size = _WINDOW.size
	add_child(_guide)
	await process_frames(2)


func after_each() -> void:
	_guide.queue_free()
	await process_frames(2)


func test_every_step_can_be_read_from_afar() -> void:
	var feed: BvhSensorFeed = BvhSensorFeed.new()
	var mounts: PackedInt32Array = PackedInt32Array(range(17))
	feed.open("res://assets/motion/01_01.bvh", mounts)
	for kind: CalibrationGuide.Kind in [
		CalibrationGuide.Kind.FULL, CalibrationGuide.Kind.FIT_CHECK
	]:
		var process: CalibrationProcess = CalibrationProcess.new()
		var now_s: float = 0.0
		equal(process.start(kind, feed.list_sensors(), mounts, Calibration.new(), now_s), "")
		while process.is_running():
			_guide.show_process(process)
			await process_frames(1)
			contains(_guide.text(), process.instruction())
			_check_words()
			now_s += process.seconds_left
			process.advance(now_s)


## Every word is large enough, is shown and lies within the window.
func _check_words() -> void:
	for label: Node in _guide.get_children():
		if label is Label:
			var words: Label = label
			var height: float = words.get_theme_font_size(&"font_size")
			is_true(height >= 36.0, "%d px of 720: '%s'" % [height, words.text])
			equal(words.get_visible_line_count(), words.get_line_count(), words.text)
			is_true(_WINDOW.grow(1.0).encloses(words.get_global_rect()), words.text)
			var needed: Vector2 = words.get_combined_minimum_size()
			is_true(words.size.x + 1.0 >= needed.x and words.size.y + 1.0 >= needed.y, words.text)
