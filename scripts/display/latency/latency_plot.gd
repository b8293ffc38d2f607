extends SceneTree
## Makes a picture of a session's latency file: godot -s latency_plot.gd -- FILE.csv PICTURE.png
##
## Needs a display (a virtual one will do). Prints the stats as JSON.

const _SIZE: Vector2i = Vector2i(960, 620)


## Draws once.
class Sheet:
	extends Control
	var probe: LatencyProbe = null

	func _draw() -> void:
		draw_rect(Rect2(Vector2.ZERO, size), Color("1a1f24"))
		var chart: LatencyChart = LatencyChart.new(self)
		chart.probe = probe
		chart.font_size = 16
		var title: String = "Sample to display, %d samples" % probe.total.count()
		draw_string(
			ThemeDB.fallback_font, Vector2(40, 40), title, HORIZONTAL_ALIGNMENT_LEFT, -1, 22
		)
		chart.draw_histogram(Rect2(40, 60, size.x - 80, 260))
		chart.draw_stages(Rect2(40, 365, size.x - 80, 24))
		chart.draw_table(Vector2(40, 425))


func _initialize() -> void:
	_make.call_deferred()


func _make() -> void:
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	if arguments.size() != 2:
		_fail("usage: latency_plot.gd FILE.csv PICTURE.png")
		return
	var probe: LatencyProbe = LatencyReader.read(arguments[0])
	if probe == null or probe.total.count() == 0:
		_fail("%s holds no latencies" % arguments[0])
		return
	print(JSON.stringify(probe.stats(), "", false))
	var viewport: SubViewport = SubViewport.new()
	viewport.size = _SIZE
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	var sheet: Sheet = Sheet.new()
	sheet.probe = probe
	sheet.size = _SIZE
	viewport.add_child(sheet)
	root.add_child(viewport)
	await process_frame
	await RenderingServer.frame_post_draw
	var image: Image = viewport.get_texture().get_image()
	if image == null or image.save_png(arguments[1]) != OK:
		_fail("no picture could be saved to %s" % arguments[1])
		return
	quit(0)


func _fail(p_why: String) -> void:
	printerr(p_why)
	quit(1)
