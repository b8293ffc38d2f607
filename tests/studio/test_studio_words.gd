extends TestCase


func test_every_setting_and_word_has_its_help() -> void:
	for name: String in EffectSettings.keys():
		contains(StudioWords.meaning(name, true), "// @" + name)
	for word: String in ["VELOCITY", "rnd_range", "mix", "vec3", "uniform"]:
		not_equal(StudioWords.meaning(word), "", word)
	equal(StudioWords.meaning("nonsense"), "")


func test_what_the_compiler_knows_is_explained() -> void:
	for name: String in CompilerWords.NAMES:
		if name == name.to_upper() and not name.begins_with("RESTART") and name.length() > 3:
			if not ["MASS", "INTERPOLATE_TO_END"].has(name):
				not_equal(StudioWords.meaning(name), "", name)


func test_helpers_are_all_explained() -> void:
	for name: String in EffectFile.HELPERS:
		is_true(StudioWords.HELPERS.has(name), name)
