extends TestCase
## Folders of levels: packed, checked, read; damaged and hostile ones are refused by name.


func before_each() -> void:
	SampleFolder.clean_up()


func after_each() -> void:
	SampleFolder.clean_up()


func test_what_was_packed_can_be_read() -> void:
	var folder: LevelFolder = LevelFolder.new(SampleFolder.make("range", 3000))
	var level: Level = folder.build()
	equal(folder.error, "")
	equal(folder.total_progress(), 1.0)
	equal([level.title, folder.manifest.files.size()], ["Sound", 2])
	level.free()


func test_damaged_and_hostile_folders_are_refused_by_name() -> void:
	var outside: String = ProjectSettings.globalize_path("user://sample_levels/outside.bake")
	var kinds: Dictionary[String, Array] = {
		"no manifest":
		[func(path: String) -> void: _remove(path, "level.json"), "level.json is missing"],
		"no scene":
		[func(path: String) -> void: _remove(path, "range.tscn"), "range.tscn is missing"],
		"cut":
		[func(path: String) -> void: _cut(path, "range.bake"), "has 2999 bytes instead of 3000"],
		"changed": [func(path: String) -> void: _change(path, "range.bake"), "its SHA-256 differs"],
		"changed scene":
		[func(path: String) -> void: _change(path, "range.tscn"), "SHA-256 differs"],
		"another version":
		[
			func(path: String) -> void: SampleFolder.edit_manifest(path, '"kit": 1', '"kit": 2'),
			"it needs level kit 2"
		],
		"link":
		[
			func(path: String) -> void:
				_remove(path, "range.bake")
				SampleFolder.store(outside, PackedByteArray([1]))
				DirAccess.open(path).create_link(outside, "range.bake"),
			"range.bake is a link"
		],
		"no folder": [SampleFolder.clean_up, "level.json is missing"],
	}
	for kind: String in kinds:
		var path: String = SampleFolder.make("range", 3000)
		(kinds[kind][0] as Callable).call(path)
		var folder: LevelFolder = LevelFolder.new(path)
		is_null(folder.build(), kind)
		contains(folder.error, kinds[kind][1], kind)
		SampleFolder.clean_up()


func test_a_level_that_may_not_be_sent_is_not_packed() -> void:
	var archive: LevelArchive = LevelArchive.new()
	is_false(archive.pack("yard", "res://scenes/world/yard", SampleFolder.ROOT))
	is_true(archive.faults.size() > 3)
	contains(" ".join(archive.faults), "yard.tscn, line 9: it uses the PackedScene")
	is_false(DirAccess.dir_exists_absolute(SampleFolder.ROOT.path_join("yard")))
	is_false(archive.pack("atlantis", "res://scenes/world/atlantis", SampleFolder.ROOT))
	contains(archive.faults[0], "there is no")


func test_a_share_lists_its_levels() -> void:
	SampleFolder.make("range")
	SampleFolder.make("alley")
	var share: LevelShare = LevelShare.new(SampleFolder.ROOT.path_join("share"))
	DirAccess.make_dir_absolute(share.folder_of("empty"))
	equal(share.names(), PackedStringArray(["alley", "range"]))
	is_true(share.has("range"))
	for name: String in ["../share/range", "empty", "atlantis", ""]:
		is_false(share.has(name), name)
	equal(share.find_fault(), "")
	contains(LevelShare.new("user://nowhere").find_fault(), "there is no folder user://nowhere")
	equal(LevelShare.new("").names(), PackedStringArray())


func test_references_name_levels_and_hashes() -> void:
	var hash: String = "0a".repeat(32)
	var sent: LevelReference = LevelReference.parse(LevelReference.text_of("range", hash))
	equal([sent.name, sent.content_hash], ["range", hash])
	for text: String in ["hall", "hall@", "@" + hash, "hall@xyz", ""]:
		var ours: LevelReference = LevelReference.parse(text)
		equal([ours.name, ours.content_hash], [text, ""])


static func _remove(p_path: String, p_file: String) -> void:
	DirAccess.remove_absolute(p_path.path_join(p_file))


static func _cut(p_path: String, p_file: String) -> void:
	var bytes: PackedByteArray = FileAccess.get_file_as_bytes(p_path.path_join(p_file))
	SampleFolder.store(p_path.path_join(p_file), bytes.slice(0, -1))


static func _change(p_path: String, p_file: String) -> void:
	var bytes: PackedByteArray = FileAccess.get_file_as_bytes(p_path.path_join(p_file))
	bytes[bytes.size() / 2] ^= 1
	SampleFolder.store(p_path.path_join(p_file), bytes)
