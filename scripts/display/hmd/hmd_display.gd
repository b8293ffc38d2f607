class_name HmdDisplay
extends DisplayMode
## Shows the world in a head-mounted display, by OpenXR; the window goes on beside it.
##
## The view is the headset's pose, unfiltered and undelayed; whoever wears it is put into the world
## by [method place_room]. If the runtime ends, the window goes on in this process; if it stalls,
## the program starts again in this process as a plain window. Both ask for the headset until it is
## back (see [HmdReturn]).

## A button of a hand (0 left, 1 right) was pressed: the name of an action of the action map, such
## as trigger_click, grip_click, ax_button, by_button, menu_button, primary_click.
signal pressed(p_action: StringName, p_hand: int)
## A button was released.
signal released(p_action: StringName, p_hand: int)
## The wearer's place and heading have been set anew or turned: what is learnt of them may be kept.
signal recentred
## Draw less (a higher detail step, 0 to 3): see [constant RateKeeper.STEPS].
signal quality_wanted(p_step: int)
## The headset was lost: only the window goes on.
signal lost
## The headset can be had again: [method enter] goes back into it.
signal returned

## What the window shows while the headset is worn.
enum Mirror {
	## The world from a smoothed camera at the wearer's head: one more view to draw.
	STEADY,
	## The same at half the resolution.
	REDUCED,
	## Only what lies over the world, such as the menu.
	NONE,
}

## The runtime has not answered for this long: it has stalled, s.
const PATIENCE_S: float = 5.0
## The same while pipelines are still compiled, s: for the first frames, and after a long one.
const _COLD_PATIENCE_S: float = 40.0
const _WARM_FRAMES: int = 30
## Resolution of the window where it is reduced, a share in each direction.
const _REDUCED: float = 0.5
## Work of scripts that takes longer than this was the loading of something, µs.
const _LONG_USEC: int = 1_000_000

## Goes back into the headset by itself once it can be had again.
var returns_by_itself: bool = true
## Recentring, seated, turned.
var recentring: Recentring = Recentring.new()
## Turning by the right thumbstick.
var snap_turn: SnapTurn = SnapTurn.new()
## Holds the rate.
var keeper: RateKeeper = RateKeeper.new()

var _runtime: HmdRuntime = null
var _view: HmdView = null
var _mirror: Mirror = Mirror.STEADY
var _spectator: SteadyCamera = null
var _room: Transform3D = Transform3D.IDENTITY
var _last_room: Transform3D = Transform3D.IDENTITY
var _watch: RuntimeWatch = RuntimeWatch.new()
var _guard: StallGuard = null
var _way_back: HmdReturn = HmdReturn.new(HmdCommand.of_this_process())
var _is_waiting: bool = false
var _why_lost: String = ""
var _begin_usec: int = 0
var _warm_frames: int = 0
var _suns: SunShadows = SunShadows.new()


func _process(p_delta: float) -> void:
	if _view != null:
		_show_frame(p_delta)
	elif _is_waiting and _way_back.advance(p_delta):
		_is_waiting = false
		returned.emit()
		if returns_by_itself:
			told.emit("The headset is back: going into it.")
			enter()
		else:
			told.emit("The headset is back: choose it in the menu to go into it.")


func _exit_tree() -> void:
	close()


## See [method DisplayMode.open]. In a process without OpenXR it does not return where the headset
## can be had: the program starts again with it.
func open() -> String:
	var lost_why: String = OS.get_environment(HmdCommand.LOST)
	var has_tried: bool = OS.get_environment(HmdCommand.TRIED) != ""
	OS.unset_environment(HmdCommand.LOST)
	OS.unset_environment(HmdCommand.TRIED)
	_runtime = HmdRuntime.find()
	if _runtime != null:
		_begin()
		return ""
	if DisplayServer.get_name() == "headless":
		return "a headset needs a screen beside it: start without --headless"
	if lost_why != "":
		_await_return.call_deferred(lost_why)
		return ""
	if has_tried:
		return _describe_failure()
	var fault: String = _way_back.ask()
	return fault if fault != "" else _way_back.enter()


## Leaves the headset; the window shows what the client's camera sees.
func close() -> void:
	_is_waiting = false
	_end_guard()
	_leave_view()


## Whether the headset shows the world.
func is_worn() -> bool:
	return _view != null


## Goes into the headset, such as by a key after it was lost. Returns why it cannot be, or an empty
## text while the program starts again.
func enter() -> String:
	if _view != null:
		return ""
	var fault: String = _way_back.ask()
	return fault if fault != "" else _way_back.enter()


## Where the wearer's tracking space lies in the world: call it each frame.
func place_room(p_room: Transform3D) -> void:
	if p_room.is_finite():
		_room = p_room
	if _view != null:
		_view.origin.transform = tracking_in_world()


## From the runtime's tracking space to the world.
func tracking_in_world() -> Transform3D:
	return _room * recentring.transform()


## Where the eyes are in the world; the identity without a headset.
func head_in_world() -> Transform3D:
	return _view.head.global_transform if _view != null else Transform3D.IDENTITY


## Where a hand (0 left, 1 right) points in the world: -Z ahead. The identity without a headset.
func controller_pose(p_hand: int) -> Transform3D:
	return _view.hand(p_hand).global_transform if _view != null else Transform3D.IDENTITY


## The view's own node, for what belongs into it; null without a headset.
func view() -> HmdView:
	return _view


## The place and heading of the head become the room's.
func recentre() -> void:
	if _view == null:
		return
	recentring.recentre(_view.head.transform)
	place_room(_room)
	_cut()


## Sits in a chair or stands.
func set_seated(p_is_seated: bool) -> void:
	recentring.is_seated = p_is_seated
	recentre()


## What the window shows.
func set_mirror(p_mirror: Mirror) -> void:
	_mirror = p_mirror
	if _view != null:
		_show_mirror()


## See [method DisplayMode.due_usec].
func due_usec() -> int:
	return _runtime.due_usec(Time.get_ticks_usec()) if _view != null else 0


## See [method DisplayMode.report].
func report() -> Dictionary:
	return {
		"worn": is_worn(),
		"runtime": _runtime.describe() if _runtime != null else "",
		"rate_hz": _runtime.rate_hz() if _view != null else 0.0,
		"frames": keeper.frames,
		"missed": keeper.missed,
		"missed_share": keeper.missed_share(),
		"quality_step": keeper.step,
		"due_exact": _runtime != null and _runtime.is_exact(),
		"lost": _why_lost,
		"waits": _is_waiting,
		"guarded": _view != null and _warm_frames >= _WARM_FRAMES,
	}


func _begin() -> void:
	_view = HmdView.new()
	add_child(_view)
	_view.set_quality(RateKeeper.STEPS[keeper.step])
	for i: int in 2:
		var hand: XRController3D = _view.hand(i)
		hand.button_pressed.connect(_on_pressed.bind(i))
		hand.button_released.connect(func(action: String) -> void: released.emit(action, i))
	if not keeper.stepped.is_connected(_on_stepped):
		keeper.stepped.connect(_on_stepped)
	_runtime.interface.pose_recentered.connect(_on_pose_recentred)
	# The headset's rate is the pace; waiting for the screen as well would halve it.
	DisplayServer.window_set_vsync_mode(DisplayServer.VSYNC_DISABLED)
	Engine.max_fps = 0
	_show_mirror()
	_watch.restart(Time.get_ticks_usec())
	_begin_guard()
	told.emit("The headset shows the world (%s)." % _runtime.describe())


func _show_frame(p_delta: float) -> void:
	var now: int = Time.get_ticks_usec()
	_runtime.note_frame(now)
	# Its clock stands still as well while nobody wears it.
	if not _runtime.is_running():
		_watch.restart(now)
	elif _watch.has_ended(_runtime.predicted_ns(), _runtime.told_rate_hz(), now):
		_lose("The headset's runtime has ended: the window goes on.")
		return
	var rate: float = _runtime.rate_hz()
	keeper.add(p_delta, 1.0 / rate if rate > 0.0 else 0.0)
	var turn: float = snap_turn.step(_view.hand(1).get_vector2(&"primary"))
	if turn != 0.0:
		recentring.turn(turn, _view.head.transform)
		_cut()
	_view.origin.transform = tracking_in_world()
	var moved: Transform3D = _last_room.affine_inverse() * _room
	var turned: float = Recentring.heading_of(moved.basis)
	_last_room = _room
	if p_delta > 0.0:
		_view.vignette.advance(moved.origin.length() / p_delta, turned / p_delta, p_delta)
	if _spectator != null:
		_spectator.follow(head_in_world(), p_delta)
	_beat(now)


## The client's own work is done: from here to the next frame only engine and runtime can wait.
func _beat(p_now: int) -> void:
	if _begin_usec != 0 and p_now - _begin_usec > _LONG_USEC:
		_warm_frames = 0
		_set_patience(_COLD_PATIENCE_S)
	_warm_frames += 1
	if _warm_frames == _WARM_FRAMES:
		_set_patience(PATIENCE_S)
	_guard.beat()


func _set_patience(p_patience_s: float) -> void:
	_guard.stop()
	_guard.hold()
	_guard.start(p_patience_s, HmdCommand.of_this_process().with_window())


func _on_frame_begun() -> void:
	_begin_usec = Time.get_ticks_usec()
	_guard.hold()


func _begin_guard() -> void:
	_guard = StallGuard.new()
	_warm_frames = 0
	# The guard's thread touches nothing of the engine: what the next process should know is laid
	# out now.
	OS.set_environment(HmdCommand.LOST, "The headset's runtime stalled: the window goes on.")
	_set_patience(_COLD_PATIENCE_S)
	get_tree().process_frame.connect(_on_frame_begun)


func _end_guard() -> void:
	if _guard == null:
		return
	_guard.stop()
	_guard = null
	OS.unset_environment(HmdCommand.LOST)
	get_tree().process_frame.disconnect(_on_frame_begun)


func _lose(p_why: String) -> void:
	_end_guard()
	_leave_view()
	# The engine would ask what is no longer there in each frame, and log it.
	XRServer.remove_interface(_runtime.interface)
	_await_return(p_why)
	lost.emit()


func _await_return(p_why: String) -> void:
	_why_lost = p_why
	_is_waiting = true
	Log.warning("headset", p_why)
	told.emit(p_why + " It is entered again when the runtime is back.")


func _leave_view() -> void:
	if _view == null:
		return
	_runtime.interface.pose_recentered.disconnect(_on_pose_recentred)
	_suns.restore()
	if _spectator != null:
		_spectator.queue_free()
		_spectator = null
	_view.queue_free()
	_view = null
	var window: Window = get_window()
	window.disable_3d = false
	window.scaling_3d_scale = 1.0
	if is_instance_valid(camera):
		camera.make_current()


func _show_mirror() -> void:
	var window: Window = get_window()
	window.disable_3d = _mirror == Mirror.NONE
	window.scaling_3d_scale = _REDUCED if _mirror == Mirror.REDUCED else 1.0
	if _spectator == null:
		_spectator = SteadyCamera.new()
		add_child(_spectator)
		_spectator.make_current()


func _cut() -> void:
	_last_room = _room
	if _spectator != null:
		_spectator.cut()
	recentred.emit()


func _on_pose_recentred() -> void:
	# The runtime has moved its own space: ours on top of that would turn twice.
	recentring.clear()
	_cut()


func _on_pressed(p_action: String, p_hand: int) -> void:
	if p_action == "recentre":
		recentre()
	pressed.emit(p_action, p_hand)


func _on_stepped(p_step: int) -> void:
	var row: Dictionary = RateKeeper.STEPS[p_step]
	if _view != null:
		_view.set_quality(row)
		_suns.set_shown(get_tree().root, row["shadows"])
	quality_wanted.emit(row["detail"])
	var text: String = "The picture is drawn %s to hold %d Hz."
	told.emit(text % [keeper.describe(), roundi(_runtime.rate_hz())])


## Why a process that was started for the headset has none.
func _describe_failure() -> String:
	if not RenderingServer.get_current_rendering_method() in ["mobile", "forward_plus"]:
		return (
			"a headset needs Vulkan, which this machine does not have: install the graphics card's"
			+ " Vulkan driver (Debian: mesa-vulkan-drivers)"
		)
	return (
		"the OpenXR runtime has a headset, but would not draw with this graphics card: look for"
		+ " OpenXR in the lines above, and that the headset is plugged into the same card"
	)
