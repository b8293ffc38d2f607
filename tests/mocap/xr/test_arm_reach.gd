extends TestCase
## A hand goes to its controller, softly, and lets go of one that lies somewhere.

const LENGTHS: Vector2 = Vector2(0.3, 0.26)
const STEP_S: float = 1.0 / 60.0

var _pose: PoseSample = null


func before_each() -> void:
	_pose = PoseSample.new()
	for limb: int in Limbs.COUNT:
		_pose.set_orientation(limb, Quaternion.IDENTITY)


func test_it_arrives_without_a_jump() -> void:
	for side: int in 2:
		var out: float = 1.0 - 2.0 * side
		var arm: ArmReach = ArmReach.new(side)
		var goal: Vector3 = Vector3(out * 0.4, 0.1, 0.25)
		var last: Vector3 = Vector3(out * 0.56, 0.0, 0.0)
		for _step: int in 60:
			before_each()
			arm.apply(_pose, Vector3.ZERO, goal, true, LENGTHS, STEP_S)
			var wrist: Vector3 = _wrist(side)
			is_true(wrist.distance_to(last) < 0.03, "a step of %f m" % wrist.distance_to(last))
			last = wrist
		almost_equal(last, goal, 1e-3)
		# The elbow is behind the arm, as it was.
		is_true((_pose.orientation(4 + 3 * side) * Vector3(out, 0, 0)).z < 0.25)
		for _step: int in 60:
			before_each()
			arm.apply(_pose, Vector3.ZERO, goal, false, LENGTHS, STEP_S)
			var wrist: Vector3 = _wrist(side)
			is_true(wrist.distance_to(last) < 0.03, "back by %f m" % wrist.distance_to(last))
			last = wrist
		almost_equal(last, Vector3(out * 0.56, 0, 0), 1e-4)


func test_a_far_controller_is_let_go() -> void:
	var arm: ArmReach = ArmReach.new(0)
	for _step: int in 60:
		before_each()
		arm.apply(_pose, Vector3.ZERO, Vector3(-0.4, 0.3, 0.4), true, LENGTHS, STEP_S)
	equal(arm.weight, 0.0)


func _wrist(p_side: int) -> Vector3:
	var out: Vector3 = Vector3.RIGHT if p_side == 0 else Vector3.LEFT
	var upper: Vector3 = _pose.orientation(4 + 3 * p_side) * out * LENGTHS.x
	return upper + _pose.orientation(5 + 3 * p_side) * out * LENGTHS.y
