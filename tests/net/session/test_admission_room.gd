extends TestCase
## Who finds room at a server, and who waits for it: [Admission] alone, with addresses of all sorts.

const OBSERVER: Roles.Role = Roles.Role.OBSERVER
const SECOND: int = 1000000

var _rules: ServerRules = null
var _sessions: SessionTable = null
var _admission: Admission = null
var _next_peer: int = 0


func before_each() -> void:
	_rules = ServerRules.new()
	_sessions = SessionTable.new()
	_admission = Admission.new(_rules, _sessions)
	_next_peer = 0


func test_the_default_is_a_quarter_but_four_at_least() -> void:
	var shares: Array[int] = []
	for clients: int in [1, 8, 16, 32, 33, 4000]:
		_rules.max_clients = clients
		shares.append(_rules.share_of_address())
	equal(shares, [4, 4, 4, 8, 9, 1000] as Array[int])
	_rules.max_per_address = 0
	equal(_rules.share_of_address(), 0)
	_rules.max_per_address = 20
	equal(_rules.share_of_address(), 20)


func test_one_machine_does_not_fill_a_default_server() -> void:
	for address: String in ["127.0.0.1", "10.0.0.1", "2001:db8:1:2::1"]:
		before_each()
		var joined: int = 0
		for _number: int in 200:
			joined += 1 if _come(address).session != null else 0
		equal(joined, 8)
		not_equal(_come("127.0.0.2").session, null, "an honest client is in at once")


func test_a_whole_64_is_one_address_and_a_48_has_two_shares() -> void:
	var joined: int = 0
	for number: int in 100:
		joined += 1 if _come("2001:db8:1:1::%x" % number).session != null else 0
	equal(joined, 8)
	for number: int in 100:
		joined += 1 if _come("2001:db8:1:%x::1" % number).session != null else 0
	equal(joined, 16)
	not_equal(_come("2001:db8:2::1").session, null)


func test_those_who_are_lost_count() -> void:
	var first: PendingPeer = _fill("10.0.0.1", 8)
	_lose(first, 0)
	var next: PendingPeer = _come("10.0.0.1", 5 * SECOND)
	equal([next.waits, next.waits_for], [true, JoinReply.Wait.SHARE])
	equal(_admission.let_next_in(9 * SECOND), null, "it may come back")
	equal(_admission.let_next_in(11 * SECOND), next)
	equal(next.displaced, first.session)


func test_room_goes_to_the_first_who_can_have_it() -> void:
	var filling: Array[PendingPeer] = []
	for machine: int in 4:
		filling.append(_fill("10.0.0.%d" % machine, 8))
	var same: PendingPeer = _come("10.0.0.1")
	var other: PendingPeer = _come("10.0.1.1")
	var last: PendingPeer = _come("10.0.1.2")
	equal(
		[same.waits_for, other.waits_for, last.waits_for],
		[JoinReply.Wait.SHARE, JoinReply.Wait.ROOM, JoinReply.Wait.ROOM]
	)
	var places: Dictionary[PendingPeer, int] = _admission.places()
	equal([places[same], places[other], places[last]], [1, 2, 3])
	equal(_admission.let_next_in(0), null)
	_leave(filling[2])
	var newcomer: PendingPeer = _come("10.0.1.3")
	is_true(newcomer.waits, "nobody goes before those who wait")
	equal(_admission.let_next_in(0), other, "the first one's address has its share still")
	equal(_admission.let_next_in(0), null)
	_leave(filling[1])
	equal(_admission.let_next_in(0), same)


func test_one_whose_address_has_its_share_stands_in_nobodys_way() -> void:
	_fill("10.0.0.1", 8)
	for _number: int in 20:
		_come("10.0.0.1")
	not_equal(_come("10.0.0.2").session, null)


func test_an_address_that_fills_the_line_is_told_to_come_later() -> void:
	_fill("10.0.0.1", 8)
	var last: PendingPeer = null
	for _number: int in 20:
		last = _come("10.0.0.1")
	equal([last.refused, last.later, last.waits], [true, true, false])
	equal(_admission.waiting().size(), 8)


func test_who_goes_leaves_the_line() -> void:
	_fill("10.0.0.1", 8)
	var first: PendingPeer = _come("10.0.0.1")
	var second: PendingPeer = _come("10.0.0.1")
	equal(_admission.places()[second], 2)
	_admission.forget(first.peer)
	equal(_admission.places(), {second: 1} as Dictionary[PendingPeer, int])
	equal(_admission.overdue(3600 * SECOND).has(second.peer), false, "it may wait for long")


func test_an_instructor_lets_somebody_into_the_line_of_a_full_server() -> void:
	_rules.max_clients = 1
	_fill("10.0.0.1", 1)
	_rules.waiting_room = true
	var first: PendingPeer = _come("10.0.0.2")
	var second: PendingPeer = _come("10.0.0.3")
	equal([first.waits_for, second.waits_for], [0, 0])
	is_false(_admission.let_in(second, 0))
	equal([second.waits, second.waits_for], [true, JoinReply.Wait.ROOM])
	equal([_admission.places()[first], _admission.places()[second]], [1, 1])
	equal(
		_admission.rows().map(func(row: RosterRow) -> int: return row.state),
		[RosterRow.State.WAITING, RosterRow.State.QUEUED]
	)
	_leave(_admission.find(1))
	equal(_admission.let_next_in(0), second)
	equal(_admission.let_next_in(0), null, "the other one was not let in")


func _come(p_address: String, p_now_usec: int = 0) -> PendingPeer:
	_next_peer += 1
	var challenge: PackedByteArray = _admission.arrive(_next_peer, p_address, p_now_usec)
	var request: JoinRequest = JoinRequest.new()
	request.role = OBSERVER
	request.name = "%d" % _next_peer
	var key: PackedByteArray = []
	key.resize(PasswordKey.SIZE)
	_admission.judge(_next_peer, request.encode(challenge, key), p_now_usec)
	return _admission.find(_next_peer)


## So many of an address; returns the first.
func _fill(p_address: String, p_count: int) -> PendingPeer:
	var first: PendingPeer = null
	for _number: int in p_count:
		var come: PendingPeer = _come(p_address)
		not_equal(come.session, null)
		first = come if first == null else first
	return first


func _lose(p_pending: PendingPeer, p_now_usec: int) -> void:
	_sessions.detach(p_pending.session, p_now_usec)


func _leave(p_pending: PendingPeer) -> void:
	_sessions.close(p_pending.session)
