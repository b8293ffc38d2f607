@tool
class_name StudioPanel
extends ScrollContainer
## Sliders and pickers of an effect, made from its header, its inputs and its uniforms. What is
## moved changes the text itself, except for inputs: those belong to the emitter.

## A slider or picker has changed a setting of the header: what stands behind its name now.
signal setting_wanted(p_name: String, p_value: String)
## A slider or picker has changed the default of a uniform.
signal default_wanted(p_name: String, p_value: String)
## An input of the emitter has changed.
signal input_wanted(p_name: StringName, p_value: Variant)

## What the sliders of some settings go to, where the bounds are far from what is usual. A number
## beyond it can be typed.
const USUAL: Dictionary[String, Vector2] = {
	"weight": Vector2(-2.0, 3.0),
	"soft": Vector2(0.0, 3.0),
	"glow": Vector2(0.0, 8.0),
}

var _file: EffectFile = null
var _rows: Dictionary[String, StudioRow] = {}
var _content: GridContainer = GridContainer.new()


func _init() -> void:
	horizontal_scroll_mode = ScrollContainer.SCROLL_MODE_DISABLED
	_content.size_flags_horizontal = Control.SIZE_EXPAND_FILL
	add_child(_content)
	resized.connect(func() -> void: _content.columns = 2 if size.x > 520.0 else 1)


## Shows what a file without problems has. Rows that are already there keep their place.
func show_file(p_file: EffectFile, p_uniforms: Array) -> void:
	_file = p_file
	var wanted: Dictionary[String, bool] = {}
	for input: EffectInput in p_file.settings.inputs:
		_show_input(input, wanted)
	for uniform: Dictionary in p_uniforms:
		_show_uniform(uniform, wanted)
	for name: String in EffectSettings.keys():
		_show_setting(EffectSettings.keys()[name], wanted)
	for name: String in _rows.keys():
		if not wanted.has(name):
			_rows[name].queue_free()
			_rows.erase(name)


## The row of a setting ("@life"), input or uniform, for tests; null if there is none.
func row(p_name: String) -> StudioRow:
	return _rows.get(p_name)


func _row(p_name: String, p_wanted: Dictionary[String, bool]) -> StudioRow:
	p_wanted[p_name] = true
	if not _rows.has(p_name):
		var made: StudioRow = StudioRow.new()
		_rows[p_name] = made
		_content.add_child(made)
	return _rows[p_name]


func _show_input(p_input: EffectInput, p_wanted: Dictionary[String, bool]) -> void:
	var is_new: bool = not _rows.has(p_input.name)
	var shown: StudioRow = _row(p_input.name, p_wanted)
	shown.describe("emitter: " + p_input.name, p_input.meaning)
	shown.show_number(p_input.minimum, p_input.maximum, 0.0)
	if is_new:
		shown.set_number(p_input.default)
		shown.number_changed.connect(
			func(value: float) -> void: input_wanted.emit(StringName(p_input.name), value)
		)


func _show_uniform(p_uniform: Dictionary, p_wanted: Dictionary[String, bool]) -> void:
	var name: String = p_uniform["name"]
	if name == EffectFile.MARK or p_wanted.has(name):
		return
	if p_uniform["type"] == TYPE_FLOAT:
		var is_new: bool = not _rows.has(name)
		var ends: PackedStringArray = String(p_uniform["hint_string"]).split(",")
		var shown: StudioRow = _row(name, p_wanted)
		shown.describe(name, "a value of the code")
		var has_range: bool = p_uniform["hint"] == PROPERTY_HINT_RANGE and ends.size() >= 2
		var highest: float = ends[1].to_float() if has_range else 10.0
		shown.show_number(ends[0].to_float() if has_range else 0.0, highest, 0.0)
		shown.set_number(p_uniform.get("value", 0.0))
		if is_new:
			shown.number_changed.connect(_on_uniform_number.bind(name))
	elif p_uniform["type"] == TYPE_VECTOR3 or p_uniform["type"] == TYPE_COLOR:
		var is_new: bool = not _rows.has(name)
		var shown: StudioRow = _row(name, p_wanted)
		shown.describe(name, "a colour or direction of the code")
		var value: Variant = p_uniform.get("value", Vector3.ONE)
		var vector: Vector3 = value if value is Vector3 else Vector3.ONE
		shown.show_colours([Color(vector.x, vector.y, vector.z)], false)
		if is_new:
			shown.colours_changed.connect(_on_uniform_colour.bind(name))


func _show_setting(p_key: EffectKey, p_wanted: Dictionary[String, bool]) -> void:
	var name: String = "@" + p_key.name
	var is_new: bool = not _rows.has(name)
	var value: Variant = _file.settings.get(p_key.name)
	if p_key.kind == EffectKey.Kind.TEXT or p_key.kind == EffectKey.Kind.NAME:
		return
	var shown: StudioRow = _row(name, p_wanted)
	shown.describe(name, "%s%s" % [p_key.meaning, ", " + p_key.suffix if p_key.suffix else ""])
	match p_key.kind:
		EffectKey.Kind.NUMBER, EffectKey.Kind.WHOLE:
			var ends: Vector2 = USUAL.get(p_key.name, Vector2(p_key.minimum, p_key.maximum))
			var lowest: float = minf(ends.x, value)
			var step: float = 1.0 if p_key.kind == EffectKey.Kind.WHOLE else 0.0
			var limits: Vector2 = Vector2(p_key.minimum, p_key.maximum)
			shown.show_number(lowest, maxf(ends.y, value), step, limits)
			shown.set_number(value)
		EffectKey.Kind.YES_NO:
			shown.show_choices(["no", "yes"], "yes" if value else "no")
		EffectKey.Kind.CHOICE:
			shown.show_choices(p_key.choices, value)
		EffectKey.Kind.NUMBERS:
			shown.show_numbers(value)
		EffectKey.Kind.COLOURS:
			shown.show_colours(value, true)
	if is_new:
		shown.number_changed.connect(
			func(number: float) -> void: setting_wanted.emit(p_key.name, HeaderEdit.number(number))
		)
		shown.text_changed.connect(
			func(text: String) -> void: setting_wanted.emit(p_key.name, text)
		)
		shown.colours_changed.connect(
			func(colours: PackedColorArray) -> void:
				setting_wanted.emit(p_key.name, StudioRow.html(colours))
		)


func _on_uniform_number(p_value: float, p_name: String) -> void:
	default_wanted.emit(p_name, HeaderEdit.code_number(p_value))


func _on_uniform_colour(p_colours: PackedColorArray, p_name: String) -> void:
	var parts: PackedStringArray = []
	for part: float in [p_colours[0].r, p_colours[0].g, p_colours[0].b]:
		parts.append(HeaderEdit.code_number(part))
	default_wanted.emit(p_name, "vec3(%s)" % ", ".join(parts))
