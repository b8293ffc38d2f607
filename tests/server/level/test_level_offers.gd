extends TestCase
## Sending levels to clients: what is asked for comes, a little in each tick; all else is refused.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")

var _pair: LinkPair = null
var _level: ServerLevel = null
var _offers: LevelOffers = null
var _number: int = 0
var _answers: Array[LevelDataMessage] = []


func before_each() -> void:
	SampleFolder.clean_up()
	SampleFolder.make("range", 200_000)
	_level = ServerLevel.new()
	add_child(_level)
	_level.share = LevelShare.new(SampleFolder.ROOT.path_join("share"))
	equal(_level.load_level("range"), "")
	_pair = LinkPair.new()
	_offers = LevelOffers.new(_pair.server, _level)
	equal(_pair.listen(), OK)
	_answers.clear()
	_number = 0


func after_each() -> void:
	_offers.close()
	_pair.close()
	_level.free()
	SampleFolder.clean_up()


func test_the_reference_names_the_levels_hash() -> void:
	var reference: LevelReference = LevelReference.parse(_level.reference)
	equal([reference.name, reference.content_hash], ["range", _hash()])
	equal(LevelMessage.decode(_level.message()).name, _level.reference)


func test_what_is_asked_for_comes_in_order() -> void:
	var end: LinkPair.End = _join()
	_ask(end, LevelRequestMessage.MANIFEST, 0, 65536)
	_ask(end, 1, 100, 5000)
	is_true(_until(func() -> bool: return _sum(2) == 5000))
	equal(_gather(1), _level.folder.manifest.bytes)
	var name: String = _level.folder.manifest.files[0].name
	var bytes: PackedByteArray = FileAccess.get_file_as_bytes(_level.folder.path.path_join(name))
	equal(_gather(2), bytes.slice(100, 5100))


func test_the_limit_of_the_network_is_kept() -> void:
	_offers.bits_per_second = 160_000.0
	var end: LinkPair.End = _join()
	_ask(end, 1, 0, 65536)
	is_true(_until(func() -> bool: return _offers.sent_bytes > 0))
	var before: int = _offers.sent_bytes
	for _tick: int in 60:
		_offers.advance(1.0 / 60.0)
	is_true(absi(_offers.sent_bytes - before - 20_000) < 1500, "%d" % (_offers.sent_bytes - before))


func test_what_is_none_of_the_level_is_refused() -> void:
	var end: LinkPair.End = _join()
	for asked: Array in [[9, 0, 10], [1, 1 << 30, 10], [1, 199_990, 500], [0, 1 << 20, 10]]:
		_ask(end, asked[0], asked[1], asked[2])
	var other: LevelRequestMessage = _request(1, 0, 10)
	other.content_hash = "ab".repeat(32).hex_decode()
	other.number = 77
	end.link.send_reliably(other.encode())
	is_true(_until(func() -> bool: return not _answers.is_empty()))
	equal([_answers[0].number, _answers[0].outcome], [77, LevelDataMessage.Outcome.REFUSED])
	contains(_answers[0].why, "another one now")
	equal(_offers.sent_bytes, 0)
	equal(_pair.server.refused.get("message %d" % Protocol.Message.LEVEL_REQUEST, 0), 4)


func test_more_requests_than_allowed_are_dropped() -> void:
	_offers.bits_per_second = 8000.0
	var end: LinkPair.End = _join()
	for _count: int in 20:
		_ask(end, 1, 0, 1000)
	var key: String = "message %d" % Protocol.Message.LEVEL_REQUEST
	is_true(_until(func() -> bool: return _pair.server.refused.get(key, 0) > 10))
	equal(_offers.count(), 1)
	end.link.close()
	is_true(_until(func() -> bool: return _offers.count() == 0))


func test_a_share_that_is_not_there_is_named() -> void:
	contains(LevelShare.new("/no/such").find_fault(), "there is no folder /no/such")
	equal(LevelShare.new("").find_fault(), "")


func test_a_level_of_the_program_is_not_sent() -> void:
	equal(_level.load_level("hall"), "")
	equal(_level.reference, "hall")
	var end: LinkPair.End = _join()
	_ask(end, 1, 0, 1000)
	is_true(_until(func() -> bool: return not _answers.is_empty()))
	equal(_answers[0].outcome, LevelDataMessage.Outcome.REFUSED)


func test_a_broken_level_leaves_the_present_one() -> void:
	SampleFolder.make("alley", 10)
	SampleFolder.edit_manifest(_level.share.folder_of("alley"), '"kit": 1', '"kit": 7')
	contains(_level.load_level("alley"), "world 'alley' is refused: it needs level kit 7")
	var ended: Array[String] = []
	_level.change_ended.connect(ended.append)
	equal(_level.change_level("alley"), "")
	contains(_level.change_level("hall"), "is being loaded")
	while ended.is_empty():
		_level.advance(1)
		await process_frames(1)
	contains(ended[0], "it needs level kit 7")
	equal([_level.level_name, _level.level.title], ["range", "Sound"])
	contains(_level.change_level("atlantis"), "there is no world 'atlantis' here")
	equal(_level.change_level("hall"), "")
	while ended.size() < 2:
		_level.advance(1)
		await process_frames(1)
	equal([ended[1], _level.level_name, _level.reference], ["", "hall", "hall"])
	equal(_level.fingerprint, LevelFingerprint.of(_level.level))
	is_null(_level.folder)


func test_the_same_level_again_has_the_same_paths() -> void:
	equal(_level.load_level("yard"), "")
	var path: NodePath = _level.level.get_path()
	var first: Level = _level.level
	var ended: Array[String] = []
	_level.change_ended.connect(ended.append)
	equal(_level.change_level("yard"), "")
	while ended.is_empty():
		_level.advance(1)
		await process_frames(1)
	equal(ended, [""] as Array[String])
	is_false(is_instance_valid(first), "the first one is gone")
	# Calls of shared nodes go by it.
	equal(_level.level.get_path(), path)


func _hash() -> String:
	return _level.folder.manifest.content_hash()


func _join() -> LinkPair.End:
	var end: LinkPair.End = _pair.join(Roles.Role.OBSERVER)
	end.link.handle(
		Protocol.Message.LEVEL_DATA,
		MessageHandlers.Path.RELIABLE,
		func(bytes: PackedByteArray, _arrival: int) -> bool:
			_answers.append(LevelDataMessage.decode(bytes))
			return true
	)
	return end


func _request(p_file: int, p_offset: int, p_length: int) -> LevelRequestMessage:
	_number += 1
	var request: LevelRequestMessage = LevelRequestMessage.new()
	request.number = _number
	if _level.folder != null:
		request.content_hash = _hash().hex_decode()
	request.content_hash.resize(LevelRequestMessage.HASH_SIZE)
	request.file = p_file
	request.offset = p_offset
	request.length = p_length
	return request


func _ask(p_end: LinkPair.End, p_file: int, p_offset: int, p_length: int) -> void:
	p_end.link.send_reliably(_request(p_file, p_offset, p_length).encode())


func _until(p_holds: Callable) -> bool:
	return _pair.until(
		func() -> bool:
			_offers.advance(1.0 / 60.0)
			return p_holds.call()
	)


func _gather(p_number: int) -> PackedByteArray:
	var bytes: PackedByteArray = []
	for answer: LevelDataMessage in _answers:
		if answer.number == p_number:
			bytes.append_array(answer.data)
	return bytes


func _sum(p_number: int) -> int:
	return _gather(p_number).size()
