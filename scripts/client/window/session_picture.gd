class_name SessionPicture
extends ClientPart
## Saves a picture of the window at the end of the session, if the options ask for it.

## Frames that must have been shown before a picture is taken, and how long that is waited for, s.
const FRAMES: int = 8
const PATIENCE_S: float = 60.0


## A busy machine may not have drawn anything by the end.
func is_ready_to_end() -> bool:
	var over_s: float = (
		context.now_s() - context.begin_s - context.options.seconds("duration") - PATIENCE_S
	)
	return not _is_wanted() or context.stats.shown_frames >= FRAMES or over_s >= 0.0


func finish() -> void:
	if not _is_wanted():
		return
	_draw_once_more()
	var path: String = context.options.file("screenshot")
	var image: Image = get_viewport().get_texture().get_image()
	var error: Error = image.save_png(path) if image != null else ERR_UNAVAILABLE
	if error != OK:
		Log.error("client", "no picture could be saved to %s: %s" % [path, error_string(error)])


func _is_wanted() -> bool:
	return context.options.file("screenshot") != ""


## A picture has time, unlike a window. A tier that an option names stays.
func _draw_once_more() -> void:
	if context.options.text("quality") != "" or ClientContext.is_headless():
		return
	if Quality.tier.render_scale < 1.0:
		Quality.use(QualityTier.high(), get_viewport())
		RenderingServer.force_draw(false)
