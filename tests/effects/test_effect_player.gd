extends TestCase
## Effects that are played: within a fixed number, by distance, and for longer than who asked.

const HERE: Transform3D = Transform3D.IDENTITY

var _stage: Node3D = null
var _player: EffectPlayer = null


func before_each() -> void:
	_stage = Node3D.new()
	_stage.add_to_group(EffectPlayer.STAGES)
	add_child(_stage)
	_player = EffectPlayer.of(_stage)


func after_each() -> void:
	_stage.free()


func test_there_is_one_for_a_level_and_it_ends_with_it() -> void:
	var car: Node3D = Node3D.new()
	var part: Node3D = Node3D.new()
	car.add_child(part)
	_stage.add_child(car)
	is_true(EffectPlayer.of(part) == _player)
	is_true(_player.get_parent() == _stage)
	car.free()
	is_true(_player.play("sparks", HERE))


func test_what_is_prepared_is_made_one_in_a_frame() -> void:
	_player.prepare("sparks", 3)
	is_false(_player.is_prepared())
	await process_frames(6)
	is_true(_player.is_prepared())
	equal(_count(), 3)
	for _index: int in 3:
		_player.play("sparks", HERE)
	equal(_count(), 3, "none is made while it plays")
	_player.prepare("sparks", 9999)
	await process_frames(40)
	equal(_count(), EffectPlayer.MAX_OF_ONE)


func test_hundreds_of_impacts_keep_to_a_number() -> void:
	for index: int in 500:
		is_true(_player.play("impact", HERE.translated(Vector3(index, 0.0, 0.0))))
	equal(_count(), EffectPlayer.UNPREPARED)
	equal(_player.played, 500)


func test_what_is_over_is_hidden() -> void:
	_player.play("sparks", HERE, 1.0, {&"ground": -2.0})
	var shown: LayeredEffect = _all()[0]
	is_true(shown.visible)
	almost_equal(_value_of(shown, &"ground"), -2.0, 1e-6)
	await process_frames(60 * 3)
	is_false(shown.visible)
	equal(_player.playing("sparks"), 0)


func test_nothing_is_played_too_far_away_or_nowhere() -> void:
	var camera: Camera3D = Camera3D.new()
	_stage.add_child(camera)
	camera.current = true
	is_true(_player.play("sparks", HERE))
	is_false(_player.play("sparks", HERE.translated(Vector3(0.0, 0.0, 900.0))))
	is_false(_player.play("sparks", HERE.translated(Vector3(NAN, 0.0, 0.0))))
	is_false(_player.play("sparks", HERE, NAN))
	is_false(_player.play("no_such_effect", HERE))


func test_size_reaches_the_file_within_its_bounds() -> void:
	_player.play("sparks", HERE, 2.5)
	almost_equal(_value_of(_all()[0], &"scale"), 2.5, 1e-6)
	_player.play("sparks", HERE, 1e9)
	almost_equal(_value_of(_all()[1], &"scale"), 6.0, 1e-6)


func _all() -> Array[LayeredEffect]:
	var found: Array[LayeredEffect] = []
	found.assign(_player.find_children("*", "LayeredEffect", false, false))
	return found


func _count() -> int:
	return _all().size()


func _value_of(p_shown: LayeredEffect, p_name: StringName) -> float:
	var motion: ShaderMaterial = p_shown.parts[0].process_material as ShaderMaterial
	return motion.get_shader_parameter(p_name)
