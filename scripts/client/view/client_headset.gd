class_name ClientHeadset
extends Node
## Puts the wearer of a headset into the session: the devices move the own body, the room lies where
## that body is, and buttons do what keys do.
##
## The wearer's own frame, in which samples are, is the recentred tracking space, turned so that who
## looks ahead in the room faces +Z, as people do. The view is the headset's alone.

## The wearer wants to leave the session.
signal leave_wanted

## People look along +Z, headsets along -Z: from the room to the wearer's own frame.
const AHEAD: Transform3D = Transform3D(Basis(Vector3.LEFT, Vector3.UP, Vector3.FORWARD))
## What buttons of the left and the right hand do: input actions.
const ACTIONS: Array[Dictionary] = [
	{
		&"trigger_click": &"interact",
		&"ax_button": &"change_view",
		&"by_button": &"next_person",
		&"menu_button": &"ui_cancel",
		&"grip_click": &"switch_torch",
		&"primary_click": &"walk_run",
	},
	{
		&"trigger_click": &"fire",
		&"grip_click": &"interact",
		&"ax_button": &"interact",
		&"by_button": &"next_ammunition",
		&"menu_button": &"ui_cancel",
	},
]
## The action that opens the menu.
const MENU: StringName = &"ui_cancel"
## Gestures of a tracked hand, and the button action that each stands for.
const GESTURES: Dictionary[HandGestures.Gesture, StringName] = {
	HandGestures.Gesture.PINCH: &"trigger_click",
	HandGestures.Gesture.FIST: &"grip_click",
	HandGestures.Gesture.THUMB_UP: &"menu_button",
}
## Strength of the vignette where the menu switches it on.
const VIGNETTE: float = 0.5
## Height of the eyes of a user without a body above the ground, m.
const _EYES_M: float = 1.65
## Where is kept how the headset sits on the head.
const _MOUNT_FILE: String = "user://headset_mount.json"

## The display.
var display: HmdDisplay = null
## The platform that the wearer sits on, which may not move the view.
var platform: PlatformFrame = PlatformFrame.new()
## The suit's motion, fitted to the headset; null without a suit.
var fused: FusedSource = null
## The body of somebody without a suit; null with one.
var body: XrBodySource = null

var _devices: XrDevices = XrDevices.new()
var _gestures: Array[HandGestures] = [HandGestures.new(), HandGestures.new()]
var _has_vignette: bool = true
var _vignette: float = VIGNETTE
var _room: RoomFrame = RoomFrame.new()
var _orientation: HeadFusion.Source = HeadFusion.Source.BOTH
var _position: HeadFusion.Source = HeadFusion.Source.BOTH
var _wanted: Transform3D = Transform3D.IDENTITY
var _velocity: Vector3 = Vector3.ZERO
var _wearer: Transform3D = Transform3D.IDENTITY
var _carrier: int = -1
var _carrier_frame: Transform3D = Transform3D.IDENTITY
var _has_begun: bool = false
var _actor: int = -1
var _tier: int = -1
var _marker: MarkerAlignment = null
var _menu: HmdMenu = null
var _list: HeadsetMenu = null
var _notice: HeadsetNotice = null


## Takes over the display and what the options say of head and body. Returns what is wrong, or an
## empty text.
func open(p_display: HmdDisplay, p_options: Options) -> String:
	display = p_display
	_orientation = HeadFusion.SOURCES[p_options.text("head-orientation")]
	_position = HeadFusion.SOURCES[p_options.text("head-position")]
	var strength: float = p_options.decimal("vignette")
	_has_vignette = strength > 0.0
	_vignette = strength if _has_vignette else VIGNETTE
	display.turning = StickTurn.parse(p_options.text("turn"))
	display.recentring.is_seated = p_options.is_on("seated")
	display.pressed.connect(_on_button.bind(true))
	display.released.connect(_on_button.bind(false))
	display.recentred.connect(_on_recentred)
	display.turned.connect(_on_turned)
	display.quality_wanted.connect(_on_quality_wanted)
	for hand: int in 2:
		_gestures[hand].began.connect(_on_gesture.bind(hand, true))
		_gestures[hand].ended.connect(_on_gesture.bind(hand, false))
	if display.turning.error != "":
		return display.turning.error
	return _set_marker(p_options.text("marker"))


## The display shows the world: adds menu and notices to the view.
func begin() -> void:
	if not display.is_worn():
		return
	var view: HmdView = display.view()
	_menu = HmdMenu.new()
	view.origin.add_child(_menu)
	_menu.use_layer(view.origin)
	_notice = HeadsetNotice.new()
	view.head.add_child(_notice)


## Where the wearer points in the world, along -Z: with the prop that has a tracker of its own, such
## as a weapon, else with the right hand, and with the head where neither is tracked.
func aim() -> Transform3D:
	if not display.is_worn():
		return display.camera.global_transform
	var frame: XrFrame = _devices.frame
	if frame.has_pins[XrFrame.Pin.HANDHELD] != 0:
		return _wearer * frame.pins[XrFrame.Pin.HANDHELD]
	if frame.has_hands[1] != 0:
		return display.controller_pose(1)
	return display.head_in_world()


## The headset in the wearer's own frame: it looks along its -Z.
func head() -> Transform3D:
	return _devices.frame.head


## Whether the left (0) or right (1) hand is tracked.
func has_hand(p_hand: int) -> bool:
	return _devices.frame.has_hands[p_hand] != 0


## Where a hand points in the wearer's own frame, along -Z.
func pointer(p_hand: int) -> Transform3D:
	return _wearer.affine_inverse() * display.controller_pose(p_hand)


## How far the stick of the left (0) or right (1) hand is pushed: x right, y ahead, up to 1.
func stick(p_hand: int) -> Vector2:
	return _devices.stick(p_hand)


## Whether the wearer has the menu open.
func is_menu_open() -> bool:
	return is_instance_valid(_menu) and _menu.is_open()


## The room is elsewhere from now on, at once.
func cut() -> void:
	_room.restart()


## Shows the wearer a text for a while.
func tell(p_text: String) -> void:
	if is_instance_valid(_notice):
		_notice.tell(p_text)


## Opens or closes the menu in front of the wearer.
func toggle_menu() -> void:
	if not is_instance_valid(_menu):
		return
	if _menu.is_open():
		_menu.close()
		return
	if _list == null:
		_list = HeadsetMenu.new()
		_list.chosen.connect(_on_chosen)
	_describe_settings()
	_menu.open(_list, display.view().head.transform)


## The motion of a wearer's suit, fitted to the headset.
func fit(p_source: MotionSource) -> MotionSource:
	if fused != null or body != null:
		return p_source
	fused = FusedSource.new(p_source)
	fused.fusion.orientation = _orientation
	fused.fusion.position = _position
	fused.fusion.mount.load_file(_MOUNT_FILE)
	return fused


## The motion of somebody who has no suit.
func make_body() -> MotionSource:
	body = XrBodySource.new()
	body.is_seated = display.recentring.is_seated
	return body


## Reads the devices for a frame that will be seen at a time, µs of [method Time.get_ticks_usec]
## and of Unix time. Call it before samples are taken.
func read(p_due_usec: int, p_unix_usec: int) -> void:
	if display.is_worn():
		read_devices(p_due_usec, p_unix_usec)


## The same of devices that somebody else shows the world of.
func read_devices(p_due_usec: int, p_unix_usec: int) -> void:
	var frame: XrFrame = _devices.read(p_unix_usec)
	for hand: int in 2:
		var tracker: XRHandTracker = XRServer.get_tracker(XrDevices.HANDS[hand]) as XRHandTracker
		# Fingers that are guessed from a controller make no gestures: its buttons do.
		var source: int = XRHandTracker.HAND_TRACKING_SOURCE_CONTROLLER
		var is_seen: bool = tracker != null and tracker.hand_tracking_source != source
		_gestures[hand].advance(tracker if is_seen else null, get_process_delta_time())
	if not frame.has_head:
		return
	if not _has_begun and frame.has_place:
		_has_begun = true
		display.recentre()
	frame.move(AHEAD * _in_room(p_due_usec))
	if fused != null:
		fused.push(frame)
	if body != null:
		body.push(frame)


## Puts the wearer's room into the world for a frame of a length, s.
func place(p_due_usec: int, p_step_s: float) -> void:
	_wearer = _room.advance(_wanted, p_step_s, _carrier, _carrier_frame, _velocity)
	if display.is_worn():
		# A cabin around the wearer is enough of a rest frame.
		var wanted: float = _vignette if _has_vignette and _carrier < 0 else 0.0
		display.view().vignette.strength = wanted
	# The display puts its own recentring between the room and the tracking space.
	var space: Transform3D = display.recentring.transform().affine_inverse()
	display.place_room(_tracking_in_world(p_due_usec) * space)
	if is_instance_valid(_menu) and _menu.is_open():
		_point_at_menu()


## The own body is somewhere.
func follow_body(p_place: WearerTransform) -> void:
	if p_place.actor != _actor:
		_actor = p_place.actor
		_room.restart()
	_wanted = p_place.room()
	_velocity = p_place.velocity
	_carrier = p_place.carrier
	_carrier_frame = p_place.carrier_frame


## Somebody without a body stands where a camera is, m, and faces where it looks.
func follow_camera(p_camera: Transform3D) -> void:
	if _actor >= 0:
		_actor = -1
		_room.restart()
	_velocity = Vector3.ZERO
	_carrier = -1
	_carrier_frame = Transform3D.IDENTITY
	var turn: Basis = Basis(Vector3.UP, Recentring.heading_of(p_camera.basis)) * AHEAD.basis
	_wanted = Transform3D(turn, p_camera.origin - Vector3(0.0, _EYES_M, 0.0))


## Stats for a report.
func report() -> Dictionary:
	var found: Dictionary = {"suit": fused != null, "body": body != null}
	if fused != null:
		found["heading_correction_deg"] = rad_to_deg(fused.correction())
	return found


func _exit_tree() -> void:
	if fused != null and fused.fusion.mount.is_solved:
		fused.fusion.mount.save_file(_MOUNT_FILE)
	if _list != null:
		if is_instance_valid(_menu):
			_menu.close()
		_list.free()


## Where the tracking space lies in the world: as the own body says, or a marker on the real wall
## for somebody who has none.
func _tracking_in_world(p_due_usec: int) -> Transform3D:
	if _marker != null:
		_marker.look()
		if _actor < 0 and _marker.is_certain():
			return _marker.room()
	return _wearer * AHEAD * _in_room(p_due_usec)


func _point_at_menu() -> void:
	var hands: Array[Transform3D] = []
	var triggers: PackedFloat32Array = []
	for hand: int in 2:
		var controller: XRController3D = display.view().hand(hand)
		hands.append(display.controller_pose(hand))
		# Some controllers have a button only.
		var click: float = 1.0 if controller.is_button_pressed(&"trigger_click") else 0.0
		var trigger: float = maxf(controller.get_float(&"trigger"), click)
		triggers.append(maxf(trigger, _gestures[hand].pinch))
	_menu.point(hands, triggers)


## From the tracking space to the room: recentred, and without what a motion platform moves.
func _in_room(p_due_usec: int) -> Transform3D:
	var still: Transform3D = platform.without_platform(Transform3D.IDENTITY, p_due_usec)
	return display.recentring.transform() * still


func _on_recentred() -> void:
	if fused != null:
		fused.recentre()
	if body != null:
		body.recentre()
		body.is_seated = display.recentring.is_seated
		# Who recentres stands upright and looks ahead.
		body.learn_pins()


## The body turns with its wearer.
func _on_turned(p_angle: float, p_is_step: bool) -> void:
	if fused != null:
		fused.turn(p_angle)
	# Feet step after a smooth turn as after one of the wearer's own.
	if body != null and p_is_step:
		body.recentre()


func _on_button(p_name: StringName, p_hand: int, p_is_pressed: bool) -> void:
	var action: StringName = ACTIONS[p_hand].get(p_name, &"")
	if action == MENU:
		if p_is_pressed:
			toggle_menu()
		return
	# While the menu is open the triggers are its own.
	if action == &"" or (p_is_pressed and is_instance_valid(_menu) and _menu.is_open()):
		return
	var event: InputEventAction = InputEventAction.new()
	event.action = action
	event.pressed = p_is_pressed
	Input.parse_input_event(event)


func _on_gesture(p_gesture: HandGestures.Gesture, p_hand: int, p_begins: bool) -> void:
	if GESTURES.has(p_gesture):
		_on_button(GESTURES[p_gesture], p_hand, p_begins)


## Draws a lower tier of quality, or the user's own again.
func _on_quality_wanted(p_step: int) -> void:
	if _tier < 0:
		_tier = maxi(Quality.NAMES.find(Quality.tier.name), 0)
	Quality.use(Quality.find(Quality.NAMES[maxi(_tier - p_step, 0)]), get_viewport())


func _on_chosen(p_entry: HeadsetMenu.Entry) -> void:
	match p_entry:
		HeadsetMenu.Entry.RECENTRE:
			display.recentre()
		HeadsetMenu.Entry.SEATED:
			display.set_seated(not display.recentring.is_seated)
		HeadsetMenu.Entry.VIGNETTE:
			_has_vignette = not _has_vignette
		HeadsetMenu.Entry.SNAP_TURN:
			display.turning.is_on = not display.turning.is_on
		HeadsetMenu.Entry.LEAVE:
			leave_wanted.emit()
	if p_entry in [HeadsetMenu.Entry.CONTINUE, HeadsetMenu.Entry.RECENTRE]:
		_menu.close()
	else:
		_describe_settings()


func _describe_settings() -> void:
	_list.describe(display.recentring.is_seated, _has_vignette, display.turning.is_on)


## Takes where the level has a marker, from a text such as "1.5,1.6,-4,90,door". Returns what is
## wrong, or an empty text. Somebody without a body is put into the world by it; a body is where the
## server has it.
func _set_marker(p_text: String) -> String:
	if p_text == "":
		return ""
	var parts: PackedStringArray = p_text.split(",")
	var are_numbers: bool = parts.size() in [4, 5]
	for part: String in parts.slice(0, 4):
		are_numbers = are_numbers and part.is_valid_float() and is_finite(part.to_float())
	if not are_numbers:
		return "--marker is X,Y,Z,HEADING or X,Y,Z,HEADING,NAME, found '%s'" % p_text.left(60)
	_marker = MarkerAlignment.new()
	_marker.marker = parts[4] if parts.size() == 5 else ""
	var turn: Basis = Basis(Vector3.UP, deg_to_rad(parts[3].to_float()))
	var place: Vector3 = Vector3(parts[0].to_float(), parts[1].to_float(), parts[2].to_float())
	_marker.in_world = Transform3D(turn, place)
	return ""
