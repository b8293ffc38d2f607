extends TestCase
## Poses that come by the VMC protocol: frames, loss, and what no sender should send.

const CLIP: String = "res://assets/motion/01_01.bvh"
const SENDER: String = "127.0.0.1:50000"
const OscTest: GDScript = preload("res://tests/mocap/vmc/test_osc.gd")


func test_unity_s_frame_as_python_osc_writes_it() -> void:
	var reader: VmcReader = VmcReader.new()
	# A frame is known as whole when the next one begins; fewer than three bones are nobody, so the
	# head comes with it.
	var samples: Array[StreamSample] = []
	for time: float in [1.0, 2.0]:
		var parts: Array[PackedByteArray] = [
			Osc.message("/VMC/Ext/T", [time]),
			Osc.message("/VMC/Ext/Bone/Pos", ["Head", 0.0, 0.6, 0.0, 0.0, 0.0, 0.0, 1.0]),
		]
		reader.read(Osc.bundle(parts), SENDER)
		samples = reader.read(_at_time(OscTest.python_osc(), time), SENDER)
	equal(reader.fault, "")
	equal(samples.size(), 1)
	var pose: PoseSample = samples[0].pose
	# In Unity a turn of +90 degrees about Y is to the right: X forward. Here that is -90.
	var hips: Quaternion = Quaternion(Vector3.UP, -PI / 2.0)
	almost_equal(pose.orientation(Limbs.HIPS), hips, 1e-5)
	almost_equal(pose.orientation(Limbs.HEAD), hips, 1e-5)
	# About Unity's Z by 60 degrees, on top of the hips' turn.
	var arm: Quaternion = hips * Quaternion(Vector3.BACK, -PI / 3.0)
	almost_equal(pose.orientation(Limbs.LEFT_LOWER_ARM), arm, 1e-5)
	# The root is at (0.5, 0, -0.25), the model twice as large as its wearer.
	almost_equal(samples[0].pose.details.joints.size(), 0, 0.0, "no joints but those of limbs")


func test_a_clip_arrives_as_it_is() -> void:
	var clip: BvhSource = _clip()
	var line: LossyLine = LossyLine.new()
	line.loss = 0.0
	line.twice = 0.0
	line.jitter_usec = 0
	var stream: PoseStream = PoseStream.new(VmcReader.new())
	var person: StreamPerson = line.run(clip, VmcWriter.new(clip.get_body()), stream, 3.0)
	is_true(line.count > 50)
	is_true(line.worst_deg() < 0.01, "%f deg" % line.worst_deg())
	is_true(line.worst_root < 0.001, "%f m" % line.worst_root)
	almost_equal(person.get_hip_height(), clip.get_hip_height(), 0.01)
	equal(person.stats()["faulty"], 0)


func test_loss_and_duplicates_are_hardly_seen() -> void:
	var clip: BvhSource = _clip()
	var line: LossyLine = LossyLine.new(5)
	var stream: PoseStream = PoseStream.new(VmcReader.new())
	line.run(clip, VmcWriter.new(clip.get_body()), stream, 4.0)
	is_true(line.count > 80)
	is_true(line.errors.mean() < 0.05, "mean %f deg" % line.errors.mean())
	is_true(line.errors.percentile(0.95) < 0.1, "p95 %f deg" % line.errors.percentile(0.95))


func test_a_time_that_stands_or_is_too_coarse_is_not_believed() -> void:
	var clip: BvhSource = _clip()
	# Stopped; Unix time in 32 bits, which has steps of 128 s; three days of uptime.
	for shown: Callable in [
		func(_at_s: float) -> float: return 0.0,
		func(at_s: float) -> float: return snappedf(1.7e9 + at_s, 128.0),
		func(at_s: float) -> float: return snappedf(260000.0 + at_s, 0.03125),
	]:
		var writer: VmcWriter = VmcWriter.new(clip.get_body())
		var reader: VmcReader = VmcReader.new()
		var osc: Osc = Osc.new()
		var count: int = 0
		for number: int in 200:
			var pose: PoseSample = clip.pose_at(1.0 + number / 100.0)
			pose.time_usec = number * 10000
			var parts: Array[PackedByteArray] = []
			for datagram: PackedByteArray in writer.write(pose):
				for message: Array in osc.read(datagram):
					var arguments: Array = message.slice(1)
					if message[0] == "/VMC/Ext/T":
						arguments = [shown.call(number / 100.0)]
					parts.append(Osc.message(message[0], arguments))
			count += reader.read(Osc.bundle(parts), SENDER).size()
		equal(reader.fault, "")
		is_true(count > 150, "%d of 200 frames" % count)


func test_messages_that_come_alone_are_frames_too() -> void:
	var clip: BvhSource = _clip()
	var writer: VmcWriter = VmcWriter.new(clip.get_body())
	var reader: VmcReader = VmcReader.new()
	var osc: Osc = Osc.new()
	var worst: float = 0.0
	var count: int = 0
	var before: PoseSample = null
	for number: int in 30:
		var pose: PoseSample = clip.pose_at(number / 60.0)
		pose.time_usec = number * 16667
		for datagram: PackedByteArray in writer.write(pose):
			for message: Array in osc.read(datagram):
				var alone: PackedByteArray = Osc.message(message[0], message.slice(1))
				for sample: StreamSample in reader.read(alone, SENDER):
					# The first one is known when the second one begins.
					var truth: PoseSample = before if count == 0 else pose
					count += 1
					for limb: int in Limbs.COUNT:
						var off: Quaternion = truth.orientation(limb)
						worst = maxf(
							worst, Rotations.between_deg(sample.pose.orientation(limb), off)
						)
		before = pose
	is_true(count >= 28, "%d of 30" % count)
	is_true(worst < 0.01, "%f deg" % worst)


func test_messages_that_come_alone_are_joined_though_some_get_lost() -> void:
	var clip: BvhSource = _clip()
	var writer: VmcWriter = VmcWriter.new(clip.get_body())
	var stream: PoseStream = PoseStream.new(VmcReader.new())
	var osc: Osc = Osc.new()
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 6
	var errors: Statistics = Statistics.new()
	for number: int in 480:
		var usec: int = LossyLine.BEGIN_USEC + number * 4167
		var pose: PoseSample = clip.pose_at(number / 240.0)
		pose.time_usec = usec
		for datagram: PackedByteArray in writer.write(pose):
			for message: Array in osc.read(datagram):
				if random.randf() >= 0.05:
					var alone: PackedByteArray = Osc.message(message[0], message.slice(1))
					stream.take(alone, SENDER, usec)
		stream.look(usec / 1e6)
		for person: StreamPerson in stream.people.values():
			var came: PoseSample = person.sample(usec)
			if came == null or number < 60:
				continue
			var truth: PoseSample = clip.pose_at((came.time_usec - LossyLine.BEGIN_USEC) / 1e6)
			for limb: int in Limbs.COUNT:
				errors.add(Rotations.between_deg(came.orientation(limb), truth.orientation(limb)))
	is_true(errors.count() > 3000)
	is_true(errors.mean() < 0.5, "mean %f deg" % errors.mean())


func test_what_is_no_bone_is_told_and_left_out() -> void:
	var reader: VmcReader = VmcReader.new()
	var cases: Dictionary[String, Array] = {
		"too few": ["Hips", 0.0, 1.0],
		"finite": ["Hips", 0.0, NAN, 0.0, 0.0, 0.0, 0.0, 1.0],
		"no finite": ["Hips", 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, INF],
		"length 0.00": ["Hips", 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
		"number": ["Hips", 0.0, 1.0, 0.0, "x", 0.0, 0.0, 1.0],
	}
	for wanted: String in cases:
		reader.fault = ""
		equal(reader.read(Osc.message("/VMC/Ext/Bone/Pos", cases[wanted]), SENDER).size(), 0)
		contains(reader.fault, wanted)
	reader.fault = ""
	var tail: Array = ["Tail", 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]
	reader.read(Osc.message("/VMC/Ext/Bone/Pos", tail), SENDER)
	reader.read(Osc.message("/VMC/Ext/Blend/Val", ["Joy", 1.0]), SENDER)
	equal(reader.fault, "", "unknown bones and messages are no fault")


func test_random_bytes_and_a_crowd_are_survived() -> void:
	var clip: BvhSource = _clip()
	var whole: Array[PackedByteArray] = VmcWriter.new(clip.get_body()).write(clip.pose_at(1.0))
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 11
	var stream: PoseStream = PoseStream.new(VmcReader.new())
	for number: int in 1500:
		var bytes: PackedByteArray = whole[number % whole.size()].duplicate()
		for _byte: int in random.randi_range(0, 8):
			bytes[random.randi() % bytes.size()] = random.randi() & 0xFF
		bytes = bytes.slice(0, random.randi_range(0, bytes.size()))
		stream.take(bytes, "10.0.0.%d:39539" % (number % 40), LossyLine.BEGIN_USEC + number * 1000)
	stream.look(LossyLine.BEGIN_USEC / 1e6)
	is_true(stream.people.size() <= PoseStream.MAX_PEOPLE)
	for person: StreamPerson in stream.people.values():
		equal(person.get_newest().find_fault() if person.get_newest() != null else "", "")


func test_a_sender_that_begins_anew_is_followed() -> void:
	var clip: BvhSource = _clip()
	var reader: VmcReader = VmcReader.new()
	var count: int = 0
	for _start: int in 2:
		var writer: VmcWriter = VmcWriter.new(clip.get_body())
		for number: int in 200:
			var pose: PoseSample = clip.pose_at(number / 60.0)
			pose.time_usec = number * 16667
			for datagram: PackedByteArray in writer.write(pose):
				count += reader.read(datagram, SENDER).size()
	is_true(count > 395, "%d of 400" % count)


func test_a_sender_without_a_model_is_reported() -> void:
	var reader: VmcReader = VmcReader.new()
	reader.read(Osc.message("/VMC/Ext/OK", [0]), SENDER)
	contains(reader.trouble(SENDER), "model")
	reader.read(Osc.message("/VMC/Ext/OK", [1, 1, 0]), SENDER)
	contains(reader.trouble(SENDER), "calibrate")
	reader.read(Osc.message("/VMC/Ext/OK", [1, 3, 0]), SENDER)
	equal(reader.trouble(SENDER), "")
	reader.read(
		Osc.message("/VMC/Ext/Tra/Pos", ["LHR-1", 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]), SENDER
	)
	contains(reader.detail(SENDER), "LHR-1")


## The same bundle with another time.
static func _at_time(p_bundle: PackedByteArray, p_time: float) -> PackedByteArray:
	var bytes: PackedByteArray = p_bundle.duplicate()
	var at: int = 76
	for step: int in 4:
		bytes[at + step] = PackedFloat32Array([p_time]).to_byte_array()[3 - step]
	return bytes


func _clip() -> BvhSource:
	var clip: BvhSource = BvhSource.new()
	clip.open(CLIP)
	return clip
