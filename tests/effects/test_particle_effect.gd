extends TestCase
## One file of an effect as particles: its header, its inputs, and how much of the picture it takes.

var _part: ParticleEffect = null


func before_each() -> void:
	_part = ParticleEffect.new()
	add_child(_part)


func after_each() -> void:
	_part.free()


func test_it_does_what_the_header_says() -> void:
	_show("// @count 33\n// @life 2\n// @burst 0.5\n// @once yes\n// @bounds 4\n// @fade 20 30")
	equal(_part.amount, 33)
	almost_equal(_part.lifetime, 2.0, 1e-6)
	almost_equal(_part.explosiveness, 0.5, 1e-6)
	is_true(_part.one_shot)
	equal(_part.visibility_aabb, AABB(Vector3.ONE * -4.0, Vector3.ONE * 8.0))
	almost_equal(_part.visibility_range_end, 34.0, 1e-4, "beyond its fade it is not moved either")


func test_what_is_quick_is_moved_more_often() -> void:
	_show("// @life 0.1")
	equal(_part.fixed_fps, ParticleEffect.MANY_STEPS_PER_SECOND)
	_show("// @life 4")
	equal(_part.fixed_fps, ParticleEffect.STEPS_PER_SECOND)
	_show("// @life 4\n// @facing velocity")
	equal(_part.fixed_fps, ParticleEffect.MANY_STEPS_PER_SECOND)


func test_colours_are_set_as_they_were_picked() -> void:
	_show("// @count 3")
	_part.set_input(&"tint", Color(0.5, 0.25, 1.0))
	var motion: ShaderMaterial = _part.process_material as ShaderMaterial
	almost_equal(motion.get_shader_parameter(&"tint"), Vector3(0.5, 0.25, 1.0), 1e-6)


func test_inputs_stay_within_their_bounds() -> void:
	_show("// @input rpm 600 2600 800 revolutions")
	var motion: ShaderMaterial = _part.process_material as ShaderMaterial
	_part.set_input(&"rpm", 99999.0)
	almost_equal(motion.get_shader_parameter(&"rpm"), 2600.0, 1e-3)


func test_near_and_large_ones_fill_the_picture_more_often() -> void:
	var camera: Camera3D = Camera3D.new()
	add_child(camera)
	_show("// @count 100\n// @size 2")
	_part.position.z = -10.0
	var near: float = _part.screens(camera)
	_part.position.z = -40.0
	almost_equal(near / _part.screens(camera), 16.0, 0.1)
	_show("// @count 100\n// @size 1")
	_part.position.z = -10.0
	almost_equal(near / _part.screens(camera), 4.0, 0.1)
	_part.emitting = false
	equal(_part.screens(camera), 0.0)
	camera.free()


func test_the_code_leaves_out_the_share_for_which_there_is_no_room() -> void:
	var file: EffectFile = _show("// @count 3")
	is_true(file.code().contains("AMOUNT_RATIO"))
	var own: String = file.text.replace("COLOR.a = 0.5;", "COLOR.a = AMOUNT_RATIO;")
	equal(EffectFile.read(own).code().count("AMOUNT_RATIO"), 1, "a file may do it itself")
	_part.share = 0.5
	_part.room = 0.5
	almost_equal(_part.amount_ratio, 0.25, 1e-6)


func _show(p_header: String) -> EffectFile:
	var file: EffectFile = (
		EffectFile
		. read(
			(
				"shader_type particles;\n%s\n" % p_header
				+ "void start() { TRANSFORM = at(vec3(0.0), 1.0); }\nvoid process() { COLOR.a = 0.5; }\n"
			)
		)
	)
	equal(ShaderCheck.problems(file).size(), 0, p_header)
	_part.show_layer(EffectLayer.make("test", file))
	return file
