@tool
@icon("res://scenes/effects/icons/effect_emitter.svg")
class_name EffectEmitter
extends Node3D
## Shows an effect at its place in a level: always, by the fields of an [Entity], or once at each of
## its events. docs/effects.md says how.
##
## It costs no bytes on the wire, and nothing on a server.

## Longest text of [member inputs].
const MAX_INPUTS_TEXT: int = 400

## Name of the effect: a file of [code]assets/effects[/code].
@export var effect: String = "smoke":
	set(p_value):
		effect = p_value
		if _shown != null:
			_shown.effect = p_value
		update_configuration_warnings()
## Share of the effect's particles.
@export_range(0.0, 1.0, 0.01) var amount: float = 1.0:
	set(p_value):
		amount = p_value
		_refresh()
## The entity whose fields and events it follows; may be empty.
@export var entity: Entity = null:
	set(p_value):
		entity = p_value
		update_configuration_warnings()
## What the effect's inputs are, a line for each: [code]revs = rpm * 0.0004[/code] follows a field,
## [code]scale = 1.5[/code] is a number, [code]amount = burning[/code] the share of particles.
@export_multiline var inputs: String = "":
	set(p_value):
		inputs = p_value.left(MAX_INPUTS_TEXT)
		_bindings = EffectBinding.read(inputs)
		_refresh()
		update_configuration_warnings()
## The event at which the effect is played once; empty: it is shown all the time. An effect without
## [code]@once[/code] goes on for the life of a particle.
@export var plays_at: String = "":
	set(p_value):
		plays_at = p_value
		update_configuration_warnings()

var _bindings: Array[EffectBinding] = []
var _shown: LayeredEffect = null
## Time for which an effect without [code]@once[/code] goes on, s.
var _left_s: float = 0.0
## The share that [constant EffectBinding.AMOUNT] says.
var _bound_amount: float = 1.0


func _ready() -> void:
	set_process(false)
	if Engine.is_editor_hint() or DisplayServer.get_name() == "headless":
		return
	show_effect()


func _process(p_delta: float) -> void:
	_left_s -= p_delta
	if _left_s <= 0.0:
		set_process(false)
		_apply_amount()


func _validate_property(p_property: Dictionary) -> void:
	if p_property["name"] == "effect":
		p_property["hint"] = PROPERTY_HINT_ENUM_SUGGESTION
		p_property["hint_string"] = ",".join(EffectLibrary.shared().names())


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	var names: PackedStringArray = EffectLibrary.shared().names()
	if not names.has(effect):
		var text: String = "There is no effect '%s': choose one of %s for 'Effect'."
		warnings.append(text % [effect, ", ".join(names)])
	for binding: EffectBinding in _bindings:
		if binding.error != "":
			warnings.append("'Inputs': %s." % binding.error)
		elif binding.field != &"":
			warnings.append_array(_warn_of("field", binding.field))
	if plays_at != "":
		warnings.append_array(_warn_of("event", StringName(plays_at)))
		if names.has(effect) and not _ends_by_itself():
			var text: String = "'%s' does not end by itself: choose an effect with '@once yes'."
			warnings.append(text % effect)
	return warnings


## Begins. Where there is a display, it does so by itself.
func show_effect() -> void:
	if _shown != null:
		return
	_shown = LayeredEffect.make(effect, plays_at == "")
	add_child(_shown)
	EffectPlayer.of(self)
	if entity != null:
		entity.started.connect(_refresh)
		entity.field_changed.connect(_on_field_changed)
		entity.happened.connect(_on_happened)
	_refresh()


func _ends_by_itself() -> bool:
	return EffectLibrary.shared().layers(effect).any(
		func(layer: EffectLayer) -> bool: return layer.file.settings.once
	)


func _warn_of(p_what: String, p_name: StringName) -> PackedStringArray:
	if entity == null:
		return ["Choose the entity with the %s '%s' for 'Entity'." % [p_what, p_name]]
	if entity.type == null:
		return []
	var is_field: bool = p_what == "field"
	var index: int = entity.type.find_field(p_name) if is_field else entity.type.find_event(p_name)
	if index >= 0:
		return []
	var text: String = "The type '%s' has no %s '%s': add it to the type, or choose another."
	return [text % [entity.type.name, p_what, p_name]]


func _refresh() -> void:
	if _shown == null:
		return
	_bound_amount = 1.0
	for binding: EffectBinding in _bindings:
		if binding.error != "":
			continue
		var value: float = 0.0
		if binding.field != &"" and entity != null and entity.is_started():
			if entity.type.find_field(binding.field) >= 0:
				value = entity.get_value(binding.field)
		_set_input(binding.input, binding.value_of(value))
	_apply_amount()


func _set_input(p_input: StringName, p_value: float) -> void:
	if p_input == EffectBinding.AMOUNT:
		_bound_amount = clampf(p_value, 0.0, 1.0)
	else:
		_shown.set_input(p_input, p_value)


func _apply_amount() -> void:
	_shown.share = amount * _bound_amount
	_shown.emitting = (plays_at == "" or _left_s > 0.0) and _shown.share > 0.0


func _on_field_changed(p_field: StringName, p_value: float) -> void:
	for binding: EffectBinding in _bindings:
		if binding.field == p_field and binding.error == "":
			_set_input(binding.input, binding.value_of(p_value))
	_apply_amount()


func _on_happened(p_event: StringName, _p_values: PackedFloat32Array) -> void:
	if plays_at == "" or p_event != StringName(plays_at):
		return
	_shown.play()
	if _ends_by_itself():
		return
	for part: ParticleEffect in _shown.parts:
		_left_s = maxf(_left_s, part.lifetime)
	set_process(_left_s > 0.0)
	_apply_amount()
