extends TestCase
## What a screen adds: frames that wait, and rows that are shown one after the other.


func test_frames_wait_where_the_screen_paces_them() -> void:
	var refresh_ms: float = 1000.0 / 60.0
	for mode: DisplayServer.VSyncMode in [
		DisplayServer.VSYNC_ENABLED, DisplayServer.VSYNC_ADAPTIVE
	]:
		almost_equal(ScreenDelay.estimate_ms(60.0, mode, 2), 2.5 * refresh_ms, 1e-6)
		almost_equal(ScreenDelay.estimate_ms(60.0, mode, 1), 1.5 * refresh_ms, 1e-6)
	almost_equal(ScreenDelay.estimate_ms(60.0, DisplayServer.VSYNC_MAILBOX, 2), refresh_ms, 1e-6)
	var off: DisplayServer.VSyncMode = DisplayServer.VSYNC_DISABLED
	almost_equal(ScreenDelay.estimate_ms(60.0, off, 2), 0.5 * refresh_ms, 1e-6)


func test_a_quicker_screen_adds_less() -> void:
	var mode: DisplayServer.VSyncMode = DisplayServer.VSYNC_ENABLED
	almost_equal(
		ScreenDelay.estimate_ms(144.0, mode, 2), ScreenDelay.estimate_ms(72.0, mode, 2) / 2.0, 1e-6
	)


func test_it_says_that_it_is_an_estimate_and_of_what() -> void:
	var text: String = ScreenDelay.describe_screen(120.0, DisplayServer.VSYNC_ENABLED, 2)
	for words: String in ["about 21 ms", "estimate", "120 Hz", "2 frames wait"]:
		contains(text, words)
	text = ScreenDelay.describe_screen(-1.0, DisplayServer.VSYNC_DISABLED, 2)
	for words: String in ["about 8 ms", "60 Hz assumed", "off"]:
		contains(text, words)
	is_true(ScreenDelay.queued_frames() >= 1)
	contains(ScreenDelay.describe(), "the screen adds about")
