class_name HmdDisplay
extends DisplayMode
## Shows the world in a head-mounted display, by OpenXR; the window goes on beside it.
##
## The view is the headset's pose, unfiltered and undelayed; whoever wears it is put into the world
## by [method place_room]. If the runtime ends, the window goes on in this process; if it stalls,
## the program starts again in this process as a plain window. Both ask for the headset until it is
## back, and so does who starts without one (see [HmdReturn]).

## A button of a hand (0 left, 1 right) was pressed: the name of an action of the action map, such
## as trigger_click, grip_click, ax_button, by_button, menu_button, primary_click.
signal pressed(p_action: StringName, p_hand: int)
## A button was released.
signal released(p_action: StringName, p_hand: int)
## The wearer's position and heading have been set anew: who recentres stands upright and looks
## ahead.
signal recentred
## A stick has turned the wearer, by a step or in this frame of a smooth turn: an angle about +Y
## through the head, rad, left is positive.
signal turned(p_angle: float, p_is_step: bool)
## Draw less (a higher detail step, 0 to 3): see [constant RateKeeper.STEPS].
signal quality_wanted(p_step: int)
## There is no headset, or none any more: only the window goes on. Again with each new answer.
signal lost
## The headset can be had again: [method enter] goes back into it.
signal returned
## The program starts again in this process, with the headset: end in order what has to be.
signal leaving

## What the window shows while the headset is worn.
enum Mirror {
	## The world from a smoothed camera at the wearer's head: one more view to draw.
	STEADY,
	## The same at half the resolution.
	REDUCED,
	## Only what lies over the world, such as the menu.
	NONE,
}

## Resolution of the window where it is reduced, a share in each direction.
const _REDUCED: float = 0.5
## Why a headset that is there shows nothing.
const _NO_VULKAN: String = (
	"a headset needs Vulkan, which this machine does not have: install the graphics card's"
	+ " Vulkan driver (Debian: mesa-vulkan-drivers)"
)
const _REFUSED: String = (
	"the OpenXR runtime has a headset, but would not draw with this graphics card: look for"
	+ " OpenXR in the lines above, and that the headset is plugged into the same card"
)

## Goes back into the headset by itself once it can be had again.
var returns_by_itself: bool = true
## Recentring, seated, turned.
var recentring: Recentring = Recentring.new()
## Turning by the right thumbstick.
var turning: StickTurn = StickTurn.new()
## Another stick that turns, such as a gamepad's: x right, y up, -1 to 1.
var stick: Vector2 = Vector2.ZERO
## Holds the rate.
var keeper: RateKeeper = RateKeeper.new()

var _runtime: HmdRuntime = null
var _view: HmdView = null
var _mirror: Mirror = Mirror.STEADY
var _spectator: SteadyCamera = null
var _room: Transform3D = Transform3D.IDENTITY
var _last_room: Transform3D = Transform3D.IDENTITY
var _watch: RuntimeWatch = RuntimeWatch.new()
var _guard: RuntimeGuard = null
var _window: KeptWindow = KeptWindow.new()
var _way_back: HmdReturn = HmdReturn.new(HmdCommand.of_this_process())
var _is_waiting: bool = false
# The user has asked to go into the headset and gets a notice of a fault.
var _is_asked: bool = false
# The notice that the headset is back has been shown.
var _is_notified: bool = false
# The headset is there but refuses: only a request of the user tries again, until the headset was
# away.
var _is_refused: bool = false
var _why_lost: String = ""
# The frame in which a seated wearer is recentred; 0: none.
var _recentre_frame: int = 0
var _suns: SunShadows = SunShadows.new()


func _init() -> void:
	super()
	_way_back.leaving.connect(leaving.emit)


func _process(p_delta: float) -> void:
	if _view != null:
		_show_frame(p_delta)
	elif _is_waiting and _way_back.advance(p_delta):
		_take_answer()


func _exit_tree() -> void:
	close()


## See [method DisplayMode.open]. In a process without OpenXR it does not return where the headset
## can be had: the program starts again with it. Where it cannot be had yet, the window waits for
## it, as after a loss.
func open() -> String:
	var why: String = OS.get_environment(HmdCommand.LOST)
	var has_tried: bool = OS.get_environment(HmdCommand.TRIED) != ""
	OS.unset_environment(HmdCommand.LOST)
	OS.unset_environment(HmdCommand.TRIED)
	_runtime = HmdRuntime.find()
	if _runtime != null:
		_begin()
		return ""
	if DisplayServer.get_name() == "headless":
		return "a headset needs a screen beside it: start without --headless"
	var drawn_by: String = RenderingServer.get_current_rendering_method()
	if has_tried and not drawn_by in ["mobile", "forward_plus"]:
		return _NO_VULKAN
	if why == "":
		why = "No headset: %s." % _find_headset(has_tried)
	_is_waiting = true
	# Deferred: the caller must know first that the display is open.
	_await_return.call_deferred(why)
	return ""


## Leaves the headset; the window shows what the client's camera sees.
func close() -> void:
	_is_waiting = false
	_end_guard()
	_leave_view()


## Whether the headset shows the world.
func is_worn() -> bool:
	return _view != null


## Goes into the headset, such as by a key after it was lost. Returns why it cannot be, or an empty
## text: then the program starts again as soon as the runtime has answered, or [signal notified] has
## its answer.
func enter() -> String:
	if _view != null:
		return ""
	_is_waiting = true
	_is_asked = _way_back.begin()
	return "" if _is_asked else _way_back.fault


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


## The head, such as for who hears by its ears; null without a headset.
func head() -> Node3D:
	return _view.head if _view != null else null


## Where a hand (0 left, 1 right) points in the world: -Z ahead. The identity without a headset.
func controller_pose(p_hand: int) -> Transform3D:
	return _view.hand(p_hand).global_transform if _view != null else Transform3D.IDENTITY


## The view's own node, for what belongs into it; null without a headset.
func view() -> HmdView:
	return _view


## The position and heading of the head become the room's.
func recentre() -> void:
	if _view == null:
		return
	recentring.recentre(_view.head.transform)
	place_room(_room)
	_cut()
	recentred.emit()


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
	return _runtime.due_usec() if _view != null else 0


## See [method DisplayMode.report].
func report() -> Dictionary:
	return {
		"worn": is_worn(),
		"eyes": _view.describe_eyes() if _view != null else [],
		"vignette": _view.vignette.amount() if _view != null else 0.0,
		"runtime": _runtime.describe() if _runtime != null else "",
		"rate_hz": _runtime.rate_hz() if _view != null else 0.0,
		"eye_size": _runtime.eye_size() if _view != null else [],
		"card_ms": 1000.0 * _view.drawing_s() if _view != null else 0.0,
		"frames": keeper.frames,
		"missed": keeper.missed,
		"missed_share": keeper.missed_share(),
		"quality_step": keeper.step,
		"due_exact": _runtime != null and _runtime.is_exact(),
		"lost": _why_lost,
		"waits": _is_waiting,
		"guarded": _guard != null and _guard.is_warm(),
	}


func _begin() -> void:
	_view = HmdView.new()
	add_child(_view)
	_view.set_quality(RateKeeper.STEPS[keeper.step])
	for i: int in 2:
		_view.hand(i).button_pressed.connect(_on_pressed.bind(i))
		_view.hand(i).button_released.connect(released.emit.bind(i))
	keeper.stepped.connect(_on_stepped)
	_runtime.interface.pose_recentered.connect(_on_pose_recentred)
	_window.take(get_window())
	_show_mirror()
	_watch.restart(Time.get_ticks_usec())
	_guard = RuntimeGuard.new()
	_guard.begin()
	get_tree().process_frame.connect(_on_frame_begun)
	notified.emit("The headset shows the world (%s)." % _runtime.describe())


func _show_frame(p_delta: float) -> void:
	var now: int = Time.get_ticks_usec()
	# Its clock stands still as well while nobody wears it.
	if not _runtime.is_running():
		_watch.restart(now)
	elif _watch.has_ended(_runtime.predicted_ns(), _runtime.reported_rate_hz(), now):
		_lose("The headset's runtime has ended: the window goes on.")
		return
	var rate: float = _runtime.rate_hz()
	var period: float = 1.0 / rate if rate > 0.0 else 0.0
	keeper.add(p_delta, period, _view.drawing_s(), _view.has_compiled())
	var turn: float = _turn(p_delta)
	if _recentre_frame > 0 and Engine.get_process_frames() >= _recentre_frame:
		_recentre_frame = 0
		recentre()
	_view.origin.transform = tracking_in_world()
	var moved: Transform3D = _last_room.affine_inverse() * _room
	turn += Recentring.heading_of(moved.basis)
	_last_room = _room
	if p_delta > 0.0:
		_view.vignette.advance(moved.origin.length() / p_delta, turn / p_delta, p_delta)
	if _spectator != null:
		_spectator.follow(head_in_world(), p_delta)
	_window.hold()
	_guard.beat()


## Turns the wearer about the own head. Returns by how much smoothly, rad.
func _turn(p_delta: float) -> float:
	var pushed: Vector2 = _view.hand(1).get_vector2(&"primary")
	var turn: float = turning.advance(pushed if stick.is_zero_approx() else stick, p_delta)
	if turn == 0.0:
		return 0.0
	recentring.turn(turn, _view.head.transform)
	var is_step: bool = turning.rate == 0.0
	if is_step:
		_cut()
		_view.vignette.blink()
	turned.emit(turn, is_step)
	return 0.0 if is_step else turn


## The runtime has said by now when the frame will be seen.
func _on_frame_begun() -> void:
	_runtime.note_frame()
	_guard.hold()


func _end_guard() -> void:
	if _guard == null:
		return
	_guard.end()
	_guard = null
	get_tree().process_frame.disconnect(_on_frame_begun)


## Looks for a headset at the start, and goes into it. Returns why there is none.
func _find_headset(p_has_tried: bool) -> String:
	var fault: String = _way_back.ask()
	if fault != "":
		return fault
	# It is there and does not take us: coming back by itself would go on for ever.
	_is_refused = true
	_is_notified = true
	return _REFUSED if p_has_tried else _way_back.enter()


## The runtime has answered a window that waits.
func _take_answer() -> void:
	if not _way_back.is_ready():
		_is_notified = false
		_is_refused = false
		_why_lost = "No headset: %s." % _way_back.fault
		if _is_asked:
			_is_asked = false
			notified.emit(_why_lost)
		lost.emit()
		return
	var was_notified: bool = _is_notified
	_is_notified = true
	if not was_notified:
		returned.emit()
	if not _is_asked and (_is_refused or not returns_by_itself):
		if not was_notified:
			notified.emit("The headset is back: choose it in the menu to go into it.")
		return
	notified.emit("The headset is back: going into it.")
	_is_asked = false
	var fault: String = _way_back.enter()
	_is_refused = true
	Log.warning("headset", fault)
	notified.emit("No headset: %s." % fault)


func _lose(p_why: String) -> void:
	_end_guard()
	_leave_view()
	# The engine would ask what is no longer there in each frame, and log it.
	XRServer.remove_interface(_runtime.interface)
	quality_wanted.emit(0)
	_is_waiting = true
	_await_return(p_why)


func _await_return(p_why: String) -> void:
	_why_lost = p_why
	Log.warning("headset", p_why)
	notified.emit(p_why + ("" if _is_refused else " It is entered when the runtime has it."))
	lost.emit()


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
	_window.give_back()
	if is_instance_valid(camera):
		camera.make_current()


func _show_mirror() -> void:
	get_window().disable_3d = _mirror == Mirror.NONE
	_window.share = _REDUCED if _mirror == Mirror.REDUCED else 1.0
	_window.hold()
	if _spectator == null:
		_spectator = SteadyCamera.new()
		add_child(_spectator)
		_spectator.make_current()


func _cut() -> void:
	_last_room = _room
	if _spectator != null:
		_spectator.cut()


func _on_pose_recentred() -> void:
	# The runtime has moved its own space: ours on top of that would turn twice.
	recentring.clear()
	_cut()
	if recentring.is_seated:
		# The eyes come to their height again, once the head is seen in the new space.
		_recentre_frame = Engine.get_process_frames() + 1
	else:
		recentred.emit()


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
	notified.emit(text % [keeper.describe(), roundi(_runtime.rate_hz())])
