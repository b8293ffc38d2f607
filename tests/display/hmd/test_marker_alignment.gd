extends TestCase
## A marker on the real wall aligns room and world.

var _alignment: MarkerAlignment = null


func before_each() -> void:
	_alignment = MarkerAlignment.new()
	_alignment.in_world = Transform3D(Basis(Vector3.UP, 0.8), Vector3(12.0, 1.5, -4.0))


func test_the_room_is_found_from_one_sight() -> void:
	for heading: float in [-2.5, 0.0, 0.4, 3.0]:
		_alignment.clear()
		var room: Transform3D = Transform3D(Basis(Vector3.UP, heading), Vector3(3.0, 0.2, 7.0))
		is_true(_alignment.observe(room.affine_inverse() * _alignment.in_world))
		var found: Transform3D = _alignment.room()
		almost_equal(found.origin.distance_to(room.origin), 0.0, 1e-4)
		almost_equal(found.basis.x.distance_to(room.basis.x), 0.0, 1e-5)


func test_a_tilted_sight_does_not_tilt_the_world() -> void:
	_alignment.observe(Transform3D(Basis(Vector3(1, 0, 1).normalized(), 0.1), Vector3(0, 1, -2)))
	almost_equal(_alignment.room().basis.y.distance_to(Vector3.UP), 0.0, 1e-6)


func test_noise_is_averaged_and_certain_only_after_a_while() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 4
	var room: Transform3D = Transform3D(Basis(Vector3.UP, 1.0), Vector3(1.0, 0.0, 2.0))
	for i: int in 30:
		is_false(_alignment.is_certain())
		var seen: Transform3D = room.affine_inverse() * _alignment.in_world
		seen.basis = Basis(Vector3.UP, random.randfn(0.0, 0.01)) * seen.basis
		seen.origin += 0.005 * Vector3(random.randfn(), random.randfn(), random.randfn())
		_alignment.observe(seen)
	is_true(_alignment.is_certain())
	var found: Transform3D = _alignment.room()
	almost_equal(found.basis.x.distance_to(room.basis.x), 0.0, 0.008)
	var seen_at: Vector3 = found * (room.affine_inverse() * _alignment.in_world.origin)
	almost_equal(seen_at.distance_to(_alignment.in_world.origin), 0.0, 0.005)


func test_a_marker_on_the_floor_has_a_heading_too() -> void:
	_alignment.in_world = Transform3D(Basis(Vector3.RIGHT, -PI / 2.0), Vector3.ZERO)
	var room: Transform3D = Transform3D(Basis(Vector3.UP, 0.7), Vector3(1.0, 0.0, 0.0))
	_alignment.observe(room.affine_inverse() * _alignment.in_world)
	almost_equal(_alignment.room().basis.x.distance_to(room.basis.x), 0.0, 1e-4)


func test_what_cannot_be_is_not_taken() -> void:
	is_false(_alignment.observe(Transform3D(Basis.IDENTITY, Vector3(INF, 0.0, 0.0))))
	equal(_alignment.room(), Transform3D.IDENTITY)
	is_false(_alignment.look(), "nothing is tracked here")


func test_a_marker_that_moves_is_not_certain() -> void:
	for i: int in 30:
		_alignment.observe(Transform3D(Basis.IDENTITY, Vector3(0.01 * i, 1.0, -1.0)))
	is_false(_alignment.is_certain())
