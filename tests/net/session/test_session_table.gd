extends TestCase
## Who keeps a session, and under which name.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const TRAINEE: Roles.Role = Roles.Role.TRAINEE
const OBSERVER: Roles.Role = Roles.Role.OBSERVER

var _pair: LinkPair = null


func before_each() -> void:
	_pair = LinkPair.new()


func after_each() -> void:
	_pair.close()


func test_a_full_server_gives_away_the_room_of_a_lost_client_only() -> void:
	_pair.listen(2)
	var first: LinkPair.End = _pair.join(TRAINEE, "first")
	_pair.join(TRAINEE, "second")
	var early: LinkPair.End = _pair.add(OBSERVER, "early")
	is_true(_pair.until(func() -> bool: return early.places == [1]))
	equal(early.waits_for, JoinReply.Wait.ROOM)
	_lose(first)
	_pair.run(0.3)
	equal(early.joined, 0, "who was lost may come back first")
	_pair.server.session(_pair.lost[0]).lost_usec -= int(Admission.RETURN_S * 1e6)
	_pair.await_join(early)
	equal(_pair.left, [first.link.session] as Array[int], "its body goes at once")
	var later: LinkPair.End = _pair.add(OBSERVER, "later")
	is_true(_pair.until(func() -> bool: return later.places == [1]))
	equal(_pair.server.session_ids().size(), 2)


func test_two_of_one_name_are_distinguished() -> void:
	_pair.listen()
	for name: String in ["Ada", "ada", "Ada", "Ada (2)"]:
		_pair.join(TRAINEE, name)
	var names: Array = _pair.server.roster().map(func(row: RosterRow) -> String: return row.name)
	equal(names, ["Ada", "ada (2)", "Ada (3)", "Ada (2) (2)"])


## Cuts a client's connection without a reason.
func _lose(p_end: LinkPair.End) -> void:
	p_end.cut()
	is_true(_pair.until(func() -> bool: return _pair.lost.size() == 1 and p_end.loss != ""))
