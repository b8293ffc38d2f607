class_name Tuning
extends Node3D
## The tuning scene: a person plays a clip, a panel turns the motor's knobs while it runs, and plots
## show what each limb makes of it. For engineers and level designers; run it with F6.

const _TAG: String = "tuning"
const _STATUS_S: float = 0.25
## Names of [enum RagdollMotor.BalancePhase], in its order.
const _PHASES: Array[String] = ["stands", "falls", "draws in its legs", "rolls over", "rises"]
const _GUARD_NAMES: Dictionary[int, String] = {
	RagdollMotor.GUARD_ENERGY: "energy",
	RagdollMotor.GUARD_SPEED: "speed",
	RagdollMotor.GUARD_GAP: "gap",
	RagdollMotor.GUARD_LOST: "lost",
}

## The clip that is played, unless the command line names another.
@export_file("*.bvh") var motion: String = "res://assets/motion/01_01.bvh"

## The command line; set it before the scene enters the tree to have another.
var arguments: PackedStringArray = OS.get_cmdline_user_args()

var _options: TuningArguments = null
var _status_age_s: float = INF
var _is_quitting: bool = false

## The person.
@onready var subject: TuningSubject = $Subject
## The knobs.
@onready var panel: TuningPanel = %Panel
## The curves.
@onready var plots: LimbPlots = %Plots
@onready var _status: Label = %Status
@onready var _camera: OrbitCamera = $Camera


func _ready() -> void:
	_connect_panel()
	subject.began.connect(_on_began)
	subject.measured.connect(plots.push)
	_options = TuningArguments.parse(arguments)
	play(_options.bvh if _options.bvh != "" else motion)
	if _options.error != "":
		_report(_options.error)
	if subject.ragdoll != null:
		panel.show_groups(subject.groups())
		panel.show_motor(subject.ragdoll.motor, Vector2.ZERO)
	_camera.target = _watched()
	_camera.snap()
	panel.group_choice.grab_focus()


func _exit_tree() -> void:
	get_tree().paused = false


func _process(p_delta: float) -> void:
	_camera.target = _watched()
	_camera.takes_keys = get_viewport().gui_get_focus_owner() == null
	_status_age_s += p_delta
	if _status_age_s >= _STATUS_S:
		_status_age_s = 0.0
		_status.text = describe()
	if _options.duration_s > 0.0 and subject.time_s >= _options.duration_s and not _is_quitting:
		_is_quitting = true
		_finish()


func _unhandled_key_input(p_event: InputEvent) -> void:
	if p_event.is_action_pressed(&"ui_cancel"):
		get_viewport().gui_release_focus()
	elif p_event.is_action_pressed(&"ui_focus_next"):
		panel.group_choice.grab_focus()
	elif p_event.is_action_pressed(&"ui_page_up", true):
		_camera.distance = maxf(_camera.distance * 0.9, 0.5)
	elif p_event.is_action_pressed(&"ui_page_down", true):
		_camera.distance = minf(_camera.distance * 1.1, 50.0)
	else:
		return
	get_viewport().set_input_as_handled()


## Plays a BVH file, or shows why it cannot, and lets the person stand.
func play(p_file: String) -> void:
	panel.file_edit.text = p_file
	panel.file_edit.caret_column = p_file.length()
	var fault: String = subject.play(p_file)
	if fault != "":
		_report(fault + ". The person stands in the reset pose.")
	else:
		panel.report("Plays %s." % subject.describe(), false)


## The status line.
func describe() -> String:
	if subject.ragdoll == null:
		return "no person"
	var motor: RagdollMotor = subject.ragdoll.motor
	var tracking: Dictionary = motor.get_tracking()
	var guard: PackedStringArray = []
	for flag: int in subject.guard_counts:
		guard.append("%s %d" % [_GUARD_NAMES[flag], subject.guard_counts[flag]])
	var stats: Array = [
		subject.time_s,
		tracking["mean_deg"],
		tracking["p95_deg"],
		tracking["lag_s"] * 1000.0,
		", ".join(guard) if not guard.is_empty() else "none",
		"yes" if motor.is_flying() else "no",
		Engine.get_frames_per_second()
	]
	var form: String = (
		"%.1f s    since the last change: mean error %.1f deg, p95 %.1f deg, lag %.0f ms"
		+ "    guard actions: %s    flying: %s    %d fps"
	)
	var clearance: String = _describe_clearance(motor.get_limb_clearances())
	return form % stats + clearance + _describe_balance(motor.get_balance())


## By how much arms and legs were turned to keep out of the own body; nothing where none was.
static func _describe_clearance(p_turns: PackedFloat32Array) -> String:
	var most: float = 0.0
	for turn: float in p_turns:
		most = maxf(most, turn)
	return "" if most == 0.0 else "    own limbs kept apart by %.0f deg" % rad_to_deg(most)


## What a grounded body does for its balance, a line of its own; nothing for others.
static func _describe_balance(p_balance: Dictionary) -> String:
	if p_balance.is_empty():
		return ""
	var offset: Vector3 = p_balance["offset_m"]
	return (
		"\n%s: force %.0f of %.0f N, torque %.0f N m (p95 %.0f, an axis up to %.0f), tether %.2f m"
		% [
			"steps" if p_balance["is_stepping"] else _PHASES[p_balance["phase"]],
			p_balance["force_n"],
			p_balance["force_limit_n"],
			p_balance["torque_nm"],
			p_balance["torque_p95_nm"],
			p_balance["torque_limit_nm"],
			Vector2(offset.x, offset.z).length(),
		]
	)


func _connect_panel() -> void:
	panel.actuation_chosen.connect(subject.set_actuation)
	panel.root_mode_chosen.connect(subject.set_root_mode)
	panel.strength_changed.connect(subject.set_strength)
	panel.spring_changed.connect(subject.set_spring)
	panel.number_changed.connect(subject.set_number)
	panel.buffer_toggled.connect(func(is_on: bool) -> void: subject.has_buffer = is_on)
	panel.file_chosen.connect(play)
	panel.group_chosen.connect(_on_group_chosen)
	panel.ball_asked.connect(
		func() -> void: subject.throw_ball(_camera.global_position - subject.hips())
	)
	panel.crate_asked.connect(func() -> void: subject.drop_crate())
	panel.reset_asked.connect(subject.reset)
	panel.pause_toggled.connect(func(is_on: bool) -> void: get_tree().paused = is_on)


## Hips alone would bob with every step.
func _watched() -> Vector3:
	var hips: Vector3 = subject.hips()
	return Vector3(hips.x, maxf(hips.y, 0.6), hips.z)


func _report(p_fault: String) -> void:
	Log.error(_TAG, p_fault)
	panel.report(p_fault, true)


func _on_began() -> void:
	plots.show_limbs(subject.ragdoll.profile)


func _on_group_chosen(p_group: StringName) -> void:
	if subject.ragdoll != null:
		panel.show_motor(subject.ragdoll.motor, subject.get_spring(p_group))


func _finish() -> void:
	var code: int = 0
	if _options.screenshot != "":
		code = await _save_picture()
	get_tree().quit(code)


func _save_picture() -> int:
	if DisplayServer.get_name() == "headless":
		_report("a screenshot needs a display, found --headless")
		return 1
	await RenderingServer.frame_post_draw
	var fault: Error = get_viewport().get_texture().get_image().save_png(_options.screenshot)
	if fault != OK:
		_report("%s: cannot be written (%s)" % [_options.screenshot, error_string(fault)])
		return 1
	Log.info(_TAG, "saved %s" % _options.screenshot)
	return 0
