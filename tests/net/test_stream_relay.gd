extends TestCase
## A stream that the server does not read goes to those whom it interests, and to nobody else.

const LinkPair: GDScript = preload("link_pair.gd")
const KIND: int = 40
const RATE: int = 50

var _pair: LinkPair = null
var _relay: StreamRelay = null
var _heard: Dictionary[int, Array] = {}
var _audience: PackedInt32Array = []


func before_each() -> void:
	_heard.clear()
	_pair = LinkPair.new()
	equal(_pair.listen(), OK)
	_relay = StreamRelay.new(
		_pair.server,
		KIND,
		func(_session: int) -> PackedInt32Array: return _audience,
		Roles.Capability.SEND_MOTION,
		RATE,
		200
	)


func after_each() -> void:
	_pair.close()


func test_those_hear_it_whom_it_interests() -> void:
	var ada: LinkPair.End = _join(Roles.Role.TRAINEE)
	var bob: LinkPair.End = _join(Roles.Role.TRAINEE)
	var cid: LinkPair.End = _join(Roles.Role.OBSERVER)
	_audience = [bob.link.session]
	ada.link.send_fast(PackedByteArray([KIND, 7, 8, 9]))
	is_true(_pair.until(func() -> bool: return not _heard[bob.link.session].is_empty()))
	var bytes: PackedByteArray = _heard[bob.link.session][0]
	equal(StreamRelay.sender_of(bytes), ada.link.session)
	equal(bytes.slice(StreamRelay.HEAD), PackedByteArray([7, 8, 9]))
	equal([_heard[ada.link.session], _heard[cid.link.session]], [[], []])
	equal(StreamRelay.sender_of(PackedByteArray([KIND])), 0, "none of ours")


func test_who_may_not_sends_too_much_or_too_often_is_not_relayed() -> void:
	var ada: LinkPair.End = _join(Roles.Role.TRAINEE)
	var cid: LinkPair.End = _join(Roles.Role.OBSERVER)
	_audience = [ada.link.session, cid.link.session]
	var large: PackedByteArray = [KIND]
	large.resize(202)
	var refused: Dictionary[String, int] = _pair.server.refused
	var fault: String = "message %d" % KIND
	ada.link.send_fast(large)
	is_true(_pair.until(func() -> bool: return refused.get(fault, 0) == 1), "too large")
	cid.link.send_fast(PackedByteArray([KIND, 1]))
	is_true(_pair.until(func() -> bool: return refused.get("role", 0) == 1), "an observer")
	equal(_relay.relayed, 0)
	# More than are relayed in a second, a few at a time.
	var is_beyond: Callable = func() -> bool:
		for i: int in 10:
			ada.link.send_fast(PackedByteArray([KIND, i]))
		return refused[fault] > 1
	is_true(_pair.until(is_beyond), "beyond the rate")
	is_true(_relay.relayed >= 2 * RATE, "each of two gets as many as are relayed")


func _join(p_role: Roles.Role) -> LinkPair.End:
	var end: LinkPair.End = _pair.join(p_role)
	var heard: Array[PackedByteArray] = []
	_heard[end.link.session] = heard
	end.link.handle(
		KIND,
		MessageHandlers.Path.FAST,
		func(bytes: PackedByteArray, _arrival_usec: int) -> bool:
			heard.append(bytes)
			return true
	)
	return end
