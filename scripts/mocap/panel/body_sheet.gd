class_name BodySheet
extends PanelSheet
## The measures of a body, cm; those that were not measured follow the height.

## A measure was changed: a name of [constant BodySize.RATIOS], and m.
signal measured(p_name: StringName, p_metres: float)

@export var _grid: GridContainer
@export var _fault: Label
@export var _close: Button

var _boxes: Dictionary[StringName, SpinBox] = {}


func _ready() -> void:
	for name: StringName in BodySize.RATIOS:
		var label: Label = Label.new()
		label.text = "%s: %s" % [String(name).replace("_", " "), BodySize.HINTS[name]]
		_grid.add_child(label)
		var box: SpinBox = SpinBox.new()
		box.max_value = 200.0
		box.step = 0.1
		box.suffix = "cm"
		box.custom_minimum_size.x = 120.0
		box.value_changed.connect(
			func(cm: float) -> void: measured.emit(name, snappedf(cm / 100.0, 0.001))
		)
		_grid.add_child(box)
		_boxes[name] = box
	_close.pressed.connect(close_wanted.emit)


## Shows the measures of a body, and what was wrong with the last one that was entered.
func show_size(p_size: BodySize, p_fault: String) -> void:
	for name: StringName in _boxes:
		_boxes[name].set_value_no_signal(p_size.length(name) * 100.0)
	_fault.text = p_fault


## Gives the first measure the keyboard.
func focus_first() -> void:
	_boxes[BodySize.RATIOS.keys()[0]].get_line_edit().grab_focus()
