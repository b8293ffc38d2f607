extends TestCase
## Wheels of vehicles on tyres roll, steer and follow the ground.

const STEP: float = 1.0 / 60.0
const NAMES: Array[String] = ["tank", "carrier", "truck", "scootmobile"]


func test_all_presets_are_shown() -> void:
	for name: String in NAMES:
		var view: VehicleView = _make(name)
		view.state.left_speed = 3.0
		view.state.right_speed = 3.0
		view.state.engine_on = true
		view.state.rpm = 1500.0
		for _count: int in 60:
			view.advance(STEP, 5.0)
		almost_equal(view.way_of(0), 3.0, 0.01, name)
		almost_equal(view.way_of(1), 3.0, 0.01, name)
		view.advance(STEP, 200.0)
		view.queue_free()


func test_wheels_roll_with_the_way_of_their_side() -> void:
	var view: VehicleView = _make("truck")
	var wheel: Node3D = view.find_part("Wheel_R2")
	var rest: Basis = wheel.basis
	var radius: float = 0.47
	view.state.right_speed = radius * TAU / 4.0
	for _count: int in 60:
		view.advance(STEP, 5.0)
	# A quarter of a turn: what was on top is now in front.
	var top: Vector3 = wheel.basis * (rest.inverse() * Vector3.UP)
	almost_equal(top.z, -1.0, 0.05, "%s" % top)
	almost_equal(view.way_of(0), 0.0, 1e-6, "the other side stands")


func test_front_wheels_steering_wheel_and_handlebar_turn() -> void:
	var truck: VehicleView = _make("truck")
	var front: Node3D = truck.find_part("Wheel_R1")
	var rear: Node3D = truck.find_part("Wheel_R2")
	truck.state.steer = 0.4
	truck.advance(STEP, 5.0)
	# Its axle points to the right and, turned to the left, forward.
	almost_equal(front.basis.x.z, -sin(0.4), 0.01)
	almost_equal(rear.basis.x.z, 0.0, 0.01)
	var scootmobile: VehicleView = _make("scootmobile")
	scootmobile.state.steer = 0.4
	scootmobile.advance(STEP, 5.0)
	var handle: Vector3 = scootmobile.find_part("HandleLeft").global_position
	var other: Vector3 = scootmobile.find_part("HandleRight").global_position
	is_true(handle.z > other.z + 0.1, "to the left: the left handle comes back")


func test_springs_follow_the_ground() -> void:
	var ground: Block = Block.new()
	ground.size = Vector3(40.0, 1.0, 40.0)
	ground.position.y = -0.5
	add_child(ground)
	var bump: Block = Block.new()
	bump.size = Vector3(4.0, 0.08, 4.0)
	bump.position = Vector3(3.0, 0.04, -1.65)
	add_child(bump)
	var view: VehicleView = _make("truck")
	view.position.x = 0.5
	await physics_frames(2)
	for _count: int in 60:
		view.advance(STEP, 5.0)
	almost_equal(view.find_part("Wheel_R1").position.y, 0.47 + 0.08, 0.015, "on the bump")
	almost_equal(view.find_part("Wheel_L2").position.y, 0.47, 0.015, "beside it")


func _make(p_name: String) -> VehicleView:
	var file: String = "res://scenes/vehicle/%s/%s_view.tscn" % [p_name, p_name]
	var view: VehicleView = (load(file) as PackedScene).instantiate()
	add_child(view)
	view.set_process(false)
	return view
