extends TestCase
## What BvhParser refuses, and in which words: file, line, what was expected, what was found.

const Samples: GDScript = preload("bvh_samples.gd")
const HEAD: String = "HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\n"


func test_structure() -> void:
	_error("", "1: expected 'HIERARCHY', found the end of the file")
	_error("\n\n# nothing\n", "3: expected 'HIERARCHY', found the end of the file")
	_error("MOTION\n", "1: expected 'HIERARCHY', found 'MOTION'")
	_error("HIERARCHY\n\nJOINT a", "3: expected 'ROOT', found 'JOINT'")
	_error("HIERARCHY\nROOT\n{", "3: expected a name after 'ROOT', found '{'")
	_error("HIERARCHY\nROOT A\nOFFSET 0 0 0", "3: expected '{' after joint 'A', found 'OFFSET'")
	_error("HIERARCHY\nROOT A\n{\n}\n", "4: expected 'OFFSET' in joint 'A', found '}'")
	_error(HEAD + "JOINT\n{", "6: expected a name after 'JOINT', found '{'")
	_error(HEAD + "END SITE\n{\n}\n}", "7: expected 'OFFSET' in the End Site of 'A', found '}'")
	_error(
		HEAD + "END SITE\n{\nOFFSET 0 0 0\nJOINT B",
		"8: expected 'OFFSET' or '}' in an End Site, found 'JOINT'"
	)
	_error(
		HEAD + "ROTATE\n}",
		"5: expected OFFSET, CHANNELS, JOINT, End Site or '}' in joint 'A', found 'ROTATE'"
	)


func test_braces() -> void:
	_error(HEAD, "4: expected '}' to close joint 'A' of line 2, found the end of the file")
	_error(
		Samples.with_line(14, ""),
		"26: expected OFFSET, CHANNELS, JOINT, End Site or '}' in joint 'Hips', found 'MOTION'"
	)
	_error(HEAD + "}\n}\n", "6: expected 'MOTION', found '}'")
	_error(HEAD + "}\n", "5: expected 'MOTION', found the end of the file")
	_error(HEAD + "}\nMOTION x\n", "6: expected the line to end after 'MOTION', found 'x'")


func test_second_root() -> void:
	_error(
		HEAD + "}\nROOT B\n",
		"6: expected 'MOTION' (one skeleton a file; export each person on its own), found 'ROOT'"
	)


func test_offset() -> void:
	_error(
		Samples.with_line(8, "\t\tOFFSET 1.0 x 3"),
		"8: expected 'OFFSET' with 3 numbers, found 'OFFSET 1.0 x 3'"
	)
	_error(
		Samples.with_line(8, "OFFSET 1 2"),
		"8: expected 'OFFSET' with 3 numbers, found 'OFFSET 1 2' and then 'CHANNELS'"
	)
	_error(
		Samples.with_line(8, "OFFSET 1 2 3 4"),
		"8: expected 'OFFSET' with 3 numbers, found 'OFFSET 1 2 3 4'"
	)
	_error(
		Samples.with_line(8, "OFFSET 1,5 2 3"),
		(
			"8: expected 'OFFSET' with 3 numbers, found 'OFFSET 1,5 2 3'"
			+ " (a decimal comma? numbers need a point)"
		)
	)
	_error(
		Samples.with_line(5, "OFFSET 0 0 0"),
		"5: expected one OFFSET in joint 'Hips', found 'OFFSET'"
	)


func test_channels() -> void:
	_error(
		Samples.with_line(9, "CHANNELS three Zrotation"),
		"9: expected the number of channels after 'CHANNELS', found 'three'"
	)
	_error(
		Samples.with_line(9, "CHANNELS -1"),
		"9: expected the number of channels after 'CHANNELS', found '-1'"
	)
	_error(
		Samples.with_line(9, "CHANNELS 3 Zrotation Wrotation Yrotation"),
		"9: expected a channel such as 'Xrotation', found 'Wrotation'"
	)
	_error(
		Samples.with_line(9, "CHANNELS 3 Zrotation Yrotation"),
		"9: expected 3 channels, found 2 in 'CHANNELS 3 Zrotation Yrotation'"
	)
	_error(
		Samples.with_line(9, "CHANNELS 1 Zrotation Yrotation"),
		"9: expected 1 channels, found 2 in 'CHANNELS 1 Zrotation Yrotation'"
	)
	_error(
		Samples.with_line(9, "CHANNELS 999999999 Zrotation"),
		"9: expected 999999999 channels, found 1 in 'CHANNELS 999999999 Zrotation'"
	)
	_error(
		Samples.with_line(9, "CHANNELS 2 Xposition Xposition"),
		"9: expected each position channel once in joint 'Chest', found 'Xposition'"
	)
	_error(
		Samples.with_line(8, "CHANNELS 0"),
		"9: expected one CHANNELS in joint 'Chest', found 'CHANNELS'"
	)
	_error(
		Samples.with_line(9, "CHANNELS 65" + " Xrotation".repeat(65)),
		"9: expected at most 64 channels, found more"
	)


func test_headers() -> void:
	_error(Samples.with_line(27, ""), "28: expected 'Frames: <number>', found 'Frame Time: 0.5'")
	_error(
		Samples.with_line(27, "Frames: three"),
		"27: expected 'Frames: <number>', found 'Frames: three'"
	)
	_error(
		Samples.with_line(27, "Frames: -3"), "27: expected 'Frames: <number>', found 'Frames: -3'"
	)
	_error(Samples.with_line(27, "Frames:"), "27: expected 'Frames: <number>', found 'Frames:'")
	_error(
		Samples.with_line(28, ""),
		"29: expected 'Frame Time: <seconds>', found '0 90 0 0 0 0 0 0 0 0'"
	)
	for bad: String in ["0", "-0.1", "3601", "x", "1e-9"]:
		_error(
			Samples.with_line(28, "Frame Time: " + bad),
			"28: expected 'Frame Time: <seconds>' from 0.000001 to 3600, found '%s'" % bad
		)
	_error(
		Samples.with_line(28, "Frame Time: 0,5"),
		(
			"28: expected 'Frame Time: <seconds>' from 0.000001 to 3600, found '0,5'"
			+ " (a decimal comma? numbers need a point)"
		)
	)
	_error(
		HEAD + "}\nMOTION\nFrames: 2\nFrame Time: 1\n\n\n",
		"7: expected no frames as no joint has CHANNELS, found 2"
	)
	_error(HEAD + "}\nMOTION\n", "6: expected 'Frames: <number>', found the end of the file")
	_error(
		HEAD + "}\nMOTION\nFrames: 0\n",
		"7: expected 'Frame Time: <seconds>', found the end of the file"
	)


func test_numbers_of_rows() -> void:
	var hints: Dictionary[String, String] = {
		"nan": " (numbers have to be finite)",
		"-inf": " (numbers have to be finite)",
		"1.#QNAN": " (numbers have to be finite)",
		"1,5": " (a decimal comma? numbers need a point)",
		"1.2abc": "",
		"x": "",
		"1e": "",
		"--1": "",
		"1e400": " (too large or too small a number)",
		"1e-500": " (too large or too small a number)",
		"1234567890": " (too large or too small a number)",
	}
	for word: String in hints:
		_error(
			Samples.with_line(30, "0 1 %s 0 0 0 0 0 0 0" % word),
			"30: expected a number, found '%s' as number 3 of frame 2%s" % [word, hints[word]]
		)


func test_short_and_long_rows() -> void:
	_error(
		Samples.with_line(30, "1 2 3 4 5 6 7 8 9"), "30: expected 10 numbers in frame 2, found 9"
	)
	_error(
		Samples.with_line(31, "1 2 3 4 5 6 7 8 9 10 11"),
		"31: expected 10 numbers in frame 3, found 11"
	)


func test_too_few_and_too_many_frames() -> void:
	_error(Samples.with_line(31, ""), "27: expected 3 frames as declared, found 2")
	_error(Samples.SIMPLE + "0 0 0 0 0 0 0 0 0 0\n", "27: expected 3 frames as declared, found 4")
	_error(Samples.with_line(27, "Frames: 0"), "27: expected 0 frames as declared, found 3")
	var long_head: String = HEAD + "CHANNELS 1 Xrotation\n}\nMOTION\nFrames: 100\nFrame Time: 1\n"
	_error(long_head + "7\n".repeat(102), "8: expected 100 frames as declared, found 102")
	_error(long_head + "7\n".repeat(99), "8: expected 100 frames as declared, found 99")


func test_huge_counts_do_not_allocate() -> void:
	var before: int = OS.get_static_memory_peak_usage()
	_error(
		Samples.with_line(27, "Frames: 99999999"),
		"27: expected 99999999 frames as declared, found 3"
	)
	_error(
		Samples.with_line(27, "Frames: 999999999"),
		"27: expected at most 100000000 frames, found 999999999"
	)
	_error(
		Samples.with_line(27, "Frames: 99999999999999999999"),
		"27: expected at most 100000000 frames, found 99999999999999999999"
	)
	is_true(OS.get_static_memory_peak_usage() - before < 50_000_000, "peak memory")


func test_limits() -> void:
	var chain: String = (
		"HIERARCHY\nROOT A {\nOFFSET 0 1 0\n" + "JOINT B {\nOFFSET 0 1 0\n".repeat(256)
	)
	_error(chain, "514: expected at most 256 joints below one another, found more")
	var wide: String = HEAD + "End Site {OFFSET 0 0 0}\n".repeat(2048)
	_error(wide, "2052: expected at most 2048 joints, found more")


func test_long_and_odd_words_are_quoted_short() -> void:
	_error("x".repeat(100_000), "1: expected 'HIERARCHY', found '%s...'" % "x".repeat(60))
	_error("a\u0007\u001b[31m", "1: expected 'HIERARCHY', found 'a??[31m'")


func test_files_that_are_no_text() -> void:
	_is_error(
		BvhParser.parse_bytes(PackedByteArray()),
		"text:1: expected 'HIERARCHY', found the end of the file"
	)
	_is_error(
		BvhParser.parse_bytes(PackedByteArray([72, 0, 1])),
		"text:1: expected UTF-8 text, found a zero byte"
	)
	_is_error(
		BvhParser.parse_bytes(PackedByteArray([0xFF, 0xFE, 72, 0])),
		"text:1: expected UTF-8 text, found UTF-16"
	)


func test_files_that_cannot_be_opened() -> void:
	_is_error(
		BvhParser.parse_file("res://no/such.bvh"),
		"such.bvh: expected a readable file, found none (file not found)"
	)
	_is_error(BvhParser.parse_file("res://tests"), "tests: expected a BVH file, found a folder")
	_is_error(
		BvhParser.parse_file(""), "(no name): expected a readable file, found none (file not found)"
	)
	var options: BvhOptions = BvhOptions.new()
	options.max_bytes = 100
	var result: BvhParser.Result = BvhParser.parse_file("res://tests/data/bvh/old_mac.bvh", options)
	_is_error(result, "")
	options.max_bytes = 10
	result = BvhParser.parse_file("res://tests/data/bvh/old_mac.bvh", options)
	contains(result.error, "old_mac.bvh: expected at most 10 bytes, found ")


func _error(p_text: String, p_wanted: String) -> void:
	_is_error(BvhParser.parse_text(p_text, "walk.bvh"), "walk.bvh:" + p_wanted)


func _is_error(p_result: BvhParser.Result, p_wanted: String) -> void:
	equal(p_result.error, p_wanted)
	equal(p_result.is_ok(), p_wanted.is_empty())
