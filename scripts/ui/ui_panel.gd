class_name UiPanel
extends PanelContainer
## A board in the middle of the screen: a title, rows below one another, and answers at its foot. It
## is as high as its rows. Where the screen is lower they scroll, and follow the keyboard; title and
## answers stay.
##
## Menus and dialogs are one of it, made in code ([code]UiPanel.new("Sound", 340.0)[/code]) or in a
## scene. A screen that fills the window is made of the engine's containers instead.

## Between the board and the edge of the screen, px.
const _EDGE_PX: float = 8.0

## What stands over the rows; nothing if empty.
@export var title: String = "":
	set(p_title):
		title = p_title
		_title.text = p_title
		_title.visible = p_title != ""
## Width of the rows, px; less where the screen is narrower.
@export var width_px: float = 280.0

## What is below the title, one below the other. Add here.
var rows: VBoxContainer = VBoxContainer.new()
## The answers, side by side; see [method add_answer].
var answers: HBoxContainer = HBoxContainer.new()

var _title: Label = Label.new()
var _scroll: ScrollContainer = ScrollContainer.new()


func _init(p_title: String = "", p_width_px: float = 280.0) -> void:
	var frame: VBoxContainer = VBoxContainer.new()
	add_child(frame)
	_title.theme_type_variation = UiStyle.TITLE
	frame.add_child(_title)
	_scroll.horizontal_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	_scroll.follow_focus = true
	frame.add_child(_scroll)
	rows.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_scroll.add_child(rows)
	answers.visible = false
	frame.add_child(answers)
	title = p_title
	width_px = p_width_px
	# Of its least size, whatever that becomes.
	set_anchors_and_offsets_preset(Control.PRESET_CENTER)
	grow_horizontal = Control.GROW_DIRECTION_BOTH
	grow_vertical = Control.GROW_DIRECTION_BOTH


func _ready() -> void:
	for part: Control in [rows, answers]:
		part.minimum_size_changed.connect(_fit)
	get_viewport().size_changed.connect(_fit)
	for part: Control in [rows, answers]:
		part.child_order_changed.connect(_join_ends)
	_join_ends()
	_fit()


## Adds a button that fills a row. It is found by its name: its text in PascalCase.
func add_button(p_text: String, p_pressed: Callable) -> Button:
	var button: Button = _button(p_text, p_pressed)
	rows.add_child(button)
	return button


## Adds a button at the foot.
func add_answer(p_text: String, p_pressed: Callable) -> Button:
	var button: Button = _button(p_text, p_pressed)
	button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	answers.add_child(button)
	answers.visible = true
	return button


## Adds a text that is wrapped at the width.
func add_text(p_text: String = "") -> Label:
	var label: Label = Label.new()
	label.text = p_text
	label.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	rows.add_child(label)
	return label


static func _button(p_text: String, p_pressed: Callable) -> Button:
	var button: Button = Button.new()
	button.text = p_text
	button.name = p_text.to_pascal_case()
	button.pressed.connect(p_pressed)
	return button


## From the first button the keyboard goes up to the last one, and down again.
func _join_ends() -> void:
	if not is_inside_tree():
		return
	var buttons: Array[Node] = rows.find_children("*", "Button", false, false)
	buttons.append_array(answers.find_children("*", "Button", false, false).slice(0, 1))
	if buttons.size() < 2:
		return
	for button: Control in buttons:
		button.focus_neighbor_top = ^""
		button.focus_neighbor_bottom = ^""
	var first: Control = buttons[0]
	var last: Control = buttons[-1]
	first.focus_neighbor_top = first.get_path_to(last)
	last.focus_neighbor_bottom = last.get_path_to(first)


func _fit() -> void:
	var room: Vector2 = get_viewport_rect().size - 2.0 * Vector2(_EDGE_PX, _EDGE_PX)
	var frame: Vector2 = get_combined_minimum_size() - _scroll.get_combined_minimum_size()
	var own: StyleBox = get_theme_stylebox(&"panel")
	rows.custom_minimum_size.x = maxf(minf(width_px, room.x - own.get_minimum_size().x), 0.0)
	var needed: float = rows.get_combined_minimum_size().y
	_scroll.custom_minimum_size.y = maxf(minf(needed, room.y - frame.y), 0.0)
