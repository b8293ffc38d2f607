extends TestCase
## The store of received levels: by hash, with a limit, shared by processes.

const STORE: String = SampleFolder.ROOT + "/store"

var _store: ReceivedLevels = null


func before_each() -> void:
	SampleFolder.clean_up()
	_store = ReceivedLevels.new(STORE)


func after_each() -> void:
	SampleFolder.clean_up()


func test_a_level_is_kept_by_its_hash() -> void:
	var hash: String = _keep("range", 100)
	is_true(_store.has(hash))
	is_false(_store.has("ab".repeat(32)))
	is_false(_store.has("../store"))
	var level: Level = LevelFolder.new(_store.folder_of(hash)).build()
	not_null(level)
	level.free()
	equal(DirAccess.get_files_at(STORE.path_join(ReceivedLevels.PARTS)).size(), 0)
	_store.remove(hash)
	is_false(_store.has(hash))


func test_of_two_processes_that_keep_a_level_both_succeed() -> void:
	var hash: String = _keep("range", 100)
	equal(_keep("range", 100), hash)
	var names: PackedStringArray = DirAccess.get_directories_at(STORE)
	equal(names.size(), 2, ", ".join(names))


func test_what_was_used_longest_ago_goes_first() -> void:
	var hashes: PackedStringArray = []
	for name: String in ["one", "two", "three"]:
		hashes.append(_keep(name, 300_000))
		OS.delay_msec(5)
	_store.touch(hashes[0])
	_store.room = 1_000_000
	equal(_store.make_room(300_000), "")
	equal(_there(hashes), [true, false, true])
	equal(_store.make_room(900_000, hashes[2]), "")
	equal(_there(hashes), [false, false, true])
	contains(_store.make_room(2 << 20), "--level-store allows 0 MB")


func test_parts_of_a_process_that_is_gone_are_taken_over() -> void:
	var sha256: String = "cd".repeat(32)
	var folder: String = STORE.path_join(ReceivedLevels.PARTS)
	DirAccess.make_dir_recursive_absolute(folder)
	# The first process of the machine is always there.
	SampleFolder.store(folder.path_join(sha256 + ".1.part"), PackedByteArray([1]))
	is_false(FileAccess.file_exists(_store.claim_part(sha256)))
	SampleFolder.store(folder.path_join(sha256 + ".99999999.part"), PackedByteArray([1, 2]))
	equal(FileAccess.get_file_as_bytes(_store.claim_part(sha256)).size(), 2)
	is_true(FileAccess.file_exists(folder.path_join(sha256 + ".1.part")))


func _there(p_hashes: PackedStringArray) -> Array:
	return Array(p_hashes).map(func(hash: String) -> bool: return _store.has(hash))


func _keep(p_name: String, p_bytes: int) -> String:
	var folder: LevelFolder = LevelFolder.new(SampleFolder.make(p_name, p_bytes))
	is_true(folder.open(), folder.error)
	for entry: LevelManifest.Entry in folder.manifest.files:
		var part: String = _store.claim_part(entry.sha256)
		DirAccess.copy_absolute(folder.path.path_join(entry.name), part)
	equal(_store.adopt(folder.manifest), "")
	return folder.manifest.content_hash()
