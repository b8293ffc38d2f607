extends TestCase
## The heights of roofs around the eye, by which rain ends.


func test_a_roof_is_found_and_open_ground_is_not() -> void:
	var roof: StaticBody3D = StaticBody3D.new()
	roof.collision_layer = PhysicsLayers.STATIC
	var shape: CollisionShape3D = CollisionShape3D.new()
	var box: BoxShape3D = BoxShape3D.new()
	box.size = Vector3(6.0, 0.2, 6.0)
	shape.shape = box
	roof.add_child(shape)
	roof.position = Vector3(103.0, 3.0, -51.0)
	add_child(roof)
	await physics_frames(2)
	var probe: RoofProbe = RoofProbe.new()
	var space: PhysicsDirectSpaceState3D = roof.get_world_3d().direct_space_state
	for _tick: int in ceili(float(RoofProbe.SIDE * RoofProbe.SIDE) / RoofProbe.RAYS):
		probe.advance(space, Vector3(102.0, 1.7, -50.0))
	almost_equal(probe.height_at(Vector3(103.0, 1.0, -51.0)), 3.1, 0.01)
	equal(probe.height_at(Vector3(108.5, 1.0, -51.0)), RoofProbe.NOTHING_M)
	roof.free()
