@abstract class_name ShellScreen
extends MarginContainer
## One screen of the start screen, such as Join or Host: a board with a title, a content that
## scrolls and follows the keyboard, and answers at its foot. Esc and the gamepad's B lead back.
##
## A screen is made in [method Object._init], knows no other screen, and says by signals what its
## user wants; [AppShell] does it.

## The user wants to go back.
signal closed
## The user wants to begin a session.
signal begin_wanted(p_choice: SessionChoice)
## The user wants another screen, by its name in [constant AppShell.SCREENS].
signal screen_wanted(p_name: StringName)

## Name of the action that leads back.
const BACK: StringName = &"ui_cancel"
const _WIDTH_PX: float = 720.0

## What stands over the content.
var title: String = "":
	set(p_title):
		title = p_title
		_title.text = p_title
## What the screen is about. It scrolls where the window is too low.
var content: VBoxContainer = VBoxContainer.new()

var _title: Label = Label.new()
var _board: PanelContainer = PanelContainer.new()
var _scroll: ScrollContainer = ScrollContainer.new()
var _answers: HFlowContainer = HFlowContainer.new()


func _init(p_title: String = "") -> void:
	set_anchors_preset(Control.PRESET_FULL_RECT)
	theme_type_variation = UiStyle.STAGE
	_board.size_flags_horizontal = Control.SIZE_SHRINK_CENTER
	_board.size_flags_vertical = Control.SIZE_EXPAND_FILL
	_board.theme_type_variation = UiStyle.BOARD
	add_child(_board)
	var rows: VBoxContainer = VBoxContainer.new()
	_board.add_child(rows)
	_title.theme_type_variation = UiStyle.TITLE
	_title.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	rows.add_child(_title)
	_scroll.horizontal_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	_scroll.size_flags_vertical = Control.SIZE_EXPAND_FILL
	_scroll.follow_focus = true
	rows.add_child(_scroll)
	content.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	content.size_flags_vertical = Control.SIZE_EXPAND_FILL
	_scroll.add_child(content)
	rows.add_child(_answers)
	title = p_title


func _ready() -> void:
	resized.connect(_fit)
	_fit()


func _input(p_event: InputEvent) -> void:
	# A text field would take the first Esc to end its own editing.
	var field: LineEdit = get_viewport().gui_get_focus_owner() as LineEdit
	if field != null and is_ancestor_of(field):
		_lead_back(p_event)


func _unhandled_input(p_event: InputEvent) -> void:
	_lead_back(p_event)


## Gives the keyboard to the control where a user begins. [AppShell] calls it when the screen opens.
@abstract func focus_first() -> void


## Adds a button at the foot, found by its name: its text in PascalCase.
func add_answer(p_text: String, p_pressed: Callable) -> Button:
	var button: Button = Button.new()
	button.text = p_text
	button.name = p_text.to_pascal_case()
	button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	button.pressed.connect(p_pressed)
	_answers.add_child(button)
	return button


## Adds a text that is wrapped at the width of the board.
func add_text(p_text: String = "", p_variation: StringName = &"") -> Label:
	var label: Label = Label.new()
	label.text = p_text
	label.theme_type_variation = p_variation
	label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	content.add_child(label)
	return label


func _lead_back(p_event: InputEvent) -> void:
	if is_visible_in_tree() and p_event.is_action_pressed(BACK):
		get_viewport().set_input_as_handled()
		closed.emit()


func _fit() -> void:
	var edges: float = get_theme_constant(&"margin_left") + get_theme_constant(&"margin_right")
	_board.custom_minimum_size.x = minf(_WIDTH_PX, maxf(size.x - edges, 0.0))
