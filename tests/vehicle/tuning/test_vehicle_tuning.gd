extends TestCase
## The scene in which vehicles are tuned: it drives, plots, and changes parameters while it runs.

var _scene: VehicleTuning = null


func before_each() -> void:
	_scene = (load("res://scenes/vehicle/tuning.tscn") as PackedScene).instantiate()
	add_child(_scene)


func test_it_plots_what_the_vehicle_does() -> void:
	_scene.vehicle.input.throttle = 1.0
	await physics_frames(120)
	var plots: VehiclePlots = _scene.get_node(^"Overlay/Plots")
	is_true(plots.strip(&"rpm").newest(0) > 900.0)
	is_true(plots.strip(&"speed").newest(0) > 1.0)
	almost_equal(plots.strip(&"speed").newest(0), _scene.vehicle.state.left_speed, 0.2)
	var springs: float = 0.0
	for wheel: int in 5:
		springs += plots.strip(&"springs_left").newest(wheel)
	is_true(springs > 150.0, "%.0f kN" % springs)


func test_every_preset_can_be_chosen() -> void:
	for preset: String in VehicleTuning.PRESETS:
		_scene.choose(preset)
		await physics_frames(40)
		equal(_scene.vehicle.fault, "", preset)
		is_true(_scene.vehicle.global_position.y > -0.2, preset)


func test_a_changed_parameter_applies_at_once_and_leaves_the_preset_alone() -> void:
	await physics_frames(30)
	_scene.change(&"steering_pivot_speed", 0.3)
	_scene.vehicle.input.steer = 1.0
	await physics_frames(120)
	is_true(_scene.vehicle.state.right_speed < 0.45, "%.2f" % _scene.vehicle.state.right_speed)
	is_true(_scene.vehicle.state.right_speed > 0.1, "%.2f" % _scene.vehicle.state.right_speed)
	var preset: VehicleParameters = load("res://scenes/vehicle/tank/tank_parameters.tres")
	is_true(preset.steering_pivot_speed > 0.5)
