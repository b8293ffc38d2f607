extends TestCase
## Getting a level from a server: as a whole, after a stop, and from servers that mean harm.

const STORE: String = SampleFolder.ROOT + "/store"

var _folder: LevelFolder = null
var _store: ReceivedLevels = null
var _download: LevelDownload = null
var _requests: Array[LevelRequestMessage] = []
## Changes an answer before it is given: func(answer: PackedByteArray, request) -> PackedByteArray.
var _tamper: Callable = Callable()


func before_each() -> void:
	SampleFolder.clean_up()
	_folder = LevelFolder.new(SampleFolder.make("range", 300_000))
	is_true(_folder.open(), _folder.error)
	_store = ReceivedLevels.new(STORE)
	_requests.clear()
	_tamper = Callable()
	_begin()


func after_each() -> void:
	_download.cancel()
	SampleFolder.clean_up()


func test_a_level_comes_as_a_whole() -> void:
	var state: LevelDownload.State = await _serve()
	equal(state, LevelDownload.State.DONE, _download.fault)
	equal([_download.progress(), _download.resumed], [1.0, 0])
	var level: Level = LevelFolder.new(_store.folder_of(_hash())).build()
	not_null(level)
	level.free()


func test_it_goes_on_where_it_was_stopped() -> void:
	await _serve(100)
	var before: int = _download.here
	is_true(before > 60_000 and before < 300_000, "%d bytes" % before)
	_begin()
	equal(await _serve(), LevelDownload.State.DONE, _download.fault)
	equal(_download.resumed, before)
	var asked: int = 0
	for request: LevelRequestMessage in _requests:
		asked += request.length if request.file != LevelRequestMessage.MANIFEST else 0
	is_true(asked < _folder.manifest.total_size() - before + 1, "%d bytes asked for" % asked)


func test_what_was_damaged_meanwhile_comes_again() -> void:
	await _serve(100)
	_download.cancel()
	for entry: LevelManifest.Entry in _folder.manifest.files:
		var part: String = _store.claim_part(entry.sha256)
		if FileAccess.file_exists(part):
			var bytes: PackedByteArray = FileAccess.get_file_as_bytes(part)
			bytes[10] ^= 1
			SampleFolder.store(part, bytes)
	_begin()
	equal(await _serve(), LevelDownload.State.DONE, _download.fault)
	var level: Level = LevelFolder.new(_store.folder_of(_hash())).build()
	not_null(level)
	level.free()


func test_hostile_servers_are_refused_by_reason() -> void:
	var kinds: Dictionary[String, Array] = {
		"another manifest": [_change_last, true, "its SHA-256 differs"],
		"endless manifest": [_grow_size, true, "16384 are the most"],
		"other bytes": [_change_last, false, "is not what was offered: its SHA-256 differs"],
		"wrong offset": [_shift, false, "something else than was asked for"],
		"wrong size": [_grow_size, false, "something else than was asked for"],
		"endless piece": [_grow, false, "sends more than was asked for"],
		"refusal": [_refuse, false, "the server does not send it: no"],
	}
	for kind: String in kinds:
		_tamper = func(answer: PackedByteArray, request: LevelRequestMessage) -> PackedByteArray:
			var is_manifest: bool = request.file == LevelRequestMessage.MANIFEST
			return kinds[kind][0].call(answer) if is_manifest == kinds[kind][1] else answer
		_begin()
		equal(await _serve(), LevelDownload.State.FAILED, kind)
		contains(_download.fault, kinds[kind][2], kind)
		is_false(_store.has(_hash()), kind)


func test_a_level_of_another_name_or_too_large_is_refused() -> void:
	var reference: LevelReference = LevelReference.parse("alley@" + _hash())
	_download.begin(reference)
	await _serve()
	contains(_download.fault, "it is called 'range'")
	_store.room = 1000
	_begin()
	await _serve()
	contains(_download.fault, "--level-store")


func test_a_server_that_stops_is_asked_again_and_given_up_at_last() -> void:
	await _serve(5)
	var asked: int = _requests.size()
	for _time: int in LevelDownload.MAX_RETRIES:
		_download.advance(LevelDownload.PATIENCE_S + 0.1)
		is_true(_download.is_busy())
	is_true(_requests.size() > asked)
	contains(_download.describe(), "the server is silent")
	_download.advance(LevelDownload.PATIENCE_S + 0.1)
	equal(_download.state, LevelDownload.State.FAILED)
	contains(_download.fault, "the server has stopped")


func test_any_bytes_are_survived() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 9
	for _count: int in 3000:
		if not _download.is_busy():
			_begin()
		var bytes: PackedByteArray = _answer(_requests[-1])[0]
		for _change: int in random.randi() % 4:
			bytes[random.randi() % bytes.size()] = random.randi() % 256
		_download.take(bytes.slice(0, random.randi() % (bytes.size() + 1)))
		_download.advance(0.001)
	is_false(_store.has("ab".repeat(32)))


func _begin() -> void:
	if _download != null:
		_download.cancel()
	_requests.clear()
	_download = LevelDownload.new(
		func(bytes: PackedByteArray) -> void: _requests.append(LevelRequestMessage.decode(bytes)),
		_store
	)
	_download.begin(LevelReference.parse("range@" + _hash()))


func _hash() -> String:
	return _folder.manifest.content_hash()


## Answers what is asked for, with so many answers at most, until it is done.
func _serve(p_answers: int = 1 << 30) -> LevelDownload.State:
	var next: int = 0
	var left: int = p_answers
	while _download.is_busy() and left > 0:
		if next == _requests.size():
			# A thread works.
			_download.advance(0.01)
			await process_frames(1)
			continue
		for answer: PackedByteArray in _answer(_requests[next]):
			if _tamper.is_valid():
				answer = _tamper.call(answer, _requests[next])
			_download.take(answer)
			left -= 1
			if left == 0 or not _download.is_busy():
				break
		next += 1
	return _download.state


func _answer(p_request: LevelRequestMessage) -> Array[PackedByteArray]:
	var bytes: PackedByteArray = _folder.manifest.bytes
	if p_request.file != LevelRequestMessage.MANIFEST:
		var name: String = _folder.manifest.files[p_request.file - 1].name
		bytes = FileAccess.get_file_as_bytes(_folder.path.path_join(name))
	var end: int = mini(p_request.offset + p_request.length, bytes.size())
	var answers: Array[PackedByteArray] = []
	for at: int in range(p_request.offset, end, LevelDataMessage.ROOM):
		var part: PackedByteArray = bytes.slice(at, mini(at + LevelDataMessage.ROOM, end))
		answers.append(LevelDataMessage.encode(p_request.number, at, bytes.size(), part))
	return answers


static func _change_last(p_answer: PackedByteArray) -> PackedByteArray:
	p_answer[-1] ^= 1
	return p_answer


static func _shift(p_answer: PackedByteArray) -> PackedByteArray:
	p_answer.encode_u32(4, p_answer.decode_u32(4) + 1)
	return p_answer


static func _grow_size(p_answer: PackedByteArray) -> PackedByteArray:
	p_answer.encode_u32(8, 1 << 30)
	return p_answer


## The same bytes again and again: the last part of a piece is longer than what was asked for.
static func _grow(p_answer: PackedByteArray) -> PackedByteArray:
	var grown: PackedByteArray = p_answer.duplicate()
	grown.resize(12 + LevelDataMessage.ROOM)
	return grown


static func _refuse(p_answer: PackedByteArray) -> PackedByteArray:
	return LevelDataMessage.refuse(p_answer.decode_u16(1), "no")
