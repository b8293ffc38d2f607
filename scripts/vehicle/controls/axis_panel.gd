class_name AxisPanel
extends CanvasLayer
## Where a wheel and pedals are calibrated: each control is moved through its whole way, one after
## the other; bars show what comes of them.

## The settings have changed.
signal calibrated

const _NAMES: Dictionary[AxisCalibrator.Kind, String] = {
	AxisCalibrator.Kind.STEER: "Steering",
	AxisCalibrator.Kind.THROTTLE: "Accelerator",
	AxisCalibrator.Kind.BRAKE: "Brake",
}

## Where calibrations are kept.
var settings: ControlSettings = null

var _panel: UiPanel = UiPanel.new("Wheel and pedals", 512.0)
var _say: Label = null
var _done: Button = null
var _first: Button = null
var _calibrator: AxisCalibrator = AxisCalibrator.new()
var _is_watching: bool = false
var _bars: Dictionary[AxisCalibrator.Kind, ProgressBar] = {}


func _init() -> void:
	visible = false
	_say = _panel.add_text()
	for kind: AxisCalibrator.Kind in _NAMES:
		_add_row(kind)
	_done = _panel.add_answer("Done", finish)
	_done.clip_text = true
	_done.size_flags_stretch_ratio = 3.0
	_panel.add_answer("Forget", _forget_all)
	_panel.add_answer("Close", hide_panel)
	add_child(_panel)


func _process(_delta: float) -> void:
	if not visible:
		return
	for kind: AxisCalibrator.Kind in _bars:
		_bars[kind].value = value_of(kind)
	if _is_watching:
		var found: String = _calibrator.device
		_done.disabled = _calibrator.result() == null
		_done.text = "Done" if found == "" else "Done: %s" % found


func _input(p_event: InputEvent) -> void:
	if not visible:
		return
	var motion: InputEventJoypadMotion = p_event as InputEventJoypadMotion
	if motion != null and _is_watching:
		_calibrator.take(Input.get_joy_name(motion.device), motion.axis, motion.axis_value)
	elif p_event.is_action_pressed(&"ui_cancel"):
		hide_panel()
		get_viewport().set_input_as_handled()


## Opens with the settings that are used.
func show_panel(p_settings: ControlSettings) -> void:
	settings = p_settings
	visible = true
	_is_watching = false
	_done.disabled = true
	_done.text = "Done"
	_say.text = describe_devices()
	_first.grab_focus()


## Closes.
func hide_panel() -> void:
	visible = false
	_is_watching = false


## Begins to watch for a control.
func begin(p_kind: AxisCalibrator.Kind) -> void:
	_calibrator.begin(p_kind)
	_is_watching = true
	_say.text = AxisCalibrator.INSTRUCTIONS[p_kind] + " Then choose Done."


## Keeps what was watched. Returns whether there was anything.
func finish() -> bool:
	var found: AxisCalibration = _calibrator.result()
	if not _is_watching or found == null:
		_say.text = "Nothing has moved far enough yet."
		return false
	_is_watching = false
	_done.disabled = true
	var fault: String = settings.keep(_calibrator.device, _calibrator.kind, found)
	var name: String = _NAMES[_calibrator.kind]
	_say.text = "%s is calibrated: %s." % [name, _calibrator.device] if fault == "" else fault
	calibrated.emit()
	return true


## What a control says now by its calibration, -1 to 1.
func value_of(p_kind: AxisCalibrator.Kind) -> float:
	for device: int in Input.get_connected_joypads():
		var known: AxisCalibration = settings.find(Input.get_joy_name(device), p_kind)
		if known != null:
			return known.value_of(Input.get_joy_axis(device, known.axis as JoyAxis))
	return 0.0


## The devices that are there, for people.
static func describe_devices() -> String:
	var names: PackedStringArray = []
	for device: int in Input.get_connected_joypads():
		names.append(Input.get_joy_name(device))
	if names.is_empty():
		return "No wheel, pedals or gamepad is plugged in."
	return "Plugged in: %s. Choose what to calibrate." % ", ".join(names)


func _forget_all() -> void:
	for device: int in Input.get_connected_joypads():
		settings.forget(Input.get_joy_name(device))
	_say.text = "What was known of these devices is forgotten."
	calibrated.emit()


func _add_row(p_kind: AxisCalibrator.Kind) -> void:
	var row: HBoxContainer = HBoxContainer.new()
	_panel.rows.add_child(row)
	var button: Button = Button.new()
	button.text = "Calibrate: %s" % _NAMES[p_kind]
	button.custom_minimum_size.x = 220.0
	button.pressed.connect(begin.bind(p_kind))
	row.add_child(button)
	var bar: ProgressBar = ProgressBar.new()
	bar.min_value = -1.0 if p_kind == AxisCalibrator.Kind.STEER else 0.0
	bar.max_value = 1.0
	bar.step = 0.001
	bar.show_percentage = false
	bar.custom_minimum_size.y = 18.0
	bar.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	bar.size_flags_vertical = Control.SIZE_SHRINK_CENTER
	row.add_child(bar)
	_bars[p_kind] = bar
	if _first == null:
		_first = button
