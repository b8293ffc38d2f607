extends TestCase

## What stands in process(), from line 5, and the line of the first problem; 0 for none.
const CASES: Array[Array] = [
	["for (int i = 0; i < 8; i++) { VELOCITY.x += float(i); }", 0],
	["for (int i = 0;\n i < 8; i++) { VELOCITY.x += 1.0; }", 0],
	["for (int i = 0; i < 8; i++) { float j = float(i); if (i == 3) { j = 1.0; } }", 0],
	["for (int i = 0; i < 8; i++) { for (int j = 0; j < 8; j++) { COLOR.r += 0.1; } }", 0],
	["float a[8]; for (int i = 0; i < 8; i++) { a[i] = 1.0; } COLOR.r = a[3];", 0],
	["for (int i = 0; i < 8; i++) VELOCITY.x += 1.0;", 5],
	["for (int i = 0; i < 8; i++) { i = 0; }", 5],
	["for (int i = 0; i < 8; i++) { i--; }", 5],
	["for (int i = 0; i < 8; i++) { --i; }", 5],
	["for (int i = 0; i < 8; i++) { (i) = 0; }", 5],
	["for (int i = 0; i < 8; i++) { ((i))--; }", 5],
	["for (int i = 0; i < 8; i++) { --(i); }", 5],
	["for (int i = 0; i < 8; i++) {\n i\n -= 1; }", 6],
	["for (int i = 0; i < 8; i++) { i /* x */ = 0; }", 5],
	["for (int i = 0; i < 8; i--) { }", 5],
	["for (int i = 0; i < 8; ) { }", 5],
	["for (int i = 0; j < 8; i++) { }", 5],
	["for (int i = 0; i < n; i++) { }", 5],
	["for (int i = 0; i != 9; i++) { }", 5],
	["for (int i = 0, k = 0; i < 8; i++) { }", 5],
	["for (uint i = 0u; i < 8u; i++) { }", 5],
	["for (int i = -8; i < 8; i++) { }", 5],
	["for (int i = 0; i < 0xFFFFFF; i++) { }", 5],
	["for (int i = 0; i < 99999999999999999999; i++) { }", 5],
	["for (int i = 0; i < 4097; i++) { }", 5],
	["for (int i = 0; i < 100; i++) {\n for (int j = 0; j < 100; j++) { COLOR.r += 1.0; } }", 6],
	["for (int i = 0; i < 100; i++) { }\nfor (int j = 0; j < 100; j++) { }", 6],
	["while (COLOR.r < 1.0) { }", 5],
	["do { } while (true);", 5],
	["float a[100000];", 5],
	["float[100000] a;", 5],
	["float a[int(100000)];", 5],
	["float a[0x7ffff];", 5],
	["const int N = 5000; float a[N];", 5],
	["const int N = 50; float a[N * N];", 5],
	["const int A = int(1), N = 5000; float a[N];", 5],
	["const int A[1] = {1}, N = 5000; float a[N];", 5],
	["float a[50 * 50 * 50];", 5],
	["float a[2], b[-(-90000)];", 5],
]


func test_cases() -> void:
	for case: Array in CASES:
		var file: EffectFile = EffectFile.read(EffectTexts.of("// @count 2", case[0]))
		var line: int = 0 if file.problems.is_empty() else file.problems[0].line
		equal(line, case[1], "%s %s" % [case[0], file.first_problem()])
		if case[1] == 0:
			equal(str(ShaderCheck.problems(file)), "[]", case[0])


func test_a_function_that_changes_a_counter_is_refused() -> void:
	for argument: String in ["inout int k", "out int k", "inout highp int k"]:
		var text: String = EffectTexts.of("", "for (int i = 0; i < 8; i++) { f(i); }")
		var file: EffectFile = EffectFile.read(
			text.replace("void start", "void f(%s) { k = 0; } void start" % argument)
		)
		is_true(file.first_problem().begins_with("line 3"), file.first_problem())


func test_arrays_in_structs_are_refused() -> void:
	var text: String = EffectTexts.of("struct A { float x[200]; };", "A a[200];")
	is_true(EffectFile.read(text).first_problem().begins_with("line 2"))
