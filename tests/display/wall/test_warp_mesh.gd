extends TestCase
## Mesh files of curved screens.


func test_a_mesh_is_drawn_where_its_nodes_are() -> void:
	var text: String = "2\n2 2\n-1.5 -1 0 0 1\n1.5 -1 1 0 1\n-1.5 1 0 1 0.5\n1.5 1 1 1 1\n"
	var mesh: WarpMesh = WarpMesh.parse(text, "dome.data")
	equal(mesh.error, "")
	var picture: EyePicture = EyePicture.new()
	mesh.draw_on(picture, Rect2i(0, 0, 600, 400))
	var arrays: Array = (picture.mesh as ArrayMesh).surface_get_arrays(0)
	var points: PackedVector2Array = arrays[Mesh.ARRAY_VERTEX]
	almost_equal(points[0], Vector2(0.0, 400.0), 1e-3, "lower left")
	almost_equal(points[3], Vector2(600.0, 0.0), 1e-3, "upper right")
	equal((arrays[Mesh.ARRAY_INDEX] as PackedInt32Array).size(), 6)
	picture.free()


func test_bad_meshes_are_named_by_line() -> void:
	var cases: Dictionary[String, String] = {
		"": "dome.data:1: the mesh has 0 nodes",
		"2\n1 4\n": "dome.data:2: a mesh has 2 to",
		"2\nmany\n": "dome.data:2: the second line",
		"2\n2 2\n0 0 0 0\n": "dome.data:3: a node is x y u v intensity, found 4",
		"2\n2 2\n0 nan 0 0 1\n": "dome.data:3: 'nan' is no number",
		"2\n2 2\n0 0 0 0 1\n": "the mesh has 1 nodes, its size asks for 4",
	}
	for text: String in cases:
		contains(WarpMesh.parse(text, "dome.data").error, cases[text])
