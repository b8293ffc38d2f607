extends TestCase
## Landmarks of a person whose pose is known become that pose: where the camera is and how far it
## looks down, noise, and limbs that are lost and come again.

const CLIP: String = "res://assets/motion/Boxing_Toes.bvh"
const STEP_USEC: int = 33333

var _clip: BvhSource = BvhSource.new()


func before_each() -> void:
	_clip.open(CLIP)


func test_a_straight_body_shows_how_far_the_camera_looks_down() -> void:
	for tilt_deg: float in [-5.0, 4.0, 15.0]:
		var camera: SyntheticCamera = SyntheticCamera.new()
		camera.tilt = deg_to_rad(tilt_deg)
		var solver: LandmarkSolver = LandmarkSolver.new()
		for step: int in 90:
			solver.solve(camera.see(_standing(Vector3.ZERO), step * STEP_USEC))
		# A part of it is what cameras usually do: nobody stands quite straight.
		var off: float = absf(rad_to_deg(solver.tilt()) - tilt_deg)
		is_true(off < 4.5, "%.0f deg is found %.1f deg off" % [tilt_deg, off])


func test_limbs_point_where_they_do_with_and_without_noise() -> void:
	for noise_m: float in [0.0, 0.02]:
		var camera: SyntheticCamera = SyntheticCamera.new()
		camera.tilt = deg_to_rad(CameraView.USUAL_TILT_DEG)
		camera.noise_m = noise_m
		camera.noise_picture = noise_m / 4.0
		var solver: LandmarkSolver = LandmarkSolver.new()
		var errors: Statistics = Statistics.new()
		for step: int in 150:
			var pose: PoseSample = _clip.pose_at(step * STEP_USEC / 1e6)
			var found: PoseSample = solver.solve(camera.see(pose, step * STEP_USEC))
			equal(found.find_fault(), "")
			for limb: int in SyntheticCamera.ALONG:
				var wanted: Vector3 = pose.orientation(limb) * SyntheticCamera.ALONG[limb]
				errors.add(
					rad_to_deg(
						(found.orientation(limb) * SyntheticCamera.ALONG[limb]).angle_to(wanted)
					)
				)
		var most: float = 5.0 if noise_m == 0.0 else 8.0
		is_true(errors.mean() < most, "%.2f m of noise: %.1f deg" % [noise_m, errors.mean()])


func test_who_walks_is_where_he_walks_to() -> void:
	var camera: SyntheticCamera = SyntheticCamera.new()
	camera.tilt = deg_to_rad(CameraView.USUAL_TILT_DEG)
	camera.noise_picture = 0.002
	var solver: LandmarkSolver = LandmarkSolver.new()
	var found: PoseSample = null
	for step: int in 240:
		var way: float = clampf((step - 60) / 90.0, 0.0, 1.0)
		var pose: PoseSample = _standing(Vector3(0.8, 0.0, -1.0) * way)
		found = solver.solve(camera.see(pose, step * STEP_USEC))
	var off: Vector3 = found.root - Vector3(0.8, found.root.y, -1.0)
	is_true(off.length() < 0.15, "%s m off" % off)
	is_true(found.root.y > 0.8 and found.root.y < 1.1, "hips at %.2f m" % found.root.y)


func test_limbs_that_are_lost_are_never_thrown_about() -> void:
	var camera: SyntheticCamera = SyntheticCamera.new()
	camera.dropouts = 0.3
	camera.noise_m = 0.01
	var solver: LandmarkSolver = LandmarkSolver.new()
	var before: PoseSample = null
	var jumps: Statistics = Statistics.new()
	for step: int in 300:
		var frame: LandmarkFrame = camera.see(_standing(Vector3.ZERO), step * STEP_USEC)
		var pose: PoseSample = solver.solve(frame)
		if before != null:
			for limb: int in SyntheticCamera.ALONG:
				var from: Vector3 = before.orientation(limb) * SyntheticCamera.ALONG[limb]
				jumps.add(
					rad_to_deg(from.angle_to(pose.orientation(limb) * SyntheticCamera.ALONG[limb]))
				)
		before = pose
	is_true(jumps.percentile(0.99) < 12.0, "%.1f deg in a picture" % jumps.percentile(0.99))
	is_true(jumps.percentile(1.0) < 40.0, "%.1f deg in a picture" % jumps.percentile(1.0))


func test_legs_out_of_the_picture_stand_below_the_hips() -> void:
	var camera: SyntheticCamera = SyntheticCamera.new()
	var solver: LandmarkSolver = LandmarkSolver.new()
	var found: PoseSample = null
	for step: int in 150:
		var frame: LandmarkFrame = camera.see(_standing(Vector3.ZERO), step * STEP_USEC)
		for point: int in range(LandmarkPose.HIP, WebcamReader.POINTS):
			frame.seen[point] = 0.01
			frame.places[point] = Vector3(0.3, 0.4, 0.5)
		found = solver.solve(frame)
	for limb: int in Limbs.LEGS:
		var down: Vector3 = found.orientation(limb) * Vector3.DOWN
		is_true(down.angle_to(Vector3.DOWN) < deg_to_rad(12.0), Limbs.BONES[limb])
		equal(found.details.measured[limb], 0)


func test_knees_and_elbows_bend_one_way_only() -> void:
	var camera: SyntheticCamera = SyntheticCamera.new()
	camera.noise_m = 0.06
	var solver: LandmarkSolver = LandmarkSolver.new()
	for step: int in 300:
		var found: PoseSample = solver.solve(camera.see(_standing(Vector3.ZERO), step * STEP_USEC))
		var pelvis: Quaternion = found.orientation(Limbs.HIPS)
		for thigh: int in [Limbs.LEFT_UPPER_LEG, Limbs.RIGHT_UPPER_LEG]:
			var along: Vector3 = found.orientation(thigh) * Vector3.DOWN
			var shank: Vector3 = found.orientation(thigh + 1) * Vector3.DOWN
			var forward: float = (pelvis * Vector3.RIGHT).dot(shank.cross(along))
			is_true(forward < sin(deg_to_rad(6.0)), "a knee bends forward by %.2f" % forward)


func _standing(p_way: Vector3) -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		pose.set_orientation(limb, Quaternion.IDENTITY)
	var hang: Quaternion = Quaternion(Vector3.BACK, -1.3)
	for limb: int in [Limbs.LEFT_UPPER_ARM, Limbs.LEFT_LOWER_ARM, Limbs.LEFT_HAND]:
		pose.set_orientation(limb, hang)
		pose.set_orientation(limb + 3, hang.inverse())
	pose.root = Vector3(0.0, 0.93, 0.0) + p_way
	return pose
