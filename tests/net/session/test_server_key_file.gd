extends TestCase
## A server's key stays the same, nobody else can read it, and damage is named and left alone.

const FOLDER: String = "user://server_key_test"
const PATH: String = FOLDER + "/deep/server.key"


func before_each() -> void:
	_clear()


func after_each() -> void:
	_clear()


func test_the_key_is_made_once_and_read_again() -> void:
	var made: ServerKeyFile = ServerKeyFile.open(PATH)
	equal(made.error, "")
	equal(made.key_seed.size(), KeyFingerprint.KEY_SIZE)
	equal(made.fingerprint, KeyFingerprint.of(ServerKeyFile.public_key_of(made.key_seed)))
	var again: ServerKeyFile = ServerKeyFile.open(PATH)
	equal(again.key_seed, made.key_seed)
	equal(again.fingerprint, made.fingerprint)
	var owner: int = FileAccess.UNIX_READ_OWNER | FileAccess.UNIX_WRITE_OWNER
	equal(FileAccess.get_unix_permissions(PATH), owner)
	equal(DirAccess.get_files_at(PATH.get_base_dir()), PackedStringArray(["server.key"]))


func test_servers_that_start_at_once_have_one_key() -> void:
	var threads: Array[Thread] = []
	for i: int in 8:
		var thread: Thread = Thread.new()
		thread.start(func() -> PackedByteArray: return ServerKeyFile.open(PATH).key_seed)
		threads.append(thread)
	var seeds: Dictionary[PackedByteArray, bool] = {}
	for thread: Thread in threads:
		seeds[thread.wait_to_finish()] = true
	equal(seeds.size(), 1)
	equal(seeds.keys()[0].size(), KeyFingerprint.KEY_SIZE)
	equal(DirAccess.get_files_at(PATH.get_base_dir()), PackedStringArray(["server.key"]))


func test_a_damaged_file_is_an_error_that_names_it_and_stays() -> void:
	ServerKeyFile.open(PATH)
	var whole: String = FileAccess.get_file_as_string(PATH)
	var lines: PackedStringArray = whole.split("\n")
	# Another letter, which is one of base64's as well.
	var seed_at: int = whole.find("seed ") + 10
	var other: String = "A" if whole[seed_at] != "A" else "B"
	var damages: PackedStringArray = [
		"",
		whole.left(40),
		whole.left(whole.length() - 10),
		"\n".join([lines[0], lines[1]]),
		whole.left(seed_at) + other + whole.substr(seed_at + 1),
		whole.replace("key 1", "key 2"),
		"\u0001\u0002\u0003",
	]
	for damage: String in damages:
		_write(damage)
		var read: ServerKeyFile = ServerKeyFile.open(PATH)
		contains(read.error, ProjectSettings.globalize_path(PATH))
		contains(read.error, "is damaged")
		equal(FileAccess.get_file_as_string(PATH), damage)
	_write(whole)
	equal(ServerKeyFile.open(PATH).error, "")


func test_a_file_that_cannot_be_had_is_an_error() -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)
	# Where the folder would be is a file.
	var file: FileAccess = FileAccess.open(FOLDER + "/deep", FileAccess.WRITE)
	file.close()
	allow_error("Could not create directory")
	var read: ServerKeyFile = ServerKeyFile.open(PATH)
	contains(read.error, ProjectSettings.globalize_path(PATH))
	contains(read.error, "--server-key")
	DirAccess.remove_absolute(FOLDER + "/deep")
	# The name of the file is a folder's.
	DirAccess.make_dir_recursive_absolute(PATH)
	contains(ServerKeyFile.open(PATH).error, "cannot be made")


func _write(p_text: String) -> void:
	var file: FileAccess = FileAccess.open(PATH, FileAccess.WRITE)
	file.store_string(p_text)


func _clear() -> void:
	for path: String in [PATH, PATH + ".new", PATH.get_base_dir(), FOLDER]:
		DirAccess.remove_absolute(path)
