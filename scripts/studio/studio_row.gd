@tool
class_name StudioRow
extends HBoxContainer
## One line of the studio's panel: a name with a slider, a choice, numbers or colours.

## The slider was moved.
signal number_changed(p_value: float)
## A choice was made, or numbers were typed.
signal text_changed(p_text: String)
## A colour was picked, added or taken away.
signal colours_changed(p_colours: PackedColorArray)

const LABEL: float = 118.0
const SWATCH: float = 30.0

var _label: Label = Label.new()
var _slider: UiSlider = null
var _edit: LineEdit = null
var _choice: OptionButton = null
var _pickers: Array[ColorPickerButton] = []
var _more: Button = null


func _init() -> void:
	_label.clip_text = true
	_label.custom_minimum_size.x = LABEL
	_label.mouse_filter = Control.MOUSE_FILTER_PASS
	add_child(_label)
	size_flags_horizontal = Control.SIZE_EXPAND_FILL
	mouse_filter = Control.MOUSE_FILTER_PASS


## Its name, and what it does.
func describe(p_name: String, p_meaning: String) -> void:
	_label.text = p_name
	_label.tooltip_text = p_meaning


## A slider between bounds; [param p_step] 0 for a fine one. What can be typed beside it,
## [param p_limits], may be more than the slider reaches; zero if it is the same.
func show_number(
	p_minimum: float, p_maximum: float, p_step: float, p_limits: Vector2 = Vector2.ZERO
) -> void:
	if _slider == null:
		_slider = UiSlider.new("", Vector3(p_minimum, p_maximum, 1.0), "", "", 0.0)
		_slider.title.visible = false
		_slider.slider.scrollable = false
		_slider.moved.connect(number_changed.emit)
		_add(_slider)
	_slider.set_range(Vector3(p_minimum, p_maximum, p_step if p_step > 0.0 else 0.001))
	_slider.let_type(Vector2(p_minimum, p_maximum) if p_limits == Vector2.ZERO else p_limits)
	# Long ranges have what is wanted at their beginning.
	_slider.slider.exp_edit = p_minimum > 0.0 and p_maximum / p_minimum > 100.0


func set_number(p_value: float) -> void:
	_slider.show_value(p_value)


## The slider, for tests.
func slider() -> HSlider:
	return _slider.slider


func show_choices(p_choices: PackedStringArray, p_chosen: String) -> void:
	if _choice == null:
		_choice = OptionButton.new()
		_choice.item_selected.connect(
			func(index: int) -> void: text_changed.emit(_choice.get_item_text(index))
		)
		_add(_choice)
	if _choice.item_count != p_choices.size():
		_choice.clear()
		for choice: String in p_choices:
			_choice.add_item(choice)
	_choice.select(p_choices.find(p_chosen))


## Several numbers with spaces between.
func show_numbers(p_values: PackedFloat64Array) -> void:
	if _edit == null:
		_edit = LineEdit.new()
		_add(_edit)
		_edit.text_submitted.connect(
			func(text: String) -> void: text_changed.emit(text.strip_edges())
		)
	var parts: PackedStringArray = []
	for value: float in p_values:
		parts.append(HeaderEdit.number(value))
	if not _edit.has_focus():
		_edit.text = " ".join(parts)


## Colours; [param p_grows] lets more be added, up to the most that a header has.
func show_colours(p_colours: PackedColorArray, p_grows: bool) -> void:
	while _pickers.size() < p_colours.size():
		var picker: ColorPickerButton = ColorPickerButton.new()
		picker.edit_alpha = p_grows
		picker.custom_minimum_size.x = SWATCH
		picker.color_changed.connect(func(_colour: Color) -> void: colours_changed.emit(_colours()))
		_pickers.append(picker)
		add_child(picker)
	while _pickers.size() > p_colours.size():
		(_pickers.pop_back() as Node).queue_free()
	for i: int in _pickers.size():
		_pickers[i].color = p_colours[i]
	if p_grows and _more == null:
		_more = Button.new()
		_more.text = "+"
		_more.tooltip_text = "one more colour over the life"
		_more.pressed.connect(_on_more)
		add_child(_more)
	if _more != null:
		move_child(_more, -1)


## Colours as a header has them.
static func html(p_colours: PackedColorArray) -> String:
	var parts: PackedStringArray = []
	for colour: Color in p_colours:
		parts.append("#" + colour.to_html(colour.a < 1.0))
	return " ".join(parts)


func _add(p_control: Control) -> void:
	p_control.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	add_child(p_control)


func _colours() -> PackedColorArray:
	var colours: PackedColorArray = []
	for picker: ColorPickerButton in _pickers:
		colours.append(picker.color)
	return colours


func _on_more() -> void:
	var colours: PackedColorArray = _colours()
	if colours.size() < EffectSettings.MAX_STEPS:
		colours.append(colours[-1])
		colours_changed.emit(colours)
