class_name ClientDisplay
extends ClientPart
## How a client shows the world: in its window, to both eyes, on walls, or in a headset.
##
## The window always works: where another display cannot be opened, or is lost, a notice says why,
## and the window shows the world.

# Topic of its notes on the screen.
const _NOTES: StringName = &"display"

## The display, or null: the window.
var mode: DisplayMode = null
## What a headset needs besides; null without one.
var headset: ClientHeadset = null

var _is_restarted: bool = false
var _late: LateStart = null
# Where the walls of a wearer's own station are, and its camera.
var _room: RoomFrame = RoomFrame.new()
var _station: Camera3D = null
var _period_usec: int = 0
var _begun_usec: int = 0


func _exit_tree() -> void:
	if mode != null:
		mode.close()


func _unhandled_input(p_event: InputEvent) -> void:
	if headset != null and p_event.is_action_pressed(&"recentre"):
		headset.display.recentre()
		get_viewport().set_input_as_handled()
	elif headset != null and p_event.is_action_pressed(&"enter_headset"):
		var fault: String = headset.display.enter()
		if fault != "":
			_on_notified("No headset: %s." % fault)
		get_viewport().set_input_as_handled()
	elif mode is StereoDisplay and p_event.is_action_pressed(&"swap_eyes"):
		(mode as StereoDisplay).swap()
		get_viewport().set_input_as_handled()
	elif mode is WallDisplay:
		_take_wall_key(mode as WallDisplay, p_event)


func open(p_context: ClientContext) -> String:
	super(p_context)
	context.fresh_file = fresh_file
	context.notified.connect(tell)
	_show(context.options)
	return ""


## Waits until it is time to begin the frame, then reads what the wearer's devices say in it.
func begin_frame() -> void:
	if _late != null:
		var wait: int = _late.wait_usec(Time.get_ticks_usec(), _period_usec)
		if wait > 0:
			OS.delay_usec(wait)
		_begun_usec = Time.get_ticks_usec()
	if headset != null:
		var due: int = maxi(due_usec(), Time.get_ticks_usec())
		headset.read(due, due + MotionSender.unix_ahead())


func advance(_delta_s: float) -> void:
	context.due_usec = due_usec()
	context.scene.view.sees_by_own_eyes = is_own_view()
	context.ears = headset.display.head() if headset != null else null


func end_frame(p_delta_s: float) -> void:
	_place_wearer(p_delta_s)
	if _late != null:
		_note_work()


## When the frame that begins now will be seen, µs; 0: as the window's [FrameClock] says.
func due_usec() -> int:
	return mode.due_usec() if mode != null else 0


## Whether the user looks out of the eyes of the own body.
func is_own_view() -> bool:
	return context.is_headset_worn() or _tracks_head()


## A file name that is still free: after a restart for a headset, or without one, this session must
## not overwrite what it recorded before.
func fresh_file(p_path: String) -> String:
	var path: String = p_path
	var number: int = 2
	while _is_restarted and FileAccess.file_exists(path):
		path = "%s-%d.%s" % [p_path.get_basename(), number, p_path.get_extension()]
		number += 1
	return path


## Shows a notice to the user, also to one who does not see the window.
func tell(p_text: String) -> void:
	if headset != null:
		headset.tell(p_text)


## From now on it does not go into a headset that comes back.
func finish() -> void:
	if headset != null:
		headset.display.returns_by_itself = false


func report() -> Dictionary:
	var found: Dictionary = mode.report() if mode != null else {"display": DisplayNames.WINDOW}
	if headset != null:
		found["headset"] = headset.report()
	return {"display": found}


## Begins to show the world as the options ask.
func _show(p_options: Options) -> void:
	# The display takes these out of the environment.
	_is_restarted = (
		OS.get_environment(HmdCommand.TRIED) + OS.get_environment(HmdCommand.LOST) != ""
	)
	if DisplayServer.get_name() == "headless":
		if p_options.text("display") != DisplayNames.WINDOW:
			Log.warning(
				"display",
				"--display=%s needs a window: start without --headless" % p_options.text("display")
			)
		return
	_set_vsync(p_options.text("vsync"))
	if p_options.is_on("late-frames"):
		_expect_frames()
	var fault: String = _make(p_options)
	if fault == "" and mode != null:
		_begin(mode)
		fault = mode.open()
	if fault != "":
		_fall_back(fault)
	elif mode != null:
		_late = null
		if headset != null:
			headset.begin()
			context.headset = headset


func _note_work() -> void:
	var window: RID = get_viewport().get_viewport_rid()
	var drawing_ms: float = (
		RenderingServer.get_frame_setup_time_cpu()
		+ RenderingServer.viewport_get_measured_render_time_cpu(window)
		+ RenderingServer.viewport_get_measured_render_time_gpu(window)
	)
	_late.worked(Time.get_ticks_usec() - _begun_usec + roundi(drawing_ms * 1000.0))


## Puts a wearer into the world, after every node is where this frame (of a length, s) shows it.
func _place_wearer(p_step_s: float) -> void:
	if not is_own_view():
		return
	var place: WearerTransform = null
	if context.people != null:
		place = context.people.find_wearer(context.scene.replica, context.own_bodies)
	if _tracks_head():
		_place_station(mode as WallDisplay, place, p_step_s)
		return
	if place != null:
		headset.follow_body(place)
	else:
		headset.follow_camera(context.scene.view.camera.global_transform)
	headset.place(maxi(due_usec(), Time.get_ticks_usec()), p_step_s)


func _take_wall_key(p_wall: WallDisplay, p_event: InputEvent) -> void:
	if p_event.is_action_pressed(&"swap_eyes"):
		p_wall.swap()
	elif p_event.is_action_pressed(&"test_picture"):
		p_wall.next_test_picture()
	else:
		return
	get_viewport().set_input_as_handled()


## Which tick of the server is shown, so that all displays of a station show the same one.
func _agree(p_tick: float) -> float:
	var rate: float = context.scene.replica.tick_rate()
	return (mode as WallDisplay).agree(p_tick, context.frame_usec, rate)


## A station whose eyes are those of its wearer: the walls are the wearer's real room.
func _place_station(p_wall: WallDisplay, p_place: WearerTransform, p_step_s: float) -> void:
	if p_place == null or not context.scene.people().has(p_place.actor):
		# Until there is a body again, the walls show what the window would show.
		p_wall.camera = context.scene.view.camera
		_room.restart()
		return
	var room: Transform3D = (
		_room.advance(p_place.room(), p_step_s, p_place.carrier, p_place.carrier_frame)
		* ClientHeadset.AHEAD
	)
	if _station == null:
		_station = Camera3D.new()
		add_child(_station)
	p_wall.camera = _station
	for property: StringName in [&"near", &"far", &"cull_mask", &"environment", &"attributes"]:
		_station.set(property, context.scene.view.camera.get(property))
	_station.global_transform = room.translated_local(p_wall.layout.eye)
	var head: Transform3D = context.scene.people()[p_place.actor].head()
	var eyes: Transform3D = room.affine_inverse() * head
	p_wall.set_eye(eyes * OrbitCamera.EYES, -eyes.basis.x)


## Makes the display that is asked for. Returns what is wrong, or an empty text.
func _make(p_options: Options) -> String:
	var name: String = p_options.text("display")
	if name == DisplayNames.HMD:
		var hmd: HmdDisplay = HmdDisplay.new()
		hmd.set_mirror(HmdDisplay.Mirror[p_options.text("mirror").to_upper()])
		mode = hmd
		headset = ClientHeadset.new()
		headset.name = "Headset"
		add_child(headset)
		headset.leave_wanted.connect(context.leave_wanted.emit.bind(StateStream.EXIT_DONE))
		hmd.leaving.connect(context.restart_near.emit)
		hmd.lost.connect(_show_waiting)
		return headset.open(hmd, p_options)
	if name == DisplayNames.WALL:
		var wall: WallDisplay = WallDisplay.new()
		wall.swap_eyes = p_options.is_on("swap-eyes")
		mode = wall
		context.agreement = _agree
		return wall.set_up(p_options.file("layout"), p_options.text("screens"))
	if not DisplayNames.STEREO.has(name):
		return ""
	var stereo: StereoDisplay = StereoDisplay.new()
	var fault: String = stereo.set_up(
		name, p_options.seconds("eye-distance"), p_options.seconds("convergence")
	)
	if fault != "":
		stereo.free()
		return fault
	stereo.swap_eyes = p_options.is_on("swap-eyes")
	mode = stereo
	return ""


func _tracks_head() -> bool:
	var wall: WallDisplay = mode as WallDisplay
	return wall != null and wall.layout.track == WallLayout.HEAD


func _begin(p_mode: DisplayMode) -> void:
	p_mode.name = "Mode"
	p_mode.camera = context.scene.view.camera
	p_mode.notified.connect(_on_notified)
	p_mode.failed.connect(_fall_back)
	add_child(p_mode)


func _on_notified(p_text: String) -> void:
	Log.info("display", p_text)
	context.hud.show_news(p_text)
	tell(p_text)


## A note in the window says why there is no headset, as long as there is none.
func _show_waiting() -> void:
	context.hud.show_note(headset.display.report()["lost"], _NOTES)


func _fall_back(p_why: String) -> void:
	Log.warning("display", p_why)
	context.agreement = Callable()
	context.headset = null
	if headset != null:
		headset.queue_free()
		headset = null
	var text: String = p_why.left(1).to_upper() + p_why.substr(1)
	context.hud.show_note("%s. You see the world in this window." % text, _NOTES)
	if mode != null:
		mode.close()
		mode.queue_free()
		mode = null


static func _set_vsync(p_wanted: String) -> void:
	# Nothing is gained by waiting for a screen where the processor draws.
	if p_wanted == "off" or (p_wanted == "auto" and Quality.draws_by_processor()):
		DisplayServer.window_set_vsync_mode(DisplayServer.VSYNC_DISABLED)
	elif p_wanted == "on":
		DisplayServer.window_set_vsync_mode(DisplayServer.VSYNC_ENABLED)


## Lets frames begin late, where the screen paces them.
func _expect_frames() -> void:
	var rate: float = DisplayServer.screen_get_refresh_rate()
	if DisplayServer.window_get_vsync_mode() != DisplayServer.VSYNC_ENABLED or rate <= 0.0:
		return
	_late = LateStart.new()
	_period_usec = roundi(1e6 / rate)
	RenderingServer.viewport_set_measure_render_time(get_viewport().get_viewport_rid(), true)
