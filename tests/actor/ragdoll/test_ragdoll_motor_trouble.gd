extends "stage_case.gd"
## What the real world does to a stream of motion, and to a body: never an explosion.

const STANDING: Vector3 = Vector3(0.0, 3.0, 0.0)
const SOFT: RagdollMotor.RootMode = RagdollMotor.ROOT_SOFT

var _fastest: float = 0.0


func before_each() -> void:
	super()
	_fastest = 0.0


func test_jitter_and_loss_do_not_shake_it() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 5
	var player: Stage.Player = _player()
	player.pose = _swing
	player.lost = func(_time: float) -> bool: return random.randf() < 0.02
	player.jitter = func() -> float: return random.randf_range(-0.004, 0.004)
	await _stage.run(300, _note.bind(player))
	is_true(player.worst_error_deg(_swing(_stage.time_s)) < 4.0)
	is_true(_fastest < 6.0, "flung with %f m/s" % _fastest)


func test_a_stall_lets_it_hold_still_and_give_way() -> void:
	var player: Stage.Player = _player()
	player.pose = _swing
	await _stage.run(60)
	var last: PoseSample = _swing(_stage.time_s)
	player.lost = func(_time: float) -> bool: return true
	await _stage.run(18, _note.bind(player))
	await _stage.run(60, _note.bind(player))
	is_true(player.worst_error_deg(last) < 5.0, "holds the last pose")
	is_true(player.speed() < 0.05, "still moves with %f m/s" % player.speed())
	player.lost = Callable()
	await _stage.run(40, _note.bind(player))
	is_true(player.worst_error_deg(_swing(_stage.time_s)) < 3.0, "follows again")
	is_true(_fastest < 6.0, "flung with %f m/s" % _fastest)


func test_half_turns_and_signs_are_taken_calmly() -> void:
	var player: Stage.Player = _player()
	player.pose = func(time: float) -> PoseSample:
		var flipped: bool = int(time * 3.0) % 2 == 1
		var turn: Quaternion = Quaternion(Vector3.UP, PI) if flipped else Quaternion.IDENTITY
		var pose: PoseSample = Stage.reset_pose({&"LeftLowerArm": turn, &"Head": turn})
		for limb: int in Limbs.COUNT:
			# q and -q are the same rotation.
			if int(time * 60.0) % 2 == 1:
				pose.set_orientation(limb, -pose.orientation(limb))
		return pose
	await _stage.run(240, _note.bind(player))
	is_true(_fastest < 15.0, "flung with %f m/s" % _fastest)
	is_true(player.gap() < 0.05, "gap %f m" % player.gap())
	player.pose = func(_time: float) -> PoseSample: return Stage.reset_pose()
	await _stage.run(120)
	is_true(player.worst_error_deg(Stage.reset_pose()) < 1.0)


func test_a_teleport_puts_it_there() -> void:
	var player: Stage.Player = _player()
	await _stage.run(30)
	player.place = func(_time: float) -> Vector3: return STANDING + Vector3(20.0, 0.0, 5.0)
	await _stage.run(10, _note.bind(player))
	almost_equal(player.joint(0), STANDING + Vector3(20.0, 0.0, 5.0), 0.03)
	is_true(_fastest < 2.0, "flung with %f m/s" % _fastest)


func test_the_guard_stops_an_explosion_and_says_so() -> void:
	var player: Stage.Player = _player()
	await _stage.run(30)
	var actions: Array[int] = [0]
	player.ragdoll.motor.guard_acted.connect(func(flags: int) -> void: actions[0] |= flags)
	for rid: RID in player.ragdoll.get_bodies():
		PhysicsServer3D.body_set_state(
			rid,
			PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY,
			Vector3(900.0, -500.0, 300.0) * (1.0 if rid.get_id() % 2 == 0 else -1.0)
		)
	await _stage.run(60)
	is_true(actions[0] & RagdollMotor.GUARD_ENERGY != 0, "flags %d" % actions[0])
	await _stage.run(360)
	is_true(player.worst_error_deg(Stage.reset_pose()) < 1.0)
	almost_equal(player.joint(0), STANDING, 0.01)
	is_true(player.gap() < 0.01)


func test_a_crate_on_the_head_does_no_harm() -> void:
	_stage.add_floor()
	var height: Vector3 = Vector3(0.0, 1.03, 0.0)
	var player: Stage.Player = _stage.add_soldier(height, SOFT)
	await _stage.run(30)
	var crate: RigidBody3D = preload("res://scenes/world/props/crate.tscn").instantiate()
	crate.mass = 40.0
	crate.position = Vector3(0.1, 4.0, 0.05)
	_stage.add_child(crate)
	await _stage.run(240, _note.bind(player))
	is_true(_fastest < 15.0, "flung with %f m/s" % _fastest)
	is_true(player.worst_error_deg(Stage.reset_pose()) < 3.0)
	is_true(player.gap() < 0.02)


func test_a_saved_state_is_restored_and_goes_on_the_same() -> void:
	for on_floor: bool in [false, true]:
		await _restore_twice(on_floor)


func test_damaged_states_are_refused() -> void:
	var player: Stage.Player = _player()
	await _stage.run(20)
	var saved: PackedByteArray = player.ragdoll.motor.save_state()
	expect_error("the saved state is cut off")
	is_false(player.ragdoll.motor.restore_state(PackedByteArray()))
	for _round: int in 20:
		var damaged: PackedByteArray = saved.duplicate()
		damaged[randi() % damaged.size()] ^= 1 << (randi() % 8)
		expect_error("the saved state is damaged")
		is_false(player.ragdoll.motor.restore_state(damaged))
	expect_error("the saved state is damaged")
	is_false(player.ragdoll.motor.restore_state(saved.slice(0, saved.size() / 2)))
	await _stage.run(20)
	is_true(player.worst_error_deg(Stage.reset_pose()) < 1.0)


func _player() -> Stage.Player:
	return _stage.add_soldier(STANDING, SOFT)


func _note(_p_time: float, p_player: Stage.Player) -> void:
	_fastest = maxf(_fastest, p_player.speed())


static func _swing(p_time: float) -> PoseSample:
	return Stage.arms_pose(45.0 + 40.0 * sin(3.0 * p_time), 45.0 + 40.0 * sin(3.0 * p_time + 1.0))


func _restore_twice(p_on_floor: bool) -> void:
	_clear_stage()
	var player: Stage.Player = _player()
	if p_on_floor:
		_stage.add_floor()
		player.place = func(_time: float) -> Vector3: return STANDING + Vector3.DOWN * 0.03
	player.pose = _swing
	await _stage.run(60)
	var saved: PackedByteArray = player.ragdoll.motor.save_state()
	var at: float = _stage.time_s
	var hashes: Array[int] = []
	for _round: int in 2:
		is_true(player.ragdoll.motor.restore_state(saved))
		_stage.time_s = at
		await _stage.run(45)
		hashes.append(player.ragdoll.motor.get_state_hash())
	equal(hashes[0], hashes[1])
	is_true(player.worst_error_deg(_swing(_stage.time_s)) < 2.0)
