class_name TuningSlider
extends HBoxContainer
## A slider with its name before it, and its value and unit behind it.

## Somebody has moved it.
signal moved(value: float)

## The control that has the keyboard's focus.
var slider: HSlider = HSlider.new()

var _unit: String = ""
var _zero: String = ""
var _value: Label = Label.new()


## [param p_zero] is what 0 means, where it is not a number.
func _init(p_title: String, p_range: Vector3, p_unit: String, p_zero: String = "") -> void:
	_unit = p_unit
	_zero = p_zero
	name = p_title.to_pascal_case()
	var title: Label = Label.new()
	title.text = p_title
	title.custom_minimum_size.x = TuningPanel.TITLE_WIDTH
	add_child(title)
	slider.min_value = p_range.x
	slider.max_value = p_range.y
	slider.step = p_range.z
	slider.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	slider.size_flags_vertical = Control.SIZE_SHRINK_CENTER
	slider.focus_mode = Control.FOCUS_ALL
	slider.value_changed.connect(_on_value_changed)
	add_child(slider)
	_value.custom_minimum_size.x = 78.0
	_value.horizontal_alignment = HORIZONTAL_ALIGNMENT_RIGHT
	add_child(_value)
	TuningPanel.mark_focus(slider, title)
	_show()


## Shows a value without emitting a signal.
func show_value(p_value: float) -> void:
	slider.set_value_no_signal(p_value)
	_show()


func _show() -> void:
	var digits: int = 0 if slider.step >= 1.0 else (1 if slider.step >= 0.1 else 2)
	_value.text = String.num(slider.value, digits).pad_decimals(digits) + " " + _unit
	if slider.value == 0.0 and _zero != "":
		_value.text = _zero


func _on_value_changed(p_value: float) -> void:
	_show()
	moved.emit(p_value)
