extends TestCase
## What BvhParser accepts.

const Samples: GDScript = preload("bvh_samples.gd")


func test_reads_the_skeleton() -> void:
	var clip: BvhClip = _clip(Samples.SIMPLE)
	equal(clip.joints.size(), 5)
	equal(clip.joint_count(), 3)
	equal(clip.end_site_count(), 2)
	equal(clip.channel_count, 10)
	equal(clip.joints[0].name, "Hips")
	equal(clip.joints[3].name, "Left Leg")
	equal(clip.joints[3].parent, 0)
	equal(clip.joints[3].first_channel, 9)
	equal(clip.joints[3].channels, PackedInt32Array([BvhJoint.Channel.X_ROTATION]))
	equal(clip.joints[4].parent, 3)
	is_true(clip.joints[4].is_end_site)
	equal(clip.joints[4].offset, Vector3(0, -90, 0))
	equal(clip.find_joint("Left Leg"), 3)
	equal(clip.find_joint(""), -1)


func test_reads_the_motion() -> void:
	var clip: BvhClip = _clip(Samples.SIMPLE)
	equal(clip.frame_count, 3)
	equal(clip.frame_time, 0.5)
	equal(clip.duration(), 1.0)
	equal(clip.value(1, 0, 0), 1.5)
	equal(clip.value(2, 3, 0), 90.0)
	equal(clip.notes.size(), 0)


func test_line_endings_and_tabs_do_not_matter() -> void:
	var wanted: PackedFloat64Array = _clip(Samples.SIMPLE).values
	equal(_clip(Samples.SIMPLE.replace("\n", "\r\n")).values, wanted)
	equal(_clip(Samples.SIMPLE.replace("\n", "\r")).values, wanted)
	equal(_clip(Samples.SIMPLE.replace(" ", "\t")).values, wanted)
	equal(_clip(Samples.SIMPLE.replace("\n", " \n\n\t \n")).values, wanted)
	equal(_clip(Samples.SIMPLE.strip_edges()).values, wanted)
	equal(_clip("\ufeff" + Samples.SIMPLE).values, wanted, "byte order mark")


func test_case_does_not_matter() -> void:
	equal(_clip(Samples.SIMPLE.to_lower()).values.size(), 30)
	equal(_clip(Samples.SIMPLE.to_upper()).joints[3].name, "LEFT LEG")


func test_comments() -> void:
	var text: String = Samples.SIMPLE.replace("\n", " # comment { 1\n// another }\n")
	equal(_clip(text).values, _clip(Samples.SIMPLE).values)
	equal(_clip(Samples.with_line(2, "ROOT a#b//c")).joints[0].name, "a#b//c")


func test_headers_with_odd_spaces() -> void:
	for header: String in ["Frames:3", "Frames : 3", "frames 3", "  FRAMES:\t3  ", "Frames: 003"]:
		equal(_clip(Samples.with_line(27, header)).frame_count, 3, header)
	for header: String in [
		"Frame Time:0.5", "frame time : .5", "FrameTime: 5e-1", "Frame  Time +.5"
	]:
		equal(_clip(Samples.with_line(28, header)).frame_time, 0.5, header)


func test_number_forms() -> void:
	var row: String = "+1.0 -.5 1e-007 1.e2 -0 5. 1.5E+01 123456789.25 007 2E3"
	var values: PackedFloat64Array = _clip(Samples.with_line(29, row)).values.slice(0, 10)
	almost_equal(values, [1.0, -0.5, 1e-7, 100.0, 0.0, 5.0, 15.0, 123456789.25, 7.0, 2000.0], 1e-12)


func test_numbers_are_read_to_double_precision() -> void:
	var values: PackedFloat64Array = (
		_clip(Samples.with_line(29, "179.842245 -0.000001 3.14159265358979 0 0 0 0 0 0 0")).values
	)
	almost_equal(values[0], 179.842245, 1e-12)
	almost_equal(values[1], -0.000001, 1e-18)
	almost_equal(values[2], 3.14159265358979, 1e-14)


func test_wrapped_rows() -> void:
	var one_a_line: String = Samples.SIMPLE.get_slice("Frame Time: 0.5\n", 1).replace(" ", "\n")
	var header: String = Samples.SIMPLE.get_slice("0.5\n", 0) + "0.5\n"
	var wanted: PackedFloat64Array = _clip(Samples.SIMPLE).values
	equal(_clip(header + one_a_line).values, wanted)
	equal(_clip(header + one_a_line.replace("\n", " ")).values, wanted)


func test_one_long_line_of_many_numbers() -> void:
	var numbers: PackedStringArray = PackedStringArray()
	numbers.resize(500_000)
	numbers.fill("-12.345678")
	var text: String = Samples.SIMPLE.get_slice("Frames", 0) + "Frames: 50000\nFrame Time: 1\n"
	equal(_clip(text + " ".join(numbers)).frame_count, 50000)


func test_no_frames() -> void:
	var text: String = Samples.SIMPLE.get_slice("Frames", 0) + "Frames: 0\nFrame Time: 0.1\n"
	var clip: BvhClip = _clip(text)
	equal(clip.frame_count, 0)
	equal(clip.duration(), 0.0)
	equal(clip.sample_at(1.0).positions, clip.rest_positions())
	equal(clip.global_orientation(0, 1), Quaternion.IDENTITY)


func test_one_surplus_row_of_a_long_clip_is_left_out_with_a_note() -> void:
	var head: String = "HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n}\nMOTION\n"
	var clip: BvhClip = _clip(head + "Frames: 100\nFrame Time: 1\n" + "7\n".repeat(101))
	equal(clip.frame_count, 100)
	equal(clip.values.size(), 100)
	equal(
		clip.notes,
		PackedStringArray(
			["simple.bvh:8: 100 frames declared, 101 found; the last one is left out"]
		)
	)


func test_deep_skeletons() -> void:
	var text: String = "HIERARCHY\nROOT A {\nOFFSET 0 1 0 CHANNELS 1 Xrotation\n"
	text += "JOINT B {\nOFFSET 0 1 0\n".repeat(255) + "}\n".repeat(256)
	equal(_clip(text + "MOTION\nFrames: 1\nFrame Time: 1\n0\n").joints.size(), 256)


func test_bytes_and_encodings() -> void:
	var latin: PackedByteArray = PackedByteArray([0x48, 0xFC, 0x66])
	equal(BvhText.decode(latin), "Hüf")
	equal(BvhText.decode("腰 𝄞 é".to_utf8_buffer()), "腰 𝄞 é")
	is_false(BvhText.is_utf8(PackedByteArray([0xC0, 0x80])), "overlong")
	is_false(BvhText.is_utf8(PackedByteArray([0xE0, 0x9F, 0xBF])), "overlong")
	is_false(BvhText.is_utf8(PackedByteArray([0xED, 0xA0, 0x80])), "surrogate")
	is_false(BvhText.is_utf8(PackedByteArray([0xF4, 0x90, 0x80, 0x80])), "too large")
	is_false(BvhText.is_utf8(PackedByteArray([0x61, 0xE2, 0x82])), "cut off")
	for size: int in 20:
		var bytes: PackedByteArray = "a".repeat(20).to_ascii_buffer()
		is_true(BvhText.is_ascii(bytes.slice(0, size)))
		bytes[size] = 0x80
		is_false(BvhText.is_ascii(bytes))


func test_parses_in_a_thread() -> void:
	var thread: Thread = Thread.new()
	thread.start(BvhParser.parse_text.bind(Samples.SIMPLE))
	var result: BvhParser.Result = thread.wait_to_finish()
	is_true(result.is_ok())


func _clip(p_text: String) -> BvhClip:
	var result: BvhParser.Result = BvhParser.parse_text(p_text, "simple.bvh")
	equal(result.error, "")
	return result.clip
