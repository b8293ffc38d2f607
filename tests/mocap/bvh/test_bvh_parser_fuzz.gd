extends TestCase
## Ten thousand damaged files: each gives a whole clip or an error with a line, never a script error
## (which the runner would catch) and never a hang.

const Samples: GDScript = preload("bvh_samples.gd")
const ROUNDS: int = 10_000
## Longest time of one file, ms. Generous, as other work may hold the processor.
const MAX_MS: int = 2000
const WORDS: PackedStringArray = [
	"nan",
	"-inf",
	"1e999",
	"1,5",
	"99999999999999999999",
	"-1",
	"+",
	"{",
	"}",
	"}}}",
	"ROOT",
	"JOINT",
	"End",
	"End Site",
	"MOTION",
	"OFFSET",
	"CHANNELS",
	"CHANNELS 0",
	"Xrotation",
	"Xscale",
	"Frames:",
	"Frame Time: 1",
	"#",
	"//",
	"\r",
	"é",
	"0x1F",
	"1e-9999",
	"999999999",
	".",
	""
]

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _place: RegEx = RegEx.create_from_string("^fuzz\\.bvh:[0-9]+: expected .+")
var _clips: int = 0


func test_damaged_files() -> void:
	_random.seed = 4711
	var seeds: Array[PackedByteArray] = _seeds()
	for number: int in ROUNDS:
		var bytes: PackedByteArray = seeds[_random.randi() % seeds.size()].duplicate()
		for _mutation: int in [1, 1, 2, 3][_random.randi() % 4]:
			bytes = _mutate(bytes)
		# Processor time: how busy the machine is does not matter.
		var started: int = ThreadClock.get_usec()
		_check_file(bytes, number)
		var spent: int = (ThreadClock.get_usec() - started) / 1000
		if spent > MAX_MS:
			fail("file %d took %d ms" % [number, spent])
	print("     %d of %d damaged files are still clips" % [_clips, ROUNDS])
	# Both ends have to be well visited, or the damage is of the wrong kind.
	is_true(_clips > ROUNDS / 20, "%d clips" % _clips)
	is_true(_clips < ROUNDS * 3 / 4, "%d clips" % _clips)


func _seeds() -> Array[PackedByteArray]:
	var seeds: Array[PackedByteArray] = [(Samples.SIMPLE as String).to_utf8_buffer()]
	for file: String in DirAccess.get_files_at("res://tests/data/bvh"):
		if file.get_extension() == "bvh":
			seeds.append(FileAccess.get_file_as_bytes("res://tests/data/bvh/" + file))
	for _number: int in 10:
		seeds.append(BvhWriter.to_text(Samples.random_clip(_random), 2).to_utf8_buffer())
	return seeds


func _check_file(p_bytes: PackedByteArray, p_number: int) -> void:
	var result: BvhParser.Result = BvhParser.parse_bytes(p_bytes, "fuzz.bvh")
	if result.is_ok() != result.error.is_empty():
		fail("file %d gave both a clip and an error, or none" % p_number)
	if not result.is_ok():
		if _place.search(result.error) == null or result.error.contains("\n"):
			fail("file %d: no proper error: %s" % [p_number, result.error])
		return
	_clips += 1
	var clip: BvhClip = result.clip
	if clip.values.size() != clip.frame_count * clip.channel_count:
		fail("file %d: %d numbers" % [p_number, clip.values.size()])
	var pose: BvhClip.Pose = clip.sample_at(_random.randf() * clip.duration())
	for joint: int in clip.joints.size():
		if not pose.positions[joint].is_finite() or not pose.orientations[joint].is_normalized():
			fail("file %d: joint %d is nowhere" % [p_number, joint])


func _mutate(p_bytes: PackedByteArray) -> PackedByteArray:
	if p_bytes.is_empty():
		return p_bytes
	match _random.randi() % 10:
		0, 1, 2, 3:
			return _mutate_bytes(p_bytes)
		4:
			return _swap_byte(p_bytes, "{}\n:"[_random.randi() % 4], " ")
		5:
			var from: String = " .0-"[_random.randi() % 4]
			return _swap_byte(p_bytes, from, "\n,e+"[_random.randi() % 4])
	return _mutate_lines(p_bytes)


func _mutate_bytes(p_bytes: PackedByteArray) -> PackedByteArray:
	var at: int = _random.randi() % p_bytes.size()
	match _random.randi() % 4:
		0:
			return p_bytes.slice(0, at)
		1:
			return p_bytes.slice(0, at) + p_bytes.slice(at + _random.randi_range(1, 40))
		2:
			return p_bytes.slice(0, at + _random.randi_range(1, 200)) + p_bytes.slice(at)
	var flipped: int = p_bytes[at] ^ (1 << _random.randi() % 8)
	p_bytes[at] = flipped if _random.randf() < 0.9 else 0
	return p_bytes


func _swap_byte(p_bytes: PackedByteArray, p_from: String, p_to: String) -> PackedByteArray:
	var at: int = p_bytes.find(p_from.unicode_at(0), _random.randi() % p_bytes.size())
	if at >= 0:
		p_bytes[at] = p_to.unicode_at(0)
	return p_bytes


func _mutate_lines(p_bytes: PackedByteArray) -> PackedByteArray:
	var lines: PackedStringArray = BvhText.decode(_without_zeros(p_bytes)).split("\n")
	var at: int = _random.randi() % lines.size()
	match _random.randi() % 4:
		0:
			lines.remove_at(at)
		1:
			lines.insert(_random.randi() % lines.size(), lines[at])
		2:
			var words: PackedStringArray = lines[at].split(" ")
			words[_random.randi() % words.size()] = WORDS[_random.randi() % WORDS.size()]
			lines[at] = " ".join(words)
		3:
			lines.insert(at, WORDS[_random.randi() % WORDS.size()])
	return "\n".join(lines).to_utf8_buffer()


func _without_zeros(p_bytes: PackedByteArray) -> PackedByteArray:
	var at: int = p_bytes.find(0)
	while at >= 0:
		p_bytes[at] = 32
		at = p_bytes.find(0, at)
	return p_bytes
