extends TestCase
## The camera of a screen: whom it follows, how it turns and zooms.

var _camera: FilmCamera = null


func before_each() -> void:
	_camera = FilmCamera.new()
	_camera.focus = 10.0
	_camera.radius = 4.0
	_camera.height = 1.5
	add_child(_camera)


func after_each() -> void:
	_camera.free()


func test_it_looks_ahead_where_nobody_is() -> void:
	_camera.advance(1.0, PackedVector3Array())
	almost_equal(-_camera.get_view().basis.z, Vector3.FORWARD, 1e-4)
	almost_equal(_camera.get_fov(), _camera.fov, 0.01)


func test_it_follows_the_nearest_to_what_it_looks_at() -> void:
	var people: PackedVector3Array = [
		Vector3(3.0, 0.0, -10.0), Vector3(-1.0, 0.2, -11.0), Vector3(0.0, 9.0, -10.0)
	]
	equal(_camera.choose(people), 1)
	equal(_camera.choose([Vector3(20.0, 0.0, -10.0)]), -1)
	equal(_camera.choose([]), -1)
	_camera.is_following = false
	equal(_camera.choose(people), -1)


func test_it_comes_to_a_person_bit_by_bit() -> void:
	_camera.advance(0.0, PackedVector3Array())
	var at: Vector3 = Vector3(3.0, 0.0, -10.0)
	var away: float = INF
	for _step: int in 30:
		_camera.advance(0.1, [at])
		var ahead: Vector3 = -_camera.get_view().basis.z
		var off: float = ahead.angle_to(at - _camera.global_position)
		is_true(off < away + 1e-4, "it turned away")
		is_true(away == INF or away - off < 0.1, "it jumped by %.2f rad" % (away - off))
		away = off
	is_true(away < 0.02, "%.3f rad off" % away)
	# What it shows of a person is as high as set.
	var high: float = 2.0 * tan(deg_to_rad(_camera.get_fov()) / 2.0) * at.length()
	almost_equal(high, _camera.frame, 0.1)


func test_it_bears_people_at_its_own_place() -> void:
	_camera.focus = 1.0
	_camera.advance(100.0, [Vector3(0.0, -0.06, 0.0), Vector3(INF, 0.0, 0.0)])
	is_true(_camera.get_view().is_finite())
	is_true(_camera.get_fov() > 0.0 and _camera.get_fov() < 90.0)


func test_it_warns_of_people_behind_it() -> void:
	equal(_camera._get_configuration_warnings(), PackedStringArray())
	_camera.radius = 40.0
	contains(_camera._get_configuration_warnings()[0], "make 'Radius' smaller")
