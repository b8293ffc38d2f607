class_name SoundMenu
extends Panel
## Where a user sets how loud things are, the limiter, captions and sound for headphones.
##
## It is placed by offsets: containers fail in exported clients.

## The user has changed a volume: its bus, and 0 to 1.
signal volume_changed(p_bus: StringName, p_share: float)
## A volume that the user has changed stays: the slider is let go, or the menu closed.
signal volume_settled(p_bus: StringName, p_share: float)
## The user has switched one of [constant SWITCHES].
signal switched(p_name: StringName, p_is_on: bool)
## The user is done.
signal closed

## What can be switched, and what the menu calls it.
const SWITCHES: Dictionary[StringName, String] = {
	&"limiter": "Limit loud sounds",
	&"captions": "Captions for sounds",
	&"binaural": "Headphones (binaural)",
}
const _TITLES: Dictionary[StringName, String] = {
	&"Master": "All",
	SoundBuses.WORLD: "World",
	SoundBuses.VOICES: "Voices and radio",
	SoundBuses.INTERFACE: "Interface",
}
const _WIDTH: float = 340.0
const _LEFT: float = 24.0
const _ROW: float = 44.0

var _sliders: Dictionary[StringName, HSlider] = {}
var _checks: Dictionary[StringName, CheckButton] = {}
var _done: Button = null
## Buses whose volume has changed and is not settled.
var _unsettled: Dictionary[StringName, bool] = {}


func _ready() -> void:
	var y: float = 20.0
	_add_label("Sound", y).add_theme_font_size_override("font_size", 22)
	y += 48.0
	for bus: StringName in SoundBuses.SETTABLE:
		_add_label(_TITLES[bus], y)
		_sliders[bus] = _add_slider(bus, y)
		y += _ROW
	for name: StringName in SWITCHES:
		var check: CheckButton = CheckButton.new()
		check.text = SWITCHES[name]
		_place(check, _LEFT, y, _WIDTH - 2.0 * _LEFT, 36.0)
		check.toggled.connect(_on_toggled.bind(name))
		_checks[name] = check
		y += _ROW
	_done = Button.new()
	_done.text = "Done"
	_place(_done, _LEFT, y + 8.0, _WIDTH - 2.0 * _LEFT, 40.0)
	_done.pressed.connect(close)
	y += 72.0
	set_anchors_preset(Control.PRESET_CENTER)
	offset_left = -_WIDTH / 2.0
	offset_right = _WIDTH / 2.0
	offset_top = -y / 2.0
	offset_bottom = y / 2.0
	visible = false


func _exit_tree() -> void:
	_settle_all()


func _unhandled_input(p_event: InputEvent) -> void:
	if visible and p_event.is_action_pressed(&"ui_cancel"):
		close()
		get_viewport().set_input_as_handled()


## Opens it.
func open() -> void:
	visible = true
	_done.grab_focus()


## Closes it.
func close() -> void:
	visible = false
	_settle_all()
	closed.emit()


## Shows a volume, 0 to 1.
func show_volume(p_bus: StringName, p_share: float) -> void:
	_sliders[p_bus].set_value_no_signal(p_share * 100.0)


## Shows whether something is on.
func show_switch(p_name: StringName, p_is_on: bool) -> void:
	_checks[p_name].set_pressed_no_signal(p_is_on)


func _on_toggled(p_is_on: bool, p_name: StringName) -> void:
	switched.emit(p_name, p_is_on)


func _on_moved(p_value: float, p_bus: StringName) -> void:
	_unsettled[p_bus] = true
	volume_changed.emit(p_bus, p_value / 100.0)


func _on_let_go(_has_changed: bool, p_bus: StringName) -> void:
	_settle(p_bus)


## Keys and the wheel move a slider without letting it go.
func _settle_all() -> void:
	for bus: StringName in _unsettled.keys():
		_settle(bus)


func _settle(p_bus: StringName) -> void:
	if _unsettled.erase(p_bus):
		volume_settled.emit(p_bus, _sliders[p_bus].value / 100.0)


func _add_label(p_text: String, p_y: float) -> Label:
	var label: Label = Label.new()
	label.text = p_text
	_place(label, _LEFT, p_y, 130.0, 28.0)
	return label


func _add_slider(p_bus: StringName, p_y: float) -> HSlider:
	var slider: HSlider = HSlider.new()
	slider.max_value = 100.0
	slider.step = 5.0
	slider.value = 100.0
	slider.tooltip_text = "Volume of: %s" % _TITLES[p_bus]
	_place(slider, _LEFT + 136.0, p_y + 4.0, _WIDTH - 2.0 * _LEFT - 136.0, 24.0)
	slider.value_changed.connect(_on_moved.bind(p_bus))
	slider.drag_ended.connect(_on_let_go.bind(p_bus))
	return slider


func _place(p_control: Control, p_x: float, p_y: float, p_width: float, p_height: float) -> void:
	p_control.position = Vector2(p_x, p_y)
	p_control.size = Vector2(p_width, p_height)
	add_child(p_control)
