extends TestCase
## What an eye sees through a wall: corners of the wall are the corners of the picture.


func test_corners_of_any_wall_are_corners_of_the_picture() -> void:
	var view: SubViewport = SubViewport.new()
	view.size = Vector2i(400, 300)
	add_child(view)
	var camera: Camera3D = Camera3D.new()
	view.add_child(camera)
	var turn: Basis = Basis.from_euler(Vector3(0.2, 0.9, 0.1))
	var eye: Vector3 = Vector3(0.4, 1.5, 0.3)
	var low: Vector3 = turn * Vector3(-1.0, -0.5, -1.5)
	var right: Vector3 = low + turn.x * 2.0
	var high: Vector3 = low + turn.y * 1.5
	var frustum: OffAxisFrustum = OffAxisFrustum.through(low, right, high, eye)
	almost_equal(frustum.extent, Vector2(2.0, 1.5), 1e-5)
	camera.global_transform = Transform3D(frustum.basis, eye)
	frustum.aim(camera, 0.05, 100.0)
	almost_equal(camera.unproject_position(low), Vector2(0.0, 300.0), 0.02)
	almost_equal(camera.unproject_position(right), Vector2(400.0, 300.0), 0.02)
	almost_equal(camera.unproject_position(high), Vector2(0.0, 0.0), 0.02)
	almost_equal(camera.unproject_position(high + right - low), Vector2(400.0, 0.0), 0.02)
	view.free()


func test_an_eye_behind_the_wall_is_noticed() -> void:
	var corners: Array[Vector3] = [Vector3(-1, 0, -2), Vector3(1, 0, -2), Vector3(-1, 2, -2)]
	var seen: OffAxisFrustum = OffAxisFrustum.through(
		corners[0], corners[1], corners[2], Vector3(0, 1, 0)
	)
	almost_equal(seen.distance, 2.0, 1e-5)
	seen = OffAxisFrustum.through(corners[0], corners[1], corners[2], Vector3(0, 1, -3))
	almost_equal(seen.distance, -1.0, 1e-5)
	seen = OffAxisFrustum.through(corners[1], corners[0], corners[2], Vector3(0, 1, 0))
	is_true(seen.distance < 0.0, "mirrored")
