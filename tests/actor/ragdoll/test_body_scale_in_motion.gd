extends "stage_case.gd"
## People of other sizes hold poses, follow motion and stand on the floor as the soldier does.

## How many times as long as the soldier's: trunk, arms, legs. Two are 1.45 m and 2.05 m tall.
const PEOPLE: Array[Vector3] = [
	Vector3(0.797, 0.797, 0.797),
	Vector3(1.126, 1.126, 1.126),
	Vector3(0.85, 1.2, 1.15),
	Vector3(1.15, 0.8, 0.8),
]
## How high the soldier's soles are below his feet's origin, m.
const SOLES: float = 0.012


func test_holds_the_reset_pose() -> void:
	for person: Vector3 in PEOPLE:
		var player: Stage.Player = _add(person, RagdollMotor.ROOT_SOFT)
		await _stage.run(90)
		var worst: float = player.worst_error_deg(Stage.reset_pose())
		is_true(worst < 0.1, "%s is off by %f deg" % [person, worst])
		is_true(player.gap() < 0.002, "%s: gap %f m" % [person, player.gap()])
		is_true(player.speed() < 0.01, "%s trembles with %f m/s" % [person, player.speed()])
		_clear_stage()


func test_follows_swinging_arms_and_tears_no_joint() -> void:
	for person: Vector3 in PEOPLE:
		var player: Stage.Player = _add(person, RagdollMotor.ROOT_SOFT)
		player.pose = func(time: float) -> PoseSample:
			return Stage.arms_pose(40.0 + 30.0 * sin(4.0 * time), 40.0 + 30.0 * sin(5.0 * time))
		var errors: Statistics = Statistics.new()
		var gaps: Statistics = Statistics.new()
		var acted: Array[int] = [0]
		player.ragdoll.motor.guard_acted.connect(func(_actions: int) -> void: acted[0] += 1)
		var note: Callable = func(time: float) -> void:
			if time > 0.5:
				gaps.add(player.gap())
				for limb: int in Limbs.COUNT:
					errors.add(player.error_deg(limb, player.pose.call(time)))
		await _stage.run(150, note)
		is_true(errors.mean() < 1.3, "%s: mean %f deg" % [person, errors.mean()])
		is_true(gaps.percentile(1.0) < 0.01, "%s: gap %f m" % [person, gaps.percentile(1.0)])
		equal(acted[0], 0, "the guard")
		_clear_stage()


func test_stands_on_the_floor() -> void:
	_stage.add_floor()
	for person: Vector3 in PEOPLE:
		var player: Stage.Player = _add(person, RagdollMotor.ROOT_CONTACTS)
		await _stage.run(120)
		var lowest: float = INF
		for limb: RagdollLimb in player.ragdoll.profile.limbs:
			for point: Vector3 in limb.contact_points if limb.is_foot else PackedVector3Array():
				var rest: Transform3D = RestSkeleton.body_of(limb)
				var body: Transform3D = player.body(Limbs.find(limb.bone))
				lowest = minf(lowest, (body * (rest.affine_inverse() * point)).y)
		almost_equal(lowest, 0.0, 0.01, "%s: soles" % person)
		is_true(player.worst_error_deg(Stage.reset_pose()) < 1.0, "%s stands askew" % person)
		_stage.players.clear()
		player.ragdoll.free()


## Goes limp, falls, gets up: nothing is flung.
func test_falls_and_gets_up() -> void:
	_stage.add_floor()
	for person: Vector3 in PEOPLE:
		var player: Stage.Player = _add(person, RagdollMotor.ROOT_SOFT)
		await _stage.run(20)
		player.ragdoll.motor.set_actuation(RagdollMotor.LIMP, &"", 0.2)
		player.ragdoll.motor.root_force = 0.0
		player.ragdoll.motor.root_torque = 0.0
		var fastest: Array[float] = [0.0]
		var note: Callable = func(_time: float) -> void:
			fastest[0] = maxf(fastest[0], player.speed())
		await _stage.run(150, note)
		is_true(player.joint(0).y < 0.6 * player.ragdoll.get_hip_height(), "%s falls" % person)
		is_true(fastest[0] < 12.0, "%s is flung with %f m/s" % [person, fastest[0]])
		player.ragdoll.motor.root_force = player.ragdoll.root_force
		player.ragdoll.motor.root_torque = player.ragdoll.root_torque
		player.ragdoll.motor.set_actuation(RagdollMotor.VELOCITY_MOTOR, &"", 1.0)
		await _stage.run(240, note)
		is_true(fastest[0] < 12.0, "%s is flung with %f m/s" % [person, fastest[0]])
		# As the soldier himself now and then, they may stand on feet that the floor holds askew.
		var worst: float = player.worst_error_deg(Stage.reset_pose())
		is_true(worst < 20.0, "%s is up again, off by %f deg" % [person, worst])
		almost_equal(player.joint(0).y, player.ragdoll.get_hip_height() + SOLES, 0.05, "hips")
		_stage.players.clear()
		player.ragdoll.free()


func _add(p_person: Vector3, p_mode: RagdollMotor.RootMode) -> Stage.Player:
	var player: Stage.Player = _stage.make_soldier(Vector3.ZERO, p_mode)
	var lengths: PackedFloat32Array = BodyScale.own_lengths(player.ragdoll)
	for limb: int in Limbs.COUNT:
		lengths[limb] *= p_person.x if limb <= 3 else p_person.y if limb < 10 else p_person.z
	is_true(player.ragdoll.fit(lengths))
	var place: Vector3 = Vector3(0.0, player.ragdoll.get_hip_height() + SOLES, 0.0)
	player.place = func(_time: float) -> Vector3: return place
	_stage.enter(player)
	return player
