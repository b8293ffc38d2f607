extends TestCase
## A back that the model takes for a front in some pictures stays a back; who turns is followed.

const STEP_USEC: int = 33333

var _keeper: FacingKeeper = null
var _camera: SyntheticCamera = null


func before_each() -> void:
	_keeper = FacingKeeper.new()
	_camera = SyntheticCamera.new()
	_camera.noise_m = 0.02


func test_a_back_that_is_taken_for_a_front_now_and_then_stays_a_back() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 7
	var wrong: int = 0
	for step: int in 300:
		# Turns away within a second, as seen rightly, and stays so for 9 s.
		var frame: LandmarkFrame = _see(clampf(step / 30.0, 0.0, 1.0) * 170.0, step)
		if step > 60 and (random.randf() < 0.2 or step % 90 < 25):
			_mistake(frame)
			wrong += 1
		_keeper.keep(frame)
		if step > 30:
			is_true(absf(_off_deg(frame, 170.0)) < 25.0, "%.0f off" % _off_deg(frame, 170.0))
	is_true(wrong > 60)


func test_points_are_those_of_the_person_again() -> void:
	_camera.noise_m = 0.0
	for step: int in 30:
		_keeper.keep(_see(180.0, step))
	var right: LandmarkFrame = _see(180.0, 30)
	var frame: LandmarkFrame = _see(180.0, 30)
	_mistake(frame)
	_keeper.keep(frame)
	for point: int in right.places.size():
		is_true(frame.places[point].distance_to(right.places[point]) < 1e-3)
		is_true(frame.rays[point].distance_to(right.rays[point]) < 1e-6)
		is_true(frame.in_picture[point].distance_to(right.in_picture[point]) < 1e-6)
		equal(frame.seen[point], right.seen[point])


func test_who_turns_about_again_and_again_is_followed() -> void:
	for turns_per_s: float in [0.4, -0.4, 1.0]:
		_keeper = FacingKeeper.new()
		for step: int in 240:
			var heading_deg: float = step / 30.0 * 360.0 * turns_per_s
			var frame: LandmarkFrame = _see(heading_deg, step)
			_keeper.keep(frame)
			is_true(absf(_off_deg(frame, heading_deg)) < 25.0, "at %.0f deg" % heading_deg)


func test_a_front_that_lasts_is_believed_and_a_back_sooner() -> void:
	# Between two pictures the person has turned about: nobody has seen how.
	for to_deg: float in [0.0, 180.0]:
		_keeper = FacingKeeper.new()
		var believed_s: float = INF
		for step: int in 240:
			var frame: LandmarkFrame = _see(to_deg if step >= 60 else 180.0 - to_deg, step)
			_keeper.keep(frame)
			if step >= 60 and believed_s == INF and absf(_off_deg(frame, to_deg)) < 25.0:
				believed_s = (step - 60) / 30.0
		is_true(believed_s < (3.5 if to_deg == 0.0 else 1.2), "believed after %.1f s" % believed_s)


func test_after_a_pause_the_model_is_believed_at_once() -> void:
	for step: int in 30:
		_keeper.keep(_see(180.0, step))
	var frame: LandmarkFrame = _see(0.0, 60)
	_keeper.keep(frame)
	is_true(absf(_off_deg(frame, 0.0)) < 25.0)


func test_points_that_lie_over_one_another_do_no_harm() -> void:
	var frame: LandmarkFrame = _see(0.0, 0)
	frame.places.fill(Vector3.ZERO)
	_keeper.keep(frame)
	equal(frame.places[LandmarkPose.SHOULDER], Vector3.ZERO)
	is_true(is_nan(FacingKeeper.heading(frame.places)))


## What the model sees of somebody who faces so far to the left of the camera, degrees.
func _see(p_heading_deg: float, p_step: int) -> LandmarkFrame:
	var pose: PoseSample = PoseSample.new()
	var heading: Quaternion = Quaternion(Vector3.UP, deg_to_rad(p_heading_deg))
	for limb: int in Limbs.COUNT:
		pose.set_orientation(limb, heading)
	pose.root = Vector3(0.0, 0.93, 0.0)
	return _camera.see(pose, p_step * STEP_USEC)


static func _off_deg(p_frame: LandmarkFrame, p_heading_deg: float) -> float:
	var heading: float = FacingKeeper.heading(p_frame.places)
	return rad_to_deg(wrapf(heading - deg_to_rad(p_heading_deg), -PI, PI))


## What the model makes of a frame when it takes the back for the front: left is right, near is far.
static func _mistake(r_frame: LandmarkFrame) -> void:
	var partners: PackedInt32Array = [0, 4, 5, 6, 1, 2, 3]
	for left: int in range(7, r_frame.places.size(), 2):
		partners.append_array([left + 1, left])
	var before: LandmarkFrame = LandmarkFrame.new()
	before.places = r_frame.places.duplicate()
	before.rays = r_frame.rays.duplicate()
	before.in_picture = r_frame.in_picture.duplicate()
	before.seen = r_frame.seen.duplicate()
	for point: int in partners.size():
		r_frame.places[point] = before.places[partners[point]] * Vector3(1.0, 1.0, -1.0)
		r_frame.rays[point] = before.rays[partners[point]]
		r_frame.in_picture[point] = before.in_picture[partners[point]]
		r_frame.seen[point] = before.seen[partners[point]]
