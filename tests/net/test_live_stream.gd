extends TestCase
## A stream of a server that shows another key: it asks, or it ends.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")

var _pair: LinkPair = null
var _live: LiveStream = null
var _asked: Array[OtherServerKey] = []
var _ended: Array[String] = []
var _codes: Array[int] = []
var _joins: Array[bool] = []


func before_each() -> void:
	_asked.clear()
	_ended.clear()
	_codes.clear()
	_joins.clear()
	_pair = LinkPair.new()
	equal(_pair.listen(), OK)
	_live = LiveStream.new()
	_live.host = "127.0.0.1"
	_live.port = _pair.port
	_live.request.role = Roles.Role.OBSERVER
	_live.request.name = "Ada"
	_live.patience_s = 30.0
	_live.key_changed.connect(_asked.append)
	_live.joined.connect(func() -> void: _joins.append(true))
	_live.ended.connect(
		func(code: int, why: String) -> void:
			_codes.append(code)
			_ended.append(why)
	)
	_pair.on_poll = _live.advance.bind(0.0)


func after_each() -> void:
	_live.close()
	_pair.close()
	# The lambdas hold the test, which holds the stream.
	_live = null
	_pair = null


func goes_by_clock() -> bool:
	return true


func test_where_nobody_is_asked_another_key_ends_it() -> void:
	_know_another()
	_live.open()
	is_true(_pair.until(func() -> bool: return not _ended.is_empty()))
	equal(_codes, [StateStream.EXIT_REFUSED] as Array[int])
	contains(_ended[0], _fingerprint())
	equal(_asked.size() + _joins.size() + _pair.joined.size(), 0)


func test_who_is_asked_and_trusts_it_joins() -> void:
	_live.asks = true
	_know_another()
	_live.open()
	is_true(_pair.until(func() -> bool: return not _asked.is_empty()))
	equal(_asked[0].fingerprint(), _fingerprint())
	# It waits for the answer, however long that takes.
	_live.patience_s = 0.001
	_pair.run(0.3)
	equal(_asked.size(), 1)
	equal(_ended.size() + _pair.joined.size(), 0)
	_live.patience_s = 30.0
	_live.trust_key(_asked[0])
	is_true(_pair.until(func() -> bool: return _pair.joined.size() == 1 and not _joins.is_empty()))
	equal(_ended.size(), 0)


func test_a_fingerprint_that_was_given_is_no_question() -> void:
	_live.asks = true
	_live.link.trust.pin = KeyFingerprint.of(PackedByteArray([1]))
	_live.open()
	is_true(_pair.until(func() -> bool: return not _ended.is_empty()))
	equal(_codes, [StateStream.EXIT_REFUSED] as Array[int])
	contains(_ended[0], _live.link.trust.pin)
	equal(_asked.size() + _pair.joined.size(), 0)


func test_a_patient_user_who_is_turned_away_tries_again() -> void:
	var reasons: Array[String] = []
	_live.turned_away.connect(reasons.append)
	_live.is_patient = true
	_live.link.trust.pin = KeyFingerprint.of(PackedByteArray([1]))
	_live.open()
	is_true(_pair.until(func() -> bool: return not reasons.is_empty()))
	contains(reasons[0], _live.link.trust.pin)
	_live.patience_s = 0.001
	_pair.run(0.3)
	equal(reasons.size(), 1, "nothing goes on before the user wants it")
	_live.patience_s = 30.0
	_live.link.trust.pin = _fingerprint()
	_live.open()
	is_true(_pair.until(func() -> bool: return _pair.joined.size() == 1 and not _joins.is_empty()))
	equal(_joins.size(), 1, "nobody hears it twice")
	equal(_ended.size(), 0)
	is_false(_live.is_patient, "a session that has begun ends as any other")


func _know_another() -> void:
	var other: PackedByteArray = Crypto.new().generate_random_bytes(KeyFingerprint.KEY_SIZE)
	_live.link.trust.take(KnownServers.address("127.0.0.1", _pair.port), other, false)


func _fingerprint() -> String:
	return _pair.rules.fingerprint()
