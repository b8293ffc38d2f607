extends "stage_case.gd"
## Every way to drive a ragdoll, switched while it runs.

const STANDING: Vector3 = Vector3(0.0, 3.0, 0.0)
const LEFT_HAND: int = 6
const RIGHT_HAND: int = 9
## Greatest error of a limb that swings slowly, deg, by mode.
const GOOD: Dictionary[RagdollMotor.Actuation, float] = {
	RagdollMotor.DIRECT_SET: 1.0,
	RagdollMotor.VELOCITY_MOTOR: 2.0,
	RagdollMotor.POSITION_MOTOR: 5.0,
	RagdollMotor.ANGULAR_MOTOR: 15.0,
}


func test_each_mode_follows_a_slow_swing_as_well_as_it_can() -> void:
	for mode: RagdollMotor.Actuation in GOOD:
		var player: Stage.Player = _swinging()
		player.ragdoll.motor.set_actuation(mode)
		await _stage.run(90)
		var error: float = player.worst_error_deg(_swing(_stage.time_s))
		is_true(error < GOOD[mode], "mode %d is off by %f deg" % [mode, error])
		_remove(player)


func test_modes_are_switched_while_it_runs() -> void:
	var player: Stage.Player = _swinging()
	await _stage.run(30)
	var fastest: Array[float] = [0.0]
	var note: Callable = func(_time: float) -> void: fastest[0] = maxf(fastest[0], player.speed())
	for mode: RagdollMotor.Actuation in [1, 3, 0, 4, 2, 3, 4, 0, 3, 5, 3]:
		player.ragdoll.motor.set_actuation(mode)
		equal(player.ragdoll.motor.get_actuation(), mode)
		await _stage.run(10, note)
	await _stage.run(60, note)
	is_true(player.worst_error_deg(_swing(_stage.time_s)) < 2.0)
	is_true(fastest[0] < 12.0, "flung with %f m/s" % fastest[0])


func test_a_group_goes_limp_alone() -> void:
	var player: Stage.Player = _stage.add_soldier(STANDING, RagdollMotor.ROOT_SOFT)
	await _stage.run(20)
	player.ragdoll.motor.set_actuation(RagdollMotor.LIMP, &"left_arm")
	await _stage.run(150)
	is_true(player.error_deg(LEFT_HAND, Stage.reset_pose()) > 30.0, "the left arm hangs")
	is_true(player.error_deg(RIGHT_HAND, Stage.reset_pose()) < 2.0, "the right one does not")
	equal(player.ragdoll.motor.get_actuation(&"left_arm"), RagdollMotor.LIMP)
	equal(player.ragdoll.motor.get_actuation(&"right_arm"), RagdollMotor.VELOCITY_MOTOR)


func test_dies_and_gets_up() -> void:
	_stage.add_floor()
	var standing: Vector3 = Vector3(0.0, 1.03, 0.0)
	var player: Stage.Player = _stage.add_soldier(standing, RagdollMotor.ROOT_SOFT)
	await _stage.run(30)
	player.ragdoll.motor.set_actuation(RagdollMotor.LIMP, &"", 0.3)
	await _stage.run(240)
	is_true(player.joint(0).y < 0.5, "lies with its hips at %s" % player.joint(0))
	var fastest: Array[float] = [0.0]
	var note: Callable = func(_time: float) -> void: fastest[0] = maxf(fastest[0], player.speed())
	player.ragdoll.motor.set_actuation(RagdollMotor.VELOCITY_MOTOR, &"", 1.5)
	await _stage.run(240, note)
	is_true(player.worst_error_deg(Stage.reset_pose()) < 3.0)
	almost_equal(player.joint(0), standing, 0.03)
	is_true(fastest[0] < 9.0, "flung up with %f m/s" % fastest[0])


func test_a_held_person_gets_up_without_being_flung() -> void:
	_stage.add_floor()
	var standing: Vector3 = Vector3(0.0, 1.03, 0.0)
	var player: Stage.Player = _stage.add_soldier(standing, RagdollMotor.ROOT_HELD)
	await _stage.run(30)
	player.ragdoll.motor.set_actuation(RagdollMotor.LIMP)
	await _stage.run(180)
	var fastest: Array[float] = [0.0]
	var note: Callable = func(_time: float) -> void: fastest[0] = maxf(fastest[0], player.speed())
	player.ragdoll.motor.set_actuation(RagdollMotor.VELOCITY_MOTOR, &"", 1.5)
	await _stage.run(240, note)
	is_true(player.worst_error_deg(Stage.reset_pose()) < 1.0)
	almost_equal(player.joint(0), standing, 0.003)
	is_true(fastest[0] < 20.0, "flung up with %f m/s" % fastest[0])


func test_a_weakened_arm_sinks_and_comes_back() -> void:
	var player: Stage.Player = _stage.add_soldier(STANDING, RagdollMotor.ROOT_SOFT)
	await _stage.run(20)
	player.ragdoll.motor.set_group_strength(0.05, &"right_arm", 0.1)
	await _stage.run(60)
	is_true(player.error_deg(RIGHT_HAND, Stage.reset_pose()) > 5.0)
	player.ragdoll.motor.set_group_strength(1.0, &"right_arm", 0.5)
	await _stage.run(90)
	is_true(player.error_deg(RIGHT_HAND, Stage.reset_pose()) < 1.0)


func test_an_arm_that_is_put_cannot_be_held_up() -> void:
	var player: Stage.Player = _stage.add_soldier(STANDING, RagdollMotor.ROOT_SOFT)
	player.pose = func(time: float) -> PoseSample:
		return Stage.arms_pose(60.0 * minf(time, 1.0), 0.0)
	var shelf: Block = Block.new()
	shelf.size = Vector3(4.0, 0.1, 4.0)
	shelf.position = STANDING + Vector3(2.4, 0.25, 0.0)
	_stage.add_child(shelf)
	player.ragdoll.motor.set_actuation(RagdollMotor.DIRECT_SET, &"left_arm")
	await _stage.run(90)
	is_true(player.error_deg(LEFT_HAND, Stage.arms_pose(60.0, 0.0)) < 1.0, "through the shelf")
	player.ragdoll.motor.set_actuation(RagdollMotor.VELOCITY_MOTOR, &"left_arm")
	await _stage.run(90)
	is_true(player.gap() < 0.05, "gap %f m" % player.gap())


func test_limbs_that_are_put_do_not_drag_the_others() -> void:
	_stage.add_floor()
	# High enough that no foot touches the floor when it is up again: friction may hold legs there.
	var player: Stage.Player = _stage.add_soldier(Vector3(0.0, 1.08, 0.0), RagdollMotor.ROOT_SOFT)
	player.pose = _swing
	await _stage.run(20)
	var fastest: Array[float] = [0.0]
	var note: Callable = func(_time: float) -> void: fastest[0] = maxf(fastest[0], player.speed())
	player.ragdoll.motor.set_actuation(RagdollMotor.DIRECT_SET, &"left_arm")
	player.ragdoll.motor.set_actuation(RagdollMotor.DIRECT_SET, &"right_leg")
	await _stage.run(120, note)
	is_true(player.worst_error_deg(_swing(_stage.time_s)) < 2.0)
	is_true(player.gap() < 0.02, "gap %f m" % player.gap())
	for group: StringName in [&"trunk", &"head", &"right_arm", &"left_leg"]:
		player.ragdoll.motor.set_actuation(RagdollMotor.LIMP, group)
	await _stage.run(240, note)
	is_true(player.joint(0).y < 0.6, "falls, and does not fly: %s" % player.joint(0))
	is_true(player.joint(0).length() < 2.0, "lies at %s" % player.joint(0))
	is_true(fastest[0] < 12.0, "flung with %f m/s" % fastest[0])
	player.ragdoll.motor.set_actuation(RagdollMotor.VELOCITY_MOTOR, &"", 1.0)
	await _stage.run(300, note)
	is_true(player.worst_error_deg(_swing(_stage.time_s)) < 3.0)
	is_true(player.gap() < 0.02, "gap %f m" % player.gap())


func test_unknown_groups_and_values_are_named() -> void:
	var player: Stage.Player = _stage.add_soldier(STANDING, RagdollMotor.ROOT_SOFT)
	expect_error("the profile has no group tail")
	player.ragdoll.motor.set_actuation(RagdollMotor.LIMP, &"tail")
	expect_error("there is no such actuation")
	player.ragdoll.motor.set_actuation(99 as RagdollMotor.Actuation)
	expect_error("a strength is 0 or more")
	player.ragdoll.motor.set_group_strength(NAN)
	expect_error("there is no such root mode")
	player.ragdoll.motor.root_mode = 99 as RagdollMotor.RootMode
	var motor: RagdollMotor = RagdollMotor.new()
	expect_error("set_actuation() comes after setup()")
	motor.set_actuation(RagdollMotor.LIMP)
	is_false(motor.drive(0.0, 0.01))
	equal(motor.get_limb_errors().size(), 0)
	motor.free()
	await _stage.run(5)
	is_true(player.worst_error_deg(Stage.reset_pose()) < 1.0)


func test_one_call_drives_everybody() -> void:
	var motors: Array[RagdollMotor] = []
	var times: PackedFloat64Array = []
	for i: int in 3:
		var player: Stage.Player = _stage.add_soldier(
			STANDING + Vector3(3.0 * i, 0.0, 0.0), RagdollMotor.ROOT_SOFT
		)
		motors.append(player.ragdoll.motor)
		times.append(0.5)
		player.ragdoll.push_sample(0.5, Stage.arms_pose(30.0, 30.0), STANDING)
	equal(RagdollMotor.drive_all(motors, times, FastPhysics.DELTA), 3)
	motors.append(null)
	times.append(0.5)
	equal(RagdollMotor.drive_all(motors, times, FastPhysics.DELTA), 3)
	expect_error("one time for each motor")
	times.append(0.0)
	equal(RagdollMotor.drive_all(motors, times, FastPhysics.DELTA), 0)
	expect_error("the time step must be above zero")
	is_false(motors[0].drive(0.0, 0.0))


func test_tells_errors_torques_and_saturation_per_limb() -> void:
	var player: Stage.Player = _stage.add_soldier(STANDING, RagdollMotor.ROOT_SOFT)
	player.ragdoll.motor.measures_torque = true
	await _stage.run(90)
	var torques: PackedFloat32Array = player.ragdoll.motor.get_limb_torques()
	equal(torques.size(), Limbs.COUNT)
	# An arm of 4 kg, stretched out: its weight times half its length.
	var shoulder: int = player.index(4)
	is_true(torques[shoulder] > 6.0 and torques[shoulder] < 18.0, "%f N m" % torques[shoulder])
	var used: PackedFloat32Array = player.ragdoll.motor.get_limb_saturations()
	almost_equal(used[shoulder], torques[shoulder] / 120.0, 0.01)
	is_true(player.ragdoll.motor.get_limb_errors()[shoulder] < 0.02)


func _swinging() -> Stage.Player:
	var player: Stage.Player = _stage.add_soldier(STANDING, RagdollMotor.ROOT_SOFT)
	player.pose = _swing
	return player


func _remove(p_player: Stage.Player) -> void:
	_stage.players.erase(p_player)
	p_player.ragdoll.free()


static func _swing(p_time: float) -> PoseSample:
	return Stage.arms_pose(45.0 + 30.0 * sin(2.0 * p_time), 45.0 + 30.0 * sin(2.0 * p_time + 1.0))
