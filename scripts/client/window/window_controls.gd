class_name WindowControls
extends Node
## What a user does to the window of a client, besides taking part: whom the camera follows and from
## where, the menu, the keys.

## The user wants to calibrate a wheel and pedals.
signal wheel_wanted
## The user wants to leave the session.
signal leave_wanted

const _NEXT: StringName = &"next_person"
const _VIEW: StringName = &"change_view"
const _CAMERA: StringName = &"next_camera"
const _TORCH: StringName = &"switch_torch"
## A click moves the mouse by less than this, pixels; a drag turns the camera.
const _CLICK_PIXELS: float = 6.0

@export var _scene: ClientScene
@export var _menu: WindowMenu
@export var _key_dialog: ServerKeyDialog

var _moves: bool = false
var _settings: UserSettings = null
var _press: Vector2 = Vector2.INF


## Takes over what the client is.
func set_up(p_role: String, p_options: Options) -> void:
	var role: int = Roles.find(p_role)
	_moves = Roles.can(role, Roles.Capability.SEND_MOTION)
	_menu.set_keys(KeyGuide.describe(_moves, Roles.can(role, Roles.Capability.COMMAND)))
	_menu.leave_wanted.connect(leave_wanted.emit)
	_menu.wheel_wanted.connect(wheel_wanted.emit)
	if DisplayServer.get_name() == "headless":
		return
	WindowFrame.follow(get_window())
	_set_up_quality(p_options.text("quality"))
	var where: String = p_options.file("file").get_file()
	var name: String = ""
	if p_role != ClientStreams.REPLAY:
		where = "%s:%d" % [p_options.text("host"), p_options.number("port")]
		name = p_options.text("name")
	get_window().title = WindowFrame.title(p_role, name, where)


## Asks the user where a server shows another key than the last time, if somebody is at the window.
func ask_about_keys(p_live: LiveStream, p_options: Options) -> void:
	var is_shown: bool = DisplayServer.get_name() != "headless"
	p_live.asks = is_shown and p_options.seconds("duration") == 0.0
	p_live.key_changed.connect(_key_dialog.ask)
	_key_dialog.trusted.connect(p_live.trust_key)
	_key_dialog.leave_wanted.connect(leave_wanted.emit)


## Uses the tier of quality that an option names, or else that of the user's settings.
func _set_up_quality(p_name: String) -> void:
	_settings = UserSettings.new()
	var name: String = p_name
	if name == "" and OS.has_feature("movie"):
		# A film has all the time that it needs.
		name = "high"
	elif name == "":
		name = _settings.quality(
			RenderingServer.get_video_adapter_name(), RenderingServer.get_video_adapter_type()
		)
	Quality.use(Quality.find(name), get_viewport())
	_menu.set_quality(name)
	_menu.quality_chosen.connect(_on_quality_chosen)


## Draws once more for a picture that is kept: it has the time that a window has not. A tier that an
## option names stays.
func draw_for_picture(p_quality: String) -> void:
	if p_quality != "" or DisplayServer.get_name() == "headless":
		return
	if Quality.tier.render_scale < 1.0:
		Quality.use(QualityTier.high(), get_viewport())
		RenderingServer.force_draw(false)


func _on_quality_chosen(p_name: String) -> void:
	_settings.choose_quality(p_name)
	Quality.use(Quality.find(p_name), get_viewport())


## Whether the menu is open, which keys are meant for then.
func is_menu_open() -> bool:
	return _menu.is_open() or _key_dialog.is_open()


## What the user has chosen; null without a window.
func settings() -> UserSettings:
	return _settings


## Where the sound is set.
func sound_menu() -> SoundMenu:
	return _menu.sound_menu


## The keys, for the line at the bottom.
func hint() -> String:
	return KeyGuide.hint(_moves)


func _unhandled_input(p_event: InputEvent) -> void:
	if p_event.is_action_pressed(_NEXT):
		_scene.follow_next()
	elif p_event.is_action_pressed(_VIEW):
		_scene.change_view()
	elif p_event.is_action_pressed(_CAMERA):
		_scene.next_camera()
	elif p_event.is_action_pressed(_TORCH) and _moves:
		_scene.switch_torch()
	else:
		_take_click(p_event as InputEventMouseButton)
		return
	get_viewport().set_input_as_handled()


func _take_click(p_event: InputEventMouseButton) -> void:
	if p_event == null or p_event.button_index != MOUSE_BUTTON_LEFT:
		return
	if p_event.pressed:
		_press = p_event.position
	elif _press.distance_to(p_event.position) < _CLICK_PIXELS:
		_scene.follow_at(p_event.position)
