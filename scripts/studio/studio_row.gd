@tool
class_name StudioRow
extends Control
## One line of the studio's panel: a name with a slider, a choice, numbers or colours.

## The slider was moved.
signal number_changed(p_value: float)
## A choice was made, or numbers were typed.
signal text_changed(p_text: String)
## A colour was picked, added or taken away.
signal colours_changed(p_colours: PackedColorArray)

const LABEL: float = 118.0
const NUMBER: float = 58.0
const SWATCH: float = 30.0

## What can be typed beside a slider; it may be more than the slider reaches.
var limits: Vector2 = Vector2.ZERO

var _label: Label = Label.new()
var _slider: HSlider = null
var _edit: LineEdit = null
var _choice: OptionButton = null
var _pickers: Array[ColorPickerButton] = []
var _more: Button = null
var _is_setting: bool = false


func _init() -> void:
	_label.clip_text = true
	_label.mouse_filter = Control.MOUSE_FILTER_PASS
	_label.add_theme_font_size_override("font_size", 12)
	add_child(_label)
	mouse_filter = Control.MOUSE_FILTER_PASS
	resized.connect(_lay_out)


## Its name, and what it does.
func describe(p_name: String, p_meaning: String) -> void:
	_label.text = p_name
	_label.tooltip_text = p_meaning


## A slider between bounds; [param p_step] 0 for a fine one.
func show_number(p_minimum: float, p_maximum: float, p_step: float) -> void:
	if _slider == null:
		_slider = HSlider.new()
		_slider.scrollable = false
		_slider.value_changed.connect(_on_slid)
		add_child(_slider)
		_add_edit()
		_edit.text_submitted.connect(_on_number_typed)
	_is_setting = true
	_slider.min_value = p_minimum
	_slider.max_value = p_maximum
	_slider.step = p_step if p_step > 0.0 else 0.001
	# Long ranges have what is wanted at their beginning.
	_slider.exp_edit = p_minimum > 0.0 and p_maximum / p_minimum > 100.0
	_is_setting = false
	_lay_out()


func set_number(p_value: float) -> void:
	_is_setting = true
	_slider.value = p_value
	if not _edit.has_focus():
		_edit.text = HeaderEdit.number(p_value)
	_is_setting = false


## The slider's value.
func number() -> float:
	return _slider.value


## The slider, for tests.
func slider() -> HSlider:
	return _slider


func show_choices(p_choices: PackedStringArray, p_chosen: String) -> void:
	if _choice == null:
		_choice = OptionButton.new()
		_choice.add_theme_font_size_override("font_size", 12)
		_choice.item_selected.connect(
			func(index: int) -> void: text_changed.emit(_choice.get_item_text(index))
		)
		add_child(_choice)
	if _choice.item_count != p_choices.size():
		_choice.clear()
		for choice: String in p_choices:
			_choice.add_item(choice)
	_choice.select(p_choices.find(p_chosen))
	_lay_out()


## Several numbers with spaces between.
func show_numbers(p_values: PackedFloat64Array) -> void:
	if _edit == null:
		_add_edit()
		_edit.text_submitted.connect(
			func(text: String) -> void: text_changed.emit(text.strip_edges())
		)
	var parts: PackedStringArray = []
	for value: float in p_values:
		parts.append(HeaderEdit.number(value))
	if not _edit.has_focus():
		_edit.text = " ".join(parts)
	_lay_out()


## Colours; [param p_grows] lets more be added, up to the most that a header has.
func show_colours(p_colours: PackedColorArray, p_grows: bool) -> void:
	while _pickers.size() < p_colours.size():
		var picker: ColorPickerButton = ColorPickerButton.new()
		picker.edit_alpha = p_grows
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
	_lay_out()


## Colours as a header has them.
static func html(p_colours: PackedColorArray) -> String:
	var parts: PackedStringArray = []
	for colour: Color in p_colours:
		parts.append("#" + colour.to_html(colour.a < 1.0))
	return " ".join(parts)


func _add_edit() -> void:
	_edit = LineEdit.new()
	_edit.add_theme_font_size_override("font_size", 12)
	add_child(_edit)


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


func _on_slid(p_value: float) -> void:
	if not _is_setting:
		_edit.text = HeaderEdit.number(p_value)
		number_changed.emit(p_value)


func _on_number_typed(p_text: String) -> void:
	if p_text.is_valid_float():
		var ends: Vector2 = limits
		if ends == Vector2.ZERO:
			ends = Vector2(_slider.min_value, _slider.max_value)
		number_changed.emit(clampf(p_text.to_float(), ends.x, ends.y))


func _lay_out() -> void:
	_label.position = Vector2.ZERO
	_label.size = Vector2(LABEL, size.y)
	var left: float = LABEL + 4.0
	var rest: Vector2 = Vector2(maxf(size.x - left, 20.0), size.y)
	if _slider != null:
		_slider.position = Vector2(left, 0.0)
		_slider.size = Vector2(maxf(rest.x - NUMBER - 4.0, 10.0), size.y)
		_edit.position = Vector2(size.x - NUMBER, 0.0)
		_edit.size = Vector2(NUMBER, size.y)
	elif _edit != null:
		_edit.position = Vector2(left, 0.0)
		_edit.size = rest
	if _choice != null:
		_choice.position = Vector2(left, 0.0)
		_choice.size = rest
	for i: int in _pickers.size():
		_pickers[i].position = Vector2(left + i * (SWATCH + 2.0), 0.0)
		_pickers[i].size = Vector2(SWATCH, size.y)
	if _more != null:
		_more.position = Vector2(left + _pickers.size() * (SWATCH + 2.0), 0.0)
		_more.size = Vector2(22.0, size.y)
