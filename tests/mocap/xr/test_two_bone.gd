extends TestCase
## Elbows and knees are where the lengths of the limbs put them.


func test_lengths_are_kept_and_the_pole_is_obeyed() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 2
	for _round: int in 200:
		var base: Vector3 = Vector3(random.randf(), random.randf(), random.randf())
		var along: Vector3 = Vector3(random.randfn(), random.randfn(), random.randfn()).normalized()
		var end: Vector3 = base + along * random.randf_range(0.2, 0.5)
		var pole: Vector3 = Vector3(random.randfn(), random.randfn(), random.randfn())
		var middle: Vector3 = TwoBone.middle(base, end, 0.3, 0.26, pole)
		almost_equal(base.distance_to(middle), 0.3, 1e-4)
		almost_equal(middle.distance_to(end), 0.26, 1e-4)
		is_true((middle - base).dot(TwoBone.across(pole, along)) > -1e-5)


func test_what_is_out_of_reach_is_a_straight_limb() -> void:
	for end: Vector3 in [Vector3(9, 0, 0), Vector3(0.001, 0, 0), Vector3.ZERO]:
		var middle: Vector3 = TwoBone.middle(Vector3.ZERO, end, 0.3, 0.26, Vector3.DOWN)
		is_true(middle.is_finite(), str(end))
		almost_equal(middle.length(), 0.3, 1e-4)
	var parallel: Vector3 = TwoBone.middle(Vector3.ZERO, Vector3.RIGHT, 0.3, 0.26, Vector3.RIGHT)
	is_true(parallel.is_finite(), "a pole along the limb")
