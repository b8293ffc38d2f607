class_name CalibrationBox
extends PanelContainer
## Leads through a calibration on the screen: what to do, how long, how good it was.

## A kind of calibration is wanted.
signal start_wanted(p_kind: CalibrationGuide.Kind)
## The result is to be accepted.
signal accept_wanted
## The calibration, or its result, is to be dropped.
signal cancel_wanted
## Sensors of two mounts are to be exchanged.
signal exchange_wanted(p_mounts: Vector2i)

## Input actions of the kinds, by [enum CalibrationGuide.Kind].
const ACTIONS: Array[StringName] = [
	&"calibrate_t_pose",
	&"calibrate_n_pose",
	&"calibrate_t_to_n",
	&"calibrate_full",
	&"calibrate_quick",
	&"check_fit",
]

@export var _kinds: Container
@export var _facing: OptionButton
@export var _heading: SpinBox
@export var _pose: OptionButton
@export var _instruction: Label
@export var _progress: ProgressBar
@export var _advice: RichTextLabel
@export var _accept: Button
@export var _again: Button
@export var _exchange: Button

var _kind: CalibrationGuide.Kind = CalibrationGuide.Kind.T_POSE
var _swap: Vector2i = Vector2i.ZERO
var _shown: String = ""


func _ready() -> void:
	for kind: int in ACTIONS.size():
		var button: Button = Button.new()
		button.text = InputKeys.label(CalibrationGuide.NAMES[kind], ACTIONS[kind])
		button.tooltip_text = _hint(kind as CalibrationGuide.Kind)
		button.pressed.connect(start.bind(kind))
		_kinds.add_child(button)
	for name: String in CalibrationOptions.FACING_NAMES:
		_facing.add_item(name)
	for name: String in ResetPose.NAMES:
		_pose.add_item(name + "-pose")
	_accept.text = InputKeys.label("Accept", &"accept_calibration")
	_again.text = InputKeys.label("Again", &"repeat_calibration")
	_accept.pressed.connect(accept_wanted.emit)
	_again.pressed.connect(_press_again)
	_exchange.pressed.connect(func() -> void: exchange_wanted.emit(_swap))
	_facing.item_selected.connect(func(_at: int) -> void: _show_heading())
	_show_heading()
	show_idle("")


## Asks for a kind of calibration.
func start(p_kind: CalibrationGuide.Kind) -> void:
	_kind = p_kind
	start_wanted.emit(p_kind)


## How it is wanted.
func options() -> CalibrationOptions:
	var wanted: CalibrationOptions = CalibrationOptions.new()
	wanted.facing = maxi(_facing.selected, 0) as CalibrationOptions.Facing
	wanted.heading_deg = _heading.value
	wanted.pose = maxi(_pose.selected, 0) as ResetPose.Kind
	return wanted


## Handles an input event; returns whether it was meant for this.
func take_input(p_event: InputEvent, p_process: CalibrationProcess) -> bool:
	for kind: int in ACTIONS.size():
		if p_event.is_action_pressed(ACTIONS[kind]):
			start(kind as CalibrationGuide.Kind)
			return true
	if p_event.is_action_pressed(&"accept_calibration") and _accept.visible:
		accept_wanted.emit()
	elif p_event.is_action_pressed(&"repeat_calibration") and _again.visible:
		_press_again()
	elif p_event.is_action_pressed(&"exchange_sensors") and _exchange.visible:
		exchange_wanted.emit(_swap)
	elif p_event.is_action_pressed(&"ui_cancel") and _is_running(p_process):
		cancel_wanted.emit()
	else:
		return false
	return true


## Shows that nothing runs, and a text.
func show_idle(p_text: String) -> void:
	_instruction.text = "Choose a calibration."
	_progress.value = 0.0
	_show_advice(p_text)
	_show_buttons(false, Vector2i.ZERO)


## Shows a calibration that runs or has ended, and what a watch has noticed.
func show_process(p_process: CalibrationProcess, p_notes: PackedStringArray) -> void:
	_progress.value = p_process.progress() * 100.0
	match p_process.phase:
		CalibrationProcess.Phase.IDLE:
			show_idle("\n".join(p_notes))
		CalibrationProcess.Phase.DONE:
			_show_result(p_process.result)
		_:
			var words: PackedStringArray = ["", "Get ready", "Hold still", "Move"]
			var parts: Array = [words[p_process.phase], ceili(p_process.seconds_left)]
			_instruction.text = "%s: %d s\n%s" % (parts + [p_process.instruction()])
			_show_advice("")
			_show_buttons(false, Vector2i.ZERO)


## Offers to exchange the sensors of two mounts.
func offer_exchange(p_mounts: Vector2i) -> void:
	_swap = p_mounts
	_exchange.visible = p_mounts != Vector2i.ZERO
	if _exchange.visible:
		var parts: Array = [BodyMounts.title(p_mounts.x), BodyMounts.title(p_mounts.y)]
		_exchange.text = InputKeys.label("Exchange %s and %s" % parts, &"exchange_sensors")


func _is_running(p_process: CalibrationProcess) -> bool:
	return p_process != null and p_process.phase != CalibrationProcess.Phase.IDLE


func _show_result(p_result: CalibrationResult) -> void:
	var is_check: bool = p_result.calibration == null
	if p_result.error != "":
		_instruction.text = "It did not work: %s." % p_result.error
	elif p_result.is_good():
		var parts: Array = [roundi(p_result.score() * 100.0)]
		_instruction.text = "Good, %d %%." % parts
		if is_check:
			_instruction.text = "All sensors are where they should be."
	else:
		_instruction.text = "Look at this first:" if is_check else "Not as good as it could be."
	var lines: PackedStringArray = p_result.advice.duplicate()
	if not is_check:
		var worst: PackedStringArray = _worst(p_result)
		if not worst.is_empty():
			lines.append("movement: " + ", ".join(worst))
	_show_advice("\n".join(lines))
	var swap: Vector2i = Vector2i.ZERO if p_result.swaps.is_empty() else p_result.swaps[0]
	_show_buttons(true, swap)
	_accept.visible = p_result.error == "" and not is_check


## The mounts that moved most, for people.
static func _worst(p_result: CalibrationResult) -> PackedStringArray:
	var sorted: Array[CalibrationResult.PlaceQuality] = p_result.mounts.duplicate()
	sorted.sort_custom(
		func(a: CalibrationResult.PlaceQuality, b: CalibrationResult.PlaceQuality) -> bool:
			return a.movement_deg > b.movement_deg
	)
	var found: PackedStringArray = []
	for quality: CalibrationResult.PlaceQuality in sorted.slice(0, 4):
		if not quality.is_missing:
			found.append("%s %.1f°" % [BodyMounts.title(quality.mount), quality.movement_deg])
	return found


func _show_buttons(p_done: bool, p_swap: Vector2i) -> void:
	_accept.visible = p_done
	_again.visible = p_done
	offer_exchange(p_swap)


func _show_advice(p_text: String) -> void:
	if p_text != _shown:
		_shown = p_text
		_advice.text = p_text


func _show_heading() -> void:
	_heading.visible = _facing.selected == CalibrationOptions.Facing.HEADING


func _press_again() -> void:
	start_wanted.emit(_kind)


static func _hint(p_kind: CalibrationGuide.Kind) -> String:
	match p_kind:
		CalibrationGuide.Kind.T_TO_N:
			return "T-pose, arms down, N-pose: finds which way you face. 10 s."
		CalibrationGuide.Kind.FULL:
			return "Also a bow, a squat and rising on the toes: for sensors without a common north."
		CalibrationGuide.Kind.QUICK:
			return "Stand in the reset pose now, for a second."
		CalibrationGuide.Kind.FIT_CHECK:
			return "Move one part after the other: finds exchanged sensors."
	return "Hold the pose for two seconds."
