class_name WindowMenu
extends CanvasLayer
## What Esc leads to: go on, see the keys, fill the screen, leave, and what the parts of the client
## add to it ([method add_entry], [method add_page]). F1 shows the keys at once.

## The user wants to end the program.
signal leave_wanted

const _SHOW_KEYS: StringName = &"show_keys"
const _FULL_SCREEN: StringName = &"toggle_full_screen"
const _MENU: StringName = &"ui_cancel"

var _menu: UiPanel = UiPanel.new("Dismount", 232.0)
var _guide: UiPanel = UiPanel.new("Keys", 720.0)
var _list: GridContainer = GridContainer.new()
var _continue: Button = null
var _leave: Button = null
var _pages: Array[UiPanel] = []


func _init() -> void:
	_continue = _menu.add_button("Continue", _show_menu.bind(false))
	_menu.add_button("Keys", _show_keys)
	_menu.add_button("Full screen", _toggle_full_screen)
	_leave = _menu.add_button("Leave", leave_wanted.emit)
	_list.columns = 4
	_guide.rows.add_child(_list)
	# The camera is turned by the mouse meanwhile.
	for part: Node in [_guide] + _guide.find_children("*", "Control", true, false):
		(part as Control).mouse_filter = Control.MOUSE_FILTER_IGNORE
	for panel: UiPanel in [_menu, _guide]:
		panel.visible = false
		add_child(panel)


## Adds an entry before the last one, and returns its button. The menu closes when it is chosen,
## unless it stays open for another choice.
func add_entry(p_text: String, p_chosen: Callable, p_stays_open: bool = false) -> Button:
	var button: Button = _menu.add_button(p_text, p_chosen)
	if not p_stays_open:
		button.pressed.connect(_show_menu.bind(false))
	_menu.rows.move_child(button, _leave.get_index())
	return button


## Adds an entry that opens a panel, by [param p_opens]. The menu counts as open as long as the
## panel is, and [param p_closed], a signal of the panel, leads back to it.
func add_page(p_text: String, p_page: UiPanel, p_opens: Callable, p_closed: Signal) -> void:
	add_entry(p_text, p_opens)
	p_closed.connect(_show_menu.bind(true))
	_pages.append(p_page)
	p_page.visible = false
	add_child(p_page)


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


## Whether the menu is open.
func is_open() -> bool:
	return _menu.visible or _pages.any(func(page: UiPanel) -> bool: return page.visible)


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


func _show_keys() -> void:
	_show_menu(false)
	_guide.visible = true


func _toggle_full_screen() -> void:
	WindowFrame.toggle_full_screen(get_window())
