extends TestCase
## The shipped effects, and what happens as texts change while they are shown.

const PLAIN: String = """shader_type particles;
// @count 20
void start() { TRANSFORM = at(EMISSION_TRANSFORM[3].xyz, 1.0); }
void process() { COLOR.a = 0.5; }
"""

var _library: EffectLibrary = null


func before_each() -> void:
	_library = EffectLibrary.shared()


func after_each() -> void:
	_library.reset()


func test_every_shipped_file_compiles_and_says_what_it_is() -> void:
	var files: int = 0
	for name: String in ResourceLoader.list_directory(EffectFile.FOLDER):
		if name.get_extension() != EffectFile.EXTENSION:
			continue
		files += 1
		var file: EffectFile = EffectFile.open(EffectFile.path_of(name.get_basename()))
		var problems: Array[EffectProblem] = ShaderCheck.problems(file)
		equal(problems.size(), 0, "%s: %s" % [name, "" if problems.is_empty() else problems[0]])
		is_true(file.settings.effect != "", "%s has no title" % name)
		if file.settings.layer_of != "":
			is_true(_library.has(file.settings.layer_of), "%s is a layer of nothing" % name)
	equal(_library.files().size(), files)


func test_what_the_thesis_and_the_issue_name_is_shipped() -> void:
	var wanted: PackedStringArray = (
		(
			"diesel_fumes track_dust muzzle_flash tracer smoke fire explosion sparks debris impact "
			+ "impact_wood impact_metal impact_glass impact_soft rain sandstorm breath fountain"
		)
		. split(" ")
	)
	for name: String in wanted:
		is_true(_library.has(name), name)
	equal(_library.layers("explosion").size(), 4)
	equal(_library.layers("explosion")[0].name, "explosion", "its own file comes first")


func test_new_text_reaches_what_is_shown_without_setting_it_up_anew() -> void:
	var shown: LayeredEffect = _show("smoke")
	var part: ParticleEffect = shown.parts[0]
	var text: String = _library.text_of("smoke")
	part.set_meta(&"same", true)
	equal(_library.set_text("smoke", text.replace("1.9 - age", "2.9 - age")).size(), 0)
	is_true(shown.parts[0].layer.shader.code.contains("2.9 - age"))
	is_true(part == shown.parts[0] and part.process_material == shown.parts[0].process_material)
	equal(_library.edited().keys(), ["smoke"])
	_library.reset()
	is_true(part.layer.shader.code.contains("1.9 - age"))
	equal(_library.edited().size(), 0)


func test_a_new_header_sets_it_up_anew_and_its_inputs_stay() -> void:
	var shown: LayeredEffect = _show("smoke")
	shown.set_input(&"thickness", 0.25)
	var text: String = _library.text_of("smoke")
	equal(_library.set_text("smoke", text.replace("@count    90", "@count    7")).size(), 0)
	equal(shown.parts[0].amount, 7)
	var motion: ShaderMaterial = shown.parts[0].process_material as ShaderMaterial
	almost_equal(motion.get_shader_parameter(&"thickness"), 0.25, 1e-6)


func test_a_broken_text_changes_nothing() -> void:
	var shown: LayeredEffect = _show("smoke")
	var text: String = _library.text_of("smoke")
	for broken: String in [
		"",
		"nonsense",
		text.replace("void process()", "void proces()"),
		text.replace("@count    90", "@count    900000000"),
		text.replace("@texture  puff", "@texture  nothing"),
		text.replace("float age", "for (;;) { } float age"),
		text.replace("CUSTOM.w *", "CUSTOM.w **"),
		text.replace("0.92 *", "1e39 *"),
		text.replace("0.92 *", "1e+99 *"),
		text.replace("0.92 *", "9".repeat(60) + ".0 *"),
	]:
		var problems: Array[EffectProblem] = _library.set_text("smoke", broken, true)
		is_true(problems.size() > 0, "accepted: %s" % broken.left(60))
		equal(_library.text_of("smoke"), text)
		equal(shown.parts[0].amount, 90)
	is_true(shown.parts[0].layer.shader.code.contains("void process()"))


func test_layers_come_and_go() -> void:
	var shown: LayeredEffect = _show("breath")
	equal(shown.parts.size(), 1)
	var layer: String = PLAIN.replace("// @count", "// @layer_of breath\n// @count")
	equal(_library.set_text("breath_more", layer).size(), 0)
	equal(shown.parts.size(), 2)
	equal(shown.parts[1].amount, 20)
	equal(_library.set_text("breath_more", layer.replace("breath", "smoke")).size(), 0)
	equal(shown.parts.size(), 1)
	equal(_library.layers("smoke").size(), 2)
	_library.reset()
	equal(_library.find("breath_more"), null)
	equal(_library.layers("smoke").size(), 1)


func test_names_and_their_number_are_bounded() -> void:
	for name: String in ["", "../smoke", "Smoke", "a b", "x".repeat(41)]:
		is_true(_library.set_text(name, PLAIN).size() > 0, "accepted '%s'" % name)
	for number: int in EffectLibrary.MAX_FILES + 4:
		_library.set_text("more_%d" % number, PLAIN)
	equal(_library.files().size(), EffectLibrary.MAX_FILES)


func _show(p_effect: String) -> LayeredEffect:
	var shown: LayeredEffect = LayeredEffect.make(p_effect)
	add_child(shown)
	return shown
