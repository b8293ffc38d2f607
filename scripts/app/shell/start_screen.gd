class_name StartScreen
extends MarginContainer
## What the program begins with: what it can do, as choices one below the other.

## The user wants another screen, by its name in [constant AppShell.SCREENS].
signal screen_wanted(p_name: StringName)
## The user wants one of the commands of [code]./run[/code] in a window of its own.
signal command_wanted(p_command: String)
## The user wants to see the demonstration.
signal demonstration_wanted
## The user wants to end the program.
signal leave_wanted

const _WIDTH_PX: float = 320.0
## Space between two groups of choices, px.
const _GAP_PX: float = 10.0

var _screens: Array = []
var _rows: VBoxContainer = VBoxContainer.new()
var _hint: Label = Label.new()


## [param p_screens] are the names of the screens that there are.
func _init(p_screens: Array) -> void:
	_screens = p_screens
	set_anchors_preset(Control.PRESET_LEFT_WIDE)
	var column: PanelContainer = PanelContainer.new()
	column.theme_type_variation = UiStyle.COLUMN
	column.custom_minimum_size.x = _WIDTH_PX
	add_child(column)
	var frame: VBoxContainer = VBoxContainer.new()
	column.add_child(frame)
	var name_label: Label = Label.new()
	name_label.text = "Dismount"
	name_label.auto_translate_mode = Node.AUTO_TRANSLATE_MODE_DISABLED
	name_label.theme_type_variation = UiStyle.HERO
	frame.add_child(name_label)
	var scroll: ScrollContainer = ScrollContainer.new()
	scroll.horizontal_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	scroll.size_flags_vertical = Control.SIZE_EXPAND_FILL
	scroll.follow_focus = true
	frame.add_child(scroll)
	_rows.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	scroll.add_child(_rows)
	_add_choices()
	_hint.theme_type_variation = UiStyle.HINT
	_hint.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_hint.custom_minimum_size.y = 2.0 * UiStyle.BODY_PX
	frame.add_child(_hint)


## Gives the keyboard to the first choice.
func focus_first() -> void:
	for child: Node in _rows.get_children():
		if child is Button and (child as Button).visible and not (child as Button).disabled:
			(child as Button).grab_focus()
			return


func _add_choices() -> void:
	_add_screen("Join", &"join", "Take part in a session on this network or elsewhere")
	_add_screen("Host", &"host", "Begin a session of your own that others can join")
	_add_screen("Watch", &"watch", "Look at a session without a body of your own")
	_add_screen("Instruct", &"instruct", "Direct a session and decide who takes part")
	_add_screen("Review", &"review", "Look at a recording of a session")
	_add_gap()
	_add(
		"Try it",
		"A short demonstration: someone walks by recorded motion",
		demonstration_wanted.emit
	)
	_add_command("Build", "editor", "Make levels and scenarios in the editor")
	_add_command("Effects studio", "studio", "Make particle effects")
	_add_gap()
	_add("Quit", "", leave_wanted.emit)


func _add_screen(p_text: String, p_name: StringName, p_hint: String) -> void:
	var button: Button = _add(p_text, p_hint, screen_wanted.emit.bind(p_name))
	button.visible = _screens.has(p_name)


func _add_command(p_text: String, p_command: String, p_hint: String) -> void:
	var button: Button = _add(p_text, p_hint, command_wanted.emit.bind(p_command))
	if ProgramPaths.run() == "":
		button.disabled = true
		button.tooltip_text = "This needs Dismount's source: start the program there by ./run"


func _add(p_text: String, p_hint: String, p_pressed: Callable) -> Button:
	var button: Button = Button.new()
	button.text = p_text
	button.name = p_text.to_pascal_case()
	button.theme_type_variation = UiStyle.CHOICE
	button.alignment = HORIZONTAL_ALIGNMENT_LEFT
	button.pressed.connect(p_pressed)
	button.focus_entered.connect(_show_hint.bind(p_hint))
	button.mouse_entered.connect(_show_hint.bind(p_hint))
	_rows.add_child(button)
	return button


func _add_gap() -> void:
	var gap: Control = Control.new()
	gap.custom_minimum_size.y = _GAP_PX
	_rows.add_child(gap)


func _show_hint(p_hint: String) -> void:
	_hint.text = p_hint
