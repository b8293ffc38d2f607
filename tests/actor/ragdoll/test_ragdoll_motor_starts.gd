extends "stage_case.gd"
## Bodies that begin in the middle of a motion, or go on after a pause, are with it at once; bodies
## that fall from a great height stay on top of what they fall on.

const HIPS: Vector3 = Vector3(0.0, 1.03, 0.0)
const MODES: Array[RagdollMotor.RootMode] = [
	RagdollMotor.ROOT_GROUNDED,
	RagdollMotor.ROOT_SOFT,
	RagdollMotor.ROOT_HELD,
	RagdollMotor.ROOT_INERTIAL,
]
## A limb may be so far off, deg, from so long after the beginning on, s.
const LIMIT_DEG: float = 8.0
const SOON_S: float = 0.1


func test_who_begins_in_mid_motion_moves_along() -> void:
	for mode: RagdollMotor.RootMode in MODES:
		_clear_stage()
		_stage.add_floor()
		# The motion has been on its way for long when the body comes.
		_stage.time_s = 100.3
		var player: Stage.Player = _stage.add_soldier(HIPS, mode)
		player.pose = _wave
		await _follows(player, "begins, mode %d" % mode)


func test_who_goes_on_after_a_pause_moves_along() -> void:
	for mode: RagdollMotor.RootMode in MODES:
		for pause: float in [0.2, 0.6, 1.5]:
			_clear_stage()
			_stage.add_floor()
			var player: Stage.Player = _stage.add_soldier(HIPS, mode)
			player.pose = _wave
			await _stage.run(40)
			player.lost = func(_time: float) -> bool: return true
			await _stage.run(roundi(pause * 60.0))
			player.lost = Callable()
			await _follows(player, "goes on after %.1f s, mode %d" % [pause, mode])


func test_a_pause_takes_nobody_through_a_wall() -> void:
	_stage.add_floor()
	_stage.add_block(Vector3(6.0, 3.0, 0.1), Vector3(0.0, 1.5, 0.6))
	var player: Stage.Player = _stage.add_soldier(HIPS, RagdollMotor.ROOT_GROUNDED)
	await _stage.run(40)
	player.lost = func(_time: float) -> bool: return true
	await _stage.run(30)
	player.lost = Callable()
	player.place = func(_time: float) -> Vector3: return HIPS + Vector3(0.0, 0.0, 1.5)
	await _stage.run(60)
	is_true(player.joint(0).z < 0.6, "the hips are at %v" % player.joint(0))


func test_who_falls_from_50_m_stays_on_a_thin_floor() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 7
	var fallen: int = 0
	for i: int in 6:
		_clear_stage()
		_stage.add_block(Vector3(20.0, 0.1, 20.0), Vector3(0.0, -0.05, 0.0))
		var player: Stage.Player = _stage.add_soldier(HIPS + Vector3.UP, RagdollMotor.ROOT_GROUNDED)
		var axis: Vector3 = Vector3(random.randfn(), random.randfn(), random.randfn()).normalized()
		var turn: Quaternion = Quaternion(axis, random.randf() * TAU)
		player.pose = func(_time: float) -> PoseSample:
			return Stage.reset_pose({&"Hips": turn, &"LeftUpperArm": turn, &"RightUpperLeg": turn})
		await _stage.run(6)
		if i % 2 == 0:
			player.ragdoll.motor.set_actuation(RagdollMotor.LIMP)
		for body: RID in player.ragdoll.get_bodies():
			PhysicsServer3D.body_set_state(
				body,
				PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY,
				Vector3.DOWN * sqrt(2.0 * 9.81 * 50.0)
			)
		await _stage.run(120)
		for limb: PhysicsBody3D in player.ragdoll.get_limb_nodes():
			fallen += 1 if limb.global_position.y < 0.0 else 0
	equal(fallen, 0)


func _follows(p_player: Stage.Player, p_what: String) -> void:
	var worst: Array[float] = [0.0]
	var since: float = _stage.time_s
	await _stage.run(
		40,
		func(time: float) -> void:
			if time > since + SOON_S - 1e-3:
				worst[0] = maxf(worst[0], p_player.worst_error_deg(_wave(time)))
	)
	is_true(worst[0] < LIMIT_DEG, "%s: %.1f deg off" % [p_what, worst[0]])


## Arms that swing with 4 rad/s and more.
static func _wave(p_time: float) -> PoseSample:
	return Stage.arms_pose(20.0 + 50.0 * sin(5.0 * p_time), 20.0 + 50.0 * cos(5.0 * p_time))
