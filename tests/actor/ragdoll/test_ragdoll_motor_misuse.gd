extends TestCase
## What a motor refuses, and that it goes on as before: bodies of its own, without any scene.

const DELTA: float = 1.0 / 60.0
const LIMBS: int = 3
const HERE: Vector3 = Vector3(0.0, 1.0, 0.0)

const _AMOUNTS: Array[StringName] = [
	&"gain", &"muscle_speed", &"root_force", &"root_torque", &"max_energy"
]

var _motor: RagdollMotor = null
var _profile: RagdollProfile = null
var _bodies: Array[RID] = []
var _time_s: float = 0.0


func before_each() -> void:
	_time_s = 0.0
	_profile = _chain()
	for limb: RagdollLimb in _profile.limbs:
		var body: RID = PhysicsServer3D.body_create()
		var place: Transform3D = Transform3D(Basis.IDENTITY, limb.position)
		PhysicsServer3D.body_set_state(body, PhysicsServer3D.BODY_STATE_TRANSFORM, place)
		PhysicsServer3D.body_set_space(body, _space())
		_bodies.append(body)
	_motor = RagdollMotor.new()
	add_child(_motor)
	is_true(_motor.setup(_profile, _bodies, PackedVector3Array(), _space()))


func after_each() -> void:
	_motor.free()
	for body: RID in _bodies:
		PhysicsServer3D.free_rid(body)
	_bodies.clear()


func test_physics_that_cannot_drive_a_ragdoll_are_named() -> void:
	equal(RagdollMotor.find_physics_problem(), "")
	const ENGINE: String = "physics/3d/physics_engine"
	const STEPS: String = "physics/jolt_physics_3d/simulation/velocity_steps"
	var engine: String = ProjectSettings.get_setting(ENGINE)
	var steps: int = ProjectSettings.get_setting(STEPS)
	ProjectSettings.set_setting(STEPS, 10)
	contains(RagdollMotor.find_physics_problem(), "10 velocity steps")
	ProjectSettings.set_setting(ENGINE, "GodotPhysics3D")
	contains(RagdollMotor.find_physics_problem(), 'Set %s to "Jolt Physics"' % ENGINE)
	ProjectSettings.set_setting(ENGINE, engine)
	ProjectSettings.set_setting(STEPS, steps)


func test_samples_of_the_wrong_size_are_refused() -> void:
	for size: int in [0, 4, 11, 13, 16]:
		var wrong: PackedFloat32Array = []
		wrong.resize(size)
		wrong.fill(0.5)
		is_false(_motor.push_sample(1.0, wrong, HERE), "%d numbers" % size)
	for size: int in [1, 8, 10, 12]:
		var rates: PackedFloat32Array = []
		rates.resize(size)
		is_false(_motor.push_sample(1.0, _still(), HERE, rates), "%d rates" % size)
	for slots: PackedInt32Array in [[0, 1], [0, 1, 2, 0], [0, 1, 3], [0, 1, -1]]:
		_motor.sample_slots = slots
		is_false(_motor.push_sample(1.0, _still(), HERE), "slots %s" % slots)
	_motor.sample_slots = [2, 1, 0]
	is_true(_motor.push_sample(1.0, _still(), HERE))


func test_steps_that_are_none_are_refused() -> void:
	await _run(3)
	for delta: float in [NAN, INF, 0.0, -1.0, 1e-300]:
		expect_error("the time step must be above zero")
		is_false(_motor.drive(_time_s, delta), "step %s" % delta)
	for time: float in [NAN, INF, -INF]:
		expect_error("the time is not finite")
		is_false(_motor.drive(time, DELTA), "time %s" % time)
		expect_error("the time is not finite")
		is_false(_motor.snap_to(time), "time %s" % time)
	await _run(20)
	almost_equal(_place(0), _profile.limbs[0].position, 0.01)


func test_values_that_no_motor_has_are_refused() -> void:
	for value: float in [NAN, INF, -1.0]:
		for property: StringName in _AMOUNTS:
			var before: float = _motor.get(property)
			expect_error("is 0 or more")
			_motor.set(property, value)
			equal(_motor.get(property), before)
		expect_error("an inertia scale is 0.01 or more")
		_motor.inertia_scale = value
		expect_error("a strength is 0 or more")
		_motor.set_group_strength(value)
		expect_error("frequency and damping ratio are 0 or more")
		_motor.set_group_spring(value, 1.0)
	await _run(20)
	almost_equal(_place(0), _profile.limbs[0].position, 0.01)


func test_bodies_that_are_none_are_refused() -> void:
	for bodies: Array[RID] in [
		[RID(), RID(), RID()] as Array[RID], [_bodies[0], _bodies[1], RID()] as Array[RID]
	]:
		expect_error("one of the bodies is none")
		is_false(_motor.setup(_profile, bodies, PackedVector3Array(), _space()))
	expect_error("two limbs have the same body")
	var same: Array[RID] = [_bodies[0], _bodies[1], _bodies[0]]
	is_false(_motor.setup(_profile, same, PackedVector3Array(), _space()))
	is_true(_motor.is_set_up(), "goes on with those that it has")
	await _run(20)
	almost_equal(_place(0), _profile.limbs[0].position, 0.01)


func test_a_held_body_falls_when_it_is_released_and_is_driven_when_set_up_again() -> void:
	_motor.root_mode = RagdollMotor.ROOT_HELD
	await _run(3)
	_motor.setup(_profile, _bodies, PackedVector3Array(), _space())
	_motor.root_mode = RagdollMotor.ROOT_SOFT
	await _run(3)
	equal(PhysicsServer3D.body_get_mode(_bodies[0]), PhysicsServer3D.BODY_MODE_RIGID)
	_motor.root_mode = RagdollMotor.ROOT_HELD
	await _run(3)
	_motor.release()
	equal(PhysicsServer3D.body_get_mode(_bodies[0]), PhysicsServer3D.BODY_MODE_RIGID)


func test_the_state_of_another_body_is_refused_and_changes_nothing() -> void:
	await _run(10)
	var own: PackedByteArray = _motor.save_state()
	var heavier: RagdollProfile = _chain()
	heavier.mass = 70.0
	var regrouped: RagdollProfile = _chain()
	regrouped.limbs[2].group = &"third"
	for other: RagdollProfile in [heavier, regrouped]:
		_motor.setup(other, _bodies, PackedVector3Array(), _space())
		await _run(3)
		_motor.set_actuation(RagdollMotor.LIMP, &"second")
		var foreign: PackedByteArray = _motor.save_state()
		_motor.setup(_profile, _bodies, PackedVector3Array(), _space())
		await _run(3)
		expect_error("the saved state is of another profile or version")
		is_false(_motor.restore_state(foreign))
		equal(_motor.get_actuation(&"second"), RagdollMotor.VELOCITY_MOTOR)
		await _run(3)
	is_true(_motor.restore_state(own))


func test_whoever_hears_of_the_guard_may_end_the_motor() -> void:
	await _run(3)
	_motor.guard_acted.connect(func(_flags: int) -> void: _motor.release())
	for i: int in LIMBS:
		PhysicsServer3D.body_set_state(
			_bodies[i],
			PhysicsServer3D.BODY_STATE_LINEAR_VELOCITY,
			Vector3(900.0 if i % 2 == 0 else -900.0, 0.0, 0.0)
		)
	is_true(_motor.drive(_time_s, DELTA))
	is_false(_motor.is_set_up())
	is_false(_motor.drive(_time_s, DELTA))


func test_finds_the_ground_though_it_was_set_up_outside_the_tree() -> void:
	remove_child(_motor)
	_motor.root_mode = RagdollMotor.ROOT_CONTACTS
	_motor.setup(_profile, _bodies, PackedVector3Array(), _space())
	await _run(2)
	equal(_motor.get_child_count(true), 0)
	add_child(_motor)
	await _run(2)
	equal(_motor.get_child_count(true), 1, "a ray")
	remove_child(_motor)
	await _run(2)
	add_child(_motor)
	await _run(2)


func test_goes_on_when_a_body_that_was_gone_is_back() -> void:
	await _run(2)
	expect_error("a body is not in a physics space")
	PhysicsServer3D.body_set_space(_bodies[2], RID())
	is_false(_motor.drive(_time_s, DELTA))
	is_false(_motor.drive(_time_s, DELTA))
	PhysicsServer3D.body_set_space(_bodies[2], _space())
	is_true(_motor.drive(_time_s, DELTA))


func _run(p_steps: int) -> void:
	for _step: int in p_steps:
		await get_tree().physics_frame
		_time_s += DELTA
		_motor.push_sample(_time_s, _still(), HERE)
		_motor.drive(_time_s, DELTA)


func _place(p_limb: int) -> Vector3:
	var state: PhysicsServer3D.BodyState = PhysicsServer3D.BODY_STATE_TRANSFORM
	return (PhysicsServer3D.body_get_state(_bodies[p_limb], state) as Transform3D).origin


func _space() -> RID:
	return get_viewport().find_world_3d().space


static func _still() -> PackedFloat32Array:
	return [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]


## Pills on top of each other.
static func _chain() -> RagdollProfile:
	var profile: RagdollProfile = RagdollProfile.new()
	for i: int in LIMBS:
		var limb: RagdollLimb = RagdollLimb.new()
		limb.bone = "limb%d" % i
		limb.parent_bone = "" if i == 0 else "limb%d" % (i - 1)
		limb.group = &"first" if i == 0 else &"second"
		limb.anchor = HERE + Vector3(0.0, 0.3 * i, 0.0)
		limb.position = limb.anchor + Vector3(0.0, 0.15, 0.0)
		limb.length = 0.2
		limb.mass_fraction = 1.0 / LIMBS
		profile.limbs.append(limb)
	return profile
