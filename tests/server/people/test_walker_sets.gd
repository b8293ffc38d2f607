extends TestCase
## Motion sets that trainees send: taken over, refused, kept. Over real connections.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const MadeSets: GDScript = preload("res://tests/walker/made_sets.gd")

var _pair: LinkPair = null
var _sets: WalkerSets = null
var _lines: PackedStringArray = []
var _changed: Array[int] = []
## Answers that each client has got, by its link.
var _answers: Dictionary[ClientLink, Array] = {}


func before_each() -> void:
	_lines.clear()
	_changed.clear()
	_answers.clear()
	Log.sink = func(line: String) -> void: _lines.append(line)
	_pair = LinkPair.new()
	_sets = WalkerSets.new(_pair.server)
	_sets.changed.connect(_changed.append)
	_pair.on_poll = func() -> void: _sets.advance()
	equal(_pair.listen(), OK)


func after_each() -> void:
	Log.sink = Callable()
	_sets.close()
	_pair.on_poll = Callable()
	_pair.close()


func goes_by_clock() -> bool:
	return true


func test_a_trainee_s_set_is_taken_and_everybody_else_keeps_theirs() -> void:
	var ada: LinkPair.End = _join(Roles.Role.TRAINEE, "Ada")
	var bob: LinkPair.End = _join(Roles.Role.TRAINEE, "Bob")
	var bytes: PackedByteArray = MadeSets.small()
	_send(ada, bytes, 5)
	is_true(_pair.until(func() -> bool: return _count(ada) == 1))
	equal([_answer(ada).number, _answer(ada).outcome], [5, MotionSetMessage.Outcome.TAKEN])
	equal(_sets.of_session(ada.link.session).id, WalkerSet.read(bytes).id)
	equal(_sets.of_session(bob.link.session), null)
	equal([_changed, _sets.taken], [[ada.link.session] as Array[int], 1])
	# Another one takes its place; one that is refused does not.
	_send(ada, MadeSets.of(["stand", "walk"]), 6)
	is_true(_pair.until(func() -> bool: return _count(ada) == 2))
	var second: WalkerSet = _sets.of_session(ada.link.session)
	is_true(second.motion.get_clip_count() > 2)
	_send(bob, MadeSets.of(["stand"]), 1)
	is_true(_pair.until(func() -> bool: return _count(bob) == 1))
	equal(_sets.of_session(ada.link.session), second)


func test_a_refusal_names_the_peer_and_the_reason() -> void:
	var broken: PackedByteArray = MadeSets.small()
	broken[3] = 0
	var far_too_large: PackedByteArray = []
	far_too_large.resize(MotionSetMessage.MAX_BYTES + 5000)
	var cases: Dictionary[String, PackedByteArray] = {
		"this is no motion set": broken,
		"it lacks walking ahead": MadeSets.of(["stand"]),
		"the motion set goes on behind its last clip": MadeSets.small() + PackedByteArray([0]),
		"it is larger than 1.6 MB": far_too_large,
	}
	for why: String in cases:
		var end: LinkPair.End = _join(Roles.Role.TRAINEE, "Ada %d" % _pair.ends.size())
		for part: PackedByteArray in (
			MessageParts.split(cases[why], 3, Protocol.Message.MOTION_SET).slice(0, 100)
		):
			end.link.send_reliably(part)
		is_true(_pair.until(func() -> bool: return _count(end) == 1), why)
		contains(_answer(end).text, why)
		equal(_answer(end).outcome, MotionSetMessage.Outcome.REFUSED)
		equal(_sets.of_session(end.link.session), null)
	equal(_sets.refused, cases.size())
	contains("\n".join(_lines), "trainee 'Ada 0' (")
	contains("\n".join(_lines), "sent a motion set that is not taken: this is no motion set")


func test_who_is_no_trainee_may_not_send_one() -> void:
	for role: Roles.Role in [Roles.Role.OBSERVER, Roles.Role.INSTRUCTOR]:
		var end: LinkPair.End = _join(role, "Ina")
		_send(end, MadeSets.small(), 1)
		var before: int = _pair.server.refused.get("role", 0)
		is_true(_pair.until(func() -> bool: return _pair.server.refused.get("role", 0) > before))
		equal(_sets.of_session(end.link.session), null)
	contains("\n".join(_lines), "'Ina' (")
	contains("\n".join(_lines), "sent MOTION_SET, which its role may not")


func test_too_many_are_refused_and_the_first_stays() -> void:
	var ada: LinkPair.End = _join(Roles.Role.TRAINEE, "Ada")
	_send(ada, MadeSets.small(), 1)
	is_true(_pair.until(func() -> bool: return _count(ada) == 1))
	for number: int in 6:
		_send(ada, MadeSets.small(), 2 + number)
	is_true(_pair.until(func() -> bool: return _count(ada) == 7))
	var refused: int = 0
	for answer: MotionSetMessage in _answers[ada.link]:
		if answer.outcome == MotionSetMessage.Outcome.REFUSED:
			refused += 1
			contains(answer.text, "too soon: 'motion-set' at most 2 times at once")
	is_true(refused >= 5, "%d" % refused)
	is_true(_sets.of_session(ada.link.session) != null)


func test_a_set_is_kept_while_the_session_is() -> void:
	var ada: LinkPair.End = _join(Roles.Role.TRAINEE, "Ada")
	_send(ada, MadeSets.small(), 1)
	is_true(_pair.until(func() -> bool: return _count(ada) == 1))
	var session: int = ada.link.session
	# Half of another one is forgotten with the connection.
	var parts: Array[PackedByteArray] = MotionSetMessage.split(MadeSets.small(), 2)
	for part: PackedByteArray in parts.slice(0, parts.size() / 2):
		ada.link.send_reliably(part)
	_pair.run(0.05)
	ada.cut()
	is_true(_pair.until(func() -> bool: return _pair.lost.has(session)))
	ada.link.open("127.0.0.1", _pair.port, ada.request)
	is_true(_pair.until(func() -> bool: return _pair.returned.has(session)))
	is_true(ada.link.came_back)
	is_true(_sets.of_session(session) != null)
	for part: PackedByteArray in parts.slice(parts.size() / 2):
		ada.link.send_reliably(part)
	_pair.run(0.05)
	equal(_count(ada), 1)
	ada.link.leave()
	is_true(_pair.until(func() -> bool: return _pair.left.has(session)))
	equal(_sets.of_session(session), null)


func test_parts_in_no_order_cost_nothing() -> void:
	var ada: LinkPair.End = _join(Roles.Role.TRAINEE, "Ada")
	var parts: Array[PackedByteArray] = MotionSetMessage.split(MadeSets.small(), 1)
	for number: int in [3, 0, 2, 1, 1, 0, 0, 5]:
		ada.link.send_reliably(parts[number])
	for bytes: PackedByteArray in [[26], [26, 0, 0], [26, 1, 0, 0, 0, 0, 0], parts[0].slice(0, 9)]:
		ada.link.send_reliably(bytes)
	var end: PackedByteArray = parts[0].duplicate()
	end.encode_u16(5, 65535)
	ada.link.send_reliably(end)
	is_true(_pair.until(func() -> bool: return _count(ada) == 1))
	contains(_answer(ada).text, "it is larger")
	is_true(_pair.server.refused.get("message 26", 0) >= 2)
	# A whole one is welcome all the same.
	_send(ada, MadeSets.small(), 2)
	is_true(_pair.until(func() -> bool: return _sets.taken == 1))


func test_the_largest_takes_no_tick_over() -> void:
	var ada: LinkPair.End = _join(Roles.Role.TRAINEE, "Ada")
	var worst_usec: Array[int] = [0]
	_pair.on_poll = func() -> void:
		var begin: int = ThreadClock.get_usec()
		_sets.advance()
		worst_usec[0] = maxi(worst_usec[0], ThreadClock.get_usec() - begin)
	_pair.run(0.05)
	for part: PackedByteArray in MotionSetMessage.split(
		MadeSets.large(MotionSetMessage.MAX_BYTES), 1
	):
		ada.link.send_reliably(part)
		_pair.poll()
		OS.delay_usec(1500)
	is_true(_pair.until(func() -> bool: return _count(ada) == 1))
	equal(_answer(ada).outcome, MotionSetMessage.Outcome.TAKEN)
	is_true(worst_usec[0] < 2000, "%d us of processor time in a tick" % worst_usec[0])


func _join(p_role: Roles.Role, p_name: String) -> LinkPair.End:
	var end: LinkPair.End = _pair.add(p_role, p_name)
	var heard: Array = []
	_answers[end.link] = heard
	end.link.handle(
		Protocol.Message.MOTION_SET,
		MessageHandlers.Path.RELIABLE,
		func(bytes: PackedByteArray, _usec: int) -> bool:
			heard.append(MotionSetMessage.decode_answer(bytes))
			return heard[-1] != null
	)
	_pair.await_join(end)
	return end


func _send(p_end: LinkPair.End, p_bytes: PackedByteArray, p_number: int) -> void:
	for part: PackedByteArray in MotionSetMessage.split(p_bytes, p_number):
		p_end.link.send_reliably(part)


func _count(p_end: LinkPair.End) -> int:
	return _answers[p_end.link].size()


func _answer(p_end: LinkPair.End) -> MotionSetMessage:
	return _answers[p_end.link][-1]
