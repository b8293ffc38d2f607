extends "sound_case.gd"
## Which voices are heard, and how loud they are in the captured mix.

const MixCapture: GDScript = preload("res://tests/bench/sound/mix_capture.gd")
const Figures: GDScript = preload("res://tests/bench/sound/sound_figures.gd")

var _ear: Node3D = null
var _capture: RefCounted = MixCapture.new()


func before_each() -> void:
	await super()
	_ear = Camera3D.new()
	add_child(_ear)
	_voices.listener = _ear
	_capture.start()


func after_each() -> void:
	_capture.stop()
	await super()


func test_what_is_too_far_or_not_there_is_refused() -> void:
	is_null(_voices.play(&"step_concrete", Vector3(500.0, 0.0, 0.0)))
	is_null(_voices.play(&"no_such_sound", Vector3.ZERO))
	is_null(_voices.play(&"step_concrete", Vector3(NAN, 0.0, 0.0)))
	is_null(_voices.play(&"step_concrete", Vector3.ZERO, INF))
	is_null(_voices.start_loop(&"../secret", null))
	equal(_voices.heard(), 0)


func test_voices_stay_within_the_budget_and_the_loudest_is_heard() -> void:
	for number: int in 200:
		_voices.play(&"impact_metal", Vector3(0.0, 0.0, -60.0 + number * 0.1), -6.0)
	equal(_voices.heard(), SoundVoices.MAX_VOICES)
	var own: SoundVoice = _voices.play(&"impact_metal", Vector3(0.0, 0.0, -1.0))
	not_null(own, "a loud one ends a quiet one")
	equal(_voices.heard(), SoundVoices.MAX_VOICES)
	is_null(_voices.play(&"impact_wood", Vector3(0.0, 0.0, -90.0), -10.0), "a quiet one is refused")
	is_true(_voices.stolen >= 1)


func test_a_loop_that_gives_way_comes_back() -> void:
	var loop: SoundVoice = _voices.start_loop(&"turret_loop", _ear, Vector3(0.0, 0.0, -30.0))
	loop.gain_db = 0.0
	await run_frames(8)
	is_true(loop.slot >= 0)
	var others: Array[SoundVoice] = []
	for number: int in 60:
		others.append(_voices.play(&"impact_metal", Vector3(0.0, 0.0, -2.0)))
	equal(loop.slot, -1)
	for voice: SoundVoice in others:
		if voice != null:
			voice.stop()
	await run_frames(12)
	is_true(loop.slot >= 0, "it is heard again when there is room")


func test_what_a_pair_does_at_once_is_one_sound() -> void:
	for number: int in 20:
		_voices.play_merged(7, &"impact_wood", Vector3(0.0, 0.0, -3.0), -20.0 + number)
	equal(_voices.begun, 1)
	await run_frames(6)
	_voices.play_merged(7, &"impact_wood", Vector3(0.0, 0.0, -3.0), 0.0)
	equal(_voices.begun, 2, "after 50 ms it is another one")


func test_a_delayed_sound_waits() -> void:
	_voices.play(&"impact_wood", Vector3(0.0, 0.0, -3.0), 0.0, 1.0, 0.25)
	await run_frames(12)
	equal(_voices.begun, 0)
	await run_frames(8)
	equal(_voices.begun, 1)


func test_a_delayed_sound_that_would_not_be_heard_does_not_wait() -> void:
	is_null(_voices.play(&"impact_wood", Vector3(900.0, 0.0, 0.0), 0.0, 1.0, 0.25), "out of range")
	is_null(_voices.play(&"impact_wood", Vector3(0.0, 0.0, -3.0), -80.0, 1.0, 0.25), "too quiet")
	equal(_voices.refused, 2)


func test_the_least_of_those_that_wait_makes_room() -> void:
	var waiting: Array[SoundVoice] = []
	for number: int in WaitingSounds.MAX_WAITING:
		var gain: float = -30.0 + number * 0.01
		waiting.append(_voices.play(&"impact_wood", Vector3(0.0, 0.0, -3.0), gain, 1.0, 0.25))
	equal(_voices.refused, 0)
	not_null(_voices.play(&"impact_wood", Vector3(0.0, 0.0, -3.0), 0.0, 1.0, 0.25))
	is_true(waiting[0].is_over, "the first is the quietest")
	is_false(waiting[1].is_over)
	is_null(_voices.play(&"impact_wood", Vector3(0.0, 0.0, -3.0), -30.0, 1.0, 0.25))
	equal(_voices.refused, 2)


func test_a_loop_behind_a_wall_begins_muffled() -> void:
	var wall: StaticBody3D = _make_wall(Vector3(0.0, 0.0, -3.0))
	await physics_frames(3)
	var loop: SoundVoice = _voices.start_loop(&"rain_loop", null)
	loop.place = Vector3(0.0, 0.0, -6.0)
	loop.gain_db = 12.0
	var was_open: bool = false
	for _frame: int in 12:
		await run_frames(1)
		was_open = was_open or (loop.slot >= 0 and not loop.is_blocked)
	is_true(loop.slot >= 0)
	is_false(was_open, "it is muffled from its first frame on")
	wall.free()


func test_levels_follow_their_law_in_the_mix() -> void:
	var loop: SoundVoice = _voices.start_loop(&"rain_loop", null)
	loop.gain_db = -2.0
	var levels: PackedFloat32Array = []
	for away: float in [2.0, 20.0]:
		loop.place = Vector3(0.0, 0.0, -away)
		await _wait(0.4)
		_capture.clear()
		await _wait(0.7)
		levels.append(MixCapture.level_db(_capture.take()))
	var law: float = loop.cue.level_at(20.0) - loop.cue.level_at(2.0)
	almost_equal(levels[1] - levels[0], law, 1.0)


func test_a_wall_muffles() -> void:
	var loop: SoundVoice = _voices.start_loop(&"rain_loop", null)
	loop.place = Vector3(0.0, 0.0, -6.0)
	loop.gain_db = 12.0
	await _wait(0.4)
	_capture.clear()
	await _wait(0.6)
	var rate: float = AudioServer.get_mix_rate()
	var open: float = Figures.level_above_db(MixCapture.mono(_capture.take()), 1000.0, rate)
	var wall: StaticBody3D = _make_wall(Vector3(0.0, 0.0, -3.0))
	await physics_frames(3)
	await _wait(0.5)
	_capture.clear()
	await _wait(0.6)
	var shut: float = Figures.level_above_db(MixCapture.mono(_capture.take()), 1000.0, rate)
	is_true(loop.is_blocked)
	is_true(open - shut >= 12.0, "%.1f dB less above 1 kHz" % (open - shut))
	wall.free()


func test_the_mix_stays_below_full_scale() -> void:
	for number: int in 24:
		_voices.play(&"cannon_near", Vector3(number * 0.1, 0.0, -2.0))
	_capture.clear()
	await _wait(0.5)
	var peak: float = MixCapture.peak_db(_capture.take())
	is_true(peak > -12.0 and peak <= -1.0, "peak %.2f dBFS" % peak)


func test_what_comes_nearer_sounds_higher() -> void:
	var source: Node3D = Node3D.new()
	add_child(source)
	source.position = Vector3(0.0, 0.0, -60.0)
	var loop: SoundVoice = _voices.start_loop(&"turret_loop", source)
	loop.gain_db = 20.0
	for frame: int in 60:
		source.position.z += 30.0 / 60.0
		await run_frames(1)
	almost_equal(loop.recession, -30.0, 3.0)
	source.free()
	await run_frames(5)
	is_true(loop.is_over, "it ends with what it follows")


func _make_wall(p_at: Vector3) -> StaticBody3D:
	var wall: StaticBody3D = StaticBody3D.new()
	var shape: CollisionShape3D = CollisionShape3D.new()
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3(8.0, 4.0, 0.2)
	shape.shape = box
	wall.add_child(shape)
	wall.position = p_at
	add_child(wall)
	return wall


## The mixer runs in real time, tests do not.
func _wait(p_seconds: float) -> void:
	var end: int = Time.get_ticks_msec() + roundi(p_seconds * 1000.0)
	while Time.get_ticks_msec() < end:
		await run_frames(1)
		OS.delay_msec(4)
