class_name ClientFrames
extends ClientPart
## Decides when frames are made and which moment each one shows: it follows the screen's refresh, or
## the server's ticks where no screen paces the frames. It also measures the frames.

var _clock: FrameClock = null
var _pacer: FramePacer = null
var _begun_usec: int = 0
var _usual_fps: int = 0
var _usual_sleep_usec: int = 0


func open(p_context: ClientContext) -> String:
	super(p_context)
	_usual_fps = Engine.max_fps
	_usual_sleep_usec = OS.low_processor_usage_mode_sleep_usec
	if ClientContext.is_headless():
		Engine.max_fps = context.options.number("fps")
		# Without this limit Godot makes up to 145 frames a second where nothing is drawn.
		OS.low_processor_usage_mode_sleep_usec = 1
	else:
		RenderingServer.frame_post_draw.connect(_on_drawn)
	_pacer = FramePacer.new(Engine.max_fps if FramePacer.is_free() else 0)
	_clock = FrameClock.of_window()
	return ""


func advance(_delta_s: float) -> void:
	_begun_usec = Time.get_ticks_usec()
	context.stats.times.begin(_begun_usec)
	context.frame_usec = _clock.begin(_begun_usec, context.due_usec)


func end_frame(_delta_s: float) -> void:
	var replica: WorldReplica = context.scene.replica
	if FramePacer.is_free() and not context.is_headset_worn():
		Engine.max_fps = _pacer.limit_for(replica.shown_tick(), replica.tick_rate())
	var server_usec: int = context.stream.server_usec(_begun_usec)
	context.stats.frame(replica, server_usec, ClientContext.is_headless())
	context.stats.times.placed(Time.get_ticks_usec())


func close() -> void:
	Engine.max_fps = _usual_fps
	OS.low_processor_usage_mode_sleep_usec = _usual_sleep_usec


func _on_drawn() -> void:
	var now: int = Time.get_ticks_usec()
	_clock.drawn(now)
	context.stats.times.drawn(now)
	if context.stream != null:
		context.stats.drawn(context.stream.server_usec(now))
