extends "stage_case.gd"
## Controls of single limbs, profiles of them, and hits.

const PLACE: Vector3 = Vector3(0.0, 3.0, 0.0)
const CHEST: int = 2
const LEFT_UPPER_ARM: int = 4
const LEFT_HAND: int = 6
const RIGHT_HAND: int = 9


func test_a_blow_turns_the_trunk_and_it_comes_back() -> void:
	_stage.add_floor()
	var player: Stage.Player = _stage.add_soldier(Vector3(0.0, 1.03, 0.0), RagdollMotor.ROOT_SOFT)
	await _stage.run(30)
	var position: Vector3 = player.body(CHEST).origin
	equal(player.ragdoll.motor.hit(Vector3.FORWARD * 50.0, position), player.index(CHEST))
	var turned: Array[float] = [0.0]
	var note: Callable = func(_time: float) -> void:
		turned[0] = maxf(turned[0], player.error_deg(CHEST, Stage.reset_pose()))
	await _stage.run(36, note)
	is_true(turned[0] > 8.0 and turned[0] < 20.0, "the trunk turned by %f deg" % turned[0])
	var left: float = player.error_deg(CHEST, Stage.reset_pose())
	is_true(left < 2.0, "%f deg are left after 0.6 s" % left)
	almost_equal(player.joint(0), Vector3(0.0, 1.03, 0.0), 0.03)


func test_a_blow_meets_the_group_it_is_meant_for() -> void:
	var player: Stage.Player = _stage.add_soldier(PLACE, RagdollMotor.ROOT_SOFT)
	await _stage.run(20)
	var motor: RagdollMotor = player.ragdoll.motor
	var hand: Vector3 = player.body(LEFT_HAND).origin
	equal(motor.hit(Vector3.ZERO, hand), player.index(LEFT_HAND))
	var other: int = motor.hit(Vector3.ZERO, hand, 0.5, 0.2, &"right_leg")
	equal(player.ragdoll.profile.limbs[other].group, &"right_leg")
	expect_error("no group tail")
	equal(motor.hit(Vector3.ZERO, hand, 0.5, 0.2, &"tail"), -1)
	expect_error("are finite")
	equal(motor.hit(Vector3(NAN, 0.0, 0.0), hand), -1)
	expect_error("0 to 1")
	equal(motor.hit(Vector3.ZERO, hand, 1.5), -1)


func test_profiles_come_by_their_names_and_blend() -> void:
	var player: Stage.Player = _stage.add_soldier(PLACE, RagdollMotor.ROOT_SOFT)
	var motor: RagdollMotor = player.ragdoll.motor
	await _stage.run(20)
	is_true(motor.invoke_control_profile(&"wounded_left_arm"))
	equal(motor.get_control_profile(), &"wounded_left_arm")
	await _stage.run(90)
	var sag: float = player.error_deg(LEFT_HAND, Stage.reset_pose())
	is_true(sag > 10.0, "the wounded arm sags by %f deg" % sag)
	is_true(player.error_deg(RIGHT_HAND, Stage.reset_pose()) < 2.0, "the other one does not")
	is_true(motor.invoke_control_profile(&"standing", 0.5))
	await _stage.run(90)
	is_true(player.worst_error_deg(Stage.reset_pose()) < 2.0)
	is_true(motor.invoke_control_profile(&"limp_legs", 0.0))
	equal(motor.get_actuation(&"left_leg"), RagdollMotor.LIMP)
	equal(motor.get_actuation(&"left_arm"), RagdollMotor.VELOCITY_MOTOR)
	expect_error("none of the name no_such")
	is_true(not motor.invoke_control_profile(&"no_such"))
	equal(motor.get_control_profile(), &"limp_legs")


func test_a_control_that_does_not_fit_changes_nothing() -> void:
	var player: Stage.Player = _stage.add_soldier(PLACE, RagdollMotor.ROOT_SOFT)
	var limp: RagdollControl = RagdollControl.new()
	limp.actuation = RagdollMotor.LIMP
	var wrong: RagdollControl = RagdollControl.new()
	wrong.limbs = ["Tail"]
	var profile: RagdollControlProfile = RagdollControlProfile.new()
	profile.controls = [limp, wrong]
	expect_error("no bone and no group Tail")
	is_true(not player.ragdoll.motor.apply_control_profile(profile))
	expect_error("no bone and no group Tail")
	is_true(not player.ragdoll.motor.set_limb_control(wrong))
	equal(player.ragdoll.motor.get_actuation(), RagdollMotor.VELOCITY_MOTOR)
	expect_error("a physics blend is 0 to 1")
	wrong.physics_blend = 2.0
	expect_error("0 or more")
	wrong.world_max_force = NAN
	equal(wrong.physics_blend, 1.0)
	equal(wrong.world_max_force, 0.0)


func test_a_hand_is_held_in_the_world() -> void:
	var player: Stage.Player = _stage.add_soldier(PLACE, RagdollMotor.ROOT_SOFT)
	await _stage.run(20)
	var where: Vector3 = player.body(LEFT_HAND).origin
	var limp: RagdollControl = RagdollControl.new()
	limp.limbs = ["left_arm"]
	limp.actuation = RagdollMotor.LIMP
	player.ragdoll.motor.set_limb_control(limp)
	var held: RagdollControl = RagdollControl.new()
	held.limbs = ["LeftHand"]
	held.actuation = RagdollMotor.LIMP
	held.world_linear_strength = 8.0
	player.ragdoll.motor.set_limb_control(held)
	await _stage.run(120)
	var off: float = player.body(LEFT_HAND).origin.distance_to(where)
	is_true(off < 0.06, "held, the hand of a limp arm is off by %f m" % off)
	held.world_max_force = 5.0
	player.ragdoll.motor.set_limb_control(held)
	await _stage.run(120)
	off = player.body(LEFT_HAND).origin.distance_to(where)
	is_true(off > 0.2, "5 N do not hold it: %f m" % off)


func test_a_limb_without_physics_follows_exactly_and_is_shown_so() -> void:
	var player: Stage.Player = _stage.add_soldier(PLACE, RagdollMotor.ROOT_SOFT)
	player.pose = func(time: float) -> PoseSample: return Stage.arms_pose(40.0 * sin(time), 0.0)
	var motor: RagdollMotor = player.ragdoll.motor
	var control: RagdollControl = RagdollControl.new()
	control.limbs = ["left_arm"]
	control.physics_blend = 0.0
	motor.set_limb_control(control, 0.2)
	await _stage.run(60)
	is_true(player.error_deg(LEFT_HAND, player.pose.call(_stage.time_s)) < 0.7)
	is_true(player.worst_error_deg(player.pose.call(_stage.time_s)) < 3.0)
	# Half-way, a limp arm is shown between where it hangs and where the motion has it.
	control.actuation = RagdollMotor.LIMP
	control.physics_blend = 0.5
	player.pose = func(_time: float) -> PoseSample: return Stage.reset_pose()
	motor.set_limb_control(control)
	await _stage.run(120)
	motor.measure(_stage.time_s)
	var hangs: float = player.error_deg(LEFT_UPPER_ARM, Stage.reset_pose())
	var slot: int = 3 + 4 * LEFT_UPPER_ARM
	var pose: PackedFloat32Array = motor.get_body_pose()
	var limb: RagdollLimb = player.ragdoll.profile.limbs[player.index(LEFT_UPPER_ARM)]
	var shown: Quaternion = Quaternion(pose[slot], pose[slot + 1], pose[slot + 2], pose[slot + 3])
	var off: float = rad_to_deg(shown.angle_to(limb.reset_orientation))
	is_true(hangs > 30.0, "it hangs by %f deg" % hangs)
	almost_equal(off, hangs / 2.0, 2.0)
