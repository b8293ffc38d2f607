extends TestCase
## What each eye sees of what the viewer's camera looks at.


func test_a_point_in_the_plane_of_the_screen_is_at_the_same_place_for_both() -> void:
	var viewer: Camera3D = Camera3D.new()
	viewer.fov = 50.0
	viewer.cull_mask = 5
	viewer.near = 0.03
	viewer.far = 700.0
	viewer.transform = Transform3D(Basis(Vector3.UP, 0.6), Vector3(1.0, 2.0, 3.0))
	add_child(viewer)
	var places: Array[Array] = []
	for side: float in [-0.5, 0.5]:
		var view: EyeView = EyeView.new()
		add_child(view)
		view.resize(Vector2i(640, 360))
		view.follow(viewer)
		view.look_beside(viewer, side * 0.065, 3.0)
		equal(view.camera.cull_mask, 5)
		equal(view.camera.far, 700.0)
		equal(view.camera.near, viewer.near)
		var found: Array[Vector2] = []
		for depth: float in [1.5, 3.0, 12.0]:
			var at: Vector3 = viewer.global_transform * Vector3(0.1 * depth, 0.0, -depth)
			found.append(view.camera.unproject_position(at))
		places.append(found)
		view.free()
	var focal: float = 180.0 / tan(deg_to_rad(25.0))
	for at: int in 3:
		var depth: float = [1.5, 3.0, 12.0][at]
		var wanted: float = 0.065 * (1.0 / 3.0 - 1.0 / depth) * focal
		almost_equal(places[1][at].x - places[0][at].x, wanted, 0.02)
		almost_equal(places[1][at].y, places[0][at].y, 1e-3)
	viewer.free()
