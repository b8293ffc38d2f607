extends TestCase
## What hits and blasts do to things and people: they are pushed, and never absurdly.

var _range: FiringRange = null


func before_each() -> void:
	_range = FiringRange.new(self)
	await _range.settle()


func after_each() -> void:
	_range.free_all()


func test_a_crate_that_is_hit_flies_off_and_not_too_fast() -> void:
	var crate: RigidBody3D = _range.add_crate(Vector3(0.0, 0.4, -40.0))
	await _range.ground.run(0.5)
	_range.aim_at(crate.global_position + Vector3(0.1, 0.2, 0.0))
	await _range.ground.run(0.1)
	_range.command(&"fire")
	var fastest: float = 0.0
	for _tick: int in 60:
		await _range.ground.run(1.0 / 60.0)
		fastest = maxf(fastest, crate.linear_velocity.length())
	equal(_range.hits[0][2], &"wood")
	is_true(fastest > 3.0 and fastest < ShellHits.MAX_GAIN + 1.0, "%.1f m/s" % fastest)
	is_true(crate.global_position.z < -41.0, str(crate.global_position))


func test_bullets_push_a_little() -> void:
	var crate: RigidBody3D = _range.add_crate(Vector3(0.0, 0.4, -40.0))
	await _range.ground.run(0.5)
	ShellHits.push(crate, Vector3(0.0, 0.0, -40.0), crate.global_position)
	await _range.ground.run(1.0 / 60.0)
	is_true(crate.linear_velocity.length() > 1.0, "%.2f m/s" % crate.linear_velocity.length())
	ShellHits.push(crate, Vector3(NAN, 0.0, 0.0), Vector3.ZERO)
	ShellHits.push(null, Vector3.ONE, Vector3.ZERO)
	crate.free()
	ShellHits.push(crate, Vector3.ONE, Vector3.ZERO)


func test_a_blast_pushes_what_it_sees_and_spares_what_is_behind_a_wall() -> void:
	var seen: RigidBody3D = _range.add_crate(Vector3(3.0, 0.4, -40.0))
	var near: RigidBody3D = _range.add_crate(Vector3(0.0, 0.4, -38.5))
	var hidden: RigidBody3D = _range.add_crate(Vector3(-4.0, 0.4, -40.0))
	_range.ground.add_box(
		Vector3(0.3, 4.0, 4.0), Transform3D(Basis.IDENTITY, Vector3(-2.0, 2.0, -40.0))
	)
	await _range.ground.run(0.5)
	var space: PhysicsDirectSpaceState3D = _range.space()
	ShellHits.burst(space, Vector3(0.0, 0.3, -40.0), _range.gun.ammunition[1])
	await _range.ground.run(2.0 / 60.0)
	is_true(seen.linear_velocity.x > 0.5, str(seen.linear_velocity))
	is_true(near.linear_velocity.length() > seen.linear_velocity.length())
	is_true(near.linear_velocity.length() < ShellHits.MAX_GAIN + 1.0)
	almost_equal(hidden.linear_velocity, Vector3.ZERO, 0.05)


func test_a_person_flinches_from_a_bullet_and_falls_from_a_blast() -> void:
	var person: Ragdoll = _range.add_person(Vector3(0.0, 0.0, -30.0))
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/01_01.bvh")
	var sample: PoseSample = source.pose_at(0.5)
	var chest: PhysicalBone3D = person.get_simulator().get_node("Chest")
	equal(ShellHits.motor_of(chest), person.motor)
	var fastest: float = 0.0
	for tick: int in 330:
		person.push_sample(tick / 60.0, sample, Vector3(0.0, sample.root.y, -30.0))
		person.drive(tick / 60.0, 1.0 / 60.0)
		await _range.ground.run(1.0 / 60.0)
		if tick == 120:
			var at: Vector3 = chest.global_position
			var ball: Ammunition = _range.coax.ammunition[0]
			var from: Vector3 = at + Vector3(0.0, 0.0, 5.0)
			is_true(_range.shells.launch(ball, from, from, Vector3(0.0, 0.0, -800.0)))
		if tick == 200:
			equal(_range.hits[0][2], &"person")
			is_true(_hips(person) > 0.7, "stands: %.2f m" % _hips(person))
			var space: PhysicsDirectSpaceState3D = _range.space()
			ShellHits.burst(space, Vector3(0.0, 0.5, -28.5), _range.gun.ammunition[1])
		for body: RID in person.get_bodies():
			var state: PhysicsDirectBodyState3D = PhysicsServer3D.body_get_direct_state(body)
			fastest = maxf(fastest, state.linear_velocity.length())
	is_true(_hips(person) < 0.6, "lies: %.2f m" % _hips(person))
	is_true(fastest > 2.0 and fastest < 25.0, "%.1f m/s" % fastest)


func _hips(p_person: Ragdoll) -> float:
	return (p_person.get_simulator().get_node("Hips") as Node3D).global_position.y
