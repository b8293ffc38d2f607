extends TestCase
## A client's physics space answers rays without making steps.


func after_each() -> void:
	PhysicsServer3D.set_active(true)


func test_rays_find_the_level_while_nothing_steps() -> void:
	ClientPhysics.begin()
	var level: Level = LevelStore.instantiate("yard")
	add_child(level)
	await process_frames(2)
	is_false(ClientPhysics.is_stepping())
	var space: PhysicsDirectSpaceState3D = level.get_world_3d().direct_space_state
	var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		Vector3(5.0, 0.5, 6.0), Vector3(5.0, 0.5, 0.0), 1
	)
	var hit: Dictionary = space.intersect_ray(ray)
	almost_equal(hit["position"], Vector3(5.0, 0.5, 3.15), 0.01, "the low wall")
	level.free()


func test_who_needs_steps_gets_them_until_the_last_one_is_gone() -> void:
	ClientPhysics.begin()
	ClientPhysics.hold()
	ClientPhysics.hold()
	ClientPhysics.release()
	is_true(ClientPhysics.is_stepping())
	var ball: RigidBody3D = RigidBody3D.new()
	add_child(ball)
	for _frame: int in 10:
		await get_tree().physics_frame
	is_true(ball.position.y < -0.01, "it falls")
	ClientPhysics.release()
	is_false(ClientPhysics.is_stepping())
	await get_tree().physics_frame
	var before: float = ball.position.y
	for _frame: int in 5:
		await get_tree().physics_frame
	equal(ball.position.y, before)
	ball.free()


func test_after_many_bodies_there_are_a_few_steps() -> void:
	ClientPhysics.begin()
	ClientPhysics.note_added(ClientPhysics.MAX_ADDED)
	ClientPhysics.advance()
	is_false(ClientPhysics.is_stepping())
	ClientPhysics.note_added(1)
	var steps: int = 0
	for _frame: int in 10:
		ClientPhysics.advance()
		steps += 1 if ClientPhysics.is_stepping() else 0
	is_true(steps >= 2, "Jolt needs two to give the nodes of its trees back")
	is_false(ClientPhysics.is_stepping())
	ClientPhysics.note_added(ClientPhysics.MAX_ADDED + 1)
	ClientPhysics.hold()
	for _frame: int in 10:
		ClientPhysics.advance()
	is_true(ClientPhysics.is_stepping(), "as somebody needs steps")
	ClientPhysics.release()
	is_false(ClientPhysics.is_stepping())


func test_a_camera_does_not_pass_a_wall() -> void:
	var level: Level = LevelStore.instantiate("yard")
	add_child(level)
	var camera: OrbitCamera = OrbitCamera.new()
	camera.obstacles = 1
	camera.azimuth = 0.0
	camera.elevation = 0.0
	camera.distance = 6.0
	camera.target = Vector3(5.0, 0.5, 1.0)
	add_child(camera)
	camera.snap()
	await process_frames(2)
	is_true(camera.position.z < 2.9, "in front of the low wall: %s" % camera.position)
	camera.obstacles = 0
	await process_frames(2)
	almost_equal(camera.position.z, 7.0, 0.01)
	camera.free()
	level.free()
