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

## Where the sound is set.
var sound_menu: SoundMenu = SoundMenu.new()

var _menu: UiPanel = UiPanel.new("Dismount", 232.0)
var _guide: UiPanel = UiPanel.new("Keys", 720.0)
var _list: GridContainer = GridContainer.new()
var _continue: Button = null
var _quality: Button = null
## Place of the tier of quality among its names.
var _tier: int = 0


func _init() -> void:
	_continue = _menu.add_button("Continue", _show_menu.bind(false))
	_menu.add_button("Keys", _show_keys)
	_menu.add_button("Full screen", _toggle_full_screen)
	_quality = _menu.add_button("Quality", _choose_next_quality)
	_menu.add_button("Sound", _on_sound_pressed)
	_menu.add_button("Wheel and pedals", _on_wheel_pressed)
	_menu.add_button("Leave", leave_wanted.emit)
	_list.columns = 4
	_guide.rows.add_child(_list)
	# The camera is turned by the mouse meanwhile.
	for part: Node in [_guide] + _guide.find_children("*", "Control", true, false):
		(part as Control).mouse_filter = Control.MOUSE_FILTER_IGNORE
	sound_menu.closed.connect(_show_menu.bind(true))
	for panel: UiPanel in [_menu, _guide, sound_menu]:
		panel.visible = false
		add_child(panel)


## Sets the keys that do something here, as of [method KeyGuide.describe]: in two columns, the upper
## half on the left.
func set_keys(p_text: String) -> void:
	for child: Node in _list.get_children():
		child.free()
	var lines: PackedStringArray = p_text.split("\n")
	var half: int = ceili(lines.size() / 2.0)
	for at: int in half:
		_add_key(lines[at])
		_add_key(lines[half + at] if half + at < lines.size() else "")


func _add_key(p_line: String) -> void:
	var key: Label = Label.new()
	key.text = p_line.get_slice("\t", 0)
	key.theme_type_variation = UiStyle.WARNING
	_list.add_child(key)
	var does: Label = Label.new()
	does.text = p_line.get_slice("\t", 1) if "\t" in p_line else ""
	does.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	does.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_list.add_child(does)


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
