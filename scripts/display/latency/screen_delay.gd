class_name ScreenDelay
extends RefCounted
## What a screen adds to a frame that has been drawn until its light is seen: an estimate, as no
## program can measure it (thesis section 7.4.2).
##
## With vertical synchronisation finished frames wait in a queue, each for a refresh of the screen.
## Then the screen shows its rows one after the other: the middle one half a refresh late. What the
## panel itself takes comes on top.

## The rate that is assumed where the screen does not say its own, Hz.
const USUAL_RATE: float = 60.0
## Frames that OpenGL lets wait with vertical synchronisation.
const _QUEUE_OPENGL: int = 1


## The delay in ms, at a screen's refresh rate (Hz), where so many finished frames may wait.
static func estimate_ms(
	p_rate: float, p_mode: DisplayServer.VSyncMode, p_queued_frames: int
) -> float:
	var refreshes: float = 0.5
	match p_mode:
		DisplayServer.VSYNC_ENABLED, DisplayServer.VSYNC_ADAPTIVE:
			refreshes += p_queued_frames
		DisplayServer.VSYNC_MAILBOX:
			# The newest frame waits for the next refresh, half of one on average.
			refreshes += 0.5
	return refreshes * 1000.0 / (p_rate if p_rate > 0.0 else USUAL_RATE)


## The delay of this program's window, ms; 0 without a window.
static func of_window_ms() -> float:
	if DisplayServer.get_name() == "headless":
		return 0.0
	var screen: int = DisplayServer.window_get_current_screen()
	var rate: float = DisplayServer.screen_get_refresh_rate(screen)
	return estimate_ms(rate, DisplayServer.window_get_vsync_mode(), queued_frames())


## The delay of this program's window, in words.
static func describe() -> String:
	var rate: float = DisplayServer.screen_get_refresh_rate(
		DisplayServer.window_get_current_screen()
	)
	return describe_screen(rate, DisplayServer.window_get_vsync_mode(), queued_frames())


## The delay of a screen, in words; see [method estimate_ms].
static func describe_screen(
	p_rate: float, p_mode: DisplayServer.VSyncMode, p_queued_frames: int
) -> String:
	var sync: String = "vertical synchronisation off"
	match p_mode:
		DisplayServer.VSYNC_ENABLED, DisplayServer.VSYNC_ADAPTIVE:
			sync = "vertical synchronisation, up to %d frames wait" % p_queued_frames
		DisplayServer.VSYNC_MAILBOX:
			sync = "only the newest frame waits"
	var hertz: String = "%.0f Hz" % p_rate if p_rate > 0.0 else "%.0f Hz assumed" % USUAL_RATE
	var ms: float = estimate_ms(p_rate, p_mode, p_queued_frames)
	return "the screen adds about %.0f ms (estimate: %s, %s)" % [ms, hertz, sync]


## How many finished frames the engine lets wait with vertical synchronisation.
static func queued_frames() -> int:
	if RenderingServer.get_rendering_device() == null:
		return _QUEUE_OPENGL
	var images: String = "rendering/rendering_device/vsync/swapchain_image_count"
	return maxi(ProjectSettings.get_setting(images, 3) - 1, 1)
