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
## All sensors are to be put where they seem to be: a mount for each, as in
## [member CalibrationResult.assignment].
signal assignment_wanted(p_mounts: PackedInt32Array)
## The last change of where sensors are worn is to be taken back.
signal undo_wanted
## The changes of where sensors are worn are to be kept.
signal keep_wanted

## Time to get ready for somebody who is alone, s.
const ALONE_S: float = 8.0

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
@export var _align: OptionButton
@export var _alone: CheckBox
@export var _heading: SpinBox
@export var _pose: OptionButton
@export var _instruction: Label
@export var _progress: ProgressBar
@export var _advice: RichTextLabel
@export var _accept: Button
@export var _again: Button
@export var _exchange: Button
@export var _undo: Button

var _kind: CalibrationGuide.Kind = CalibrationGuide.Kind.T_POSE
var _swap: Vector2i = Vector2i.ZERO
var _assignment: PackedInt32Array = PackedInt32Array()
var _has_changes: bool = false
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
	_accept.pressed.connect(_press_accept)
	_again.pressed.connect(_press_again)
	_exchange.pressed.connect(_press_exchange)
	_undo.text = InputKeys.label("Undo", &"undo_mounts")
	_undo.pressed.connect(undo_wanted.emit)
	for name: String in CalibrationOptions.ALIGN_NAMES:
		_align.add_item(name)
	_alone.text = "Alone: shake a hand to start"
	_alone.tooltip_text = "Every calibration leaves %d s to get ready" % roundi(ALONE_S)
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
	wanted.align = maxi(_align.selected, 0) as CalibrationOptions.Align
	if _alone.button_pressed:
		wanted.ready_s = ALONE_S
	wanted.pose = maxi(_pose.selected, 0) as ResetPose.Kind
	return wanted


## Handles an input event; returns whether it was meant for this.
func take_input(p_event: InputEvent, p_process: CalibrationProcess) -> bool:
	for kind: int in ACTIONS.size():
		if p_event.is_action_pressed(ACTIONS[kind]):
			start(kind as CalibrationGuide.Kind)
			return true
	if p_event.is_action_pressed(&"accept_calibration") and _accept.visible:
		_press_accept()
	elif p_event.is_action_pressed(&"undo_mounts") and _undo.visible:
		undo_wanted.emit()
	elif p_event.is_action_pressed(&"repeat_calibration") and _again.visible:
		_press_again()
	elif p_event.is_action_pressed(&"exchange_sensors") and _exchange.visible:
		_press_exchange()
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


## Whether the wearer is alone: starts by a gesture, and needs time to get ready.
func is_alone() -> bool:
	return _alone.button_pressed


## Shows whether changes of where sensors are worn wait to be kept.
func show_changes(p_has_changes: bool) -> void:
	_has_changes = p_has_changes


func _is_running(p_process: CalibrationProcess) -> bool:
	return p_process != null and p_process.phase != CalibrationProcess.Phase.IDLE


func _show_result(p_result: CalibrationResult) -> void:
	var is_check: bool = p_result.calibration == null
	if p_result.error != "":
		_instruction.text = "It did not work: %s." % p_result.error
	elif p_result.is_good():
		var parts: Array = [p_result.word().capitalize(), roundi(p_result.error_deg)]
		_instruction.text = "%s: limbs are off by about %d°." % parts
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
	_show_buttons(true, Vector2i.ZERO)
	_accept.visible = p_result.error == "" and not is_check
	if p_result.error == "" and p_result.is_reassigned():
		_offer_assignment(p_result)


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
	_accept.visible = p_done or _has_changes
	_accept.text = InputKeys.label("Accept" if p_done else "Keep changes", &"accept_calibration")
	_again.visible = p_done
	_undo.visible = _has_changes
	offer_exchange(p_swap)


## Offers to put all sensors where they seem to be, at once.
func _offer_assignment(p_result: CalibrationResult) -> void:
	var exchanges: Array[Vector2i] = p_result.exchanges()
	if exchanges.size() == 1:
		offer_exchange(exchanges[0])
		return
	var moved: int = 0
	for sensor: int in p_result.assignment.size():
		moved += 1 if p_result.assignment[sensor] != p_result.present[sensor] else 0
	_assignment = p_result.assignment
	_exchange.visible = true
	_exchange.text = InputKeys.label("Put %d sensors where they are" % moved, &"exchange_sensors")


func _press_exchange() -> void:
	if _swap != Vector2i.ZERO:
		exchange_wanted.emit(_swap)
	else:
		assignment_wanted.emit(_assignment)


## Accepts the result, or, where there is none, the changes of where sensors are worn.
func _press_accept() -> void:
	if _again.visible:
		accept_wanted.emit()
	else:
		keep_wanted.emit()


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
