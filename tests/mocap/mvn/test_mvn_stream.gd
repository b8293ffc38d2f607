extends TestCase
## A person's motion through MVN's stream over a real socket of this machine, and what goes wrong on
## the way.

const CLIP: String = "res://assets/motion/01_01.bvh"
const MAX_DEG: float = 0.05
const MAX_M: float = 0.001
## How long a busy machine may take for a datagram.

var _stream: MvnStream = null
var _peer: PacketPeerUDP = null
var _people: Dictionary[RefCounted, String] = {}
var _gone: Array[MotionSource] = []
var _seen: PoseSample = null


func before_each() -> void:
	_people.clear()
	_gone.clear()
	_seen = null
	_stream = MvnStream.new()
	_stream.appeared.connect(
		func(p_one: MotionSource, p_name: String) -> void: _people[p_one] = p_name
	)
	_stream.vanished.connect(func(p_one: MotionSource) -> void: _gone.append(p_one))
	equal(_stream.open(0), "")
	_peer = PacketPeerUDP.new()
	_peer.set_dest_address("127.0.0.1", _stream.receiver.get_port())


func after_each() -> void:
	_stream.close()
	_peer.close()


func test_poses_arrive_as_the_file_has_them() -> void:
	for type: int in [1, 2, 5]:
		before_each()
		var source: BvhSource = _clip()
		var writer: MvnWriter = MvnWriter.new(source.get_body())
		writer.name = "Eve"
		writer.take(source.pose_at(0.0), 0.0)
		_send(writer.sample(12, 0, 0))
		_send(writer.sample(13, 0, 0))
		_send(writer.sample(type, 0, 0))
		var person: MvnSource = await _first_person()
		not_null(person, "type %d" % type)
		if person == null:
			return
		equal(_people[person], "Eve")
		equal((await _next(person)).details.counter, 0)
		almost_equal(person.get_hip_height(), source.get_hip_height(), 0.002)
		var worst: Vector2 = Vector2.ZERO
		for step: int in range(1, 60):
			var pose: PoseSample = source.pose_at(step / 10.0)
			writer.take(pose, step / 10.0)
			_send(writer.sample(type, step, step * 100))
			var came: PoseSample = await _next(person)
			not_null(came, "type %d, step %d" % [type, step])
			if came == null:
				return
			equal(came.find_fault(), "")
			equal(came.details.counter, step)
			worst = worst.max(_difference(came, pose))
		is_true(worst.x < MAX_DEG, "type %d is off by %f deg" % [type, worst.x])
		is_true(worst.y < MAX_M, "type %d is off by %f m" % [type, worst.y])
		after_each()


func test_several_people_come_and_go() -> void:
	var source: BvhSource = _clip()
	for number: int in 3:
		var writer: MvnWriter = MvnWriter.new(source.get_body())
		writer.character = number * 5
		writer.name = "P%d" % number
		writer.take(source.pose_at(number), 0.0)
		_send(writer.sample(12, 0, 0))
		_send(writer.sample(2, 0, 0))
	await until(func() -> bool: return _people.size() == 3, _stream.advance)
	equal(_people.size(), 3)
	for person: MvnSource in _people:
		@warning_ignore("integer_division")
		var number: int = person.character / 5
		equal(_people[person], "P%d" % number)
		var difference: Vector2 = _difference(person.get_newest(), source.pose_at(number))
		is_true(difference.x < MAX_DEG, "%f deg" % difference.x)
	await until(func() -> bool: return _stream.list_devices().size() == 4, _stream.advance)
	for row: Dictionary in _stream.list_devices():
		for key: String in DeviceList.KEYS:
			is_true(row[key] is String)
	contains(_stream.list_devices()[1]["name"], "P0")
	contains(_stream.list_devices()[1]["detail"], "types 02 12")
	_stream.close()
	equal(_gone.size(), 3)
	equal(_stream.people.size(), 0)


func test_centimetres_are_noticed() -> void:
	var source: BvhSource = _clip()
	var writer: MvnWriter = MvnWriter.new(source.get_body())
	var pose: PoseSample = source.pose_at(1.0)
	writer.take(pose, 0.0)
	var sample: Dictionary = writer.sample(2, 0, 0)
	var positions: PackedVector3Array = sample["positions"]
	for at: int in positions.size():
		positions[at] *= 100.0
	sample["positions"] = positions
	_send(sample)
	_send(writer.sample(12, 0, 0))
	var person: MvnSource = await _first_person()
	almost_equal((await _next(person)).root, pose.root, 0.001)


func test_both_quaternions_of_a_rotation_are_one_motion() -> void:
	var source: BvhSource = _clip()
	var writer: MvnWriter = MvnWriter.new(source.get_body())
	writer.take(source.pose_at(0.0), 0.0)
	_send(writer.sample(12, 0, 0))
	_send(writer.sample(2, 0, 0))
	var person: MvnSource = await _first_person()
	var before: PoseSample = await _next(person)
	for step: int in range(1, 20):
		writer.take(source.pose_at(step / 60.0), step / 60.0)
		var sample: Dictionary = writer.sample(2, step, step * 17)
		var wxyz: PackedFloat32Array = sample["orientations"]
		if step % 2 == 0:
			for at: int in wxyz.size():
				wxyz[at] = -wxyz[at]
		sample["orientations"] = wxyz
		_send(sample)
		var came: PoseSample = await _next(person)
		for limb: int in Limbs.COUNT:
			is_true(came.orientation(limb).dot(before.orientation(limb)) > 0.9)
		before = came


func test_fingers_are_joints_of_their_own() -> void:
	var source: BvhSource = _clip()
	var writer: MvnWriter = MvnWriter.new(source.get_body())
	writer.take(source.pose_at(0.0), 0.0)
	var sample: Dictionary = writer.sample(2, 0, 0)
	var segments: PackedInt32Array = sample["segments"]
	var positions: PackedVector3Array = sample["positions"]
	var wxyz: PackedFloat32Array = sample["orientations"]
	sample["props"] = 1
	sample["fingers"] = 40
	for extra: int in 41:
		segments.append(24 + extra)
		positions.append(Vector3.ZERO)
		var angle: float = 0.02 * extra
		# About MVN's Y, to the left: Godot's X.
		wxyz.append_array([cos(angle / 2.0), 0.0, sin(angle / 2.0), 0.0])
	sample["segments"] = segments
	sample["positions"] = positions
	sample["orientations"] = wxyz
	_send(sample)
	_send(writer.sample(12, 0, 0))
	var joints: Dictionary = (await _next(await _first_person())).details.joints
	# Behind the prop: the left carpus, three of the thumb, four of each finger; then the right hand.
	var wanted: Dictionary[int, int] = {
		XRBodyTracker.JOINT_LEFT_THUMB_METACARPAL: 2,
		XRBodyTracker.JOINT_LEFT_THUMB_PHALANX_DISTAL: 4,
		XRBodyTracker.JOINT_LEFT_INDEX_FINGER_METACARPAL: 5,
		XRBodyTracker.JOINT_LEFT_PINKY_FINGER_PHALANX_DISTAL: 20,
		XRBodyTracker.JOINT_RIGHT_THUMB_METACARPAL: 22,
		XRBodyTracker.JOINT_RIGHT_RING_FINGER_PHALANX_PROXIMAL: 34,
	}
	for joint: int in wanted:
		var turn: Quaternion = Quaternion(Vector3.RIGHT, 0.02 * wanted[joint])
		is_true(joints.has(joint) and joints[joint].angle_to(turn) < 0.002, "joint %d" % joint)
	is_false(joints.has(XRBodyTracker.JOINT_LEFT_THUMB_TIP))


func test_a_body_of_a_few_segments_is_filled() -> void:
	var source: BvhSource = _clip()
	var writer: MvnWriter = MvnWriter.new(source.get_body())
	var pose: PoseSample = source.pose_at(0.5)
	writer.take(pose, 0.0)
	var sample: Dictionary = writer.sample(2, 0, 0)
	for key: String in ["segments", "positions"]:
		sample[key] = sample[key].slice(0, 15)
	sample["orientations"] = sample["orientations"].slice(0, 60)
	_send(sample)
	_send(writer.sample(12, 0, 0))
	var came: PoseSample = await _next(await _first_person())
	equal(came.find_fault(), "")
	is_true(Rotations.between_deg(came.orientation(6), pose.orientation(6)) < MAX_DEG)
	equal(came.details.measured[6], 1)
	equal(came.details.measured[11], 0)


func test_trackers_become_sensors() -> void:
	var source: BvhSource = _clip()
	var writer: MvnWriter = MvnWriter.new(source.get_body())
	var feeds: Array[MvnTrackerFeed] = []
	_stream.trackers_appeared.connect(
		func(p_feed: MvnTrackerFeed, _p_name: String) -> void: feeds.append(p_feed)
	)
	var pose: PoseSample = source.pose_at(1.0)
	writer.take(source.pose_at(0.99), 0.99)
	writer.take(pose, 1.0)
	_send(writer.sample(12, 0, 0))
	_send(writer.sample(23, 0, 0))
	await until(func() -> bool: return not feeds.is_empty(), _stream.advance)
	equal(feeds.size(), 1)
	var frames: Array[SensorFrame] = feeds[0].take_frames()
	var sensors: Array[SensorInfo] = feeds[0].list_sensors()
	equal(frames.size(), 1)
	equal(sensors.size(), BodyMounts.COUNT)
	equal(frames[0].find_fault(), "")
	for at: int in sensors.size():
		var place: int = BodyMounts.find(sensors[at].mount)
		is_true(place >= 0, sensors[at].id)
		equal(sensors[at].state, SensorInfo.State.MEASURING)
		if not sensors[at].id.contains("Shoulder"):
			var turn: Quaternion = pose.orientation(BodyMounts.LIMBS[place])
			var off: float = Rotations.between_deg(frames[0].orientation(at), turn)
			is_true(off < MAX_DEG, "%s is off by %f deg" % [sensors[at].id, off])
		is_true(frames[0].accelerations[at].length() > 1.0)


func test_a_port_in_use_is_reported() -> void:
	var other: MvnStream = MvnStream.new()
	var fault: String = other.open(_stream.receiver.get_port())
	contains(fault, str(_stream.receiver.get_port()))
	contains(fault, "in use")
	contains(other.open(70000), "65535")


func test_rubbish_is_counted_and_told() -> void:
	_peer.put_packet("rubbish".to_ascii_buffer())
	var writer: MvnWriter = MvnWriter.new()
	writer.take(_clip().pose_at(0.0), 0.0)
	var datagram: PackedByteArray = MvnEncoder.encode(writer.sample(2, 0, 0))[0]
	datagram[11] = 255
	_peer.put_packet(datagram)
	await until(
		func() -> bool: return _stream.receiver.get_stats()["refused"] == 2, _stream.advance
	)
	equal(_stream.receiver.get_stats()["refused"], 2)
	contains(_stream.trouble(), "2 datagrams")
	equal(_people.size(), 0)


func test_samples_that_are_none_are_refused_by_the_encoder() -> void:
	expect_error('there is no "type"')
	equal(MvnEncoder.encode({}).size(), 0)
	expect_error('"positions" has another number')
	var bad: Dictionary = {
		"type": 3,
		"sample": 1,
		"segments": PackedInt32Array([1, 2]),
		"positions": PackedVector3Array([Vector3.ZERO]),
	}
	equal(MvnEncoder.encode(bad).size(), 0)
	expect_error("is no int")
	equal(MvnEncoder.encode({"type": "02", "sample": 1}).size(), 0)


func test_all_types_that_are_written_are_read() -> void:
	var writer: MvnWriter = MvnWriter.new()
	var source: BvhSource = _clip()
	writer.take(source.pose_at(0.0), 0.0)
	writer.take(source.pose_at(0.1), 0.1)
	for type: int in MvnWriter.TYPES:
		_send(writer.sample(type, 7, 100))
	await until(
		func() -> bool: return not _stream.receiver.get_newest(0, 25).is_empty(), _stream.advance
	)
	for type: int in MvnWriter.TYPES:
		var wanted: Dictionary = writer.sample(type, 7, 100)
		var came: Dictionary = _stream.receiver.get_newest(0, type)
		for key: String in wanted:
			equal(came.get(key), wanted[key], "type %d: %s" % [type, key])
	equal(_stream.receiver.get_characters()[0]["types"], PackedInt32Array(MvnWriter.TYPES))


func _clip() -> BvhSource:
	var source: BvhSource = BvhSource.new()
	source.open(CLIP)
	return source


func _send(p_sample: Dictionary) -> void:
	for datagram: PackedByteArray in MvnEncoder.encode(p_sample):
		_peer.put_packet(datagram)


func _first_person() -> MvnSource:
	await until(func() -> bool: return not _people.is_empty(), _stream.advance)
	return null if _people.is_empty() else _people.keys()[0]


## The next pose that is measured.
func _next(p_person: MvnSource) -> PoseSample:
	var limit: int = Time.get_ticks_msec() + int(Waiting.PATIENCE_S * 1000.0)
	while Time.get_ticks_msec() < limit:
		var found: PoseSample = p_person.get_newest()
		if found != null and found != _seen:
			_seen = found
			return found
		OS.delay_usec(200)
	return null


## The largest angle between two poses' limbs, degrees, and how far their roots are apart, m.
static func _difference(p_one: PoseSample, p_other: PoseSample) -> Vector2:
	var worst: float = 0.0
	for limb: int in Limbs.COUNT:
		var off: float = Rotations.between_deg(p_one.orientation(limb), p_other.orientation(limb))
		worst = maxf(worst, off)
	return Vector2(worst, p_one.root.distance_to(p_other.root))
