extends TestCase
## Effects of a level: what an emitter shows follows the fields and events of an entity, and what is
## set up wrongly says how to mend it.

var _stage: Node3D = null
var _emitter: EffectEmitter = null
var _entity: Entity = null


func before_each() -> void:
	_stage = Node3D.new()
	_entity = Entity.new()
	_entity.type = EntityType.new()
	_entity.type.name = &"stove"
	for name: StringName in [&"burning", &"rpm"]:
		var field: EntityField = EntityField.new()
		field.name = name
		field.max_value = 4000.0
		field.resolution = 0.01
		_entity.type.fields.append(field)
	var bang: EntitySchema = EntitySchema.new()
	bang.name = &"bang"
	_entity.type.events.append(bang)
	_emitter = EffectEmitter.new()
	_emitter.entity = _entity
	_stage.add_child(_entity)
	_stage.add_child(_emitter)
	_stage.add_child(LocalSession.new())


func after_each() -> void:
	_stage.free()


func test_inputs_and_amount_follow_fields() -> void:
	_emitter.effect = "diesel_fumes"
	_emitter.inputs = "revs = rpm * 0.0005\nload = 0.25\namount = burning"
	await _start()
	var shown: LayeredEffect = _shown()
	is_false(shown.emitting, "no amount")
	_entity.set_value(&"burning", 0.5)
	_entity.set_value(&"rpm", 1000.0)
	is_true(shown.emitting)
	almost_equal(shown.share, 0.5, 0.01)
	almost_equal(_value_of(&"revs"), 0.5, 0.01)
	almost_equal(_value_of(&"load"), 0.25, 1e-6)
	_entity.set_value(&"rpm", 4000.0)
	almost_equal(_value_of(&"revs"), 1.0, 1e-6)


func test_it_plays_at_an_event() -> void:
	_emitter.effect = "explosion"
	_emitter.plays_at = "bang"
	await _start()
	var part: ParticleEffect = _shown().parts[0]
	is_false(part.emitting)
	_entity.happened.emit(&"other", PackedFloat32Array())
	is_false(part.emitting)
	_entity.happened.emit(&"bang", PackedFloat32Array())
	is_true(part.emitting)


func test_what_does_not_end_by_itself_is_played_for_its_life() -> void:
	_emitter.effect = "fountain"
	_emitter.plays_at = "bang"
	_warns("@once yes")
	await _start()
	var part: ParticleEffect = _shown().parts[0]
	is_false(part.emitting)
	_entity.happened.emit(&"bang", PackedFloat32Array())
	_emitter.amount = 0.5
	is_true(part.emitting)
	_emitter._process(part.lifetime * 0.5)
	is_true(part.emitting)
	_emitter._process(part.lifetime)
	is_false(part.emitting)


func test_without_an_entity_it_is_always_there() -> void:
	_emitter.entity = null
	_emitter.effect = "fountain"
	_emitter.amount = 0.5
	await _start()
	is_true(_shown().emitting and _shown().parts[0].emitting)
	almost_equal(_shown().parts[0].amount_ratio, 0.5 * EffectBudget.share, 1e-6)
	_emitter.effect = "smoke"
	equal(_shown().parts[0].amount, 90)


func test_warnings_say_what_to_do() -> void:
	_emitter.effect = "smoke"
	_emitter.inputs = "thickness = rpm"
	equal(_emitter._get_configuration_warnings().size(), 0)
	_emitter.effect = "smok"
	_warns("choose one of")
	_emitter.effect = "smoke"
	_emitter.inputs = "thickness rpm"
	_warns("INPUT = FIELD")
	_emitter.inputs = "thickness = heat"
	_warns("The type 'stove' has no field 'heat'")
	_emitter.inputs = ""
	_emitter.plays_at = "boom"
	_warns("no event 'boom'")
	_emitter.entity = null
	_warns("for 'Entity'")


func test_nonsense_does_no_harm() -> void:
	_emitter.inputs = "a = 1e99\nb = = 2\n= 3\nthickness = missing\nthickness=2"
	await _start()
	is_true(_shown().emitting)
	almost_equal(_value_of(&"thickness"), 1.0, 1e-6, "clamped to what the file declares")


func _start() -> void:
	add_child(_stage)
	await process_frames(2)
	_emitter.show_effect()


func _shown() -> LayeredEffect:
	return _emitter.find_children("*", "LayeredEffect", false, false)[0] as LayeredEffect


func _value_of(p_name: StringName) -> float:
	var motion: ShaderMaterial = _shown().parts[0].process_material as ShaderMaterial
	return motion.get_shader_parameter(p_name)


func _warns(p_words: String) -> void:
	var text: String = " ".join(_emitter._get_configuration_warnings())
	is_true(text.contains(p_words), "'%s' is not in '%s'" % [p_words, text])
