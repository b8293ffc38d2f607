extends TestCase
## How particles are drawn: every kind of header makes a shader that compiles, for Compatibility and
## for the other renderers, and those that are drawn alike share it.

const INCLUDE: String = "res://assets/shaders/effect.gdshaderinc"
const LIGHT: String = "res://assets/shaders/light.gdshaderinc"
const RENDERER: String = "CURRENT_RENDERER == RENDERER_COMPATIBILITY"


func after_each() -> void:
	EffectDrawing.forget()


func test_every_kind_of_header_compiles_for_all_renderers() -> void:
	var codes: Dictionary[String, bool] = {}
	for texture: String in EffectSettings.TEXTURES:
		for blend: String in ["alpha", "add", "fire"]:
			for light: String in ["none", "sun"]:
				for facing: String in ["viewer", "velocity", "none"]:
					var settings: EffectSettings = EffectSettings.new()
					settings.texture = texture
					settings.blend = blend
					settings.light = light
					settings.facing = facing
					settings.soft = 0.5 if blend == "alpha" else 0.0
					settings.topology = "triangle" if facing == "none" else "quad"
					codes[EffectDrawing.code_of(settings)] = true
	for code: String in codes:
		for is_compatible: bool in [true, false]:
			is_true(_compiles(code, is_compatible), code)


func test_what_is_drawn_alike_shares_a_shader() -> void:
	var smoke: EffectSettings = EffectFile.open(EffectFile.path_of("smoke")).settings
	var fumes: EffectSettings = EffectFile.open(EffectFile.path_of("diesel_fumes")).settings
	var sparks: EffectSettings = EffectFile.open(EffectFile.path_of("sparks")).settings
	is_true(EffectDrawing.shader_of(smoke) == EffectDrawing.shader_of(fumes))
	is_false(EffectDrawing.shader_of(smoke) == EffectDrawing.shader_of(sparks))
	var material: ShaderMaterial = EffectDrawing.make_material(smoke)
	almost_equal(material.get_shader_parameter(&"soft_m"), smoke.soft, 1e-6)
	equal(material.get_shader_parameter(&"grid"), Vector2i(8, 8))


func test_there_is_a_picture_for_every_texture_that_a_header_may_name() -> void:
	for name: String in EffectSettings.TEXTURES:
		var file: String = "puff_a" if name == "puff" else name
		is_true(EffectDrawing.texture(file) != null, name)
	is_true(EffectDrawing.texture("puff_b") != null)


func test_a_triangle_holds_the_disc_of_a_quad() -> void:
	equal(EffectDrawing.mesh("quad").get_faces().size(), 6)
	var corners: PackedVector3Array = EffectDrawing.mesh("triangle").get_faces()
	equal(corners.size(), 3)
	for index: int in 3:
		var from: Vector3 = corners[index]
		var side: Vector3 = corners[(index + 1) % 3] - from
		var away: float = side.cross(-from).length() / side.length()
		almost_equal(away, 0.5, 1e-4)


## The engine without a display compiles as one renderer: so the choice is made here.
func _compiles(p_code: String, p_is_compatible: bool) -> bool:
	var light: String = FileAccess.get_file_as_string(LIGHT)
	var text: String = p_code.replace(
		'#include "%s"' % INCLUDE, FileAccess.get_file_as_string(INCLUDE)
	)
	text = text.replace('#include "%s"' % LIGHT, light)
	text = text.replace(RENDERER, "1 == 1" if p_is_compatible else "1 == 2")
	is_false(text.contains("#include") or text.contains("CURRENT_RENDERER"))
	var shader: Shader = Shader.new()
	shader.code = text
	for uniform: Dictionary in shader.get_shader_uniform_list():
		if uniform["name"] == "fade_m":
			return true
	return false
