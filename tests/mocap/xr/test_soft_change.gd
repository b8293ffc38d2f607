extends TestCase
## A jump becomes a short motion without one.


func test_a_jump_fades() -> void:
	var soft: SoftChange = SoftChange.new()
	soft.add_jump(Vector3(2, 0, 0), Vector3.ZERO)
	soft.add_turn(Quaternion(Vector3.UP, 2.5), Quaternion.IDENTITY)
	almost_equal(soft.offset, Vector3(2, 0, 0), 1e-6)
	almost_equal(soft.turn, Quaternion(Vector3.UP, 2.5), 1e-5)
	for _step: int in 60 * 6:
		var before: Vector3 = soft.offset
		var turned: Quaternion = soft.turn
		soft.advance(1.0 / 60.0)
		is_true(before.distance_to(soft.offset) < 1.01 / 60.0)
		is_true(Rotations.between(turned, soft.turn) < 2.02 / 60.0)
	almost_equal(soft.offset, Vector3.ZERO, 1e-3)
	almost_equal(soft.turn, Quaternion.IDENTITY, 1e-3)
