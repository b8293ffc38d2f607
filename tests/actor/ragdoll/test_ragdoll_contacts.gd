extends "stage_case.gd"
## People, props and walls push each other.

const CRATE: PackedScene = preload("res://scenes/world/props/crate.tscn")
const SOFT: RagdollMotor.RootMode = RagdollMotor.ROOT_SOFT
const HEIGHT: Vector3 = Vector3(0.0, 1.03, 0.0)


func test_two_people_do_not_pass_through_each_other() -> void:
	var players: Array[Stage.Player] = []
	for side: float in [-1.0, 1.0]:
		var player: Stage.Player = _stage.add_soldier(HEIGHT, SOFT)
		player.pose = func(_time: float) -> PoseSample: return Stage.arms_pose(75.0, 75.0)
		player.place = func(time: float) -> Vector3:
			return HEIGHT + Vector3(0.0, 0.0, side * maxf(1.0 - time, 0.0))
		players.append(player)
	await _stage.run(150)
	var apart: Vector3 = players[1].joint(0) - players[0].joint(0)
	is_true(apart.z > 0.15, "hips are %s m apart" % apart)
	for player: Stage.Player in players:
		is_true(player.gap() < 0.02, "gap %f m" % player.gap())


func test_a_person_alone_goes_where_the_two_would_meet() -> void:
	var player: Stage.Player = _stage.add_soldier(HEIGHT, SOFT)
	player.place = func(time: float) -> Vector3:
		return HEIGHT + Vector3(0.0, 0.0, maxf(1.0 - time, 0.0))
	await _stage.run(150)
	almost_equal(player.joint(0), HEIGHT, 0.003)


func test_a_crate_is_pushed() -> void:
	_stage.add_floor()
	var crate: RigidBody3D = CRATE.instantiate()
	crate.position = Vector3(0.0, 0.25, 0.8)
	_stage.add_child(crate)
	var player: Stage.Player = _stage.add_soldier(HEIGHT, SOFT)
	player.place = func(time: float) -> Vector3: return HEIGHT + Vector3(0, 0, 0.8 * time)
	await _stage.run(120)
	is_true(crate.position.z > 1.3, "the crate is at %s" % crate.position)
	is_true(player.joint(0).z > 1.4, "the person is at %s" % player.joint(0))
	is_true(crate.position.y > 0.2, "the crate did not fall through the floor")


func test_a_blow_moves_crates_as_an_arm_can() -> void:
	var light: float = await _swing_at(10.0, 8.0)
	var heavy: float = await _swing_at(40.0, 8.0)
	var machine: float = await _swing_at(10.0, 0.0)
	# An arm of 4 kg at 4 m/s, inelastic: 1.1 and 0.36 m/s.
	is_true(light > 0.6 and light < 1.5, "10 kg go with %f m/s" % light)
	is_true(heavy > 0.15 and heavy < 0.5, "40 kg go with %f m/s" % heavy)
	is_true(machine > 1.3 * light, "with all torque %f m/s, else %f" % [machine, light])


func test_a_wall_stops_a_soft_person() -> void:
	var wall: Block = Block.new()
	wall.size = Vector3(6.0, 4.0, 0.3)
	wall.position = Vector3(0.0, 2.0, 1.0)
	_stage.add_child(wall)
	var player: Stage.Player = _stage.add_soldier(HEIGHT, SOFT)
	player.place = func(time: float) -> Vector3: return HEIGHT + Vector3(0, 0, minf(time, 2.0))
	await _stage.run(150)
	is_true(player.joint(0).z < 0.85, "hips at %s, wall at 0.85" % player.joint(0))
	is_true(player.joint(0).z > 0.3, "hips at %s" % player.joint(0))


func test_a_limp_person_falls_to_the_floor_and_not_through() -> void:
	_stage.add_floor()
	var player: Stage.Player = Stage.Player.new()
	player.ragdoll = Stage.SOLDIER.instantiate()
	player.ragdoll.strength = 0.0
	player.ragdoll.root_force = 0.0
	player.ragdoll.root_torque = 0.0
	player.pose = func(_time: float) -> PoseSample: return Stage.reset_pose()
	player.place = func(_time: float) -> Vector3: return HEIGHT
	_stage.add_child(player.ragdoll)
	is_true(player.ragdoll.start())
	_stage.players.append(player)
	await _stage.run(180)
	is_true(player.joint(0).y < 0.5, "hips at %s" % player.joint(0))
	for limb: int in Limbs.COUNT:
		is_true(player.body(limb).origin.y > -0.02, "%s is below" % Limbs.BONES[limb])
	is_true(player.gap() < 0.02, "gap %f m" % player.gap())


func test_two_people_that_start_inside_each_other_come_apart_calmly() -> void:
	for i: int in 2:
		var player: Stage.Player = _stage.add_soldier(HEIGHT, SOFT)
		player.place = func(_time: float) -> Vector3: return HEIGHT + Vector3(0, 0, 0.05 * i)
	var fastest: Array[float] = [0.0]
	var note: Callable = func(_time: float) -> void:
		for player: Stage.Player in _stage.players:
			fastest[0] = maxf(fastest[0], player.speed())
	await _stage.run(90, note)
	is_true(fastest[0] < 15.0, "flung with %f m/s" % fastest[0])
	for player: Stage.Player in _stage.players:
		is_true(player.joint(0).distance_to(HEIGHT) < 1.5, "hips at %s" % player.joint(0))


## Speed of a free crate in front of the right hand, 0.1 s after the straight arm has swung
## into it with about 4 m/s.
func _swing_at(p_mass: float, p_muscle_speed: float) -> float:
	_clear_stage()
	var player: Stage.Player = _stage.make_soldier(HEIGHT, SOFT)
	player.ragdoll.muscle_speed = p_muscle_speed
	player.pose = func(time: float) -> PoseSample:
		var pose: PoseSample = Stage.reset_pose()
		for limb: int in [7, 8, 9]:
			pose.set_orientation(limb, Quaternion(Vector3.UP, minf(6.5 * time - 1.3, 0.6)))
		return pose
	_stage.enter(player)
	var crate: RigidBody3D = CRATE.instantiate()
	crate.mass = p_mass
	crate.gravity_scale = 0.0
	crate.position = player.joint(7) + Vector3(-0.6, 0.0, 0.3)
	_stage.add_child(crate)
	await _stage.run(18)
	return crate.linear_velocity.z
