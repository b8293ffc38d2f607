extends TestCase


func test_calls_that_double_each_time_are_refused() -> void:
	var functions: String = "void f0() { }"
	for i: int in 30:
		functions += " void f%d() { f%d(); f%d(); }" % [i + 1, i, i]
	var file: EffectFile = EffectFile.read(EffectTexts.of(functions, "f30();"))
	contains(file.first_problem(), "too long, with all that it calls")


func test_a_function_below_is_refused() -> void:
	var file: EffectFile = EffectFile.read(EffectTexts.of("", "f();") + "void f() { }")
	is_true(file.first_problem().contains("above"), file.first_problem())
	file = EffectFile.read(EffectTexts.of("void f() { f(); }", "f();"))
	is_true(file.first_problem().contains("above"), file.first_problem())


func test_work_grows_with_rounds_and_calls() -> void:
	var once: int = EffectFile.read(EffectTexts.of("", "COLOR.r += sin(1.0);")).work
	var loop: String = "for (int i = 0; i < 100; i++) { COLOR.r += sin(1.0); }"
	var often: int = EffectFile.read(EffectTexts.of("// @count 9", loop)).work
	is_true(often > 100 * 15 and often > 20 * once, "%d and %d" % [once, often])
	var called: String = "void f() { for (int i = 0; i < 100; i++) { COLOR.r += 1.0; } }"
	var by_call: int = EffectFile.read(EffectTexts.of("", "")).work
	var text: String = EffectTexts.of("", "f(); f();").replace("void start", called + "void start")
	is_true(EffectFile.read(text).work > by_call + 2 * 100 * 5)


func test_depth_and_length_are_bounded() -> void:
	for text: String in EffectTexts.deep():
		not_equal(EffectFile.read(text).first_problem(), "", text.left(200))


func test_brackets_that_do_not_fit_are_named_by_line() -> void:
	var problems: Dictionary[String, String] = {
		"COLOR = vec4(1.0;": "line 5: The ( has no ).",
		"}": "line 6: This } closes nothing.",
		"{": "line 4: The { has no }.",
		"COLOR.r = a[1);": "line 5: The [ has no ].",
	}
	for body: String in problems:
		equal(EffectFile.read(EffectTexts.of("", body)).first_problem(), problems[body])


func test_preprocess_counts() -> void:
	var body: String = "for (int i = 0; i < 20; i++) { COLOR.r += sin(1.0); }"
	equal(EffectFile.read(EffectTexts.of("// @count 20000", body)).first_problem(), "")
	var text: String = EffectTexts.of("// @count 20000\n// @preprocess 10", body)
	is_true(EffectFile.read(text).first_problem().contains("too much work"))
