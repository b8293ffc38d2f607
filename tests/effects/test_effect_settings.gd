extends TestCase


func test_every_setting_has_the_default_that_its_key_says() -> void:
	var settings: EffectSettings = EffectSettings.new()
	for name: String in EffectSettings.keys():
		var key: EffectKey = EffectSettings.keys()[name]
		equal(settings.get(name), key.default, name)
		not_equal(key.meaning, "", name)
		if key.kind == EffectKey.Kind.NUMBER:
			is_true(key.default >= key.minimum and key.default <= key.maximum, name)


func test_how_it_is_written_can_be_read() -> void:
	for name: String in EffectSettings.keys():
		var usage: String = EffectSettings.keys()[name].usage()
		equal(EffectFile.read(EffectTexts.of(usage, "")).first_problem(), "", usage)


func test_only_what_is_drawn_otherwise_must_be_made_anew() -> void:
	var one: EffectSettings = EffectFile.read(EffectTexts.GOOD).settings
	var text: String = EffectTexts.GOOD.replace("@weight 1", "@weight 2").replace("0.2 0.1", "0.3")
	is_true(one.draws_like(EffectFile.read(text).settings))
	is_false(one.draws_like(EffectFile.read(text.replace("@count 50", "@count 51")).settings))
	is_false(one.draws_like(null))


func test_colours_over_life_have_the_steps_of_the_header() -> void:
	var file: EffectFile = EffectFile.read(EffectTexts.GOOD)
	is_true(
		file.settings.helpers(file.text).contains("vec4(0.560784, 0.203922, 0.011765, 0.000000)")
	)


func test_a_mistyped_setting_is_suggested() -> void:
	var file: EffectFile = EffectFile.read(EffectTexts.of("// @lfe 3", ""))
	equal(file.first_problem(), "line 2: There is no setting 'lfe'. Did you mean 'life'?")


func test_a_setting_stands_once() -> void:
	var file: EffectFile = EffectFile.read(EffectTexts.of("// @life 3\n// @life 4", ""))
	equal(file.first_problem(), "line 3: 'life' already stands on line 2.")
