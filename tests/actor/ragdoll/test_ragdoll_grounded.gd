extends "stage_case.gd"
## People who stand on their own feet: what carries them, pushes, falls, ground that is not level.

const GROUNDED: RagdollMotor.RootMode = RagdollMotor.ROOT_GROUNDED
const HEIGHT: Vector3 = Vector3(0.0, 1.03, 0.0)
const CHEST: int = 2
const LEFT_FOOT: int = 12
const RIGHT_FOOT: int = 15


func test_the_floor_carries_a_standing_person() -> void:
	var scale: RigidBody3D = _add_scale()
	_stage.add_soldier(HEIGHT, GROUNDED)
	await _stage.run(60)
	PhysicsServer3D.body_set_state(
		scale.get_rid(), PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY, Vector3.ZERO
	)
	var sum: Array[float] = [0.0]
	await _stage.run(
		120,
		func(_time: float) -> void:
			var rid: RID = scale.get_rid()
			var velocity: Vector3 = PhysicsServer3D.body_get_state(
				rid, PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY
			)
			sum[0] -= velocity.y * scale.mass * 60.0 / 120.0
			PhysicsServer3D.body_set_state(
				rid, PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY, Vector3.ZERO
			)
	)
	almost_equal(sum[0] / (80.0 * 9.8), 1.0, 0.05)


func test_a_light_push_makes_it_lean_and_come_back() -> void:
	var player: Stage.Player = await _push(40.0)
	var seen: Dictionary = await _watch(player)
	is_true(seen.far > 0.03, "the chest moves by %f m" % seen.far)
	is_false(seen.phases.has(RagdollMotor.BALANCE_FALLING), "it falls")
	is_true(player.worst_error_deg(Stage.reset_pose()) < 5.0, "it is upright again")


func test_it_flinches_from_a_ball_and_comes_back() -> void:
	_stage.add_floor()
	var player: Stage.Player = _stage.add_soldier(HEIGHT, GROUNDED)
	await _stage.run(90)
	var ball: RigidBody3D = RigidBody3D.new()
	var shape: CollisionShape3D = CollisionShape3D.new()
	shape.shape = SphereShape3D.new()
	(shape.shape as SphereShape3D).radius = 0.11
	ball.add_child(shape)
	ball.mass = 5.0
	ball.collision_layer = PhysicsLayers.PROPS
	ball.collision_mask = PhysicsLayers.ALL
	ball.position = player.joint(CHEST) + Vector3(0.0, 0.2, 0.8)
	ball.linear_velocity = Vector3.FORWARD * 10.0
	_stage.add_child(ball)
	var most: Array[float] = [0.0]
	await _stage.run(
		120,
		func(_time: float) -> void:
			most[0] = maxf(most[0], player.error_deg(CHEST, Stage.reset_pose()))
	)
	is_true(most[0] > 6.0 and most[0] < 25.0, "the chest turns by %f deg" % most[0])
	is_true(player.error_deg(CHEST, Stage.reset_pose()) < 2.0, "it is back")


func test_hands_that_lean_on_walls_come_to_rest() -> void:
	_stage.add_floor()
	var player: Stage.Player = _stage.add_soldier(HEIGHT, GROUNDED)
	await _stage.run(60)
	# Both hands are 5 cm into what is there.
	var tip: float = player.joint(Limbs.LEFT_HAND).x + 0.17
	for side: float in [-1.0, 1.0]:
		_stage.add_block(Vector3(0.2, 4.0, 4.0), Vector3(side * (tip - 0.05 + 0.1), 2.0, 0.0))
	await _stage.run(180)
	var squares: Dictionary[int, float] = {CHEST: 0.0, Limbs.LEFT_HAND: 0.0, Limbs.RIGHT_HAND: 0.0}
	await _stage.run(
		120,
		func(_time: float) -> void:
			for limb: int in squares:
				var rid: RID = player.ragdoll.get_bodies()[player.index(limb)]
				var turning: Vector3 = PhysicsServer3D.body_get_state(
					rid, PhysicsServer3D.BODY_STATE_ANGULAR_VELOCITY
				)
				squares[limb] += turning.length_squared() / 120.0
	)
	for limb: int in squares:
		var speed: float = rad_to_deg(sqrt(squares[limb]))
		is_true(speed < 2.0, "limb %d turns by %f deg/s" % [limb, speed])


func test_a_push_makes_it_step() -> void:
	var player: Stage.Player = await _push(80.0)
	var seen: Dictionary = await _watch(player)
	is_true(seen.steps > 0, "it takes no step")
	is_false(seen.phases.has(RagdollMotor.BALANCE_FALLING), "it falls")
	is_true(player.worst_error_deg(Stage.reset_pose()) < 5.0, "it is upright again")


func test_a_blow_fells_it_and_it_gets_up() -> void:
	var player: Stage.Player = await _push(160.0)
	var seen: Dictionary = await _watch(player)
	is_true(seen.low < 0.5, "the hips are at %f m at the lowest" % seen.low)
	equal(
		seen.phases,
		[
			RagdollMotor.BALANCE_STANDING,
			RagdollMotor.BALANCE_FALLING,
			RagdollMotor.BALANCE_TUCKING,
			RagdollMotor.BALANCE_ROLLING,
			RagdollMotor.BALANCE_RISING,
			RagdollMotor.BALANCE_STANDING,
		]
	)
	almost_equal(player.joint(0).y, HEIGHT.y, 0.05)
	is_true(player.worst_error_deg(Stage.reset_pose()) < 5.0, "it is upright again")


func test_nothing_lifts_it_off_lower_ground() -> void:
	_stage.add_floor()
	# The motion is 0.3 m higher than what there is to stand on.
	var player: Stage.Player = _stage.add_soldier(HEIGHT + Vector3.UP * 0.3, GROUNDED)
	await _stage.run(120)
	almost_equal(player.joint(0).y, HEIGHT.y, 0.05)


func test_who_drops_from_high_stands_on_the_ground_at_last() -> void:
	_stage.add_floor()
	var step: Block = Block.new()
	step.size = Vector3(0.5, 0.2, 1.0)
	step.position = Vector3(0.27, 0.05, 2.0)
	_stage.add_child(step)
	var player: Stage.Player = _stage.add_soldier(HEIGHT + Vector3.UP * 3.0, GROUNDED)
	await _stage.run(420)
	almost_equal(player.joint(0).y, HEIGHT.y, 0.05)
	is_true(player.worst_error_deg(Stage.reset_pose()) < 5.0, "it is upright")


func test_who_is_carried_in_a_frame_stays_in_it() -> void:
	for speed: float in [0.3, 5.0]:
		_clear_stage()
		var platform: AnimatableBody3D = _add_platform()
		var player: Stage.Player = _stage.make_soldier(HEIGHT, GROUNDED)
		var ragdoll: Ragdoll = player.ragdoll
		player.place = func(time: float) -> Vector3:
			var at: Vector3 = Vector3.RIGHT * speed * time
			platform.position = at + Vector3.DOWN * 0.5
			ragdoll.motor.set_frame(Transform3D(Basis.IDENTITY, at))
			return HEIGHT
		_stage.enter(player)
		await _stage.run(300)
		var balance: Dictionary = player.ragdoll.motor.get_balance()
		var tether: Vector3 = balance.offset_m
		is_true(Vector2(tether.x, tether.z).length() < 0.15, "%f m/s: %s" % [speed, balance])
		equal(balance.phase, RagdollMotor.BALANCE_STANDING)
		almost_equal(player.joint(0).y, HEIGHT.y, 0.05)


func test_a_platform_takes_along_who_stands_on_it() -> void:
	var platform: AnimatableBody3D = _add_platform()
	var player: Stage.Player = _stage.make_soldier(HEIGHT, GROUNDED)
	player.place = func(time: float) -> Vector3:
		platform.position = Vector3(maxf(time - 1.0, 0.0) * 1.0, -0.5, 0.0)
		return HEIGHT
	_stage.enter(player)
	await _stage.run(300)
	almost_equal(player.joint(0).x, platform.position.x, 0.15)
	almost_equal(player.joint(0).y, HEIGHT.y, 0.05)


func test_it_stands_with_one_foot_on_a_step() -> void:
	_stage.add_floor()
	var step: Block = Block.new()
	step.size = Vector3(0.5, 0.2, 1.0)
	step.position = Vector3(0.27, 0.05, 0.0)
	_stage.add_child(step)
	var player: Stage.Player = _stage.add_soldier(HEIGHT + Vector3.UP * 0.15, GROUNDED)
	await _stage.run(180)
	var higher: float = player.joint(LEFT_FOOT).y - player.joint(RIGHT_FOOT).y
	almost_equal(higher, 0.15, 0.03)
	is_true(player.error_deg(CHEST, Stage.reset_pose()) < 5.0, "it stands upright")


func test_balance_is_told_of_grounded_people_only() -> void:
	_stage.add_floor()
	var player: Stage.Player = _stage.add_soldier(HEIGHT, GROUNDED)
	await _stage.run(30)
	var balance: Dictionary = player.ragdoll.motor.get_balance()
	is_true(balance.force_n <= balance.force_limit_n + 0.01, "%s" % balance)
	almost_equal(balance.force_limit_n, 0.06 * 80.0 * 9.8, 1.0)
	is_true(balance.torque_nm > 0.1 and balance.torque_nm < 1386.0, "%s" % balance)
	player.ragdoll.motor.root_mode = RagdollMotor.ROOT_SOFT
	is_true(player.ragdoll.motor.get_balance().is_empty(), "another mode has a balance")


func _push(p_impulse: float) -> Stage.Player:
	_stage.add_floor()
	var player: Stage.Player = _stage.add_soldier(HEIGHT, GROUNDED)
	await _stage.run(60)
	var chest: RID = player.ragdoll.get_bodies()[player.index(CHEST)]
	PhysicsServer3D.body_apply_central_impulse(chest, Vector3.BACK * p_impulse)
	return player


## What happens within the next five seconds.
func _watch(p_player: Stage.Player) -> Dictionary:
	var start: Vector3 = p_player.joint(CHEST)
	var seen: Dictionary = {"far": 0.0, "low": 9.0, "steps": 0, "phases": []}
	await _stage.run(
		300,
		func(_time: float) -> void:
			var balance: Dictionary = p_player.ragdoll.motor.get_balance()
			seen.far = maxf(seen.far, p_player.joint(CHEST).z - start.z)
			seen.low = minf(seen.low, p_player.joint(0).y)
			seen.steps += 1 if balance.is_stepping else 0
			if seen.phases.is_empty() or seen.phases[-1] != balance.phase:
				seen.phases.append(balance.phase)
	)
	return seen


## A floor that is moved.
func _add_platform() -> AnimatableBody3D:
	var platform: AnimatableBody3D = AnimatableBody3D.new()
	platform.sync_to_physics = false
	platform.collision_layer = PhysicsLayers.STATIC
	platform.position.y = -0.5
	_add_box(platform)
	return platform


## A floor that weighs: a heavy body without gravity, which takes up what presses on it.
func _add_scale() -> RigidBody3D:
	var scale: RigidBody3D = RigidBody3D.new()
	scale.mass = 1e5
	scale.gravity_scale = 0.0
	scale.lock_rotation = true
	scale.can_sleep = false
	scale.collision_layer = PhysicsLayers.STATIC
	scale.collision_mask = PhysicsLayers.ALL
	scale.position = Vector3(0.0, -0.5, 0.0)
	_add_box(scale)
	return scale


func _add_box(p_body: PhysicsBody3D) -> void:
	var shape: CollisionShape3D = CollisionShape3D.new()
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3(20.0, 1.0, 20.0)
	shape.shape = box
	p_body.add_child(shape)
	_stage.add_child(p_body)
