extends TestCase


func test_a_whole_effect_is_read() -> void:
	var file: EffectFile = EffectFile.read(EffectTexts.GOOD)
	equal(file.first_problem(), "")
	equal(file.settings.effect, "Test fountain")
	equal(file.settings.count, 50)
	equal(file.settings.size, PackedFloat64Array([0.2, 0.1]))
	equal(file.settings.inputs[0].name, "strength")
	equal(file.settings.inputs[0].meaning, "how strong it is")
	is_true(file.work > 50 and file.work < 500, "work %d" % file.work)


func test_the_code_keeps_its_lines() -> void:
	var file: EffectFile = EffectFile.read(EffectTexts.GOOD)
	var code: String = file.code()
	equal(code.count("\n"), EffectTexts.GOOD.count("\n"))
	equal(code.split("\n")[24], EffectTexts.GOOD.split("\n")[24])


func test_colours_stay_as_picked() -> void:
	var code: String = EffectFile.read(EffectTexts.GOOD).code()
	is_false(code.contains("source_color"))
	var texts: Dictionary[String, String] = {
		"uniform vec3 a : source_color;": "uniform vec3 a ;",
		"uniform sampler2D t : source_color, filter_linear;":
		"uniform sampler2D t : filter_linear;",
		"uniform vec3 a:source_color=vec3(1.0);": "uniform vec3 a=vec3(1.0);",
	}
	for text: String in texts:
		var file: EffectFile = EffectFile.read(
			EffectTexts.of("", "").replace("void start", text + "void start")
		)
		is_true(file.code().contains(texts[text]), file.code())


func test_a_comment_is_no_shader_type() -> void:
	var text: String = (
		"// shader_type particles;\n" + EffectTexts.of("", "COLOR = vec4(wind, 1.0);")
	)
	equal(ShaderCheck.problems(EffectFile.read(text)), [] as Array[EffectProblem])


func test_what_is_no_effect_has_a_problem() -> void:
	for text: String in [
		"",
		"hello",
		"shader_type spatial;",
		"{ \u0001 =",
		"shader_type particles;",
		"// @count 3",
		"shader_type particles; void process();",
	]:
		not_equal(EffectFile.read(text).first_problem(), "", text)


func test_bytes_that_are_no_text_are_refused_without_a_word_in_the_log() -> void:
	for bytes: PackedByteArray in [
		PackedByteArray([0xFF, 0xFE, 0x00]),
		PackedByteArray([0x41, 0x00]),
		PackedByteArray([0xC3]),
		PackedByteArray([0xED, 0xA0, 0x80]),
		PackedByteArray([0x1B, 0x5B]),
	]:
		equal(EffectFile.from_bytes(bytes).first_problem(), "line 1: This is not a text in UTF-8.")
	var umlauts: String = EffectTexts.GOOD.replace("Test", "Füntain\t→")
	var file: EffectFile = EffectFile.from_bytes(umlauts.to_utf8_buffer())
	equal(file.first_problem(), "")
	equal(file.text, umlauts)


func test_a_file_that_is_too_large_or_absent_is_refused() -> void:
	var large: PackedByteArray = []
	large.resize(EffectLimits.MAX_BYTES + 1)
	large.fill(32)
	equal(
		EffectFile.from_bytes(large).first_problem(), "line 1: An effect has at most 65536 bytes."
	)
	large.resize(EffectLimits.MAX_BYTES)
	not_equal(EffectFile.from_bytes(large).first_problem(), "")
	var problem: String = EffectFile.open("user://no/such.gdshader").first_problem()
	is_true(problem.contains("cannot be read"), problem)


func test_names() -> void:
	for name: String in ["smoke", "dust_2", "a"]:
		is_true(EffectLimits.is_name(name), name)
	for name: String in ["", "Smoke", "2dust", "../x", "a b", "a.b", "a\n", "x".repeat(41), "é"]:
		is_false(EffectLimits.is_name(name), name)


## Broken files and the line of their first problem; 0 for none.
func test_loops_and_settings_by_line() -> void:
	var cases: Array[Array] = [
		["// @count 10", "TRANSFORM = at(vec3(0), 1.0);", 0],
		["// @count ten", "", 2],
		["// @count 99999", "", 2],
		["// @blend mix", "", 2],
		["// @life", "", 2],
		["// @texture gone", "", 2],
		["// @colour red", "", 2],
		["", "\twhile (true) { }", 5],
		["", "\tfor (;;) { }", 5],
		["#define W while\n", "", 2],
		["// while (true)", "", 0],
		["/* for (;;) */", "", 0],
		["// @fade 9 3", "", 2],
		["// @input x 1 0 0 y", "", 2],
		["// @speed 4", "", 2],
		["// @once maybe", "", 2],
		["// @weight nan", "", 2],
		["", "\tdo { } while (true);", 5],
		["// @count 2.5", "", 2],
		["// @count 20000", "for (int i = 0; i < 4096; i++) { COLOR += vec4(0.1); }", 1],
	]
	for case: Array in cases:
		var file: EffectFile = EffectFile.read(EffectTexts.of(case[0], case[1]))
		var line: int = 0 if file.problems.is_empty() else file.problems[0].line
		equal(line, case[2], "%s %s" % [case, file.first_problem()])


func test_ten_thousand_broken_texts_end() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 17
	var good: int = 0
	for i: int in 10000:
		var text: String = EffectTexts.mutate(EffectTexts.GOOD, random)
		var file: EffectFile = EffectFile.from_bytes(text.to_utf8_buffer())
		good += int(ShaderCheck.problems(file, true).is_empty())
	is_true(good > 100 and good < 9000, "%d of 10000 are good" % good)


func test_small_hostile_texts_are_refused() -> void:
	for text: String in EffectTexts.long():
		var file: EffectFile = EffectFile.from_bytes(text.to_utf8_buffer())
		is_false(file.problems.is_empty(), text.left(80))
		is_true(file.problems.size() <= EffectLimits.MAX_PROBLEMS, text.left(80))


func test_keys_keep_nothing_of_a_reading() -> void:
	var key: EffectKey = EffectSettings.keys()["count"]
	var bad: Variant = key.read(["ten"])
	equal(key.read(["10"]), 10)
	is_true(bad is EffectProblem and (bad as EffectProblem).text.contains("'ten'"))
