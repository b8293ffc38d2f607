extends "stage_case.gd"
## A body's own arms do not lie in it, though its wearer is slimmer and the motion has them there.

const STANDING: Vector3 = Vector3(0.0, 3.0, 0.0)
const _DEEPEST_M: float = 0.015
const _FURTHEST_DEG: float = 6.0
const _CALM_DEG_S: float = 2.0


func test_crossed_arms_rest_on_the_chest() -> void:
	var person: ContactPerson = await _hold("crossed arms", RagdollMotor.ROOT_SOFT)
	is_true(_wanted_depth(person, "crossed arms") > 0.05, "the motion has them deep in the chest")
	_check(person)


func test_who_stands_on_the_own_feet_crosses_the_arms_calmly() -> void:
	_stage.add_floor()
	_check(await _hold("crossed arms", RagdollMotor.ROOT_GROUNDED))


func test_hands_rest_on_hips_and_on_each_other() -> void:
	for pose: String in ["hands on hips", "praying", "arms round the knees"]:
		_check(await _hold(pose, RagdollMotor.ROOT_SOFT))
		_clear_stage()


func test_bodies_that_were_fitted_to_a_person_keep_clear_too() -> void:
	var lengths: PackedFloat32Array = []
	lengths.resize(Limbs.COUNT)
	for bone: StringName in [&"LeftUpperArm", &"RightUpperArm"]:
		lengths[Limbs.find(bone)] = 0.31
	for bone: StringName in [&"LeftLowerArm", &"RightLowerArm"]:
		lengths[Limbs.find(bone)] = 0.23
	_check(await _hold("crossed arms", RagdollMotor.ROOT_SOFT, lengths))


func test_a_pose_beside_the_body_is_left_as_it_is() -> void:
	var player: Stage.Player = _stage.add_soldier(STANDING, RagdollMotor.ROOT_SOFT)
	player.pose = func(_time: float) -> PoseSample: return Stage.arms_pose(20.0, -10.0)
	await _stage.run(60)
	for angle: float in player.ragdoll.motor.get_limb_clearances():
		equal(angle, 0.0)
	is_true(player.worst_error_deg(Stage.arms_pose(20.0, -10.0)) < 1.0)


func test_limbs_that_collide_do_not_fight() -> void:
	var person: ContactPerson = await _hold(
		"crossed arms", RagdollMotor.ROOT_SOFT, PackedFloat32Array(), true
	)
	_check(person)


## Somebody who has entered a pose and held it for a while.
func _hold(
	p_pose: String,
	p_root: RagdollMotor.RootMode,
	p_lengths: PackedFloat32Array = PackedFloat32Array(),
	p_collides: bool = false
) -> ContactPerson:
	var at: Vector3 = Vector3(0.0, 1.03, 0.0) if p_root == RagdollMotor.ROOT_GROUNDED else STANDING
	var player: Stage.Player = _stage.make_soldier(at, p_root)
	player.ragdoll.self_collision = p_collides
	_stage.add_child(player.ragdoll)
	if not p_lengths.is_empty():
		is_true(player.ragdoll.fit(p_lengths))
	_stage.remove_child(player.ragdoll)
	_stage.enter(player)
	var person: ContactPerson = ContactPerson.new(player.ragdoll)
	player.pose = func(time: float) -> PoseSample:
		return OwnPoses.pose(person, p_pose, 1, ContactPoses.smooth(time - 0.2))
	await _stage.run(240)
	return person


func _check(p_person: ContactPerson) -> void:
	var bodies: Array[Transform3D] = p_person.bodies()
	var own: OwnLimbs = OwnLimbs.new(p_person)
	var depth: float = own.depth(bodies)
	is_true(depth < _DEEPEST_M, "%s by %f m" % [own.worst_pair(bodies), depth])
	for angle: float in p_person.ragdoll.motor.get_limb_errors():
		is_true(rad_to_deg(angle) < _FURTHEST_DEG, "off by %f deg" % rad_to_deg(angle))
	for i: int in p_person.count:
		var spin: float = rad_to_deg(p_person.spin_of(i).length())
		is_true(spin < _CALM_DEG_S, "%s turns by %f deg/s" % [p_person.shape_of(i).bone, spin])


func _wanted_depth(p_person: ContactPerson, p_pose: String) -> float:
	var pose: PoseSample = OwnPoses.pose(p_person, p_pose, 1, 1.0)
	return OwnLimbs.new(p_person).depth(p_person.targets(pose, STANDING))
