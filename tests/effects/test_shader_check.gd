extends TestCase


func test_a_good_effect_has_no_problems() -> void:
	equal(str(ShaderCheck.problems(EffectFile.read(EffectTexts.GOOD))), "[]")


func test_mistakes_are_named_by_line_in_plain_words() -> void:
	for error: String in [
		"Shader compilation failed",
		"No matching function",
		"Unknown identifier",
		"Expected a ';'",
		"Invalid arguments",
		"Invalid assignment",
		"Invalid member",
		"Constants cannot",
	]:
		allow_error(error)
	var point: String = " Write numbers with a point: 1.0, not 1."
	var cases: Dictionary[String, String] = {
		"VELOCITY = gravty();":
		"line 5: There is no function 'gravty' with such arguments. " + "Did you mean 'gravity'?",
		"VELOCITY = velocty;": "line 5: 'velocty' is not known here. Did you mean 'VELOCITY'?",
		"VELOCITY = vec3(1.0)": "line 5: At the end of this line a ';' is missing.",
		"VELOCITY.y -= 14;": "line 5: '-=' does not work between these types: float, int." + point,
		"float a = 1;": "line 5: A value of type int stands where a float belongs." + point,
		"VELOCITY.q = 1.0;": "line 5: A vec3 has no part 'q'.",
		"DELTA = 1.0;": "line 5: This can be read, but not changed.",
	}
	for body: String in cases:
		var text: String = EffectTexts.of("", body + "\n\n\tCUSTOM.x = 1.0;")
		var problems: Array[EffectProblem] = ShaderCheck.problems(EffectFile.read(text))
		equal(str(problems[0]) if not problems.is_empty() else "", cases[body])


func test_quietly_nothing_is_logged() -> void:
	var file: EffectFile = EffectFile.read(EffectTexts.of("", "VELOCITY = gravty;"))
	equal(str(ShaderCheck.problems(file, true)), "[line 1: The code does not compile.]")


func test_the_engines_voice_comes_back() -> void:
	ShaderCheck.problems(EffectFile.read(EffectTexts.of("", "x;")), true)
	is_true(Engine.print_error_messages and Engine.print_to_stdout)
