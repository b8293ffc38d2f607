extends TestCase
## Landmarks of a webcam: where limbs point, how elbows and knees turn them, and what is no
## landmark.

const CLIP: String = "res://assets/motion/01_01.bvh"
## Directions of limbs in the reset pose that their points show.
const ALONG: Dictionary[int, Vector3] = {
	Limbs.LEFT_UPPER_ARM: Vector3.RIGHT,
	Limbs.LEFT_LOWER_ARM: Vector3.RIGHT,
	Limbs.RIGHT_UPPER_ARM: Vector3.LEFT,
	Limbs.RIGHT_LOWER_ARM: Vector3.LEFT,
	Limbs.LEFT_UPPER_LEG: Vector3.DOWN,
	Limbs.LEFT_LOWER_LEG: Vector3.DOWN,
	Limbs.LEFT_FOOT: Vector3.BACK,
	Limbs.RIGHT_UPPER_LEG: Vector3.DOWN,
	Limbs.RIGHT_LOWER_LEG: Vector3.DOWN,
	Limbs.RIGHT_FOOT: Vector3.BACK,
}


func test_limbs_point_where_the_points_are() -> void:
	var clip: BvhSource = _clip()
	var reader: WebcamReader = WebcamReader.new()
	var writer: WebcamWriter = WebcamWriter.new(clip.get_body())
	for step: int in 40:
		var pose: PoseSample = clip.pose_at(step * 0.1)
		pose.time_usec = step * 100000
		var samples: Array[StreamSample] = reader.read(writer.write(pose)[0], "x")
		equal(samples.size(), 1, reader.fault)
		equal(samples[0].name, "Dismount")
		for limb: int in ALONG:
			var came: Vector3 = samples[0].pose.orientation(limb) * ALONG[limb]
			var off: float = rad_to_deg(came.angle_to(pose.orientation(limb) * ALONG[limb]))
			is_true(off < 0.1, "%s points %f deg off" % [Limbs.BONES[limb], off])
		for limb: int in [Limbs.HEAD, Limbs.LEFT_HAND, Limbs.RIGHT_HAND]:
			var off: float = Rotations.between_deg(
				samples[0].pose.orientation(limb), pose.orientation(limb)
			)
			is_true(off < 0.1, "%s is %f deg off" % [Limbs.BONES[limb], off])


func test_a_bent_elbow_and_a_bent_knee_show_how_limbs_are_turned() -> void:
	var bent: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		bent.set_orientation(limb, Quaternion.IDENTITY)
	var arm: Quaternion = Quaternion(Vector3(1.0, 2.0, 0.5).normalized(), 0.8)
	bent.set_orientation(Limbs.LEFT_UPPER_ARM, arm)
	bent.set_orientation(Limbs.LEFT_LOWER_ARM, arm * Quaternion(Vector3.DOWN, 1.2))
	var leg: Quaternion = Quaternion(Vector3(0.3, 1.0, 0.2).normalized(), 0.5)
	bent.set_orientation(Limbs.RIGHT_UPPER_LEG, leg)
	bent.set_orientation(Limbs.RIGHT_LOWER_LEG, leg * Quaternion(Vector3.RIGHT, 0.9))
	var samples: Array[StreamSample] = WebcamReader.new().read(
		WebcamWriter.new().write(bent)[0], "x"
	)
	var limbs: PackedInt32Array = [Limbs.LEFT_UPPER_ARM, Limbs.LEFT_LOWER_ARM]
	limbs.append_array([Limbs.RIGHT_UPPER_LEG, Limbs.RIGHT_LOWER_LEG])
	for limb: int in limbs:
		var off: float = Rotations.between_deg(
			samples[0].pose.orientation(limb), bent.orientation(limb)
		)
		is_true(off < 0.1, "%s is %f deg off" % [Limbs.BONES[limb], off])


func test_mediapipe_s_own_form_is_read() -> void:
	var points: Array = []
	for point: Vector3 in WebcamWriter.new().landmarks(_clip().pose_at(0.0)):
		points.append({"x": point.x, "y": -point.y, "z": -point.z, "visibility": 0.9})
	var text: String = JSON.stringify({"worldLandmarks": [points]})
	var samples: Array[StreamSample] = WebcamReader.new().read(text.to_utf8_buffer(), "x")
	equal(samples.size(), 1)
	equal(samples[0].source_usec, -1)


func test_what_is_not_seen_is_filled() -> void:
	var message: Dictionary = JSON.parse_string(
		WebcamWriter.new().write(_clip().pose_at(1.0))[0].get_string_from_utf8()
	)
	for point: int in [LandmarkPose.KNEE, LandmarkPose.ANKLE, LandmarkPose.WRIST]:
		message["world_landmarks"][point][3] = 0.1
	var reader: WebcamReader = WebcamReader.new()
	var samples: Array[StreamSample] = reader.read(JSON.stringify(message).to_utf8_buffer(), "x")
	equal(samples.size(), 1)
	equal(samples[0].pose.find_fault(), "")
	equal(samples[0].pose.details.measured[Limbs.LEFT_LOWER_LEG], 0)
	equal(samples[0].pose.details.measured[Limbs.RIGHT_LOWER_LEG], 1)
	# Who sits at a desk shows no hips.
	message["world_landmarks"][LandmarkPose.HIP][3] = 0.1
	samples = reader.read(JSON.stringify(message).to_utf8_buffer(), "x")
	equal(samples.size(), 1)
	equal(samples[0].pose.details.measured[Limbs.HIPS], 0)
	message["world_landmarks"][LandmarkPose.SHOULDER][3] = 0.1
	equal(reader.read(JSON.stringify(message).to_utf8_buffer(), "x").size(), 0)
	contains(reader.fault, "not seen")


func test_news_and_small_pictures_are_kept_for_the_panel() -> void:
	var reader: WebcamReader = WebcamReader.new()
	var news: Dictionary = {"rate_hz": 29.7, "work_ms": 21.0, "faults": ["it is dark", 3, "x\n"]}
	equal(reader.read(JSON.stringify({"status": news}).to_utf8_buffer(), "x").size(), 0)
	equal(reader.fault, "")
	contains(reader.detail("x"), "30 pictures/s")
	contains(reader.trouble("x"), "it is dark")
	is_true(not reader.trouble("x").contains("\n"))
	equal(reader.trouble("y"), "")
	var image: Image = Image.create(32, 18, false, Image.FORMAT_RGB8)
	reader.read(image.save_jpg_to_buffer(), "x")
	equal(reader.picture.count(), 0, "a stranger's picture is none")
	reader.fault = ""
	reader.helper = WebcamHelper.new()
	reader.read(image.save_jpg_to_buffer(), "x")
	equal(reader.fault, "")
	equal(reader.picture.count(), 1)
	equal(reader.picture.image().get_size(), Vector2i(32, 18))
	for strange: String in ['{"status": 3}', '{"status": {"faults": 4, "rate_hz": "x"}}']:
		equal(reader.read(strange.to_utf8_buffer(), "x").size(), 0)
		equal(reader.fault, "")


func test_landmarks_in_the_picture_are_checked() -> void:
	var message: Dictionary = JSON.parse_string(
		WebcamWriter.new().write(_clip().pose_at(1.0))[0].get_string_from_utf8()
	)
	var points: Array = []
	for number: int in WebcamReader.POINTS:
		points.append([0.5, 0.3 + 0.005 * number, 0.0, 0.9])
	message["picture"] = [1280, 720]
	message["landmarks"] = points
	var reader: WebcamReader = WebcamReader.new()
	equal(reader.read(JSON.stringify(message).to_utf8_buffer(), "x").size(), 1)
	equal(reader.picture.people(reader.now_usec).size(), 1)
	equal(reader.picture.people(reader.now_usec + 2000000).size(), 0)
	message["picture"] = [1280, 0]
	equal(reader.read(JSON.stringify(message).to_utf8_buffer(), "x").size(), 0)
	contains(reader.fault, "pixels")
	message["picture"] = [1280, 720]
	points[3] = [0.1, "x", 0.0, 1.0]
	equal(reader.read(JSON.stringify(message).to_utf8_buffer(), "x").size(), 0)
	contains(reader.fault, "in the picture")


func test_what_is_none_is_reported() -> void:
	var reader: WebcamReader = WebcamReader.new()
	var cases: Dictionary[String, String] = {
		"0 landmarks": "{}",
		"2 landmarks": '{"world_landmarks": [[0,0,0],[1,1,1]]}',
		"no [x, y, z": '{"world_landmarks": [%s[0,"x",1]]}' % "[0,0,0,1],".repeat(32),
		"finite": '{"world_landmarks": [%s[0,1e99,1]]}' % "[0,0,0,1],".repeat(32),
		"not seen": '{"world_landmarks": [%s[0,0,0]]}' % "[0,0,0],".repeat(32),
	}
	for wanted: String in cases:
		reader.fault = ""
		equal(reader.read(cases[wanted].to_utf8_buffer(), "x").size(), 0, wanted)
		contains(reader.fault, wanted)
	var status: PackedByteArray = '{"status": {"faults": ["dark"], "rate_hz": 3}}'.to_utf8_buffer()
	equal(LossyLine.fuzz(reader, [status] as Array[PackedByteArray], 500), "")
	equal(LossyLine.fuzz(reader, WebcamWriter.new().write(_clip().pose_at(1.0)), 500), "")


func _clip() -> BvhSource:
	var clip: BvhSource = BvhSource.new()
	clip.open(CLIP)
	return clip
