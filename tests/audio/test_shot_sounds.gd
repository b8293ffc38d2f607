extends TestCase
## Guns are heard late by the way of their sound; far ones by their far takes.

var _voices: SoundVoices = null


func before_each() -> void:
	_voices = SoundVoices.new()
	add_child(_voices)
	_voices.listener = _voices
	await process_frames(1)


func after_each() -> void:
	_voices.stop_all()
	await process_frames(4)
	# The mixer, which runs in real time, lets go of what has stopped.
	OS.delay_msec(120)
	await process_frames(2)
	_voices.free()
	SoundBank.clear()


func test_a_gun_at_343_m_is_heard_after_a_second() -> void:
	ShotSounds.play_blast(_voices, "cannon", Vector3(0.0, 0.0, -343.0))
	await _frames(57)
	equal(_voices.begun, 0)
	await _frames(6)
	equal(_voices.begun, 2, "between near and far both takes are heard")


func test_a_shot_that_is_past_is_heard_sooner() -> void:
	ShotSounds.play_blast(_voices, "cannon", Vector3(0.0, 0.0, -34.3), 0.1)
	equal(_voices.begun, 1)


func test_far_away_only_the_far_take_is_heard() -> void:
	ShotSounds.play_blast(_voices, "explosion", Vector3(0.0, 0.0, -450.0), 10.0)
	equal(_voices.begun, 1)


## Runs so many frames of a sixtieth of a second: the machine's own may be of any length.
func _frames(p_count: int) -> void:
	_voices.set_process(false)
	for _frame: int in p_count:
		_voices._process(1.0 / 60.0)
		await process_frames(1)
	_voices.set_process(true)
