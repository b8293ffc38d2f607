extends TestCase
## The manifest of a level's folder: what it says, and that broken and hostile ones are refused.

const GOOD: String = """{"format": 1, "kit": 1, "name": "range", "title": "Range", "files": [
{"name": "range.tscn", "size": 5, "sha256": "%s"}]}"""


func test_what_is_written_is_read() -> void:
	var made: LevelManifest = LevelManifest.new()
	made.name = "range"
	made.title = "Schießplatz"
	for file: String in ["range.tscn", "range.bake", "dunes.height", "preview.png"]:
		var entry: LevelManifest.Entry = LevelManifest.Entry.new()
		entry.name = file
		entry.size = 7
		entry.sha256 = "ab".repeat(32)
		made.files.append(entry)
	made.encode()
	var read: LevelManifest = LevelManifest.decode(made.bytes)
	equal(read.error, "")
	equal([read.name, read.title, read.files.size()], ["range", "Schießplatz", 4])
	equal([read.total_size(), read.scene_file()], [28, "range.tscn"])
	equal(read.content_hash(), made.content_hash())
	is_true(LevelManifest.is_hash(read.content_hash()))


func test_hostile_manifests_are_refused_by_name() -> void:
	var entry: String = '{"name": "range.tscn", "size": 5, "sha256": "%s"}' % "ab".repeat(32)
	var changes: Dictionary[String, Array] = {
		"later format": ['"format": 1', '"format": 2', "has format 2"],
		"no format": ['"format": 1', '"format": "1"', "has format 1"],
		"later kit": ['"kit": 1', '"kit": 9', "it needs level kit 9"],
		"name that leads away": ['"name": "range",', '"name": "../x",', "is no name of a level"],
		"endless title": ['"Range"', '"%s"' % "x".repeat(200), "longer one than 80"],
		"path": ["range.tscn", "../range.tscn", "which a level may not hold"],
		"whole path": ["range.tscn", "/etc/passwd", "which a level may not hold"],
		"hidden file": ["range.tscn", ".x.tscn", "which a level may not hold"],
		"script": ["range.tscn", "range.gd", "which a level may not hold"],
		"library": ["range.tscn", "range.so", "which a level may not hold"],
		"pack": ["range.tscn", "range.pck", "which a level may not hold"],
		"resource": ["range.tscn", "range.tres", "which a level may not hold"],
		"other scene": ["range.tscn", "other.tscn", "lists no range.tscn"],
		"size below": ['"size": 5', '"size": -5', "is said to have -5"],
		"part of a byte": ['"size": 5', '"size": 5.5', "is said to have 5.5"],
		"huge scene": ['"size": 5', '"size": 1e12', "are allowed"],
		"no hash": ["ab".repeat(32), "xyz", "has no SHA-256 of range.tscn"],
		"twice": [entry, entry + ", " + entry, "'range.tscn' twice"],
		"no list": ["[", '"', "is no JSON"],
		"nested": ['"title": "Range"', '"title": %s' % "[".repeat(5000), "is no JSON"],
	}
	var good: String = GOOD % "ab".repeat(32)
	equal(LevelManifest.decode(good.to_utf8_buffer()).error, "")
	for kind: String in changes:
		var text: String = good.replace(changes[kind][0], changes[kind][1])
		contains(LevelManifest.decode(text.to_utf8_buffer()).error, changes[kind][2], kind)
	for bytes: PackedByteArray in [
		PackedByteArray(),
		PackedByteArray([0, 1, 2]),
		PackedByteArray([0xFF, 0xFE]),
		"[]".to_utf8_buffer()
	]:
		is_true(LevelManifest.decode(bytes).error != "")
	var large: PackedByteArray = []
	large.resize(LevelManifest.MAX_BYTES + 1)
	large.fill(32)
	contains(LevelManifest.decode(large).error, "16384 are the most")


func test_all_files_together_have_a_limit() -> void:
	var rows: PackedStringArray = []
	for index: int in 3:
		var row: String = '{"name": "b%d.bake", "size": %d, "sha256": "%s"}'
		rows.append(row % [index, 100 << 20, "ab".repeat(32)])
	var text: String = (GOOD % "ab".repeat(32)).replace("]", "," + ",".join(rows) + "]")
	contains(LevelManifest.decode(text.to_utf8_buffer()).error, "268435456 are the most")


func test_mutated_manifests_are_refused_or_sound() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 3
	var good: PackedByteArray = (GOOD % "ab".repeat(32)).to_utf8_buffer()
	var sound: int = 0
	for _count: int in 3000:
		var bytes: PackedByteArray = good.duplicate()
		for _change: int in random.randi_range(1, 3):
			bytes[random.randi() % bytes.size()] = random.randi() % 256
		var manifest: LevelManifest = LevelManifest.decode(bytes)
		if manifest.error == "":
			sound += 1
			if not manifest.files.all(
				func(entry: LevelManifest.Entry) -> bool:
					return LevelManifest.is_file_name(entry.name)
			):
				fail("a file name that leads away")
	is_true(sound > 0 and sound < 3000, "%d are sound" % sound)
