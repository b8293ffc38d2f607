extends TestCase
## Who may come in, who comes back, and what instructors decide.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")
const TRAINEE: Roles.Role = Roles.Role.TRAINEE
const OBSERVER: Roles.Role = Roles.Role.OBSERVER
const INSTRUCTOR: Roles.Role = Roles.Role.INSTRUCTOR
const V: int = Protocol.VERSION

var _pair: LinkPair = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _server_control: SessionControl = null
var _token_file: SessionTokenFile = null


## A server that takes any password, as one would that only wants to have people on it.
class Impostor:
	extends ServerRules

	func challenge() -> Challenge:
		var made: Challenge = super()
		made.locked_roles = 0xFF
		return made


func before_each() -> void:
	_random.seed = 3
	_pair = LinkPair.new()


func after_each() -> void:
	_pair.close()
	if _token_file != null:
		_token_file.forget()


func test_the_right_password_opens() -> void:
	_pair.rules.password = "sesame"
	_pair.listen()
	equal(_pair.join(TRAINEE, "Ada", "sesame").joined, 1)
	var wrong: LinkPair.End = _pair.add(TRAINEE, "Bob", V, "Sesame")
	var none: LinkPair.End = _pair.add(OBSERVER, "Eve")
	is_true(_pair.until(func() -> bool: return wrong.refusal != "" and none.refusal != ""))
	equal([wrong.refusal, none.refusal], ["the password is wrong", "the password is wrong"])
	equal(_pair.server.session_ids().size(), 1)


func test_instructors_have_a_password_of_their_own() -> void:
	_pair.rules.password = "all"
	_pair.rules.instructor_password = "few"
	_pair.listen()
	equal(_pair.join(INSTRUCTOR, "Ida", "few").joined, 1)
	equal(_pair.join(TRAINEE, "Ada", "all").joined, 1)
	var wrong: LinkPair.End = _pair.add(INSTRUCTOR, "Eve", V, "all")
	is_true(_pair.until(func() -> bool: return wrong.refusal != ""))


func test_instructors_without_password_are_local() -> void:
	_pair.listen()
	equal(_pair.join(INSTRUCTOR).joined, 1)
	is_true(ServerRules.is_loopback("127.1.2.3") and ServerRules.is_loopback("::1"))
	is_false(ServerRules.is_loopback("10.0.0.1") or ServerRules.is_loopback("12.7.0.1"))


func test_a_server_that_does_not_know_the_password_is_left() -> void:
	_pair.rules = Impostor.new()
	_pair.rules.seals = false
	_pair.listen()
	var end: LinkPair.End = _pair.add(TRAINEE, "Ada", V, "sesame")
	is_true(_pair.until(func() -> bool: return end.refusal != ""))
	equal(end.refusal, "the server does not know the password")
	equal(_pair.joined.size(), 0)


func test_another_password_is_tried_without_sealing() -> void:
	_pair.rules.password = "sesame"
	_pair.rules.seals = false
	_pair.listen()
	var end: LinkPair.End = _pair.add(TRAINEE, "Ada", V, "open")
	is_true(_pair.until(func() -> bool: return end.refusal != ""))
	end.link.open("127.0.0.1", _pair.port, end.request, "sesame")
	is_true(_pair.until(func() -> bool: return end.joined == 1))


func test_guessing_is_slowed_down_and_keeps_nobody_out_who_comes_back() -> void:
	_pair.rules.password = "sesame"
	_pair.listen(64)
	var good: LinkPair.End = _pair.join(TRAINEE, "Ada", "sesame")
	var began: int = Time.get_ticks_usec()
	var guesses: Array[LinkPair.End] = []
	for i: int in 12:
		guesses.append(_pair.add(OBSERVER, "Eve", V, "guess %d" % i))
	var told: Callable = func() -> bool:
		return guesses.all(
			func(end: LinkPair.End) -> bool: return end.refusal != "" or end.loss != ""
		)
	is_true(_pair.until(told))
	# Where twelve handshakes take seconds, a few more may be tried.
	var seconds: float = (Time.get_ticks_usec() - began) / 1e6
	var tried: int = LoginRateLimiter.BURST + ceili(seconds / LoginRateLimiter.PER_GUESS_S)
	var late: int = 0
	for end: LinkPair.End in guesses:
		late += 1 if end.loss.contains("too many wrong passwords") else 0
	is_true(late >= 12 - tried, "%d of 12 were not even tried in %.1f s" % [late, seconds])
	_lose(good)
	good.link.open("127.0.0.1", _pair.port, good.request, "sesame")
	is_true(
		_pair.until(func() -> bool: return good.joined == 2), "%s %s" % [good.loss, good.refusal]
	)
	is_true(_pair.until(func() -> bool: return _pair.returned == _pair.joined.keys()))


func test_a_lost_client_comes_back_into_its_session() -> void:
	_pair.listen(2)
	var end: LinkPair.End = _pair.join(TRAINEE)
	var session: int = end.link.session
	equal(_pair.joined.keys(), [session] as Array[int])
	_lose(end)
	equal(_pair.server.session_ids().size(), 0)
	end.link.open("127.0.0.1", _pair.port, end.request)
	is_true(_pair.until(func() -> bool: return _pair.returned.size() == 1))
	equal([end.link.session, _pair.returned[0]], [session, session])
	equal(_pair.joined.size(), 1, "joined once")
	end.send(NetSamples.pose(_random))
	is_true(_pair.until(func() -> bool: return _pair.poses.has(session)))


func test_a_token_that_is_guessed_opens_nothing() -> void:
	_pair.listen()
	var end: LinkPair.End = _pair.join(TRAINEE)
	_lose(end)
	var thief: LinkPair.End = LinkPair.End.new()
	_pair.ends.append(thief)
	thief.request.role = TRAINEE
	thief.link.token_file = _claim_token_file("thief")
	thief.link.token_file.keep(Crypto.new().generate_random_bytes(JoinRequest.TOKEN_SIZE))
	thief.link.open("127.0.0.1", _pair.port, thief.request)
	is_true(_pair.until(func() -> bool: return thief.joined == 1))
	not_equal(thief.link.session, end.link.session)
	equal(_pair.returned.size(), 0)


func test_a_new_connection_replaces_the_old() -> void:
	_pair.listen(1)
	var end: LinkPair.End = _pair.add(TRAINEE)
	end.link.token_file = _claim_token_file("twin")
	is_true(_pair.until(func() -> bool: return end.joined == 1 and _pair.joined.size() == 1))
	var twin: LinkPair.End = LinkPair.End.new()
	_pair.ends.append(twin)
	twin.link.token_file = end.link.token_file
	twin.request.role = TRAINEE
	twin.link.open("127.0.0.1", _pair.port, twin.request)
	is_true(_pair.until(func() -> bool: return twin.joined == 1 and end.loss != ""))
	is_true(_pair.until(func() -> bool: return _pair.returned.size() == 1))
	equal(_pair.left.size(), 0)
	equal(_pair.server.session_ids().size(), 1)


func test_a_place_is_kept_for_a_minute_only() -> void:
	_pair.listen()
	var end: LinkPair.End = _pair.join(TRAINEE)
	_lose(end)
	var session: Session = _pair.server.session(_pair.lost[0])
	var last_usec: int = 20000000
	session.lost_usec -= int(SessionTable.KEPT_S * 1e6) - last_usec
	_pair.run(0.2)
	equal(_pair.left.size(), 0)
	session.lost_usec -= last_usec
	is_true(_pair.until(func() -> bool: return _pair.left.size() == 1))
	end.link.open("127.0.0.1", _pair.port, end.request)
	is_true(_pair.until(func() -> bool: return _pair.joined.size() == 2), "as somebody new")


func test_an_instructor_admits_and_refuses() -> void:
	_pair.rules.waiting_room = true
	_pair.listen()
	var control: InstructorControl = _add_instructor()
	var first: LinkPair.End = _pair.add(TRAINEE, "first")
	is_true(_pair.until(func() -> bool: return first.places.has(1)))
	var second: LinkPair.End = _pair.add(OBSERVER, "second")
	is_true(_pair.until(func() -> bool: return second.places.has(2)))
	_pair.run(0.2)
	equal([first.joined, second.joined], [0, 0])
	var waiting: Array[RosterRow] = []
	var knows_both: Callable = func() -> bool:
		waiting.assign(
			control.roster.filter(
				func(row: RosterRow) -> bool: return row.state == RosterRow.State.WAITING
			)
		)
		return waiting.size() == 2
	is_true(_pair.until(knows_both))
	equal(waiting.map(func(row: RosterRow) -> String: return row.name), ["first", "second"])
	control.admit(waiting[0].peer)
	is_true(_pair.until(func() -> bool: return first.joined == 1 and second.places.back() == 1))
	control.refuse(waiting[1].peer, "not today")
	is_true(_pair.until(func() -> bool: return second.refusal != ""))
	equal(second.refusal, "refused by instructor 'Ida': not today")


func test_those_who_wait_are_kept_longer_than_a_greeting_takes() -> void:
	_pair.rules.waiting_room = true
	_pair.listen()
	var first: LinkPair.End = _pair.add(TRAINEE, "first")
	is_true(_pair.until(func() -> bool: return first.places.size() == 1))
	_pair.run(Admission.REQUEST_S + 3.0)
	equal([first.refusal, first.loss], ["", ""])
	equal(_pair.server.admit(_pair.server.roster()[0].peer), "")
	is_true(_pair.until(func() -> bool: return first.joined == 1))


func test_an_instructor_kicks_and_bans() -> void:
	var file: String = "user://bans_%d.json" % Time.get_ticks_usec()
	_pair.rules.bans = BanList.open(file)
	_pair.listen()
	var control: InstructorControl = _add_instructor()
	var answers: Array[String] = []
	control.answered.connect(func(answer: AnswerMessage) -> void: answers.append(answer.text))
	var rude: LinkPair.End = _pair.join(TRAINEE, "rude")
	control.kick(rude.link.session, "be\nkind")
	is_true(_pair.until(func() -> bool: return rude.refusal != ""))
	equal(rude.refusal, "kicked by instructor 'Ida': bekind")
	equal(_pair.left.size(), 1, "its body goes at once")
	control.kick(999, "")
	is_true(_pair.until(func() -> bool: return answers.has("there is no session 999")))
	var worse: LinkPair.End = _pair.join(TRAINEE, "worse")
	control.ban(worse.link.session, "again")
	is_true(_pair.until(func() -> bool: return worse.refusal != ""))
	var late: LinkPair.End = _pair.add(OBSERVER)
	is_true(_pair.until(func() -> bool: return late.refusal != ""))
	equal(late.refusal, "your address is banned")
	is_true(BanList.open(file).has("127.0.0.1"), "kept in the file")
	DirAccess.remove_absolute(file)


func test_nobody_else_gives_orders() -> void:
	_pair.listen()
	_serve_orders()
	var victim: LinkPair.End = _pair.join(TRAINEE, "victim")
	for role: Roles.Role in [TRAINEE, OBSERVER]:
		var rogue: LinkPair.End = _pair.join(role, "rogue")
		var control: InstructorControl = InstructorControl.new(rogue.link)
		control.kick(victim.link.session, "")
		control.ask_who()
		_pair.run(0.3)
		equal(control.roster.size(), 0, "nobody is named to it")
	equal([victim.refusal, victim.loss, _pair.left.size()], ["", "", 0])


func test_the_engines_own_packets_never_reach_it() -> void:
	_pair.listen()
	var good: LinkPair.End = _pair.join(TRAINEE, "good")
	var bad: LinkPair.End = _pair.join(INSTRUCTOR, "bad")
	for round: int in 40:
		var bytes: PackedByteArray = NetSamples.noise(_random, 40)
		bytes.insert(0, [0, 1, 2, 4, 5, 6, 7][round % 7])
		bad.peer().set_target_peer(1)
		bad.peer().put_packet(bytes)
		_pair.run(0.01)
	# An engine error would fail the test.
	var is_counted: Callable = func() -> bool:
		return _pair.server.stats().get("dropped_in", 0) >= 40
	is_true(_pair.until(is_counted), "all are counted")
	is_true(good.link.is_joined())


func test_ban_file_with_faults() -> void:
	var file: String = "user://bans_%d.json" % Time.get_ticks_usec()
	_write(file, '[\n"10.0.0.1",\n"nonsense",\n7]\n')
	var list: BanList = BanList.open(file)
	equal(list.error, "")
	is_true(list.has("10.0.0.1") and not list.has("nonsense"))
	_write(file, '[\n"10.0.0.1",\n')
	contains(BanList.open(file).error, "is no JSON")
	_write(file, "{}")
	contains(BanList.open(file).error, "no JSON list")
	DirAccess.remove_absolute(file)


## Where a client keeps its token; the test removes it.
func _claim_token_file(p_name: String) -> SessionTokenFile:
	_token_file = SessionTokenFile.claim("127.0.0.1:%d" % _pair.port, TRAINEE, p_name)
	return _token_file


func _write(p_path: String, p_text: String) -> void:
	var file: FileAccess = FileAccess.open(p_path, FileAccess.WRITE)
	file.store_string(p_text)
	file.close()


func _add_instructor() -> InstructorControl:
	_serve_orders()
	var end: LinkPair.End = _pair.add(INSTRUCTOR, "Ida")
	var control: InstructorControl = InstructorControl.new(end.link)
	is_true(_pair.until(func() -> bool: return end.joined == 1 and not control.roster.is_empty()))
	return control


func _serve_orders() -> void:
	_server_control = SessionControl.new(_pair.server)
	_pair.on_poll = _server_control.advance


## Cuts a client's connection without a reason.
func _lose(p_end: LinkPair.End) -> void:
	p_end.cut()
	is_true(_pair.until(func() -> bool: return _pair.lost.size() == 1 and p_end.loss != ""))
