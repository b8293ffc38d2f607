extends "res://tests/audio/sound_case.gd"
## What is heard of a vehicle follows its state.

var _vehicle: Vehicle = null
var _sound: VehicleSound = null


func before_each() -> void:
	await super()
	_vehicle = Vehicle.new()
	_vehicle.freeze = true
	_vehicle.process_mode = Node.PROCESS_MODE_DISABLED
	_vehicle.position = Vector3(0.0, 0.0, -12.0)
	add_child(_vehicle)
	_sound = VehicleSound.new()
	_sound.vehicle = _vehicle
	add_child(_sound)
	await process_frames(2)


func after_each() -> void:
	_sound.free()
	_vehicle.free()
	await super()


func others() -> Array[Node]:
	return [_sound]


func test_a_vehicle_at_rest_is_silent() -> void:
	await run_frames(20)
	equal(_voices.heard(), 0)


func test_the_engine_is_heard_at_its_revolutions() -> void:
	_vehicle.state.engine_on = true
	_vehicle.state.rpm = 1500.0
	await run_frames(60)
	is_true(_voices.heard() >= 2)
	almost_equal(_sound.heard_rpm(), 1500.0, 5.0)
	_vehicle.state.engine_on = false
	await run_frames(60)
	equal(_voices.heard(), 0)


func test_tracks_and_turret_are_heard_while_they_move() -> void:
	_vehicle.state.left_speed = 5.0
	_vehicle.state.right_speed = 5.0
	await run_frames(20)
	var rolling: int = _voices.heard()
	is_true(rolling >= 2, "%d voices" % rolling)
	for frame: int in 30:
		_vehicle.state.turret_yaw += 0.01
		await run_frames(1)
	equal(_voices.heard(), rolling + 1)
	_vehicle.state.left_speed = 0.0
	_vehicle.state.right_speed = 0.0
	await run_frames(60)
	equal(_voices.heard(), 0)


func test_it_ends_with_its_vehicle() -> void:
	_vehicle.state.engine_on = true
	_vehicle.state.rpm = 1000.0
	await run_frames(30)
	is_true(_voices.heard() > 0)
	_sound.stop()
	await run_frames(4)
	equal(_voices.heard(), 0)


func test_the_vehicles_of_the_program_have_it() -> void:
	for name: String in ["tank", "carrier", "truck", "scootmobile"]:
		var scene: Node = (
			(load("res://scenes/vehicle/%s/%s.tscn" % [name, name]) as PackedScene).instantiate()
		)
		var sound: VehicleSound = scene.get_node("Sound") as VehicleSound
		not_null(sound, name)
		equal(Array(sound._get_configuration_warnings()), [], name)
		scene.free()


func test_a_gun_that_is_loaded_is_heard() -> void:
	var gun: VehicleGun = VehicleGun.new()
	_vehicle.add_child(gun)
	_sound.gun = gun
	gun.loaded = 0.4
	await run_frames(3)
	var before: int = _voices.begun
	gun.loaded = 1.0
	await run_frames(3)
	equal(_voices.begun, before + 1)
