extends TestCase
## The shock wave of a bullet comes from its path, before the muzzle.

const SPEED: Vector3 = Vector3(0.0, 0.0, -820.0)


func test_who_is_beside_the_path_hears_it_before_the_muzzle() -> void:
	var ear: Vector3 = Vector3(20.0, 0.0, -300.0)
	var crack: BulletCrack = BulletCrack.of_shot(Vector3.ZERO, SPEED, 900.0, ear)
	is_true(crack.is_heard)
	almost_equal(crack.beside_m, 20.0, 1e-3)
	# Along the path, and then across at the angle of the cone.
	var mach: float = 820.0 / 343.0
	almost_equal(crack.delay_s, 300.0 / 820.0 + 20.0 / 343.0 * sqrt(1.0 - 1.0 / mach / mach), 1e-3)
	is_true(crack.delay_s < ear.length() / 343.0)
	is_true(crack.place.z > ear.z and crack.place.z < 0.0, "it comes from before the ear")


func test_who_is_behind_or_far_beside_hears_none() -> void:
	for ear: Vector3 in [
		Vector3(5.0, 0.0, 50.0), Vector3(400.0, 0.0, -100.0), Vector3(3.0, 0.0, -2000.0)
	]:
		is_false(BulletCrack.of_shot(Vector3.ZERO, SPEED, 900.0, ear).is_heard, str(ear))


func test_what_is_slower_than_sound_makes_none() -> void:
	var slow: Vector3 = Vector3(0.0, 0.0, -300.0)
	var ear: Vector3 = Vector3(5.0, 0.0, -100.0)
	is_false(BulletCrack.of_shot(Vector3.ZERO, slow, 900.0, ear).is_heard)
	is_false(BulletCrack.of_shot(Vector3.ZERO, Vector3(NAN, 0, 0), 900.0, ear).is_heard)
