extends TestCase
## Sounds by name: takes, levels, figures of their samples.

const Figures: GDScript = preload("res://tests/bench/sound/sound_figures.gd")


func after_each() -> void:
	SoundBank.clear()


func test_takes_are_found_and_loops_are_whole() -> void:
	equal(SoundBank.find(&"step_sand").takes.size(), 4)
	var loop: AudioStreamWAV = SoundBank.find(&"turret_loop").takes[0] as AudioStreamWAV
	is_true(SoundBank.find(&"turret_loop").is_loop())
	equal(loop.loop_end, loop.data.size() / 2)
	is_false(SoundBank.find(&"step_sand").is_loop())


func test_a_name_that_is_a_path_finds_nothing() -> void:
	is_null(SoundBank.find(&"../world/x"))
	is_null(SoundBank.find(&""))


func test_a_level_falls_by_6_db_for_each_doubling() -> void:
	var cue: SoundCue = SoundBank.find(&"cannon_near")
	almost_equal(cue.level_at(10.0) - cue.level_at(100.0), 20.0, 0.1)
	equal(cue.level_at(cue.range_m), -INF)


func test_the_engine_beats_with_its_revolutions() -> void:
	for rpm: int in [700, 1800]:
		var name: StringName = StringName("engine12_%d_loop" % rpm)
		var stream: AudioStreamWAV = SoundBank.find(name).takes[0] as AudioStreamWAV
		var thin: PackedFloat32Array = Figures.thinned(Figures.samples_of(stream), 16)
		var hz: float = Figures.strongest_hz(thin, 30.0, 350.0, 1.0, stream.mix_rate / 16.0)
		almost_equal(hz, rpm / 10.0, rpm / 1000.0)


func test_guns_have_the_crest_of_guns() -> void:
	for take: AudioStream in SoundBank.find(&"machine_gun_near").takes:
		var crest: float = Figures.crest_db(Figures.samples_of(take as AudioStreamWAV))
		is_true(crest > 18.0 and crest < 22.0, "%.1f dB" % crest)
