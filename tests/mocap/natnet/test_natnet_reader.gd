extends TestCase
## OptiTrack's NatNet: versions' layouts, bones on one another and in the world, what is asked. What
## [NatnetWriter] writes was read by TimSchneider42/python-natnet-client in versions 3.0, 4.0 and
## 4.1.

const CLIP: String = "res://assets/motion/01_01.bvh"
const SERVER: String = "127.0.0.1:1510"


func test_every_version_arrives_as_it_is() -> void:
	var clip: BvhSource = _clip()
	for version: int in [300, 301, 400, 401]:
		for local: bool in [true, false]:
			var writer: NatnetWriter = NatnetWriter.new(clip.get_body())
			writer.version = version
			writer.is_local = local
			var reader: NatnetReader = NatnetReader.new()
			reader.host = "127.0.0.1"
			_introduce(reader, writer)
			contains(
				reader.detail(SERVER), "NatNet %d.%d" % [floori(version / 100.0), version % 100]
			)
			for step: int in 8:
				var pose: PoseSample = clip.pose_at(step * 0.4)
				pose.time_usec = step * 400000
				var samples: Array[StreamSample] = reader.read(writer.write(pose)[0], SERVER)
				equal(samples.size(), 1, reader.fault)
				equal(samples[0].source_usec, step * 400000)
				equal(samples[0].name, "Dismount")
				almost_equal(samples[0].pose.root, pose.root, 1e-5)
				for limb: int in Limbs.COUNT:
					var off: float = Rotations.between_deg(
						samples[0].pose.orientation(limb), pose.orientation(limb)
					)
					is_true(off < 0.01, "%s off by %f deg" % [Limbs.BONES[limb], off])


func test_loss_and_duplicates_are_hardly_seen() -> void:
	var clip: BvhSource = _clip()
	var writer: NatnetWriter = NatnetWriter.new(clip.get_body())
	var reader: NatnetReader = NatnetReader.new()
	reader.host = "127.0.0.1"
	_introduce(reader, writer)
	var line: LossyLine = LossyLine.new(8)
	var stream: PoseStream = PoseStream.new(reader)
	var person: StreamPerson = line.run(clip, writer, stream, 3.5)
	is_true(line.errors.percentile(0.95) < 0.1, "p95 %f deg" % line.errors.percentile(0.95))
	is_true(person.stats()["twice"] > 10 and person.stats()["lost"] > 10)


func test_a_server_that_only_sends_is_asked() -> void:
	var clip: BvhSource = _clip()
	var writer: NatnetWriter = NatnetWriter.new(clip.get_body())
	var reader: NatnetReader = NatnetReader.new()
	equal(reader.talk(5_000_000).size(), 0)
	# From its multicast group, from any port.
	equal(reader.read(writer.write(clip.pose_at(0.0))[0], "127.0.0.1:40000").size(), 0)
	var parcels: Array[StreamPort.Parcel] = reader.talk(6_000_000)
	equal(parcels.size(), 1)
	equal([parcels[0].address, parcels[0].port], ["127.0.0.1", 1510])
	equal(parcels[0].bytes.hex_encode(), "0000050050696e6700", "connect, with a ping")
	_introduce(reader, writer)
	equal(reader.read(writer.write(clip.pose_at(0.0))[0], "127.0.0.1:40000").size(), 1)


func test_skeletons_that_are_made_later_are_asked_for() -> void:
	var clip: BvhSource = _clip()
	var writer: NatnetWriter = NatnetWriter.new(clip.get_body())
	var reader: NatnetReader = NatnetReader.new()
	reader.host = "127.0.0.1"
	var empty: PackedByteArray = NatnetBytes.message(NatnetReader.MODELDEF)
	empty.resize(8)
	empty.encode_u16(2, 4)
	for second: int in 3:
		for parcel: StreamPort.Parcel in reader.talk(10_000_000 + second * 1_100_000):
			if parcel.bytes.decode_u16(0) == NatnetReader.REQUEST_MODELDEF:
				reader.read(empty, SERVER)
			else:
				for reply: PackedByteArray in writer.answer(parcel.bytes):
					reader.read(reply, SERVER)
	contains(reader.trouble(SERVER), "create one in Motive")
	_introduce(reader, writer)
	equal(reader.trouble(SERVER), "")
	equal(reader.read(writer.write(clip.pose_at(0.0))[0], SERVER).size(), 1)


func test_strangers_are_not_the_server_that_was_named() -> void:
	var clip: BvhSource = _clip()
	var writer: NatnetWriter = NatnetWriter.new(clip.get_body())
	var reader: NatnetReader = NatnetReader.new()
	reader.host = "127.0.0.1"
	_introduce(reader, writer)
	equal(reader.read(writer.write(clip.pose_at(0.0))[0], "10.9.8.7:1511").size(), 0)
	contains(reader.fault, "the server is 127.0.0.1")
	equal(reader.talk(60_000_000).size(), 1, "nobody else is asked")


func test_names_of_three_conventions() -> void:
	var names: Dictionary[String, int] = {
		"Skeleton 1_LUArm": XRBodyTracker.JOINT_LEFT_UPPER_ARM,
		"Eve:RightForeArm": XRBodyTracker.JOINT_RIGHT_LOWER_ARM,
		"my_skeleton_RToe": XRBodyTracker.JOINT_RIGHT_TOES,
		"RShoulder": XRBodyTracker.JOINT_RIGHT_SHOULDER,
		"LeftKnee": XRBodyTracker.JOINT_LEFT_LOWER_LEG,
		"RightUpLeg": XRBodyTracker.JOINT_RIGHT_UPPER_LEG,
		"x_Hip": XRBodyTracker.JOINT_HIPS,
		"Prop": -1,
		"": -1,
	}
	for name: String in names:
		equal(NatnetReader.joint_of(name), names[name], name)


func test_what_is_none_is_reported() -> void:
	var clip: BvhSource = _clip()
	for version: int in [300, 401]:
		var writer: NatnetWriter = NatnetWriter.new(clip.get_body())
		writer.version = version
		var reader: NatnetReader = NatnetReader.new()
		reader.host = "127.0.0.1"
		_introduce(reader, writer)
		var datagrams: Array[PackedByteArray] = writer.write(clip.pose_at(0.5))
		datagrams.append_array(writer.answer(NatnetBytes.message(NatnetReader.CONNECT)))
		datagrams.append_array(writer.answer(NatnetBytes.message(NatnetReader.REQUEST_MODELDEF)))
		reader.read(datagrams[0].slice(0, 300), SERVER)
		contains(reader.fault, "bytes where")
		equal(LossyLine.fuzz(reader, datagrams, 1200), "")
	var old: NatnetWriter = NatnetWriter.new()
	old.version = 207
	var other: NatnetReader = NatnetReader.new()
	other.read(old.answer(NatnetBytes.message(NatnetReader.CONNECT))[0], SERVER)
	contains(other.fault, "2.7")


static func _introduce(p_reader: NatnetReader, p_writer: NatnetWriter) -> void:
	for second: int in 4:
		for parcel: StreamPort.Parcel in p_reader.talk(10_000_000 + second * 1_100_000):
			for reply: PackedByteArray in p_writer.answer(parcel.bytes):
				p_reader.read(reply, SERVER)


func _clip() -> BvhSource:
	var clip: BvhSource = BvhSource.new()
	clip.open(CLIP)
	return clip
