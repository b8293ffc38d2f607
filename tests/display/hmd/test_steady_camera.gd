extends TestCase
## The spectator's picture of what a wearer sees.

var _camera: SteadyCamera = null


func before_each() -> void:
	_camera = SteadyCamera.new()


func after_each() -> void:
	_camera.free()


func test_it_looks_where_the_head_looks_without_its_tilt() -> void:
	var head: Transform3D = Transform3D(
		Basis(Vector3.UP, 0.5) * Basis(Vector3.BACK, 0.4), Vector3(1.0, 1.7, 2.0)
	)
	_camera.follow(head, 0.016)
	almost_equal(_camera.position.distance_to(head.origin), 0.0, 1e-6)
	almost_equal((-_camera.basis.z).distance_to(-head.basis.z), 0.0, 1e-5)
	almost_equal(_camera.basis.x.y, 0.0, 1e-5, "the horizon is level")


func test_a_shaking_head_shakes_it_less() -> void:
	_camera.follow(Transform3D.IDENTITY, 0.016)
	var most: float = 0.0
	for i: int in 200:
		var yaw: float = 0.05 * sin(i * 0.016 * TAU * 6.0)
		_camera.follow(Transform3D(Basis(Vector3.UP, yaw), Vector3.ZERO), 0.016)
		most = maxf(most, absf(_camera.rotation.y))
	is_true(most < 0.02, str(most))


func test_it_arrives_and_a_jump_is_a_cut() -> void:
	_camera.follow(Transform3D.IDENTITY, 0.016)
	var turned: Transform3D = Transform3D(Basis(Vector3.UP, 1.0), Vector3(0.3, 0.0, 0.0))
	for i: int in 120:
		_camera.follow(turned, 0.016)
	almost_equal(_camera.rotation.y, 1.0, 0.01)
	almost_equal(_camera.position.x, 0.3, 0.001)
	var far: Transform3D = Transform3D(Basis.IDENTITY, Vector3(50.0, 0.0, 0.0))
	_camera.follow(far, 0.016)
	almost_equal(_camera.position.x, 50.0, 1e-4)
	almost_equal(_camera.rotation.y, 0.0, 1e-4)


func test_a_lost_head_leaves_it() -> void:
	_camera.follow(Transform3D.IDENTITY, 0.016)
	_camera.follow(Transform3D(Basis.IDENTITY, Vector3(NAN, 0.0, 0.0)), 0.016)
	equal(_camera.position, Vector3.ZERO)
