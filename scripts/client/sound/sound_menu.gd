class_name SoundMenu
extends UiPanel
## Where a user sets how loud things are, the limiter, captions and sound for headphones.

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

var _sliders: Dictionary[StringName, UiSlider] = {}
var _checks: Dictionary[StringName, CheckButton] = {}
var _done: Button = null


func _init() -> void:
	super("Sound", 360.0)
	for bus: StringName in SoundBuses.SETTABLE:
		var row: UiSlider = UiSlider.new(_TITLES[bus], Vector3(0.0, 100.0, 5.0), "%")
		row.show_value(100.0)
		row.slider.tooltip_text = "Volume of: %s" % _TITLES[bus]
		row.moved.connect(func(value: float) -> void: volume_changed.emit(bus, value / 100.0))
		row.settled.connect(func(value: float) -> void: volume_settled.emit(bus, value / 100.0))
		rows.add_child(row)
		_sliders[bus] = row
	for switch: StringName in SWITCHES:
		var check: CheckButton = CheckButton.new()
		check.text = SWITCHES[switch]
		check.toggled.connect(func(is_on: bool) -> void: switched.emit(switch, is_on))
		rows.add_child(check)
		_checks[switch] = check
	_done = add_answer("Done", close)
	visible = false


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
	for bus: StringName in _sliders:
		_sliders[bus].settle()
	closed.emit()


## Shows a volume, 0 to 1.
func show_volume(p_bus: StringName, p_share: float) -> void:
	_sliders[p_bus].show_value(p_share * 100.0)


## Shows whether something is on.
func show_switch(p_name: StringName, p_is_on: bool) -> void:
	_checks[p_name].set_pressed_no_signal(p_is_on)
