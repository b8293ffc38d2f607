extends TestCase


func test_a_setting_changes_on_its_line_only() -> void:
	var changed: String = HeaderEdit.set_setting(EffectTexts.GOOD, "count", "77")
	equal(EffectFile.read(changed).settings.count, 77)
	equal(changed.count("\n"), EffectTexts.GOOD.count("\n"))
	equal(changed.split("\n")[2], "// @count    77")


func test_a_setting_that_is_not_there_is_added_below_the_others() -> void:
	var changed: String = HeaderEdit.set_setting(EffectTexts.GOOD, "glow", "3")
	equal(EffectFile.read(changed).settings.glow, 3.0)
	equal(changed.count("\n"), EffectTexts.GOOD.count("\n") + 1)
	equal(
		(
			EffectFile
			. read(
				HeaderEdit.set_setting("shader_type particles;\nvoid process() {}\n", "life", "2")
			)
			. settings
			. life
		),
		2.0
	)


func test_a_default_of_a_uniform_changes() -> void:
	var changed: String = HeaderEdit.set_default(EffectTexts.GOOD, "drag", "1.5")
	contains(changed, "uniform float drag : hint_range(0, 4) = 1.5;")
	changed = HeaderEdit.set_default(changed, "tint", "vec3(0.1, 0.2, 0.3)")
	contains(changed, "uniform vec3 tint : source_color = vec3(0.1, 0.2, 0.3);")
	equal(HeaderEdit.set_default(changed, "absent", "1.0"), changed)
	contains(HeaderEdit.set_default("uniform float a;", "a", "2.0"), "uniform float a = 2.0;")


func test_numbers_of_code_have_a_point() -> void:
	equal([HeaderEdit.code_number(2.0), HeaderEdit.code_number(0.125)], ["2.0", "0.125"])
