extends "stage_case.gd"
## Joints of people turn only so far, if they are asked to.

const STANDING: Vector3 = Vector3(0.0, 3.0, 0.0)
const SHIN: int = 11
const THIGH: int = 10


func test_a_knee_bends_backwards_only_without_limits() -> void:
	for limited: bool in [false, true]:
		var player: Stage.Player = _soldier(limited)
		# The shin swung ahead, as no knee can.
		player.pose = func(time: float) -> PoseSample: return _bent(60.0 * minf(time, 1.0))
		await _stage.run(120)
		var angle: float = _knee_deg(player)
		if limited:
			is_true(absf(angle) < 25.0, "bent by %f deg" % angle)
		else:
			is_true(absf(angle) > 55.0, "bent by %f deg" % angle)
		_remove(player)


func test_what_people_can_do_is_not_hindered() -> void:
	var player: Stage.Player = _soldier(true)
	player.pose = func(time: float) -> PoseSample: return _bent(-90.0 * minf(time, 1.0))
	await _stage.run(120)
	is_true(player.worst_error_deg(_bent(-90.0)) < 3.0, "a knee")
	player.pose = func(time: float) -> PoseSample: return Stage.arms_pose(80.0, 80.0)
	await _stage.run(120)
	is_true(player.worst_error_deg(Stage.arms_pose(80.0, 80.0)) < 3.0, "hanging arms")


func test_a_limp_body_with_limits_lies_still() -> void:
	_stage.add_floor()
	var player: Stage.Player = _soldier(true)
	player.place = func(_time: float) -> Vector3: return Vector3(0.0, 1.03, 0.0)
	await _stage.run(10)
	player.ragdoll.motor.set_actuation(RagdollMotor.LIMP, &"", 0.2)
	await _stage.run(420)
	is_true(player.speed() < 0.3, "still moves with %f m/s" % player.speed())
	is_true(player.gap() < 0.03, "gap %f m" % player.gap())
	is_true(absf(_knee_deg(player)) < 160.0)


func test_arms_are_stopped_by_the_own_body_if_asked() -> void:
	for collides: bool in [false, true]:
		var player: Stage.Player = _stage.make_soldier(STANDING, RagdollMotor.ROOT_SOFT)
		player.ragdoll.self_collision = collides
		player.ragdoll.self_overlap = 1.0
		_stage.enter(player)
		# Both arms turned inwards by more than half a circle lie in the chest.
		player.pose = func(time: float) -> PoseSample:
			var angle: float = minf(time * 120.0, 170.0)
			return Stage.arms_pose(angle, angle)
		await _stage.run(180)
		var worst: float = player.worst_error_deg(Stage.arms_pose(170.0, 170.0))
		is_true(worst > 5.0 if collides else worst < 1.0, "off by %f deg" % worst)
		is_true(player.speed() < 0.5, "shakes with %f m/s" % player.speed())
		_remove(player)


func _soldier(p_limited: bool) -> Stage.Player:
	var player: Stage.Player = _stage.make_soldier(STANDING, RagdollMotor.ROOT_SOFT)
	player.ragdoll.anatomical_limits = p_limited
	_stage.enter(player)
	return player


func _remove(p_player: Stage.Player) -> void:
	_stage.players.erase(p_player)
	p_player.ragdoll.free()


## The left shin turned ahead, with its foot.
static func _bent(p_ahead_deg: float) -> PoseSample:
	var turn: Quaternion = Quaternion(Vector3.RIGHT, deg_to_rad(-p_ahead_deg))
	return Stage.reset_pose({&"LeftLowerLeg": turn, &"LeftFoot": turn})


static func _knee_deg(p_player: Stage.Player) -> float:
	var thigh: RagdollLimb = p_player.ragdoll.profile.find(&"LeftUpperLeg")
	var shin: RagdollLimb = p_player.ragdoll.profile.find(&"LeftLowerLeg")
	var still: Quaternion = thigh.reset_orientation.inverse() * shin.reset_orientation
	var now: Quaternion = (
		p_player.body(THIGH).basis.get_rotation_quaternion().inverse()
		* p_player.body(SHIN).basis.get_rotation_quaternion()
	)
	return rad_to_deg(now.angle_to(still))
