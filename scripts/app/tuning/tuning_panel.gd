class_name TuningPanel
extends PanelContainer
## The knobs of the tuning scene. All of them can be reached and turned by the keyboard: Tab,
## arrow keys, Space; Escape gives the arrow keys to the camera.

## How to drive a strength group (all with an empty name), within [param blend_s] seconds.
signal actuation_chosen(mode: RagdollMotor.Actuation, group: StringName, blend_s: float)
## Who holds the hips.
signal root_mode_chosen(mode: RagdollMotor.RootMode)
## The strength of a group, 1 being the profile's.
signal strength_changed(strength: float, group: StringName, blend_s: float)
## The spring of a group: frequency (Hz) and damping ratio.
signal spring_changed(spring: Vector2, group: StringName)
## A property of the motor.
signal number_changed(property: StringName, value: float)
## Whether the next sample is known.
signal buffer_toggled(is_on: bool)
## A motion file is to be played.
signal file_chosen(file: String)
## Another group's settings are to be shown.
signal group_chosen(group: StringName)
## A ball is to be thrown.
signal ball_asked
## A crate is to be dropped.
signal crate_asked
## Everything is to be reset.
signal reset_asked
## Time is to stop, or to go on.
signal pause_toggled(is_on: bool)

## Names of [enum RagdollMotor.Actuation], in its order.
const MODES: Array[String] = [
	"direct set", "spring torque", "angular motor", "velocity motor", "position motor", "limp"
]
## Names of [enum RagdollMotor.RootMode], in its order.
const ROOTS: Array[String] = [
	"held", "soft", "lowest foot", "contacts", "pendulum", "self-righting", "inertial", "grounded"
]

## Width of the names, px.
const _TITLE_PX: float = 92.0

## A strength group, or all.
var group_choice: OptionButton = OptionButton.new()
## Of the group.
var mode_choice: OptionButton = OptionButton.new()
## Of the person.
var root_choice: OptionButton = OptionButton.new()
## Of the group.
var strength: UiSlider = _slider("Strength", Vector3(0.0, 4.0, 0.05), "x")
## Of the group.
var frequency: UiSlider = _slider("Spring", Vector3(0.0, 30.0, 0.5), "Hz", "mode's own")
## Of the group.
var damping: UiSlider = _slider("Damping", Vector3(0.0, 3.0, 0.05), "", "mode's own")
## Of changes of mode and strength.
var blend: UiSlider = _slider("Blend", Vector3(0.0, 3.0, 0.05), "s")
## Of the person: by the names of the motor's properties.
var numbers: Dictionary[StringName, UiSlider] = {
	&"gain": _slider("Gain", Vector3(1.0, 240.0, 1.0), "1/s"),
	&"muscle_speed": _slider("Muscle speed", Vector3(0.0, 60.0, 0.5), "rad/s", "any"),
	&"root_force": _slider("Root force", Vector3(0.0, 10000.0, 50.0), "N"),
	&"root_torque": _slider("Root torque", Vector3(0.0, 5000.0, 20.0), "N m"),
	&"standing_torque": _slider("When standing", Vector3(0.0, 5000.0, 20.0), "N m"),
	&"residual_share": _slider("Grounded: force", Vector3(0.0, 1.0, 0.01), "of weight"),
}
## Whether the next sample is known.
var buffer_box: CheckBox = CheckBox.new()
## Stops the time.
var pause_button: Button = Button.new()
## The motion file.
var file_edit: LineEdit = LineEdit.new()

var _list: VBoxContainer = VBoxContainer.new()
var _message: Label = Label.new()
var _buttons: GridContainer = GridContainer.new()


func _ready() -> void:
	theme = load(UiStyle.DENSE)
	add_child(_list)
	_add_file()
	_add_heading("Limbs")
	_add_choice("Group", group_choice)
	_add_choice("Actuation", mode_choice)
	for row: UiSlider in [strength, frequency, damping, blend]:
		_list.add_child(row)
	_add_heading("Whole person")
	_add_choice("Root", root_choice)
	for property: StringName in numbers:
		_list.add_child(numbers[property])
	buffer_box.text = "One tick buffer (next sample is known)"
	_list.add_child(buffer_box)
	_add_buttons()
	_message.autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
	_message.name = "Message"
	_list.add_child(_message)
	_fill(mode_choice, MODES)
	_fill(root_choice, ROOTS)
	_connect_all()


## Lets somebody choose among these strength groups, or all.
func show_groups(p_groups: PackedStringArray) -> void:
	group_choice.clear()
	group_choice.add_item("all")
	for group: String in p_groups:
		group_choice.add_item(group.replace("_", " "))
		group_choice.set_item_metadata(group_choice.item_count - 1, StringName(group))


## Shows what a motor does now, for the group that is chosen.
func show_motor(p_motor: RagdollMotor, p_spring: Vector2) -> void:
	mode_choice.select(p_motor.get_actuation(group()))
	if group() == &"" and _is_mixed(p_motor):
		mode_choice.select(-1)
		mode_choice.text = "mixed"
	root_choice.select(p_motor.root_mode)
	strength.show_value(p_motor.get_group_strength(group()))
	frequency.show_value(p_spring.x)
	damping.show_value(p_spring.y)
	for property: StringName in numbers:
		numbers[property].show_value(p_motor.get(property))


## Tells the user something; [param p_is_fault] if it went wrong.
func report(p_text: String, p_is_fault: bool) -> void:
	_message.text = p_text
	_message.add_theme_color_override("font_color", UiStyle.BAD if p_is_fault else UiStyle.TEXT)


## The message to the user.
func last_report() -> String:
	return _message.text


## The strength group that is chosen; empty for all.
func group() -> StringName:
	var chosen: Variant = group_choice.get_selected_metadata()
	return chosen if chosen is StringName else &""


func _is_mixed(p_motor: RagdollMotor) -> bool:
	var modes: Array[int] = []
	for at: int in range(1, group_choice.item_count):
		var mode: int = p_motor.get_actuation(group_choice.get_item_metadata(at))
		if not mode in modes:
			modes.append(mode)
	return modes.size() > 1


func _add_heading(p_text: String) -> void:
	var heading: Label = Label.new()
	heading.text = p_text
	heading.theme_type_variation = UiStyle.HINT
	_list.add_child(heading)
	_list.add_child(HSeparator.new())


func _add_choice(p_title: String, p_choice: OptionButton) -> void:
	p_choice.fit_to_longest_item = false
	_list.add_child(UiRow.new(p_title, p_choice, _TITLE_PX))


func _add_file() -> void:
	file_edit.placeholder_text = "a BVH file, then Enter"
	file_edit.tooltip_text = "A BVH file, absolute or res://; Enter plays it"
	_list.add_child(UiRow.new("Motion", file_edit, _TITLE_PX))


func _add_buttons() -> void:
	_buttons.columns = 2
	var asked: Dictionary[String, Signal] = {
		"Throw a ball": ball_asked, "Drop a crate": crate_asked, "Reset": reset_asked
	}
	for text: String in asked:
		var button: Button = Button.new()
		_add_button(button, text)
		button.pressed.connect(func() -> void: asked[text].emit())
	pause_button.toggle_mode = true
	_add_button(pause_button, "Pause")
	_list.add_child(_buttons)


func _add_button(p_button: Button, p_text: String) -> void:
	p_button.text = p_text
	p_button.name = p_text.to_pascal_case()
	p_button.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	_buttons.add_child(p_button)


func _fill(p_choice: OptionButton, p_names: Array[String]) -> void:
	for name_of_mode: String in p_names:
		p_choice.add_item(name_of_mode)


func _connect_all() -> void:
	group_choice.item_selected.connect(func(_at: int) -> void: group_chosen.emit(group()))
	mode_choice.item_selected.connect(
		func(at: int) -> void: actuation_chosen.emit(at, group(), blend.slider.value)
	)
	root_choice.item_selected.connect(func(at: int) -> void: root_mode_chosen.emit(at))
	strength.moved.connect(
		func(value: float) -> void: strength_changed.emit(value, group(), blend.slider.value)
	)
	for row: UiSlider in [frequency, damping]:
		row.moved.connect(
			func(_value: float) -> void:
				spring_changed.emit(Vector2(frequency.slider.value, damping.slider.value), group())
		)
	for property: StringName in numbers:
		numbers[property].moved.connect(
			func(value: float) -> void: number_changed.emit(property, value)
		)
	buffer_box.toggled.connect(func(is_on: bool) -> void: buffer_toggled.emit(is_on))
	file_edit.text_submitted.connect(func(file: String) -> void: file_chosen.emit(file))
	pause_button.toggled.connect(func(is_on: bool) -> void: pause_toggled.emit(is_on))


static func _slider(
	p_title: String, p_range: Vector3, p_unit: String, p_zero: String = ""
) -> UiSlider:
	return UiSlider.new(p_title, p_range, p_unit, p_zero, _TITLE_PX)
