extends TestCase
## Rotations for calibration: exact for small angles, robust means.

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 4


func test_small_angles_are_exact() -> void:
	for angle: float in [1e-5, 1e-4, 1e-3, 0.1, 1.0, 3.0]:
		for round: int in 20:
			var base: Quaternion = any_rotation(_random)
			var turned: Quaternion = base * Quaternion(any_axis(_random), angle)
			almost_equal(Rotations.between(base, turned), angle, 1e-6 + angle * 1e-4)


func test_vectors_and_back() -> void:
	for round: int in 200:
		var turned: Quaternion = any_rotation(_random)
		almost_equal(Rotations.from_vector(Rotations.vector(turned)), turned, 1e-5)
		is_true(Rotations.vector(turned).length() < PI + 1e-4)
	almost_equal(Rotations.vector(Quaternion.IDENTITY), Vector3.ZERO)


func test_yaw() -> void:
	for round: int in 200:
		var yaw: float = _random.randf_range(-3.1, 3.1)
		almost_equal(Rotations.yaw_of(Rotations.yaw(yaw)), yaw, 1e-5)
		almost_equal(Rotations.facing_of(Rotations.yaw(yaw)), yaw, 1e-5)
		var tilt: Quaternion = Quaternion(Vector3.RIGHT.rotated(Vector3.UP, yaw * 3.0), 0.7)
		almost_equal(Rotations.yaw_of(Rotations.yaw(yaw) * tilt), yaw, 1e-4)


func test_the_mean_is_in_the_middle() -> void:
	for round: int in 20:
		var middle: Quaternion = any_rotation(_random)
		var samples: Array[Quaternion] = []
		for side: int in 50:
			var off: Quaternion = Quaternion(any_axis(_random), _random.randf_range(0.0, 0.3))
			var sign: float = -1.0 if _random.randf() < 0.5 else 1.0
			samples.append(middle * off * sign)
			samples.append(middle * off.inverse())
		is_true(Rotations.between_deg(Rotations.mean(samples), middle) < 0.5)


func test_odd_samples_hardly_move_a_robust_mean() -> void:
	for round: int in 20:
		var middle: Quaternion = any_rotation(_random)
		var samples: Array[Quaternion] = []
		for sample: int in 90:
			samples.append(middle * Quaternion(any_axis(_random), deg_to_rad(0.2)))
		for sample: int in 10:
			samples.insert(_random.randi_range(0, 50), any_rotation(_random))
		var found: Quaternion = Rotations.mean(samples, deg_to_rad(2.0))
		is_true(Rotations.between_deg(found, middle) < 0.3)
	equal(Rotations.mean([]), Quaternion.IDENTITY)


static func any_axis(p_random: RandomNumberGenerator) -> Vector3:
	var axis: Vector3 = Vector3.ZERO
	while axis.length() < 0.1:
		axis = Vector3(p_random.randfn(), p_random.randfn(), p_random.randfn())
	return axis.normalized()


static func any_rotation(p_random: RandomNumberGenerator) -> Quaternion:
	return Quaternion(any_axis(p_random), p_random.randf_range(-PI, PI))
