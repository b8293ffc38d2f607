extends TestCase
## Which server a client joins: without a password only the one that it has joined before.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const FOLDER: String = "user://server_trust_test"
const PATH: String = FOLDER + "/known_servers"
const OBSERVER: Roles.Role = Roles.Role.OBSERVER

var _pairs: Array[LinkPair] = []


func before_each() -> void:
	_clear()


func after_each() -> void:
	for pair: LinkPair in _pairs:
		pair.close()
	_pairs.clear()
	_clear()


func goes_by_clock() -> bool:
	return true


func test_the_first_key_is_remembered_and_joined_again() -> void:
	var pair: LinkPair = _server(0)
	_join(pair)
	var address: String = KnownServers.address("127.0.0.1", pair.port)
	equal(KnownServers.new(PATH).find(address), _key(1))
	_join(pair)


func test_another_key_is_refused_before_anything_is_sent() -> void:
	var first: LinkPair = _server(0)
	_join(first)
	first.close()
	var second: LinkPair = _server(first.port, 2)
	var end: LinkPair.End = _add(second)
	is_true(second.until(func() -> bool: return end.refusal != ""))
	equal(end.joined, 0)
	equal(second.server.roster().size(), 0)
	equal(end.link.other_key.shown, _key(2))
	for part: String in [
		KeyFingerprint.of(_key(1)),
		KeyFingerprint.of(_key(2)),
		ProjectSettings.globalize_path(PATH),
		"--trust-new-key",
		str(first.port),
	]:
		contains(end.refusal, part)
	equal(_known(second), _key(1), "it stays")
	# The user trusts it.
	end.link.trust.trust(end.link.other_key)
	equal(_known(second), _key(2))
	end.link.open("127.0.0.1", second.port, end.request)
	is_true(second.until(func() -> bool: return end.joined == 1))
	is_null(end.link.other_key)


func test_a_key_that_is_trusted_once_is_remembered() -> void:
	var first: LinkPair = _server(0)
	_join(first)
	first.close()
	var second: LinkPair = _server(first.port, 2)
	var trust: ServerTrust = _trust()
	trust.takes_new = true
	_join(second, trust)
	equal(_known(second), _key(2))
	second.close()
	# Once: the same program does not trust a third.
	var third: LinkPair = _server(first.port, 3)
	var end: LinkPair.End = _add(third, trust)
	is_true(third.until(func() -> bool: return end.refusal != ""))
	equal(_known(third), _key(2))


func test_within_a_run_the_key_stays_though_nothing_is_kept() -> void:
	var first: LinkPair = _server(0)
	var end: LinkPair.End = _add(first, ServerTrust.new())
	is_true(first.until(func() -> bool: return end.joined == 1))
	first.ends.clear()
	end.link.close()
	first.close()
	var second: LinkPair = _server(first.port, 2)
	second.ends.append(end)
	# Its session's token is for the first alone.
	end.link.open("127.0.0.1", second.port, end.request)
	is_true(second.until(func() -> bool: return end.refusal != ""))
	equal(end.joined, 1)
	equal(second.joined.size(), 0)
	contains(end.refusal, KeyFingerprint.of(_key(2)))


func test_a_password_proves_more_than_a_key_which_is_remembered() -> void:
	var first: LinkPair = _server(0, 1, "secret")
	_join(first, _trust(), "secret")
	equal(_known(first), _key(1))
	first.close()
	var second: LinkPair = _server(first.port, 2, "secret")
	_join(second, _trust(), "secret")
	equal(_known(second), _key(2))


func test_a_fingerprint_that_is_given_holds_from_the_first_time() -> void:
	var pair: LinkPair = _server(0)
	var wrong: ServerTrust = _trust()
	wrong.pin = KeyFingerprint.of(_key(2))
	equal(wrong.find_fault(), "")
	var end: LinkPair.End = _add(pair, wrong)
	is_true(pair.until(func() -> bool: return end.refusal != ""))
	contains(end.refusal, wrong.pin)
	contains(end.refusal, KeyFingerprint.of(_key(1)))
	is_true(end.link.other_key.is_pinned)
	equal(_known(pair).size(), 0)
	equal(pair.joined.size(), 0)
	pair.ends.clear()
	# One that staff hand out replaces what was remembered.
	KnownServers.new(PATH).keep(KnownServers.address("127.0.0.1", pair.port), _key(2), false)
	var right: ServerTrust = _trust()
	right.pin = KeyFingerprint.of(_key(1))
	_join(pair, right)
	equal(_known(pair), _key(1))
	right.pin = "SHA256:short"
	contains(right.find_fault(), "--server-fingerprint")


func test_two_clients_trust_the_one_that_was_first() -> void:
	var trust: ServerTrust = _trust()
	var address: String = KnownServers.address("127.0.0.1", 1)
	equal(trust.expect(address).size(), 0)
	KnownServers.new(PATH).keep(address, _key(1), false)
	is_false(trust.take(address, _key(2), false))
	equal(trust.other.known, KeyFingerprint.of(_key(1)))
	is_true(trust.take(address, _key(1), false))


func test_without_sealing_there_is_no_key() -> void:
	var pair: LinkPair = _make()
	pair.rules.seals = false
	pair.listen()
	_join(pair)
	equal(_known(pair).size(), 0)


func _make() -> LinkPair:
	var pair: LinkPair = LinkPair.new()
	_pairs.append(pair)
	return pair


## A server with a key, at a port if it is not 0.
func _server(p_port: int, p_key: int = 1, p_password: String = "") -> LinkPair:
	var pair: LinkPair = _make()
	pair.rules.server_key = _seed(p_key)
	pair.rules.password = p_password
	if p_port == 0:
		equal(pair.listen(), OK)
		return pair
	pair.listen()
	pair.server.close()
	pair.port = p_port
	equal(pair.server.listen(p_port, pair.rules), OK)
	return pair


func _add(
	p_pair: LinkPair, p_trust: ServerTrust = _trust(), p_password: String = ""
) -> LinkPair.End:
	var end: LinkPair.End = LinkPair.End.new()
	end.request.role = OBSERVER
	end.request.name = "Ada"
	end.link.seals = p_pair.rules.seals
	end.link.trust = p_trust
	p_pair.ends.append(end)
	end.link.open("127.0.0.1", p_pair.port, end.request, p_password)
	return end


func _join(p_pair: LinkPair, p_trust: ServerTrust = _trust(), p_password: String = "") -> void:
	var end: LinkPair.End = _add(p_pair, p_trust, p_password)
	is_true(p_pair.until(func() -> bool: return end.joined == 1 or end.refusal != ""))
	equal(end.refusal, "")
	p_pair.ends.erase(end)
	end.link.leave()


func _trust() -> ServerTrust:
	var trust: ServerTrust = ServerTrust.new()
	trust.servers = KnownServers.new(PATH)
	return trust


func _known(p_pair: LinkPair) -> PackedByteArray:
	return KnownServers.new(PATH).find(KnownServers.address("127.0.0.1", p_pair.port))


func _seed(p_number: int) -> PackedByteArray:
	var made: PackedByteArray = []
	made.resize(KeyFingerprint.KEY_SIZE)
	made.fill(p_number)
	return made


func _key(p_number: int) -> PackedByteArray:
	return ServerKeyFile.public_key_of(_seed(p_number))


func _clear() -> void:
	for path: String in [PATH, PATH + ".new", PATH + ".lock", FOLDER]:
		DirAccess.remove_absolute(path)
