extends TestCase
## Axis Studio's BVH stream. The header's fields are those of NeuronDataReader's BvhDataHeader, its
## bytes in version 1.1 as GodotXRAxisStudioTracker quotes them.

const CLIP: String = "res://assets/motion/01_01.bvh"
## FF DD, version 1.1.0.1, 354 values, with displacement, no reference, avatar 0, "chr00".
const HEAD: String = "ffdd010001016201010000000000" + "6368723030"


func test_the_header_is_the_documented_one() -> void:
	var frame: PackedByteArray = AxisWriter.new().write(_clip().pose_at(0.0))[0]
	equal(frame.slice(0, 19).hex_encode(), HEAD)
	equal(frame.slice(62, 64).hex_encode(), "ffee")
	equal(frame.size(), 64 + 354 * 4)


func test_a_clip_arrives_as_it_is_in_every_form() -> void:
	var clip: BvhSource = _clip()
	for text: bool in [false, true]:
		for places: bool in [true, false]:
			var writer: AxisWriter = AxisWriter.new(clip.get_body())
			writer.is_text = text
			writer.has_places = places
			writer.has_reference = text == places
			var reader: AxisReader = AxisReader.new()
			for step: int in 20:
				var pose: PoseSample = clip.pose_at(step * 0.15)
				var samples: Array[StreamSample] = reader.read(writer.write(pose)[0], "x")
				equal(samples.size(), 1, reader.fault)
				equal(samples[0].name, "chr00")
				almost_equal(samples[0].pose.root, pose.root, 1e-4)
				for limb: int in Limbs.COUNT:
					var off: float = Rotations.between_deg(
						samples[0].pose.orientation(limb), pose.orientation(limb)
					)
					is_true(off < 0.01, "%s off by %f deg" % [Limbs.BONES[limb], off])


func test_the_header_of_version_1_0_is_read_too() -> void:
	var clip: BvhSource = _clip()
	var frame: PackedByteArray = AxisWriter.new(clip.get_body()).write(clip.pose_at(1.0))[0]
	var old: PackedByteArray = PackedByteArray()
	old.resize(64)
	old.encode_u16(0, 0xDDFF)
	# Version 1.0.0.2; numbers and flags of four bytes.
	old.encode_u32(2, 0x01000002)
	old.encode_u32(6, 354)
	old.encode_u32(10, 1)
	old.encode_u32(18, 3)
	for at: int in 3:
		old[22 + at] = "Eve".unicode_at(at)
	old.encode_u16(62, 0xEEFF)
	old.append_array(frame.slice(64))
	var samples: Array[StreamSample] = AxisReader.new().read(old, "x")
	equal(samples.size(), 1)
	equal([samples[0].name, samples[0].person], ["Eve", "3"])
	almost_equal(samples[0].pose.root, clip.pose_at(1.0).root, 1e-4)


func test_loss_and_duplicates_are_hardly_seen() -> void:
	var clip: BvhSource = _clip()
	var line: LossyLine = LossyLine.new(8)
	var stream: PoseStream = PoseStream.new(AxisReader.new())
	var person: StreamPerson = line.run(clip, AxisWriter.new(clip.get_body()), stream, 3.5)
	# Frames are counted but bear no time: how long one takes is known better with every second.
	is_true(line.errors.mean() < 0.05, "mean %f deg" % line.errors.mean())
	is_true(line.errors.percentile(0.95) < 0.2, "p95 %f deg" % line.errors.percentile(0.95))
	is_true(person.stats()["twice"] > 10 and person.stats()["lost"] > 10)


func test_pieces_of_a_tcp_stream_are_put_together() -> void:
	var clip: BvhSource = _clip()
	for text: bool in [false, true]:
		var reader: AxisReader = AxisReader.new()
		reader.is_tcp = true
		var writer: AxisWriter = AxisWriter.new(clip.get_body())
		writer.is_text = text
		var bytes: PackedByteArray = PackedByteArray()
		for step: int in 12:
			bytes.append_array(writer.write(clip.pose_at(step * 0.1))[0])
			if step == 5:
				bytes.append_array("rubbish".to_ascii_buffer() if not text else PackedByteArray())
		var count: int = 0
		for at: int in range(0, bytes.size(), 997):
			count += reader.read(bytes.slice(at, at + 997), "x").size()
		equal(count, 12, "text %s: %s" % [text, reader.fault])


func test_what_is_none_is_reported() -> void:
	var reader: AxisReader = AxisReader.new()
	var frame: PackedByteArray = AxisWriter.new().write(_clip().pose_at(0.0))[0]
	var few: PackedByteArray = frame.duplicate()
	few.encode_u16(6, 60)
	var nan_value: PackedByteArray = frame.duplicate()
	nan_value.encode_float(100, NAN)
	var cases: Dictionary[String, PackedByteArray] = {
		"60 values instead of 354": few.slice(0, 64 + 240),
		"no angle": nan_value,
		"no whole frame": frame.slice(0, 500),
		"is no frame": "hello".to_ascii_buffer(),
		"where a number is": "0 chr00 1.0 x2 ||".to_ascii_buffer(),
	}
	for wanted: String in cases:
		reader.fault = ""
		equal(reader.read(cases[wanted], "x").size(), 0, wanted)
		contains(reader.fault, wanted)
	var writer: AxisWriter = AxisWriter.new()
	var frames: Array[PackedByteArray] = writer.write(_clip().pose_at(1.0))
	writer.is_text = true
	frames.append_array(writer.write(_clip().pose_at(1.0)))
	for tcp: bool in [false, true]:
		reader.is_tcp = tcp
		equal(LossyLine.fuzz(reader, frames, 700), "")


func _clip() -> BvhSource:
	var clip: BvhSource = BvhSource.new()
	clip.open(CLIP)
	return clip
