extends TestCase
## Recentring, seated, and turning on the spot.

var _centre: Recentring = Recentring.new()
var _head: Transform3D = Transform3D(
	Basis(Vector3.UP, 1.1) * Basis(Vector3.RIGHT, 0.4), Vector3(0.7, 1.5, -0.3)
)


func before_each() -> void:
	_centre = Recentring.new()


func test_head_becomes_origin_and_heading() -> void:
	_centre.recentre(_head)
	var head: Transform3D = _centre.transform() * _head
	almost_equal(head.origin.x, 0.0, 1e-5)
	almost_equal(head.origin.z, 0.0, 1e-5)
	almost_equal(head.origin.y, 1.5, 1e-5, "the runtime's height stays")
	almost_equal(Recentring.heading_of(head.basis), 0.0, 1e-5)
	almost_equal((_centre.transform().basis * Vector3.UP).distance_to(Vector3.UP), 0.0, 1e-6)


func test_seated_eyes_are_as_high_as_standing_ones() -> void:
	_centre.is_seated = true
	_head.origin.y = 1.1
	_centre.recentre(_head)
	almost_equal((_centre.transform() * _head).origin.y, Recentring.STANDING_EYES_M, 1e-5)


func test_turning_leaves_the_head_where_it_is() -> void:
	_centre.recentre(_head)
	var before: Transform3D = _centre.transform() * _head
	for i: int in 12:
		_centre.turn(deg_to_rad(30.0), _head)
		almost_equal((_centre.transform() * _head).origin.distance_to(before.origin), 0.0, 1e-4)
	almost_equal(
		Recentring.heading_of((_centre.transform() * _head).basis), 0.0, 1e-3, "a full turn"
	)
	_centre.turn(deg_to_rad(30.0), _head)
	almost_equal(Recentring.heading_of((_centre.transform() * _head).basis), deg_to_rad(30.0), 1e-3)


func test_somebody_who_looks_down_has_a_heading() -> void:
	var down: Basis = Basis(Vector3.UP, 0.6) * Basis(Vector3.RIGHT, -PI / 2.0)
	almost_equal(Recentring.heading_of(down), 0.6, 1e-4)
	var up: Basis = Basis(Vector3.UP, 0.6) * Basis(Vector3.RIGHT, PI / 2.0)
	almost_equal(Recentring.heading_of(up), 0.6, 1e-4)


func test_a_lost_head_changes_nothing() -> void:
	_centre.recentre(Transform3D(Basis.IDENTITY, Vector3(NAN, 0.0, 0.0)))
	_centre.turn(NAN, _head)
	equal(_centre.transform(), Transform3D.IDENTITY)
