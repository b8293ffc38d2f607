extends TestCase
## Who waits at a server, and who makes room for whom.

const SHARE: int = 8


func test_places_are_told_apart_by_what_is_waited_for() -> void:
	var line: WaitingLine = WaitingLine.new()
	var peers: Array[PendingPeer] = []
	for number: int in 4:
		peers.append(_add(line, "10.0.0.%d" % number))
		peers[number].waits_for = (
			JoinReply.Wait.INSTRUCTOR if number % 2 == 0 else JoinReply.Wait.ROOM
		)
	equal(peers.map(func(one: PendingPeer) -> int: return line.places()[one]), [1, 1, 2, 2])
	peers[0].waits_for = JoinReply.Wait.SHARE
	line.move_back(peers[0])
	equal(peers.map(func(one: PendingPeer) -> int: return line.places()[one]), [3, 1, 1, 2])


func test_an_address_has_its_share_of_it() -> void:
	var line: WaitingLine = WaitingLine.new()
	for _number: int in SHARE:
		is_true(_add(line, "10.0.0.1").waits)
	is_false(_add(line, "10.0.0.1").waits)
	is_true(_add(line, "10.0.0.2").waits)


func test_a_site_with_a_whole_48_has_two() -> void:
	var line: WaitingLine = WaitingLine.new()
	var waiting: int = 0
	for number: int in 1000:
		waiting += 1 if _add(line, "2001:db8:1:%x::1" % number).waits else 0
	equal(waiting, ServerRules.SITE_SHARES * SHARE)


func test_who_fills_it_pushes_out_nobody_but_himself() -> void:
	var line: WaitingLine = WaitingLine.new()
	var first: PendingPeer = _add(line, "192.168.0.1")
	for number: int in 10 * WaitingLine.MAX:
		_add(line, "10.0.0.%d" % (number % 12))
	equal(line.all().size(), WaitingLine.MAX)
	var pushed: Array[PendingPeer] = []
	var newcomer: PendingPeer = _add(line, "192.168.0.2", pushed)
	is_true(newcomer.waits and first.waits)
	equal([pushed.size(), pushed[0].network.begins_with("10."), pushed[0].waits], [1, true, false])
	equal(line.all().size(), WaitingLine.MAX)


func test_where_all_have_one_a_newcomer_comes_later() -> void:
	var line: WaitingLine = WaitingLine.new()
	for number: int in WaitingLine.MAX:
		_add(line, "10.0.%d.1" % number)
	var pushed: Array[PendingPeer] = []
	is_false(_add(line, "192.168.0.2", pushed).waits)
	equal(pushed.size(), 0)


func _add(p_line: WaitingLine, p_address: String, r_pushed: Array[PendingPeer] = []) -> PendingPeer:
	var made: PendingPeer = PendingPeer.new(1, p_address, 0)
	p_line.add(made, SHARE, r_pushed)
	return made
