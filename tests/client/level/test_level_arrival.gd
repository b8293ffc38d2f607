extends TestCase
## A client that waits for the server's level: what it shows meanwhile, what it keeps, and that it
## stays where a level is refused.

const CLIENT: PackedScene = preload("res://scenes/client/client.tscn")

var _client: Node = null
var _scene: ClientScene = null
var _arrival: LevelArrival = null
var _store: ReceivedLevels = null
var _folder: LevelFolder = null
var _shown: PackedStringArray = []
var _taken: Array[PackedByteArray] = []
var _requests: Array[PackedByteArray] = []


func goes_by_clock() -> bool:
	return true


func before_each() -> void:
	SampleFolder.clean_up()
	_client = CLIENT.instantiate()
	_scene = _client.get_node(^"Scene")
	_client.remove_child(_scene)
	_scene.owner = null
	add_child(_scene)
	_store = ReceivedLevels.new(SampleFolder.ROOT.path_join("store"))
	_scene.get_level().store = _store
	_arrival = LevelArrival.new(_scene, _store, _requests.append)
	_arrival.progressed.connect(_shown.append)
	_shown.clear()
	_taken.clear()
	_requests.clear()


func after_each() -> void:
	_arrival.close()
	_scene.free()
	_client.free()
	SampleFolder.clean_up()


func test_a_level_of_ours_comes_over_several_frames_with_progress() -> void:
	is_false(_arrival.keeps(_table()), "nothing is waited for")
	is_true(_arrival.keeps(_level("yard")))
	is_true(_arrival.keeps(_table()))
	is_true(_arrival.keeps(PackedByteArray([Protocol.Message.SNAPSHOT, 0])))
	await _until(LevelArrival.Wait.NOTHING)
	equal(_taken.size(), 2, "the level and the table, but no snapshot")
	equal([_taken[0][0], _taken[1][0]], [Protocol.Message.LEVEL, Protocol.Message.TABLE])
	equal(_scene.get_level().level_name, "yard")
	contains(_shown[0], "Loading world 'yard': ")
	equal(_shown[-1], "")
	equal(_arrival.report()["loaded"], 1)
	# Another one takes its place, and nothing of the first is left.
	is_true(_arrival.keeps(_level("yard")))
	await _until(LevelArrival.Wait.NOTHING)
	equal(_scene.get_level().level.name, &"Yard", "calls of shared nodes go by this path")
	is_true(_arrival.keeps(_level("hall")))
	is_null(_scene.get_level().level)
	await _until(LevelArrival.Wait.NOTHING)
	for _frame: int in 60:
		_arrival.advance(0.01, _taken.append)
	equal(_scene.get_level().get_child_count(), 1)


func test_a_level_that_is_lacking_comes_from_the_server() -> void:
	_offer(LevelTexts.level())
	is_true(_arrival.keeps(_level("range@" + _hash())))
	contains(_shown[0], "Downloading world 'range'")
	await _until(LevelArrival.Wait.NOTHING)
	equal(_scene.get_level().level.title, "Sound")
	equal(_arrival.downloaded, _folder.manifest.total_size())
	contains(" ".join(_shown), "Downloading world 'Sound': ")
	# The second time it is here.
	_requests.clear()
	_arrival.keeps(_level("range@" + _hash()))
	await _until(LevelArrival.Wait.NOTHING)
	equal(_requests.size(), 0)


func test_a_hostile_level_is_refused_and_the_client_waits_for_another() -> void:
	HostileLevels.write_bait()
	_offer(LevelTexts.level({"end": '[node name="T" type="Timer" parent="."]'}))
	_arrival.keeps(_level("range@" + _hash()))
	await _until(LevelArrival.Wait.ANOTHER)
	contains(_shown[-1], "is refused: range.tscn, line ")
	contains(_shown[-1], "Waiting for another one")
	is_false(_store.has(_hash()))
	is_true(_arrival.keeps(_table()), "it is of no use")
	_arrival.keeps(_level("hall"))
	await _until(LevelArrival.Wait.NOTHING)
	equal([_scene.get_level().level_name, _taken.size()], ["hall", 1])
	equal(HostileLevels.marks(), PackedStringArray())
	HostileLevels.clean_up()


func test_a_damaged_store_is_noticed_and_mended() -> void:
	_offer(LevelTexts.level())
	_arrival.keeps(_level("range@" + _hash()))
	await _until(LevelArrival.Wait.NOTHING)
	var file: String = _store.folder_of(_hash()).path_join("range.tscn")
	var bytes: PackedByteArray = FileAccess.get_file_as_bytes(file)
	bytes[-5] ^= 1
	SampleFolder.store(file, bytes)
	_arrival.keeps(_level("range@" + _hash()))
	await _until(LevelArrival.Wait.NOTHING)
	equal(_scene.get_level().level.title, "Sound")
	equal(_arrival.loaded, 2)


func test_a_level_that_is_neither_here_nor_offered_is_left_to_others() -> void:
	for name: String in ["atlantis", "", "../hall", "hall@xyz"]:
		is_false(_arrival.keeps(_level(name)), name)
	is_false(_arrival.keeps(PackedByteArray([Protocol.Message.LEVEL, 9])))


func test_too_much_while_it_loads_is_refused() -> void:
	_arrival.keeps(_level("hall"))
	var large: PackedByteArray = []
	large.resize(LevelArrival.MAX_KEPT / 4)
	large[0] = Protocol.Message.TABLE
	for _count: int in 5:
		_arrival.keeps(large)
	equal(_arrival.wait, LevelArrival.Wait.ANOTHER)
	contains(_shown[-1], "sends too much while it loads")


func test_a_new_connection_begins_anew() -> void:
	for _frames: int in 6:
		_arrival.keeps(_level("yard"))
		for _frame: int in _frames * 3:
			_arrival.advance(0.01, _taken.append)
			await process_frames(1)
		_arrival.restart()
	_arrival.keeps(_level("yard"))
	await _until(LevelArrival.Wait.NOTHING)
	for _frame: int in 60:
		_arrival.advance(0.01, _taken.append)
	equal(_scene.get_level().get_child_count(), 1)


func _level(p_name: String) -> PackedByteArray:
	return LevelMessage.encode(p_name, PackedByteArray())


static func _table() -> PackedByteArray:
	return PackedByteArray([Protocol.Message.TABLE, 0])


func _hash() -> String:
	return _folder.manifest.content_hash()


## Makes a level that a server offers, whatever is in its scene.
func _offer(p_scene: String) -> void:
	_folder = LevelFolder.new(SampleFolder.make("range"))
	_folder.open()
	var entry: LevelManifest.Entry = _folder.manifest.files[0]
	var bytes: PackedByteArray = p_scene.to_utf8_buffer()
	SampleFolder.store(_folder.path.path_join(entry.name), bytes)
	entry.size = bytes.size()
	entry.sha256 = LevelManifest.sha256_of(bytes)
	_folder.manifest.encode()


func _until(p_wait: LevelArrival.Wait) -> void:
	var next: int = _requests.size()
	var limit: int = Time.get_ticks_msec() + 20000
	next = 0
	while _arrival.wait != p_wait and Time.get_ticks_msec() < limit:
		while next < _requests.size():
			_answer(LevelRequestMessage.decode(_requests[next]))
			next += 1
		_arrival.advance(0.01, _take)
		await process_frames(1)
	equal(_arrival.wait, p_wait)


func _take(p_bytes: PackedByteArray) -> void:
	_taken.append(p_bytes)
	if p_bytes[0] == Protocol.Message.LEVEL:
		_scene.replica.take(p_bytes, 0.0)


func _answer(p_request: LevelRequestMessage) -> void:
	var bytes: PackedByteArray = _folder.manifest.bytes
	if p_request.file != LevelRequestMessage.MANIFEST:
		var entry: LevelManifest.Entry = _folder.manifest.files[p_request.file - 1]
		bytes = FileAccess.get_file_as_bytes(_folder.path.path_join(entry.name))
	var end: int = mini(p_request.offset + p_request.length, bytes.size())
	for at: int in range(p_request.offset, end, LevelDataMessage.ROOM):
		var part: PackedByteArray = bytes.slice(at, mini(at + LevelDataMessage.ROOM, end))
		_arrival.take_data(LevelDataMessage.encode(p_request.number, at, bytes.size(), part))
