extends TestCase
## Recordings of raw bytes: written from a socket, composed by hand, played as motion.

const CLIP: String = "res://assets/motion/01_01.bvh"
const FOLDER: String = "user://test_recording"
const START_USEC: int = 1780000000000000
## How long a busy machine may take for what was sent.
## From docs/xbus.md: DeviceID of an MTi-30, and MTData2 with counter, quaternion, acceleration and
## rate of turn.
const DEVICE_ID: String = "FAFF0104036008A6EB"
const DATA: String = (
	"FAFF364410200 2E686106004005751262010103F7F1DDEBDA63508BC8E1BCD3AB3C08840200C3EB6FC53BFC6F4B9"
	+ "411726918 0200CBBB384003C1FC8BDBA8DE78CE02004000000017A"
)

var _path: String = ""


func before_each() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)
	_path = ProjectSettings.globalize_path(FOLDER.path_join("raw"))
	DirAccess.remove_absolute(_path)


func after_each() -> void:
	DirAccess.remove_absolute(_path)


func test_a_stream_is_recorded_and_played_byte_for_byte() -> void:
	var sent: Array[PackedByteArray] = await _record_stream(40)
	var player: RawPlayer = RawPlayer.new()
	equal(player.open(_path), "")
	is_true(player.get_stats()["is_whole"])
	equal(player.get_streams().size(), 1)
	contains(player.get_streams()[0]["sender"], "127.0.0.1:")
	var came: Array[PackedByteArray] = []
	for step: int in sent.size():
		var record: Dictionary = player.step()
		equal(record["kind"], "datagram")
		came.append(record["bytes"])
	equal(came, sent)
	equal(player.step(), {})
	is_true(player.is_at_end())


func test_a_recorded_person_moves_as_before() -> void:
	await _record_stream(40)
	var playback: RawPlayback = RawPlayback.new()
	equal(playback.open(_path), "")
	is_null(playback.suit)
	var people: Array[MvnSource] = []
	playback.stream.appeared.connect(
		func(p_source: MotionSource, _p_name: String) -> void: people.append(p_source)
	)
	playback.player.begin(START_USEC, 1.0)
	var length_usec: int = ceili(playback.player.get_length_s() * 1e6)
	playback.advance_to(START_USEC + length_usec)
	equal(people.size(), 1)
	var source: BvhSource = BvhSource.new()
	source.open(CLIP)
	var pose: PoseSample = people[0].get_newest()
	for limb: int in Limbs.COUNT:
		var off: float = Rotations.between_deg(
			pose.orientation(limb), source.pose_at(39 / 60.0).orientation(limb)
		)
		is_true(off < 0.05, "%s is off by %f deg" % [Limbs.BONES[limb], off])
	is_true(pose.time_usec > START_USEC - 1000000)
	is_true(pose.time_usec <= START_USEC + length_usec)
	playback.close()


func test_speed_and_steps_follow_the_recorded_times() -> void:
	var file: PackedByteArray = _magic()
	for number: int in 11:
		file += _record(4, 0, 5000000 + number * 100000, PackedByteArray([number]))
	_write(file)
	var player: RawPlayer = RawPlayer.new()
	equal(player.open(_path), "")
	almost_equal(player.get_length_s(), 1.0, 1e-6)
	for speed: float in [1.0, 4.0, 0.5]:
		player.begin(START_USEC, speed)
		equal(player.advance(START_USEC - 1), 0)
		equal(player.advance(START_USEC), 1)
		equal(player.advance(START_USEC + roundi(500001 / speed)), 5)
		var datagrams: Array[Dictionary] = player.take_datagrams()
		equal(datagrams.size(), 6)
		equal(datagrams[5]["bytes"], PackedByteArray([5]))
		equal(datagrams[5]["time_usec"], START_USEC + roundi(500000 / speed))
		equal(player.advance(START_USEC + 10000000), 5)
		is_true(player.is_at_end())
	expect_error("0.01 to 1000")
	player.begin(START_USEC, 0.0)


func test_a_recorded_tracker_becomes_a_sensor() -> void:
	var file: PackedByteArray = _magic()
	var about: String = "kind=bus\nusb=2639:0003\nname=MTi-30\nserial=036008A6\n"
	file += _record(1, 3, 1000, about.to_utf8_buffer())
	file += _record(2, 3, 2000, _hex(DEVICE_ID))
	var data: PackedByteArray = _hex(DATA)
	for number: int in 20:
		# A message is cut over two records.
		file += _record(2, 3, 10000 + number * 10000, data.slice(0, 30))
		file += _record(2, 3, 10500 + number * 10000, data.slice(30))
	_write(file + PackedByteArray([0xA5]))
	var playback: RawPlayback = RawPlayback.new()
	equal(playback.open(_path), "")
	equal(playback.player.get_stats()["cut_bytes"], 1)
	playback.player.begin(START_USEC, 1.0)
	playback.advance_to(START_USEC + 1000000)
	var sensors: Array[SensorInfo] = playback.suit.list_sensors()
	equal(sensors.size(), 1)
	equal(sensors[0].id, "036008A6")
	var frames: Array[SensorFrame] = playback.suit.take_frames()
	equal(frames.size(), 20)
	var turn: Quaternion = frames[0].orientation(0)
	# w x y z of the message: 0.99654, -0.08116, -0.01735, 0.00137, with X east and Z up.
	var wanted: Quaternion = SourceFrames.rotation(
		0.996549, -0.081155, -0.017347, 0.001371, SourceFrames.Frame.XSENS_ENU
	)
	is_true(Rotations.between_deg(turn, wanted) < 0.01)
	equal(playback.suit.devices[0].get_name(), "MTi-30")
	playback.close()


func test_files_that_are_none_are_refused() -> void:
	var playback: RawPlayback = RawPlayback.new()
	contains(playback.open(_path), "raw can't be read")
	_write("FA FF 30 00 D1".to_utf8_buffer())
	contains(playback.open(_path), "is no recording")
	_write(_magic())
	contains(playback.open(_path), "holds no suit")
	var recorder: RawRecorder = RawRecorder.new()
	contains(recorder.open(_path), "never overwritten")


## Sends a clip through a socket to a receiver that records. Returns what was sent.
func _record_stream(p_count: int) -> Array[PackedByteArray]:
	var recorder: RawRecorder = RawRecorder.new()
	equal(recorder.open(_path), "")
	var receiver: MvnReceiver = MvnReceiver.new()
	receiver.set_recorder(recorder)
	equal(receiver.open(0), "")
	var peer: PacketPeerUDP = PacketPeerUDP.new()
	peer.set_dest_address("127.0.0.1", receiver.get_port())
	var source: BvhSource = BvhSource.new()
	source.open(CLIP)
	var writer: MvnWriter = MvnWriter.new(source.get_body())
	var sent: Array[PackedByteArray] = []
	for number: int in p_count:
		writer.take(source.pose_at(number / 60.0), number / 60.0)
		for type: int in [12, 2]:
			for datagram: PackedByteArray in MvnEncoder.encode(
				writer.sample(type, number, number * 17)
			):
				peer.put_packet(datagram)
				sent.append(datagram)
		OS.delay_usec(500)
	await until(func() -> bool: return receiver.get_stats()["datagrams"] >= sent.size())
	equal(receiver.get_stats()["datagrams"], sent.size())
	receiver.close()
	recorder.close()
	equal(recorder.get_stats()["lost"], 0)
	return sent


# The layout of a file, written down a second time from docs/recordings.md.


static func _magic() -> PackedByteArray:
	return "DMTRAW1\n".to_ascii_buffer()


static func _record(
	p_kind: int, p_stream: int, p_time_usec: int, p_payload: PackedByteArray
) -> PackedByteArray:
	var writer: StreamPeerBuffer = StreamPeerBuffer.new()
	writer.put_u32(0x524D44A5)
	writer.put_u32(p_payload.size())
	writer.put_u8(p_kind)
	writer.put_u8(0)
	writer.put_u16(p_stream)
	writer.put_u64(p_time_usec)
	writer.put_u32(_crc32(p_payload))
	writer.put_u32(_crc32(writer.data_array))
	return writer.data_array + p_payload


static func _crc32(p_bytes: PackedByteArray) -> int:
	var rest: int = 0xFFFFFFFF
	for byte: int in p_bytes:
		rest ^= byte
		for bit: int in 8:
			rest = (rest >> 1) ^ (0xEDB88320 if rest & 1 else 0)
	return rest ^ 0xFFFFFFFF


static func _hex(p_text: String) -> PackedByteArray:
	return p_text.replace(" ", "").hex_decode()


func _write(p_bytes: PackedByteArray) -> void:
	var file: FileAccess = FileAccess.open(_path, FileAccess.WRITE)
	file.store_buffer(p_bytes)
	file.close()
