extends TestCase
## Messages of sessions reach their handlers, in turns that none can exceed.

const FAST: MessageHandlers.Path = MessageHandlers.Path.FAST
const RELIABLE: MessageHandlers.Path = MessageHandlers.Path.RELIABLE
const SLOW: int = 40
const QUICK: int = 41

var _inbox: SessionInbox = null
var _session: Session = null
## Number and kind of what the handlers have got.
var _handled: Array[int] = []


func before_each() -> void:
	_inbox = SessionInbox.new()
	_session = _make_session(1)
	_handled.clear()
	_inbox.handle(SLOW, MessageHandlers.Path.ANY, _handle_slowly)
	_inbox.handle(QUICK, MessageHandlers.Path.ANY, _handle)


func test_what_fits_into_a_turn_is_handled_at_once() -> void:
	for number: int in 5:
		_take(QUICK, number, FAST)
	equal(_handled, [0, 1, 2, 3, 4])


func test_what_does_not_fit_waits_for_the_next_turns_in_its_order() -> void:
	for number: int in 4:
		_take(SLOW, number, FAST)
	equal(_handled, [0])
	_take(QUICK, 4, FAST)
	for number: int in 3:
		_inbox.begin_turns()
		equal(_handled.size(), number + 2)
	_inbox.begin_turns()
	equal(_handled, [0, 1, 2, 3, 4])
	equal(_inbox.dropped, 0)


func test_a_turn_that_was_used_up_is_whole_again_in_the_next() -> void:
	_take(SLOW, 0, FAST)
	for number: int in range(1, 4):
		# Nothing waits: it begins nonetheless.
		_inbox.begin_turns()
		_take(QUICK, 10 * number, FAST)
		_take(SLOW, number, FAST)
	equal(_handled, [0, 10, 1, 20, 2, 30, 3])


func test_who_waited_is_not_asked_again_once_nothing_waits() -> void:
	_take(SLOW, 0, FAST)
	_take(QUICK, 1, FAST)
	for _more: int in 3:
		_inbox.begin_turns()
	equal(_handled, [0, 1])
	_take(SLOW, 2, RELIABLE)
	_take(QUICK, 3, RELIABLE)
	_inbox.begin_turns()
	equal(_handled, [0, 1, 2, 3])


func test_nobody_waits_for_another_session() -> void:
	for number: int in 4:
		_take(SLOW, number, FAST)
	_take(QUICK, 9, FAST, _make_session(2))
	equal(_handled, [0, 9])


func test_of_too_many_datagrams_the_newest_are_kept() -> void:
	_take(SLOW, 0, FAST)
	for number: int in range(1, SessionInbox.MAX_FAST + 11):
		_take(QUICK, number, FAST)
	equal(_inbox.dropped, 10)
	_inbox.begin_turns()
	for _more: int in SessionInbox.MAX_FAST:
		_inbox.begin_turns()
	equal(_handled, [0] + range(11, SessionInbox.MAX_FAST + 11))


func test_reliable_messages_are_never_dropped() -> void:
	var overrun: Array[Session] = []
	_inbox.overrun.connect(overrun.append)
	_take(SLOW, 0, RELIABLE)
	for number: int in range(1, SessionInbox.MAX_RELIABLE):
		_take(QUICK, number % 256, RELIABLE)
	equal(overrun, [])
	_take(QUICK, 0, RELIABLE)
	equal(overrun, [_session])
	for _more: int in SessionInbox.MAX_RELIABLE:
		_inbox.begin_turns()
	equal(_handled.size(), SessionInbox.MAX_RELIABLE + 1)


func test_who_has_gone_is_not_heard_any_more() -> void:
	_take(SLOW, 0, FAST)
	_take(QUICK, 1, FAST)
	_session.is_here = false
	_inbox.begin_turns()
	equal(_handled, [0])
	_session.is_here = true
	_take(SLOW, 2, FAST)
	_take(QUICK, 3, FAST)
	_inbox.forget(_session)
	_inbox.begin_turns()
	equal(_handled, [0, 2])


func test_a_message_that_waited_may_end_another_session() -> void:
	var other: Session = _make_session(2)
	_inbox.handle(
		42,
		MessageHandlers.Path.ANY,
		func(_session: Session, _bytes: PackedByteArray, _usec: int) -> String:
			_inbox.forget(other)
			return ""
	)
	for session: Session in [_session, other]:
		_take(SLOW, 0, RELIABLE, session)
	_take(42, 0, RELIABLE)
	_take(QUICK, 9, RELIABLE, other)
	_inbox.begin_turns()
	equal(_handled, [0, 0])


func _make_session(p_id: int) -> Session:
	var session: Session = Session.new()
	session.id = p_id
	session.is_here = true
	return session


func _take(
	p_kind: int, p_number: int, p_path: MessageHandlers.Path, p_session: Session = _session
) -> void:
	var packet: FastPacket = FastPacket.new()
	packet.bytes = PackedByteArray([p_kind, p_number])
	_inbox.take(p_session, packet, p_path)


func _handle(_p_session: Session, p_bytes: PackedByteArray, _p_arrival_usec: int) -> String:
	_handled.append(p_bytes[1])
	return ""


## Takes a whole turn of processor time.
func _handle_slowly(p_session: Session, p_bytes: PackedByteArray, p_arrival_usec: int) -> String:
	var end_usec: int = ThreadClock.get_usec() + SessionInbox.TURN_USEC
	while ThreadClock.get_usec() < end_usec:
		pass
	return _handle(p_session, p_bytes, p_arrival_usec)
