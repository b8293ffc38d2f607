extends "sound_case.gd"
## Impacts and scrapes by material and strength.

var _impacts: ImpactSounds = null


func before_each() -> void:
	await super()
	_impacts = ImpactSounds.new(_voices)


func after_each() -> void:
	_impacts = null
	await super()


func test_every_material_of_the_kit_has_sounds() -> void:
	for key: StringName in ContactMaterial.KEYS:
		var sound: StringName = StringName(ContactMaterial.named(key).sound)
		not_null(SoundBank.find(StringName("impact_" + ImpactSounds.kind_of(sound))), key)
		not_null(SoundBank.find(ImpactSounds.step_name(sound)), key)
		var scrape: String = "scrape_%s_loop" % ImpactSounds.scrape_kind(sound, sound)
		not_null(SoundBank.find(StringName(scrape)), key)


func test_twice_the_impulse_is_6_db() -> void:
	almost_equal(ImpactSounds.gain_of(20.0) - ImpactSounds.gain_of(10.0), 6.02, 0.01)


func test_a_touch_and_nonsense_are_not_heard() -> void:
	_impacts.play_impact(&"wood", &"metal", Vector3(0.0, 0.0, -2.0), 0.01)
	_impacts.play_impact(&"wood", &"metal", Vector3(0.0, 0.0, -2.0), NAN)
	_impacts.play_impact(&"wood", &"metal", Vector3(INF, 0.0, -2.0), 10.0)
	equal(_voices.begun, 0)
	_impacts.play_impact(&"wood", &"metal", Vector3(0.0, 0.0, -2.0), 10.0)
	equal(_voices.begun, 2, "both materials are heard")


func test_a_scrape_ends_without_news() -> void:
	for frame: int in 10:
		_impacts.set_scrape(5, &"metal", &"concrete", Vector3(0.0, 0.0, -2.0), 1.0, 200.0)
		_impacts.advance(1.0 / 60.0)
		await process_frames(1)
	equal(_impacts.scrape_count(), 1)
	equal(_voices.heard(), 1)
	for frame: int in ceili(ImpactSounds.SCRAPE_S * 60.0) + 2:
		_impacts.advance(1.0 / 60.0)
		await process_frames(1)
	equal(_impacts.scrape_count(), 0)
	equal(_voices.heard(), 0)


func test_a_scrape_goes_on_from_news_to_news() -> void:
	# The server tells of it each 6 ticks; one datagram in three is lost.
	for frame: int in 72:
		if frame % 6 == 0 and frame % 18 != 6:
			_impacts.set_scrape(5, &"metal", &"concrete", Vector3(0.0, 0.0, -2.0), 1.0, 200.0)
		_impacts.advance(1.0 / 60.0)
		await process_frames(1)
		equal(_impacts.scrape_count(), 1)
	equal(_voices.begun, 1, "it is one sound all the time")


func test_hundreds_of_scrapes_are_few() -> void:
	for pair: int in 400:
		_impacts.set_scrape(pair, &"wood", &"sand", Vector3(0.0, 0.0, -2.0), 1.0, 200.0)
	equal(_impacts.scrape_count(), ImpactSounds.MAX_SCRAPES)
