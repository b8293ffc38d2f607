extends TestCase
## Where a path leads, how long it is, and what it warns of.

const UP: Vector3 = Vector3.UP

var _path: WaypointPath = null


func before_each() -> void:
	_path = WaypointPath.new()
	_path.points = [Vector3.ZERO, Vector3(0.0, 0.0, 4.0), Vector3(3.0, 0.0, 4.0)]
	_path.position = Vector3(10.0, 1.0, 0.0)
	add_child(_path)


func after_each() -> void:
	_path.free()


func test_the_way() -> void:
	almost_equal(_path.get_length(), 7.0, 1e-5)
	almost_equal(_path.sample(2.0).origin, Vector3(10.0, 1.0, 2.0), 1e-5)
	almost_equal(_path.sample(5.0).origin, Vector3(11.0, 1.0, 4.0), 1e-5)
	almost_equal(_path.sample(5.0).basis.z, Vector3.RIGHT, 1e-5, "+Z points along the way")
	almost_equal(_path.sample(99.0).origin, Vector3(13.0, 1.0, 4.0), 1e-5)
	almost_equal(_path.sample(-9.0).origin, Vector3(10.0, 1.0, 0.0), 1e-5)
	equal(_path.get_places()[2], Vector3(13.0, 1.0, 4.0))


func test_a_closed_way() -> void:
	_path.is_closed = true
	almost_equal(_path.get_length(), 12.0, 1e-5)
	almost_equal(_path.sample(12.0 + 2.0).origin, Vector3(10.0, 1.0, 2.0), 1e-5)
	almost_equal(_path.sample(-2.5).origin, Vector3(11.5, 1.0, 2.0), 1e-5)


func test_too_few_points() -> void:
	for points: PackedVector3Array in [
		PackedVector3Array(), PackedVector3Array([Vector3.UP]), PackedVector3Array([UP, UP])
	]:
		_path.points = points
		almost_equal(_path.get_length(), 0.0, 1e-5)
		is_true(_path.sample(3.0).is_finite())
	_path.points = [UP]
	contains(_path._get_configuration_warnings()[0], "two points at least")
