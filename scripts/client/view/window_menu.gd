class_name WindowMenu
extends CanvasLayer
## What Esc leads to: go on, see the keys, choose the quality, set the sound, calibrate a
## wheel, fill the screen, leave. F1 shows the keys at once.

## The user wants to end the program.
signal leave_wanted
## The user wants another tier of quality, one of [constant Quality.NAMES].
signal quality_chosen(p_name: String)
## The user wants to calibrate a wheel and pedals.
signal wheel_wanted

const _SHOW_KEYS: StringName = &"show_keys"
const _FULL_SCREEN: StringName = &"toggle_full_screen"
const _MENU: StringName = &"ui_cancel"

@export var _menu: Control
@export var _continue: Button
@export var _keys: Button
@export var _full_screen: Button
@export var _quality: Button
@export var _sound: Button
@export var _wheel: Button
@export var _leave: Button
@export var _list: Label
@export var _names: Label
@export var _guide: Control

## Where the sound is set.
var sound_menu: SoundMenu = null

## Place of the tier of quality among its names.
var _tier: int = 0


func _ready() -> void:
	_continue.pressed.connect(_show_menu.bind(false))
	_keys.pressed.connect(_show_keys)
	_full_screen.pressed.connect(_toggle_full_screen)
	_leave.pressed.connect(leave_wanted.emit)
	_quality.pressed.connect(_choose_next_quality)
	_wheel.pressed.connect(_on_wheel_pressed)
	_sound.pressed.connect(_on_sound_pressed)
	_menu.visible = false
	_guide.visible = false
	sound_menu = SoundMenu.new()
	sound_menu.add_theme_stylebox_override("panel", _menu.get_theme_stylebox("panel"))
	sound_menu.closed.connect(_show_menu.bind(true))
	add_child(sound_menu)


## Sets the keys that do something here, as of [method KeyGuide.describe].
func set_keys(p_text: String) -> void:
	var keys: PackedStringArray = []
	var names: PackedStringArray = []
	for line: String in p_text.split("\n"):
		keys.append(line.get_slice("\t", 0))
		names.append(line.get_slice("\t", 1))
	_list.text = "\n".join(keys)
	_names.text = "\n".join(names)


## Sets the tier of quality that is used.
func set_quality(p_name: String) -> void:
	_tier = Quality.NAMES.find(p_name)
	_quality.text = "Quality: " + p_name


func _choose_next_quality() -> void:
	set_quality(Quality.NAMES[(_tier + 1) % Quality.NAMES.size()])
	quality_chosen.emit(Quality.NAMES[_tier])


## Whether the menu is open.
func is_open() -> bool:
	return _menu.visible or sound_menu.visible


## Whether the list of keys is open.
func shows_keys() -> bool:
	return _guide.visible


func _unhandled_input(p_event: InputEvent) -> void:
	if p_event.is_action_pressed(_MENU):
		var is_free: bool = not _guide.visible
		_guide.visible = false
		_show_menu(is_free and not _menu.visible)
	elif p_event.is_action_pressed(_SHOW_KEYS):
		_guide.visible = not _guide.visible
		_menu.visible = false
	elif p_event.is_action_pressed(_FULL_SCREEN):
		_toggle_full_screen()
	else:
		return
	get_viewport().set_input_as_handled()


func _show_menu(p_shows: bool) -> void:
	_menu.visible = p_shows
	if p_shows:
		_continue.grab_focus()


func _on_wheel_pressed() -> void:
	_show_menu(false)
	wheel_wanted.emit()


func _on_sound_pressed() -> void:
	_show_menu(false)
	sound_menu.open()


func _show_keys() -> void:
	_show_menu(false)
	_guide.visible = true


func _toggle_full_screen() -> void:
	WindowFrame.toggle_full_screen(get_window())
