extends "stage_case.gd"
## People whose motion goes on where their bodies cannot.

const HEIGHT: Vector3 = Vector3(0.0, 1.03, 0.0)
const MODES: Array[RagdollMotor.RootMode] = [
	RagdollMotor.ROOT_SOFT, RagdollMotor.ROOT_HELD, RagdollMotor.ROOT_GROUNDED
]
## Where the wall begins, m.
const WALL: float = 1.0


func test_nobody_follows_the_motion_through_a_wall() -> void:
	for mode: RagdollMotor.RootMode in [RagdollMotor.ROOT_SOFT, RagdollMotor.ROOT_HELD]:
		var player: Stage.Player = _walker(mode, func(time: float) -> float: return minf(time, 4.0))
		await _stage.run(300)
		is_true(_furthest(player) < WALL + 0.03, "a limb is at %f m" % _furthest(player))
		var tether: Vector3 = player.ragdoll.motor.get_tether()
		almost_equal(tether.z, player.joint(0).z - 4.0, 0.1)
		is_true(player.error_deg(0, Stage.reset_pose()) < 5.0, "it leans")


func test_it_comes_back_with_its_wearer() -> void:
	for mode: RagdollMotor.RootMode in [RagdollMotor.ROOT_SOFT, RagdollMotor.ROOT_HELD]:
		var there_and_back: Callable = func(time: float) -> float: return 4.0 - absf(time - 4.0)
		var player: Stage.Player = _walker(mode, there_and_back)
		await _stage.run(480)
		almost_equal(player.joint(0), HEIGHT, 0.05)
		almost_equal(player.ragdoll.motor.get_tether(), Vector3.ZERO, 0.01)


func test_a_jump_of_the_motion_goes_through_no_wall() -> void:
	for mode: RagdollMotor.RootMode in MODES:
		var jump: Callable = func(time: float) -> float: return 0.0 if time < 1.0 else 30.0
		var player: Stage.Player = _walker(mode, jump)
		await _stage.run(180)
		is_true(_furthest(player) < WALL + 0.03, "a limb is at %f m" % _furthest(player))
		almost_equal(player.ragdoll.motor.get_tether().z, -30.0, 1.0)


func test_a_loose_thing_hides_no_wall() -> void:
	for mode: RagdollMotor.RootMode in MODES:
		var jump: Callable = func(time: float) -> float: return 0.0 if time < 1.0 else 30.0
		var player: Stage.Player = _walker(mode, jump)
		_add_loose(HEIGHT + Vector3.BACK * 0.6)
		await _stage.run(90)
		is_true(_furthest(player) < WALL + 0.03, "a limb is at %f m" % _furthest(player))


func test_people_are_no_walls() -> void:
	for mode: RagdollMotor.RootMode in MODES:
		_clear_stage()
		_stage.add_floor()
		_stage.add_soldier(HEIGHT + Vector3.BACK, RagdollMotor.ROOT_HELD)
		var player: Stage.Player = _stage.make_soldier(HEIGHT, mode)
		player.place = func(time: float) -> Vector3:
			return HEIGHT + Vector3.BACK * (0.0 if time < 1.0 else 4.0)
		_stage.enter(player)
		await _stage.run(90)
		almost_equal(player.joint(0).z, 4.0, 0.1)


func test_who_begins_anew_is_put_wherever_that_is() -> void:
	for mode: RagdollMotor.RootMode in MODES:
		var jump: Callable = func(time: float) -> float: return 0.0 if time < 1.0 else 4.0
		var player: Stage.Player = _walker(mode, jump)
		await _stage.run(60)
		player.ragdoll.motor.clear_motion()
		await _stage.run(60)
		almost_equal(player.joint(0).z, 4.0, 0.1)
		almost_equal(player.ragdoll.motor.get_tether(), Vector3.ZERO, 0.1)


func test_a_seat_is_taken_through_a_wall() -> void:
	for mode: RagdollMotor.RootMode in MODES:
		var player: Stage.Player = _walker(mode, func(_time: float) -> float: return 0.0)
		await _stage.run(60)
		player.ragdoll.motor.set_frame(Transform3D(Basis.IDENTITY, Vector3(0.0, 0.0, 4.0)))
		await _stage.run(60)
		almost_equal(player.joint(0).z, 4.0, 0.1)


func test_an_open_way_is_gone_at_once() -> void:
	var player: Stage.Player = _walker(
		RagdollMotor.ROOT_SOFT, func(time: float) -> float: return minf(time, 4.0)
	)
	await _stage.run(300)
	_stage.get_node("Wall").free()
	await _stage.run(120)
	almost_equal(player.joint(0).z, 4.0, 0.05)


func test_held_hips_are_exact_as_long_as_nothing_is_in_the_way() -> void:
	var player: Stage.Player = _walker(
		RagdollMotor.ROOT_HELD, func(time: float) -> float: return minf(time, 0.5)
	)
	var worst: Array[float] = [0.0]
	await _stage.run(
		60,
		func(time: float) -> void:
			worst[0] = maxf(worst[0], absf(player.joint(0).z - minf(time, 0.5)))
	)
	is_true(worst[0] < 0.02, "off by %f m" % worst[0])


func test_what_moves_and_turns_carries_people() -> void:
	for mode: RagdollMotor.RootMode in MODES + [RagdollMotor.ROOT_INERTIAL]:
		_clear_stage()
		var platform: AnimatableBody3D = _add_platform()
		var player: Stage.Player = _stage.make_soldier(HEIGHT + Vector3.BACK, mode)
		player.place = func(time: float) -> Vector3:
			platform.position.x = maxf(time - 1.0, 0.0)
			platform.rotation.y = maxf(time - 1.0, 0.0) * PI / 6.0
			return HEIGHT + Vector3.BACK
		_stage.enter(player)
		await _stage.run(240)
		var body: Transform3D = PhysicsServer3D.body_get_state(
			platform.get_rid(), PhysicsServer3D.BODY_STATE_TRANSFORM
		)
		var at: Vector3 = body.affine_inverse() * player.joint(0)
		almost_equal(Vector2(at.x, at.z), Vector2(0.0, 1.0), 0.1)
		var heading: Vector3 = player.body(0).basis.z - player.body(0).basis.z.y * Vector3.UP
		almost_equal(heading.signed_angle_to(body.basis.z, Vector3.UP), 0.0, 0.1)


## A soldier whose motion is so far ahead at a time, m, with a wall in the way.
func _walker(p_mode: RagdollMotor.RootMode, p_way: Callable) -> Stage.Player:
	_clear_stage()
	_stage.add_floor()
	var wall: Block = Block.new()
	wall.name = "Wall"
	wall.size = Vector3(6.0, 4.0, 0.1)
	wall.position = Vector3(0.0, 2.0, WALL + 0.05)
	_stage.add_child(wall)
	var player: Stage.Player = _stage.make_soldier(HEIGHT, p_mode)
	player.place = func(time: float) -> Vector3: return HEIGHT + Vector3.BACK * p_way.call(time)
	_stage.enter(player)
	return player


## How far the middle of a limb is ahead at most, m.
static func _furthest(p_player: Stage.Player) -> float:
	var furthest: float = -INF
	for limb: int in Limbs.COUNT:
		furthest = maxf(furthest, p_player.body(limb).origin.z)
	return furthest


## A light thing that floats at a place.
func _add_loose(p_place: Vector3) -> void:
	var loose: RigidBody3D = RigidBody3D.new()
	loose.collision_layer = PhysicsLayers.PROPS
	loose.gravity_scale = 0.0
	loose.position = p_place
	var shape: CollisionShape3D = CollisionShape3D.new()
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3(0.6, 0.6, 0.2)
	shape.shape = box
	loose.add_child(shape)
	_stage.add_child(loose)


func _add_platform() -> AnimatableBody3D:
	var platform: AnimatableBody3D = AnimatableBody3D.new()
	platform.sync_to_physics = false
	platform.collision_layer = PhysicsLayers.STATIC
	platform.position.y = -0.5
	var shape: CollisionShape3D = CollisionShape3D.new()
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3(20.0, 1.0, 20.0)
	shape.shape = box
	platform.add_child(shape)
	_stage.add_child(platform)
	return platform
