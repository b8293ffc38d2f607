extends TestCase
## SlimeVR trackers without SlimeVR's server. Layouts are those of SlimeVR-Tracker-ESP
## (src/network/packets.h, connection.cpp) and of SlimeVR-Server's UDPPacket.kt.

const CLIP: String = "res://assets/motion/01_01.bvh"
const SENDER: String = "127.0.0.1:50123"
const BEGIN: int = 1_700_000_000_000_000
## A handshake as slimevr-node encodes it: type 3, number 0, board 9, sensor 4, processor 2, three
## zeros, build 17, "0.4.0", hardware address.
const HANDSHAKE: String = (
	"000000030000000000000000000000090000000400000002000000000000000000000000"
	+ "00000011"
	+ "05302e342e30"
	+ "246f28a1b2c3"
)
## Rotation (17) number 1 of sensor 0: normal, x 0, y 0, z sin 45, w cos 45, accuracy 0.
const ROTATION: String = (
	"000000110000000000000001" + "0001" + "00000000000000003f3504f33f3504f3" + "00"
)


func goes_by_clock() -> bool:
	return true


func test_a_tracker_is_answered_and_its_rotation_read() -> void:
	var peer: PacketPeerUDP = PacketPeerUDP.new()
	var feed: SlimeFeed = SlimeFeed.new()
	feed.open(0)
	equal(feed.error, "")
	peer.set_dest_address("127.0.0.1", feed.get_port())
	peer.put_packet(HANDSHAKE.hex_decode())
	for _frame: int in 3000:
		if peer.get_available_packet_count() > 0:
			break
		await process_frames(1)
	# 3, then the text that the firmware compares, then a zero.
	equal(peer.get_packet().hex_encode(), "03486579204f5652203d44203500")
	peer.put_packet(ROTATION.hex_decode())
	var sensors: Array[SensorInfo] = []
	for _frame: int in 3000:
		sensors = feed.list_sensors()
		if not sensors.is_empty():
			break
		await process_frames(1)
	equal(sensors.size(), 1)
	equal(sensors[0].id, "246F28A1B2C3-0")
	contains(feed.list_devices()[1]["detail"], "firmware 0.4.0")
	feed.close()
	peer.close()


func test_z_up_becomes_y_up() -> void:
	var feed: SlimeFeed = SlimeFeed.new()
	feed.take(HANDSHAKE.hex_decode(), SENDER, BEGIN)
	feed.take(ROTATION.hex_decode(), SENDER, BEGIN + 1000)
	var frames: Array[SensorFrame] = feed.frames_until(BEGIN + 30000)
	is_true(frames.size() >= 1)
	# A quarter turn about their vertical is one about ours.
	almost_equal(frames[-1].orientation(0), Quaternion(Vector3.UP, PI / 2.0), 1e-5)


func test_a_suit_of_twelve_arrives_through_loss_and_duplicates() -> void:
	var feed: SlimeFeed = SlimeFeed.new()
	var writer: SlimeWriter = SlimeWriter.new()
	var clip: BvhSource = _clip()
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 5
	var errors: Statistics = Statistics.new()
	for number: int in 480:
		var usec: int = BEGIN + number * 4167
		var pose: PoseSample = clip.pose_at(number * 0.004167)
		pose.time_usec = usec
		for datagram: PackedByteArray in writer.write(pose):
			for _copy: int in 2 if random.randf() < 0.05 else 1:
				if random.randf() >= 0.05 or datagram[3] == SlimeDevice.Packet.HANDSHAKE:
					feed.take(datagram, SENDER, usec + 2000)
		if number == 0:
			var answer: PackedByteArray = [3]
			answer.append_array(SlimeFeed.ANSWER.to_ascii_buffer())
			writer.answer(answer)
		for frame: SensorFrame in feed.frames_until(usec + 2000):
			equal(frame.find_fault(), "")
			var truth: PoseSample = clip.pose_at((frame.time_usec - 2000 - BEGIN) / 1e6)
			for at: int in frame.count():
				var limb: int = BodyMounts.LIMBS[writer.mounts[at]]
				if frame.present[at] != 0 and number > 20:
					errors.add(
						Rotations.between_deg(frame.orientation(at), truth.orientation(limb))
					)
	is_true(errors.count() > 1500, "%d" % errors.count())
	is_true(errors.percentile(0.95) < 0.1, "p95 %f deg" % errors.percentile(0.95))
	var sensors: Array[SensorInfo] = feed.list_sensors()
	equal(sensors.size(), writer.mounts.size())
	for at: int in sensors.size():
		equal(sensors[at].mount, BodyMounts.NAMES[writer.mounts[at]])
	almost_equal(sensors[0].battery, 0.8, 1e-6)
	contains(feed.list_devices()[1]["detail"], "magnetometer off")
	is_true(sensors[0].loss > 0.01 and sensors[0].loss < 0.12)


func test_gravity_is_felt() -> void:
	var feed: SlimeFeed = SlimeFeed.new()
	var writer: SlimeWriter = SlimeWriter.new()
	writer.mounts = [0]
	var pose: PoseSample = _clip().pose_at(1.0)
	pose.time_usec = BEGIN
	feed.take(writer.write(pose)[0], SENDER, BEGIN)
	var answer: PackedByteArray = [3]
	answer.append_array(SlimeFeed.ANSWER.to_ascii_buffer())
	writer.answer(answer)
	for datagram: PackedByteArray in writer.write(pose):
		feed.take(datagram, SENDER, BEGIN + 1000)
	var frame: SensorFrame = feed.frames_until(BEGIN + 40000)[-1]
	var up: Vector3 = frame.orientation(0) * frame.accelerations[0]
	almost_equal(up, Vector3(0.0, 9.80665, 0.0), 1e-3)


func test_trackers_are_told_that_somebody_is_there() -> void:
	var feed: SlimeFeed = SlimeFeed.new()
	feed.take(HANDSHAKE.hex_decode(), SENDER, BEGIN)
	var told: Array[StreamPort.Parcel] = feed.talk(BEGIN + 1000)
	equal(told.size(), 2)
	equal(told[0].bytes.hex_encode(), "000000010000000000000000", "heartbeat")
	equal(told[1].bytes.hex_encode(), "0000000a000000000000000000000001", "ping 1")
	equal([told[0].address, told[0].port], ["127.0.0.1", 50123])
	equal(feed.talk(BEGIN + 2000).size(), 0)
	var reply: PackedByteArray = "0000000a00000000000000050000000100".hex_decode().slice(0, 16)
	feed.take(reply, SENDER, BEGIN + 13000)
	contains(feed.list_devices()[1]["detail"], "ping 12 ms")


func test_a_tracker_that_comes_again_keeps_its_sensor() -> void:
	var feed: SlimeFeed = SlimeFeed.new()
	for port: int in [50123, 50124]:
		var sender: String = "127.0.0.1:%d" % port
		feed.take(HANDSHAKE.hex_decode(), sender, BEGIN)
		feed.take(ROTATION.hex_decode(), sender, BEGIN + 1000)
	equal(feed.list_sensors().size(), 1)
	equal(feed.list_devices().size(), 2)
	# Packets of somebody who never introduced themselves are nobody's.
	feed.take(ROTATION.hex_decode(), "127.0.0.1:9", BEGIN)
	equal(feed.list_sensors().size(), 1)


func test_what_is_none_is_reported() -> void:
	var feed: SlimeFeed = SlimeFeed.new()
	feed.take("hello".to_ascii_buffer(), SENDER, BEGIN)
	contains(feed.trouble(), "no SlimeVR packet")
	feed.take(HANDSHAKE.hex_decode(), SENDER, BEGIN)
	var writer: SlimeWriter = SlimeWriter.new()
	var pose: PoseSample = _clip().pose_at(1.0)
	var packets: Array[PackedByteArray] = writer.write(pose)
	var answer: PackedByteArray = [3]
	answer.append_array(SlimeFeed.ANSWER.to_ascii_buffer())
	writer.answer(answer)
	packets.append_array(writer.write(pose))
	packets.append(ROTATION.hex_decode())
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 9
	for number: int in 3000:
		var bytes: PackedByteArray = packets[number % packets.size()].duplicate()
		for _byte: int in random.randi_range(0, 6):
			bytes[random.randi() % bytes.size()] = random.randi() & 0xFF
		bytes.encode_u32(0, bytes.decode_u32(0) & 0xFF000000)
		bytes = bytes.slice(0, random.randi_range(4, bytes.size()))
		feed.take(bytes, SENDER, BEGIN + number * 5000)
		for frame: SensorFrame in feed.frames_until(BEGIN + number * 5000):
			equal(frame.find_fault(), "")
	is_true(feed.list_sensors().size() <= SlimeFeed.MAX_DEVICES * SlimeDevice.MAX_SENSORS)


func _clip() -> BvhSource:
	var clip: BvhSource = BvhSource.new()
	clip.open(CLIP)
	return clip
