@tool
class_name StudioBar
extends HFlowContainer
## The studio's buttons. They stand in as many rows as the width needs.

## A button was pressed: one of [constant BUTTONS].
signal asked(p_what: String)
signal effect_chosen(p_name: String)
## Simulated seconds a second.
signal speed_changed(p_value: float)
## m/s.
signal wind_changed(p_value: float)
signal ground_changed(p_is_there: bool)
## Speed of the emitter, m/s.
signal travel_changed(p_value: float)

## What each button asks for: its text, and what it does.
const BUTTONS: Dictionary[String, Array] = {
	"new": ["New", "a copy under another name"],
	"save": ["Save", "Ctrl+S"],
	"undo": ["Undo", "Ctrl+Z"],
	"redo": ["Redo", "Ctrl+Shift+Z"],
	"restart": ["Restart", "F5: plays it from the beginning"],
	"pause": ["Pause", "F6"],
	"step": ["Step", "F7: a sixtieth of a second"],
	"compare": ["A/B", "beside it, as it is saved"],
	"picture": ["Picture", "saves a picture"],
	"film": ["Film", "saves a film of six seconds"],
	"measure": ["Measure", "what it costs, and what CPU particles would"],
	"send": ["Send", "to everybody in the session at the address"],
	"help": ["Help", "F1: all settings and words"],
}
var _names: OptionButton = OptionButton.new()
var _address: LineEdit = LineEdit.new()


func _init() -> void:
	_names.item_selected.connect(
		func(index: int) -> void: effect_chosen.emit(_names.get_item_text(index))
	)
	_add(_names, "the effect", 150.0)
	for what: String in BUTTONS:
		if what == "send":
			_address.text = "127.0.0.1:%d" % Protocol.DEFAULT_PORT
			_add(_address, "server of the session", 130.0)
		var button: Button = Button.new()
		button.text = BUTTONS[what][0]
		button.pressed.connect(func() -> void: asked.emit(what))
		_add(button, BUTTONS[what][1], 0.0)
	_add_slider("speed", 0.05, 2.0, 1.0, speed_changed.emit)
	_add_slider("wind", 0.0, 15.0, 0.0, wind_changed.emit)
	_add_slider("drive", 0.0, 15.0, 0.0, travel_changed.emit)
	var ground: CheckBox = CheckBox.new()
	ground.text = "ground"
	ground.button_pressed = true
	ground.toggled.connect(ground_changed.emit)
	_add(ground, "whether there is ground", 0.0)


## Shows the names of the effects, one of them chosen.
func show_names(p_names: PackedStringArray, p_chosen: String) -> void:
	_names.clear()
	for name: String in p_names:
		_names.add_item(name)
	if not p_names.has(p_chosen):
		_names.add_item(p_chosen)
	for i: int in _names.item_count:
		if _names.get_item_text(i) == p_chosen:
			_names.select(i)


## Where the session is.
func address() -> String:
	return _address.text.strip_edges()


func _add(p_part: Control, p_tip: String, p_width: float) -> void:
	p_part.tooltip_text = p_tip
	p_part.custom_minimum_size.x = p_width
	p_part.focus_mode = Control.FOCUS_CLICK
	add_child(p_part)


func _add_slider(
	p_name: String, p_from: float, p_to: float, p_value: float, p_taker: Callable
) -> void:
	var row: UiSlider = UiSlider.new(p_name, Vector3(p_from, p_to, 0.05), "", "", 0.0)
	row.show_value(p_value)
	row.slider.focus_mode = Control.FOCUS_CLICK
	row.moved.connect(p_taker)
	_add(row, p_name, 0.0)
