extends TestCase
## What is remembered stays, whoever else writes and whatever else stands in the file.

const FOLDER: String = "user://known_servers_test"
const PATH: String = FOLDER + "/known_servers"

var _known: KnownServers = null
var _key: PackedByteArray = PackedByteArray()
var _other: PackedByteArray = PackedByteArray()


func before_each() -> void:
	_clear()
	_known = KnownServers.new(PATH)
	_key = Crypto.new().generate_random_bytes(KeyFingerprint.KEY_SIZE)
	_other = Crypto.new().generate_random_bytes(KeyFingerprint.KEY_SIZE)


func after_each() -> void:
	_clear()


func test_addresses_are_the_same_however_they_are_written() -> void:
	equal(KnownServers.address(" Server.Example. ", 7777), "server.example:7777")
	equal(KnownServers.address("::1", 1), "[::1]:1")
	equal(KnownServers.address("[::1]", 1), "[::1]:1")
	not_equal(KnownServers.address("a", 1), KnownServers.address("a", 2))


func test_a_key_is_remembered_and_replaced_only_where_it_may_be() -> void:
	equal(_known.find("a:1").size(), 0)
	equal(_known.keep("a:1", _key, false), _key)
	equal(_known.keep("a:2", _other, false), _other)
	var again: KnownServers = KnownServers.new(PATH)
	equal(again.find("a:1"), _key)
	equal(again.keep("a:1", _other, false), _key)
	equal(again.find("a:1"), _key)
	equal(again.keep("a:1", _other, true), _other)
	equal(KnownServers.new(PATH).find("a:1"), _other)
	equal(KnownServers.new(PATH).find("a:2"), _other)
	equal(_known.error + again.error, "")
	var owner: int = FileAccess.UNIX_READ_OWNER | FileAccess.UNIX_WRITE_OWNER
	equal(FileAccess.get_unix_permissions(PATH), owner)


func test_writers_at_the_same_time_lose_no_line() -> void:
	const WRITERS: int = 4
	const EACH: int = 25
	var write: Callable = func(writer: int) -> void:
		for i: int in EACH:
			KnownServers.new(PATH).keep("host-%d:%d" % [writer, i + 1], _key, false)
	var threads: Array[Thread] = []
	for writer: int in WRITERS:
		var thread: Thread = Thread.new()
		thread.start(write.bind(writer))
		threads.append(thread)
	for thread: Thread in threads:
		thread.wait_to_finish()
	for writer: int in WRITERS:
		for i: int in EACH:
			equal(_known.find("host-%d:%d" % [writer, i + 1]), _key)
	equal(_known.faults.size(), 0)


func test_of_two_who_are_the_first_one_is() -> void:
	# Both have looked, and neither has found anything.
	equal(_known.find("a:1").size(), 0)
	var second: KnownServers = KnownServers.new(PATH)
	equal(second.keep("a:1", _other, false), _other)
	equal(_known.keep("a:1", _key, false), _other)


func test_damaged_lines_are_named_and_left_alone() -> void:
	var good: String = "a:1 %s 2026-11-28" % KeyFingerprint.to_text(_key)
	var damaged: PackedStringArray = ["nonsense", "b:1 abc 2026-11-28", good + " more", good]
	_write("# mine\n\n%s\n%s\n" % [good, "\n".join(damaged)])
	equal(_known.find("a:1"), _key)
	equal(_known.faults.size(), damaged.size())
	var full: String = ProjectSettings.globalize_path(PATH)
	for i: int in damaged.size():
		is_true(_known.faults[i].begins_with("%s:%d: " % [full, i + 4]), _known.faults[i])
	# No server has such a key: the user is asked, and may put it right.
	equal(_known.find("b:1"), _no_key())
	_known.keep("c:1", _other, false)
	equal(_known.find("c:1"), _other)
	var text: String = FileAccess.get_file_as_string(PATH)
	is_true(text.begins_with("# mine\n\n%s\n%s\nc:1 " % [good, "\n".join(damaged)]), text)
	equal(_known.keep("b:1", _key, false), _no_key())
	equal(_known.keep("b:1", _key, true), _key)
	equal(_known.find("b:1"), _key)


func test_lines_of_another_system_are_read() -> void:
	_write("# mine\r\na:1 %s 2026-11-28\r\n" % KeyFingerprint.to_text(_key))
	equal(_known.find("a:1"), _key)
	equal(_known.faults.size(), 0)


func test_a_file_that_is_none_of_ours_stays_as_it_is() -> void:
	var large: String = "# %s\n".repeat(KnownServers.MAX_BYTES / 5 + 1)
	for text: String in [large, "a\u0001b\n"]:
		_write(text)
		if text != large:
			_write_zero()
		equal(_known.find("a:1"), _no_key(), "the user is asked")
		equal(_known.keep("a:1", _key, true), _key, "it goes on")
		contains(_known.error, ProjectSettings.globalize_path(PATH))
		equal(FileAccess.get_file_as_bytes(PATH).size(), text.length())


func test_the_file_is_bounded_and_nothing_in_it_is_lost() -> void:
	var lines: PackedStringArray = []
	for i: int in KnownServers.MAX_SERVERS:
		lines.append("h:%d %s 2026-11-28" % [i, KeyFingerprint.to_text(_key)])
	_write("\n".join(lines) + "\n")
	equal(_known.keep("new:1", _other, false), _other)
	contains(_known.error, "%d servers" % KnownServers.MAX_SERVERS)
	equal(_known.find("new:1").size(), 0)
	equal(_known.find("h:0"), _key)
	equal(_known.keep("h:0", _other, true), _other, "those that are there can change")
	equal(_known.find("h:0"), _other)
	equal(_known.keep("no address:1", _other, false), _other)
	equal(_known.find("no address:1").size(), 0)


func _write(p_text: String) -> void:
	DirAccess.make_dir_recursive_absolute(FOLDER)
	var file: FileAccess = FileAccess.open(PATH, FileAccess.WRITE)
	file.store_string(p_text)


func _write_zero() -> void:
	var file: FileAccess = FileAccess.open(PATH, FileAccess.READ_WRITE)
	file.seek(1)
	file.store_8(0)


func _no_key() -> PackedByteArray:
	var zeros: PackedByteArray = []
	zeros.resize(32)
	return zeros


func _clear() -> void:
	for path: String in [PATH, PATH + ".new", PATH + ".lock", FOLDER]:
		DirAccess.remove_absolute(path)
