class_name WindowControls
extends ClientPart
## What a user does to the window of a client, besides taking part: whom the camera follows and from
## where, the menu, the keys.

const _MENU: PackedScene = preload("res://scenes/client/view/window_menu.tscn")
const _NEXT: StringName = &"next_person"
const _VIEW: StringName = &"change_view"
const _CAMERA: StringName = &"next_camera"
const _TORCH: StringName = &"switch_torch"
## A click moves the mouse by less than this, pixels; a drag turns the camera.
const _CLICK_PIXELS: float = 6.0

var _menu: WindowMenu = null
var _moves: bool = false
var _quality: Button = null
## Place of the tier of quality among its names.
var _tier: int = 0
var _press: Vector2 = Vector2.INF


func _unhandled_input(p_event: InputEvent) -> void:
	if p_event.is_action_pressed(_NEXT):
		context.scene.view.follow_next()
	elif p_event.is_action_pressed(_VIEW):
		context.scene.view.change_view()
	elif p_event.is_action_pressed(_CAMERA):
		context.scene.next_camera()
	elif p_event.is_action_pressed(_TORCH) and _moves:
		context.scene.switch_torch()
	else:
		_take_click(p_event as InputEventMouseButton)
		return
	get_viewport().set_input_as_handled()


func open(p_context: ClientContext) -> String:
	super(p_context)
	_moves = context.can(Roles.Capability.SEND_MOTION)
	_menu = _MENU.instantiate()
	add_child(_menu)
	_menu.set_keys(KeyGuide.describe(_moves, context.can(Roles.Capability.COMMAND)))
	_menu.leave_wanted.connect(context.leave_wanted.emit.bind(StateStream.EXIT_DONE))
	context.menu = _menu
	context.menus.append(_menu.is_open)
	if ClientContext.is_headless():
		return ""
	WindowFrame.follow(self)
	_set_up_quality(context.options.text("quality"))
	get_window().title = WindowFrame.title(
		context.role, context.options.text("name"), context.stream.describe()
	)
	return ""


## Uses the tier of quality that an option names, or else that of the user's settings.
func _set_up_quality(p_name: String) -> void:
	context.settings = UserSettings.new()
	var name: String = p_name
	if name == "" and OS.has_feature("movie"):
		# A film has all the time that it needs.
		name = "high"
	elif name == "":
		name = context.settings.quality(
			RenderingServer.get_video_adapter_name(), RenderingServer.get_video_adapter_type()
		)
	Quality.use(Quality.find(name), get_viewport())
	_quality = _menu.add_entry("Quality", _choose_next_quality, true)
	_show_quality(name)


func _show_quality(p_name: String) -> void:
	_tier = Quality.NAMES.find(p_name)
	_quality.text = "Quality: " + p_name


func _choose_next_quality() -> void:
	var name: String = Quality.NAMES[(_tier + 1) % Quality.NAMES.size()]
	_show_quality(name)
	context.settings.choose_quality(name)
	Quality.use(Quality.find(name), get_viewport())


func _take_click(p_event: InputEventMouseButton) -> void:
	if p_event == null or p_event.button_index != MOUSE_BUTTON_LEFT:
		return
	if p_event.pressed:
		_press = p_event.position
	elif _press.distance_to(p_event.position) < _CLICK_PIXELS:
		context.scene.view.follow_at(p_event.position)
