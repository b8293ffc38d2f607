extends "res://tests/audio/sound_case.gd"
## Doors creak and fall shut as they are displayed.

const STEP_S: float = 1.0 / 60.0

var _level: Level = null
var _door: Door = null
var _sounds: DoorSounds = null


func before_each() -> void:
	await super()
	_level = (load("res://scenes/world/yard/yard.tscn") as PackedScene).instantiate()
	_door = Door.new()
	_door.position = Vector3(0.0, 0.0, -3.0)
	_door.freeze = true
	_level.add_child(_door)
	add_child(_level)
	_sounds = DoorSounds.new(_voices)
	_sounds.take_level(_level)
	await process_frames(2)


func after_each() -> void:
	_sounds = null
	await super()
	_level.free()


func test_a_door_that_stands_is_silent() -> void:
	_turn(40.0, 40.0, 30)
	equal(_voices.begun, 0)


func test_a_door_that_falls_shut_is_heard() -> void:
	_turn(60.0, 0.0, 20)
	equal(_voices.begun, 1)


func test_a_slow_door_creaks_once() -> void:
	_turn(20.0, 40.0, 40)
	equal(_voices.begun, 1)


func _turn(p_from: float, p_to: float, p_frames: int) -> void:
	for frame: int in p_frames + 1:
		_door.rotation.y = deg_to_rad(lerpf(p_from, p_to, float(frame) / p_frames))
		_sounds.advance(STEP_S)
