extends "sound_case.gd"
## Guns are heard late by the way of their sound; far ones by their far takes.


func test_a_gun_at_343_m_is_heard_after_a_second() -> void:
	ShotSounds.play_blast(_voices, "cannon", Vector3(0.0, 0.0, -343.0))
	await run_frames(57)
	equal(_voices.begun, 0)
	await run_frames(6)
	equal(_voices.begun, 2, "between near and far both takes are heard")


func test_a_shot_that_is_past_is_heard_sooner() -> void:
	ShotSounds.play_blast(_voices, "cannon", Vector3(0.0, 0.0, -34.3), 0.1)
	equal(_voices.begun, 1)


func test_far_away_only_the_far_take_is_heard() -> void:
	ShotSounds.play_blast(_voices, "explosion", Vector3(0.0, 0.0, -450.0), 10.0)
	equal(_voices.begun, 1)
