@tool
class_name UiSlider
extends UiRow
## A number between two ends: its name, a slider, its value and unit. Arrow keys, the mouse and its
## wheel move it; with [method let_type] a number can be typed, too.

## The user has moved it, or typed a number.
signal moved(value: float)
## The user has moved it and let it go, or goes elsewhere: see [method settle]. What is written to a
## file waits for this.
signal settled(value: float)

## Width of the number, px.
const VALUE_PX: float = 62.0
## What ends and steps are rounded to.
const _EXACT: float = 1e-6

## What is moved. Setting its value counts as the user's move; see [method show_value].
var slider: HSlider = HSlider.new()

var _unit: String = ""
var _zero: String = ""
var _value: Label = Label.new()
var _edit: LineEdit = null
var _typed_ends: Vector2 = Vector2.ZERO
## Whether it was moved and has not settled.
var _has_moved: bool = false


## [param p_range] is the least and the most value, and the step. [param p_zero] is what 0 means,
## where it is not a number.
func _init(
	p_title: String,
	p_range: Vector3,
	p_unit: String = "",
	p_zero: String = "",
	p_title_px: float = UiRow.TITLE_PX
) -> void:
	super(p_title, slider, p_title_px)
	_unit = p_unit
	_zero = p_zero
	slider.size_flags_vertical = Control.SIZE_FILL
	slider.custom_minimum_size.x = 60.0
	set_range(p_range)
	slider.value_changed.connect(_on_moved)
	slider.drag_ended.connect(func(_has_changed: bool) -> void: settle())
	_value.custom_minimum_size.x = VALUE_PX
	_value.horizontal_alignment = HORIZONTAL_ALIGNMENT_RIGHT
	add_child(_value)
	_show()


func _exit_tree() -> void:
	settle()


## Other ends and another step; the value stays, as far as it lies between them.
func set_range(p_range: Vector3) -> void:
	slider.set_block_signals(true)
	# A vector has fewer digits than the slider.
	slider.min_value = snappedf(p_range.x, _EXACT)
	slider.max_value = snappedf(p_range.y, _EXACT)
	slider.step = snappedf(p_range.z, _EXACT)
	slider.set_block_signals(false)
	_show()


## Shows a value, as if nobody had moved it.
func show_value(p_value: float) -> void:
	slider.set_value_no_signal(p_value)
	_show()


## Says [signal settled] if the user has moved it since the last time. Keys and the wheel move it
## without letting it go: whoever closes a panel calls this.
func settle() -> void:
	if _has_moved:
		_has_moved = false
		settled.emit(slider.value)


## Lets numbers be typed between two ends, which may be further than the slider's. The slider shows
## what is typed once somebody shows it.
func let_type(p_ends: Vector2) -> void:
	_typed_ends = p_ends
	if _edit == null:
		_edit = LineEdit.new()
		_edit.custom_minimum_size.x = VALUE_PX
		_edit.text_submitted.connect(_on_typed)
		add_child(_edit)
		_value.visible = false
	_show()


## The value as people read it: with the digits that the step has.
func text() -> String:
	if slider.value == 0.0 and _zero != "":
		return _zero
	var digits: int = clampi(ceili(-log(slider.step) / log(10.0) - 0.001), 0, 4)
	var number: String = String.num(slider.value, digits)
	number = number.pad_decimals(digits)
	return number if _unit == "" else "%s %s" % [number, _unit]


func _show() -> void:
	_value.text = text()
	if _edit != null and not _edit.has_focus():
		_edit.text = String.num(slider.value, 4).trim_suffix(".0")


func _on_moved(p_value: float) -> void:
	_has_moved = true
	_show()
	moved.emit(p_value)


func _on_typed(p_text: String) -> void:
	if p_text.is_valid_float():
		moved.emit(clampf(p_text.to_float(), _typed_ends.x, _typed_ends.y))
