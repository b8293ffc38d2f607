extends "stage_case.gd"
## Gravity is that of the areas that a person is in.

const PLACE: Vector3 = Vector3(0.0, 3.0, 0.0)
const CHEST: int = 2
const LEFT_UPPER_ARM: int = 4


func test_arms_weigh_by_the_gravity_of_the_area() -> void:
	var usual: float = await _arm_torque(-1.0, 1.0)
	is_true(usual > 5.0 and usual < 30.0, "%f N m hold an arm out level" % usual)
	almost_equal(await _arm_torque(1.62, 1.0), usual * 1.62 / 9.8, 0.1 * usual)
	almost_equal(await _arm_torque(0.0, 1.0), 0.0, 0.02 * usual)
	almost_equal(await _arm_torque(-1.0, 0.5), usual * 0.5, 0.1 * usual)


func test_a_body_that_is_new_has_the_gravity_of_its_space() -> void:
	var player: Stage.Player = _stage.make_soldier(PLACE, RagdollMotor.ROOT_HELD)
	_stage.enter(player)
	player.ragdoll.motor.measures_torque = true
	# The first step: the engine has not yet found what pulls at the bodies.
	await _stage.run(1)
	var torque: float = player.ragdoll.motor.get_limb_torques()[player.index(LEFT_UPPER_ARM)]
	is_true(torque > 5.0, "%f N m" % torque)


func test_what_holds_the_hips_is_measured() -> void:
	# A force at the chest and a torque, in the middle of nowhere without weight.
	_add_area(0.0)
	var player: Stage.Player = _stage.make_soldier(PLACE, RagdollMotor.ROOT_SOFT)
	_stage.enter(player)
	player.ragdoll.motor.measures_torque = true
	var chest: RID = player.ragdoll.get_bodies()[player.index(CHEST)]
	var force: Vector3 = Vector3(0.0, 0.0, 60.0)
	var torque: Vector3 = Vector3(4.0, 10.0, -6.0)
	await _stage.run(
		120,
		func(_time: float) -> void:
			PhysicsServer3D.body_apply_central_force(chest, force)
			PhysicsServer3D.body_apply_torque(chest, torque)
	)
	var at: Transform3D = PhysicsServer3D.body_get_state(
		chest, PhysicsServer3D.BODY_STATE_TRANSFORM
	)
	var wanted: Vector3 = torque + (at.origin - player.joint(0)).cross(force)
	almost_equal(player.ragdoll.motor.get_limb_torques()[player.index(0)], wanted.length(), 0.3)


## What the torque meter has of a shoulder whose arm is held out level, N m.
func _arm_torque(p_area_gravity: float, p_scale: float) -> float:
	_clear_stage()
	if p_area_gravity >= 0.0:
		_add_area(p_area_gravity)
	var player: Stage.Player = _stage.make_soldier(PLACE, RagdollMotor.ROOT_HELD)
	for bone: Node in player.ragdoll.get_simulator().get_children():
		if bone is PhysicalBone3D:
			(bone as PhysicalBone3D).gravity_scale = p_scale
	_stage.enter(player)
	player.ragdoll.motor.measures_torque = true
	await _stage.run(60)
	return player.ragdoll.motor.get_limb_torques()[player.index(LEFT_UPPER_ARM)]


func _add_area(p_gravity: float) -> void:
	var area: Area3D = Area3D.new()
	var shape: CollisionShape3D = CollisionShape3D.new()
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3(6.0, 6.0, 6.0)
	shape.shape = box
	area.add_child(shape)
	area.position = PLACE
	area.collision_mask = 0xFFFFFFFF
	area.gravity_space_override = Area3D.SPACE_OVERRIDE_REPLACE
	area.gravity = p_gravity
	_stage.add_child(area)
