extends TestCase
## The hips are as high as the lower foot allows.


func test_standing() -> void:
	for height: float in [1.45, 1.75, 2.05]:
		var size: BodySize = BodySize.of_height(height)
		almost_equal(StandingHeight.new(size).of(_pose()), size.length(&"hip_height"), 1e-4)


func test_a_squat_goes_down_and_a_step_stands_on_the_other_foot() -> void:
	var size: BodySize = BodySize.of_height(1.75)
	var standing: StandingHeight = StandingHeight.new(size)
	var squat: PoseSample = _pose()
	for leg: int in [10, 13]:
		squat.set_orientation(leg, Quaternion(Vector3.RIGHT, -deg_to_rad(60.0)))
		squat.set_orientation(leg + 1, Quaternion(Vector3.RIGHT, deg_to_rad(60.0)))
	var legs: float = size.length(&"hip_height") - size.length(&"foot_height")
	almost_equal(standing.of(squat), legs * 0.5 + size.length(&"foot_height"), 0.01)
	var step: PoseSample = _pose()
	step.set_orientation(10, Quaternion(Vector3.RIGHT, -deg_to_rad(60.0)))
	almost_equal(standing.of(step), size.length(&"hip_height"), 1e-4)


func test_on_the_toes_the_hips_are_higher() -> void:
	var size: BodySize = BodySize.of_height(1.75)
	var pose: PoseSample = _pose()
	for foot: int in [12, 15]:
		pose.set_orientation(foot, Quaternion(Vector3.RIGHT, deg_to_rad(40.0)))
	is_true(StandingHeight.new(size).of(pose) > size.length(&"hip_height") + 0.05)


func _pose() -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		pose.set_orientation(limb, Quaternion.IDENTITY)
	return pose
