extends TestCase
## The meshes of a terrain.


func test_a_piece_has_levels_of_detail_that_look_upwards() -> void:
	var mesh: ArrayMesh = TerrainMesh.make_piece(0.5)
	var lists: Array = [mesh.surface_get_arrays(0)[Mesh.ARRAY_INDEX]]
	var points: PackedVector3Array = mesh.surface_get_arrays(0)[Mesh.ARRAY_VERTEX]
	var surface: Dictionary = RenderingServer.mesh_get_surface(mesh.get_rid(), 0)
	is_true(points.size() == 97 * 97 + 4 * 96, str(points.size()))
	not_null(surface)
	for step: int in TerrainMesh.STEPS:
		lists.append(TerrainMesh._indices(step))
	for index: PackedInt32Array in lists:
		for first: int in range(0, index.size(), 3):
			var a: Vector3 = points[index[first]]
			var b: Vector3 = points[index[first + 1]]
			var c: Vector3 = points[index[first + 2]]
			if a.y + b.y + c.y == 0.0:
				# Faces are clockwise seen from where they look.
				is_true((b - a).cross(c - a).y < 0.0, "a face looks down")


func test_a_coarse_surface_lies_on_the_ground() -> void:
	var field: HeightField = HeightField.create(101, 61, 0.5)
	for index: int in field.points():
		field.heights[index] = 2.0 * sin(index % 101 * 0.1)
	var arrays: Array = TerrainMesh.make_coarse(field, 2.5)
	var points: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	equal(points.size(), 21 * 13)
	equal((arrays[Mesh.ARRAY_INDEX] as PackedInt32Array).size(), 20 * 12 * 6)
	for point: Vector3 in points:
		almost_equal(point.y, field.height_at(point.x, point.z), 1e-4)
	almost_equal(points[0].x, -25.0, 1e-5)
	almost_equal(points[-1].z, 15.0, 1e-5)


func test_hills_begin_at_the_edge_of_the_field() -> void:
	var field: HeightField = HeightField.create(101, 81, 1.0)
	field.heights.fill(4.0)
	var mesh: ArrayMesh = TerrainMesh.make_hills(field, 1)
	var points: PackedVector3Array = mesh.surface_get_arrays(0)[Mesh.ARRAY_VERTEX]
	var normals: PackedVector3Array = mesh.surface_get_arrays(0)[Mesh.ARRAY_NORMAL]
	for place: int in 28:
		almost_equal(points[place].y, 4.0, 1e-5)
		var is_edge: bool = absf(absf(points[place].x) - 50.0) < 1e-4
		is_edge = is_edge or absf(absf(points[place].z) - 40.0) < 1e-4
		is_true(is_edge, "%s is not at the edge" % points[place])
	for normal: Vector3 in normals:
		is_true(normal.y > 0.2, "a hill looks down: %s" % normal)
	is_true(mesh.get_aabb().size.x > 3000.0, "hills reach to %s" % mesh.get_aabb())
