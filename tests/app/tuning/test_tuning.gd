extends TestCase
## The tuning scene, used by its knobs as a person would.

const FastPhysics: GDScript = preload("res://tests/actor/ragdoll/fast_physics.gd")
const SCENE: PackedScene = preload("res://scenes/app/tuning/tuning.tscn")

var _tuning: Tuning = null


func before_each() -> void:
	FastPhysics.start()


func after_each() -> void:
	FastPhysics.stop()
	if _tuning != null:
		_tuning.free()
		_tuning = null


func test_every_limb_gets_its_curves() -> void:
	_open([])
	await physics_frames(60)
	var plots: Array[LimbPlot] = _tuning.plots.plots
	equal(plots.size(), Limbs.COUNT)
	var torques: int = 0
	for plot: LimbPlot in plots:
		is_true(plot.count() > 20, "%s has %d values" % [plot.title, plot.count()])
		is_true(plot.value(LimbPlot.Trace.ERROR) > 0.0, "%s has an error" % plot.title)
		torques += int(plot.value(LimbPlot.Trace.TORQUE) > 0.0)
		var share: float = plot.value(LimbPlot.Trace.SATURATION)
		is_true(share >= 0.0 and is_finite(share), "%s: %f %%" % [plot.title, share])
	equal(torques, Limbs.COUNT)
	contains(_tuning.panel.last_report(), "01_01.bvh")
	is_true(_motor().get_tracking()["mean_deg"] < 5.0, "follows the clip")
	for word: String in ["mean error", "p95", "lag", "guard actions: none", "flying", "fps"]:
		contains(_tuning.describe(), word)


func test_every_mode_is_chosen_for_all_and_for_a_group() -> void:
	_open([])
	var panel: TuningPanel = _tuning.panel
	equal(panel.mode_choice.item_count, RagdollMotor.LIMP + 1)
	for mode: int in panel.mode_choice.item_count:
		_choose(panel.mode_choice, mode)
		await physics_frames(5)
		for group: String in _tuning.subject.groups():
			equal(_motor().get_actuation(group), mode, group)
	_choose(panel.mode_choice, RagdollMotor.VELOCITY_MOTOR)
	_choose(panel.group_choice, _group("left_arm"))
	_choose(panel.mode_choice, RagdollMotor.LIMP)
	equal(_motor().get_actuation(&"left_arm"), RagdollMotor.LIMP)
	equal(_motor().get_actuation(&"right_arm"), RagdollMotor.VELOCITY_MOTOR)
	# The panel shows the group that is chosen.
	_choose(panel.group_choice, _group("right_arm"))
	equal(panel.mode_choice.selected, RagdollMotor.VELOCITY_MOTOR)
	_choose(panel.group_choice, 0)
	equal(panel.mode_choice.text, "mixed")


func test_every_root_mode_is_chosen() -> void:
	_open([])
	var choice: OptionButton = _tuning.panel.root_choice
	equal(choice.item_count, RagdollMotor.ROOT_GROUNDED + 1)
	for mode: int in choice.item_count:
		_choose(choice, mode)
		equal(_motor().root_mode, mode)
		await physics_frames(5)
	contains(_tuning.describe(), "tether")


func test_sliders_turn_the_motor_and_outlive_a_reset() -> void:
	_open([])
	var panel: TuningPanel = _tuning.panel
	await physics_frames(5)
	panel.numbers[&"gain"].slider.value = 30.0
	panel.numbers[&"root_force"].slider.value = 1500.0
	panel.numbers[&"root_torque"].slider.value = 600.0
	_choose(panel.group_choice, _group("left_arm"))
	panel.strength.slider.value = 0.5
	panel.frequency.slider.value = 6.0
	_choose(panel.root_choice, RagdollMotor.ROOT_HELD)
	panel.buffer_box.button_pressed = true
	var before: Ragdoll = _tuning.subject.ragdoll
	_press("Reset")
	await physics_frames(5)
	not_equal(_tuning.subject.ragdoll, before)
	equal(_motor().gain, 30.0)
	equal(_motor().root_force, 1500.0)
	equal(_motor().root_torque, 600.0)
	almost_equal(_motor().get_group_strength(&"left_arm"), 0.5, 1e-6)
	almost_equal(_motor().get_group_strength(&"right_arm"), 1.0, 1e-6)
	equal(_tuning.subject.get_spring(&"left_arm"), Vector2(6.0, 0.0))
	equal(_motor().root_mode, RagdollMotor.ROOT_HELD)
	is_true(_tuning.subject.has_buffer)
	contains(panel.numbers[&"gain"].find_children("*", "Label", true, false)[1].text, "30 1/s")


func test_a_ball_and_a_crate_hit_the_person() -> void:
	_open(["--bvh=/nowhere/at/all.bvh"])
	# At full strength a ball hardly moves an arm or a leg.
	_tuning.panel.strength.slider.value = 0.2
	_tuning.panel.numbers[&"root_force"].slider.value = 1000.0
	await physics_frames(30)
	var calm: float = _worst_error()
	_press("Throw a ball")
	_press("Drop a crate")
	var worst: float = 0.0
	for _step: int in 60:
		await physics_frames(1)
		worst = maxf(worst, _worst_error())
	is_true(worst > calm + 1.0, "from %f to %f deg" % [calm, worst])


func test_pause_stops_the_time() -> void:
	_open([])
	await physics_frames(10)
	_tuning.panel.pause_button.button_pressed = true
	var before: float = _tuning.subject.time_s
	var place: Vector3 = _tuning.subject.hips()
	await physics_frames(10)
	equal(_tuning.subject.time_s, before)
	equal(_tuning.subject.hips(), place)
	_tuning.panel.pause_button.button_pressed = false
	await physics_frames(10)
	is_true(_tuning.subject.time_s > before)


func test_a_bad_file_is_told_and_the_person_stands() -> void:
	var text: String = "user://tuning.bvh"
	FileAccess.open(text, FileAccess.WRITE).store_string("this is no motion")
	for bad: String in ["/nowhere/at/all.bvh", text]:
		_open(["--bvh=" + bad])
		contains(_tuning.panel.last_report(), bad.get_file())
		contains(_tuning.panel.last_report(), "expected")
		await physics_frames(60)
		equal(_tuning.plots.plots.size(), Limbs.COUNT)
		is_true(_tuning.subject.hips().y > 0.8, "stands at %s" % _tuning.subject.hips())
		# A good file then plays.
		_tuning.panel.file_edit.text_submitted.emit("res://assets/motion/01_03.bvh")
		contains(_tuning.panel.last_report(), "Plays 01_03.bvh")
		await physics_frames(5)
		_tuning.free()
		_tuning = null
	DirAccess.remove_absolute(text)


func test_wrong_options_are_reported() -> void:
	for wrong: String in ["--bhv=x", "--duration=soon", "--duration=-1", "more"]:
		contains(TuningArguments.parse([wrong]).error, "found '")
	_open(["--duration=soon"])
	contains(_tuning.panel.last_report(), "--duration=soon")
	await physics_frames(5)
	is_true(_tuning.subject.time_s > 0.0)


func test_the_keyboard_reaches_every_knob() -> void:
	_open([])
	await process_frames(2)
	var panel: TuningPanel = _tuning.panel
	var reached: Array[Control] = []
	var at: Control = panel.group_choice
	while not at in reached and reached.size() < 100:
		reached.append(at)
		at = at.find_next_valid_focus()
	for kind: String in ["BaseButton", "HSlider", "LineEdit"]:
		var knobs: Array[Node] = panel.find_children("*", kind, true, false)
		is_true(not knobs.is_empty())
		for knob: Control in knobs:
			is_true(knob in reached, "%s is not reached" % knob.get_path())


func test_keys_turn_a_knob_or_the_camera() -> void:
	_open([])
	await process_frames(2)
	var slider: HSlider = _tuning.panel.numbers[&"gain"].slider
	slider.grab_focus()
	await _type(KEY_RIGHT)
	equal(_motor().gain, 51.0)
	var camera: OrbitCamera = _tuning.get_node("Camera")
	is_false(camera.takes_keys)
	await _type(KEY_ESCAPE)
	is_true(camera.takes_keys)
	var before: float = camera.distance
	await _type(KEY_PAGEUP)
	is_true(camera.distance < before)
	await _type(KEY_TAB)
	is_true(_tuning.panel.group_choice.has_focus())
	await _type(KEY_TAB)
	is_true(_tuning.panel.mode_choice.has_focus())


func test_scales_end_at_round_numbers() -> void:
	almost_equal(LimbPlot.round_top(101.0), 150.0, 1e-6)
	almost_equal(LimbPlot.round_top(480.0), 500.0, 1e-6)
	almost_equal(LimbPlot.round_top(8.0), 10.0, 1e-6)
	equal(LimbPlots.shorten("LeftUpperArm"), "L upper arm")


func _open(p_arguments: PackedStringArray) -> void:
	_tuning = SCENE.instantiate()
	_tuning.arguments = p_arguments
	add_child(_tuning)


func _motor() -> RagdollMotor:
	return _tuning.subject.ragdoll.motor


func _worst_error() -> float:
	var worst: float = 0.0
	for error: float in _motor().get_limb_errors():
		worst = maxf(worst, rad_to_deg(error))
	return worst


func _group(p_name: String) -> int:
	return _tuning.subject.groups().find(p_name) + 1


func _type(p_key: Key) -> void:
	for is_pressed: bool in [true, false]:
		var event: InputEventKey = InputEventKey.new()
		event.keycode = p_key
		event.physical_keycode = p_key
		event.pressed = is_pressed
		get_viewport().push_input(event)
		await process_frames(2)


func _choose(p_choice: OptionButton, p_index: int) -> void:
	p_choice.select(p_index)
	p_choice.item_selected.emit(p_index)


func _press(p_text: String) -> void:
	for button: Button in _tuning.panel.find_children("*", "Button", true, false):
		if button.text == p_text:
			button.pressed.emit()
			return
	fail("no button '%s'" % p_text)
