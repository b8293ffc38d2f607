extends TestCase
## Orders of instructors and their answers, over a real link.

const LinkPair: GDScript = preload("link_pair.gd")
const NetSamples: GDScript = preload("net_samples.gd")
const TRAINEE: Roles.Role = Roles.Role.TRAINEE
const OBSERVER: Roles.Role = Roles.Role.OBSERVER
const INSTRUCTOR: Roles.Role = Roles.Role.INSTRUCTOR

var _pair: LinkPair = null
var _control: SessionControl = null
var _answers: Array[AnswerMessage] = []
## Calibrations that clients were asked for: person, kind.
var _asked: Array[Vector2i] = []
## Their numbers.
var _numbers: Array[int] = []


func before_each() -> void:
	_pair = LinkPair.new()
	_answers.clear()
	_asked.clear()
	_numbers.clear()
	_pair.listen()
	_control = SessionControl.new(_pair.server)
	_pair.on_poll = _control.advance


func after_each() -> void:
	_pair.close()


func test_a_calibration_is_asked_for_and_its_outcome_comes_back() -> void:
	var control: InstructorControl = _instructor()
	var ada: LinkPair.End = _trainee("Ada")
	var bob: LinkPair.End = _trainee("Bob")
	var order: int = control.calibrate(ada.link.session, 1, 4)
	is_true(_pair.until(func() -> bool: return _answers.size() == 1 and _asked.size() == 1))
	equal(_asked, [Vector2i(1, 4)] as Array[Vector2i], "only one of the two was asked")
	equal(_last(), [order, AnswerMessage.Outcome.BEGUN, "Ada: calibrating"])
	# Somebody else cannot answer for Ada.
	bob.link.send_reliably(WearerMessage.encode(_numbers[0], true, "calibrated"))
	_pair.run(0.2)
	equal(_answers.size(), 1)
	ada.link.send_reliably(WearerMessage.encode(_numbers[0], true, "calibrated, quality 93 %"))
	is_true(_pair.until(func() -> bool: return _answers.size() == 2))
	equal(_last(), [order, AnswerMessage.Outcome.DONE, "Ada: calibrated, quality 93 %"])
	ada.link.send_reliably(WearerMessage.encode(_numbers[0], true, "again"))
	_pair.run(0.2)
	equal(_answers.size(), 2, "it is answered once")


func test_a_refusal_and_a_leave_reach_the_instructor() -> void:
	var control: InstructorControl = _instructor()
	var ada: LinkPair.End = _trainee("Ada")
	var bob: LinkPair.End = _trainee("Bob")
	control.calibrate(ada.link.session, 0, 0)
	# Otherwise the second one's question might come first, and the first number be its own.
	is_true(_pair.until(func() -> bool: return _asked.size() == 1))
	control.calibrate(bob.link.session, 0, 0)
	is_true(_pair.until(func() -> bool: return _asked.size() == 2))
	ada.link.send_reliably(WearerMessage.encode(_numbers[0], false, "this motion comes calibrated"))
	is_true(_pair.until(func() -> bool: return _answers.size() == 3))
	equal([_answers[2].outcome, _answers[2].text], _failed("Ada: this motion comes calibrated"))
	_pair.server.kick(bob.link.session, "")
	is_true(_pair.until(func() -> bool: return _answers.size() == 4))
	equal([_answers[3].outcome, _answers[3].text], _failed("Bob: left during the calibration"))


func test_what_cannot_be_done_is_said() -> void:
	var control: InstructorControl = _instructor()
	var ada: LinkPair.End = _trainee("Ada")
	var eve: LinkPair.End = _pair.join(OBSERVER, "Eve")
	var wrong: Array[Array] = [
		[control.calibrate.bind(eve.link.session, 0, 0), "Eve: is no trainee"],
		[control.calibrate.bind(999, 0, 0), "is no trainee"],
		[control.calibrate.bind(ada.link.session, PersonCard.MAX_PEOPLE, 0), "no person"],
		[control.kick.bind(999, ""), "there is no session 999"],
		[control.ban.bind(0, ""), "there is no session 0"],
		[control.admit.bind(12), "nobody waits"],
		[control.refuse.bind(12, ""), "nobody waits"],
	]
	for row: Array in wrong:
		_answers.clear()
		var number: int = row[0].call()
		is_true(_pair.until(func() -> bool: return not _answers.is_empty()), row[1])
		contains(_answers[0].text, row[1])
		equal([_answers[0].number, _answers[0].outcome], [number, AnswerMessage.Outcome.FAILED])
	equal(_asked, [] as Array[Vector2i])


func test_the_roster_has_what_an_instructor_needs() -> void:
	_control.describer = func(row: RosterRow) -> void:
		row.delay_ms = 18.4
		row.tracking_deg = 0.83
		row.people = 2
	var control: InstructorControl = _instructor()
	var ada: LinkPair.End = _trainee("Ada")
	ada.link.send_reliably(WearerMessage.encode(0, true, "17 trackers on USB, calibrated"))
	var rows: Array[RosterRow] = []
	var knows_suit: Callable = func() -> bool:
		rows.assign(control.roster.filter(func(row: RosterRow) -> bool: return row.suit != ""))
		return rows.size() == 1
	is_true(_pair.until(knows_suit))
	var row: RosterRow = rows[0]
	equal([row.name, row.role, row.state_name()], ["Ada", TRAINEE, "here"])
	equal([row.people, row.suit], [2, "17 trackers on USB, calibrated"])
	is_true(absf(row.delay_ms - 18.4) < 0.06 and absf(row.tracking_deg - 0.83) < 0.006)
	equal(row.round_trip_ms, -1.0, "not known")


func test_orders_that_come_too_soon_are_answered_and_harm_nobody() -> void:
	var control: InstructorControl = _instructor()
	for round: int in 400:
		control.kick(999, "")
		if round % 40 == 0:
			_pair.poll()
	var is_told: Callable = func() -> bool:
		return _answers.any(func(one: AnswerMessage) -> bool: return one.text.contains("too soon"))
	is_true(_pair.until(is_told))
	is_true(_pair.until(func() -> bool: return _pair.server.refused.get("haste", 0) > 100))
	is_true(control._link.is_joined())
	_answers.clear()
	# Another kind has a limit of its own, and so has another instructor.
	control.calibrate(999, 0, 0)
	var other: InstructorControl = _instructor()
	var number: int = other.kick(998, "")
	var is_answered: Callable = func() -> bool:
		var texts: Array = _answers.map(func(one: AnswerMessage) -> String: return one.text)
		return texts.has("there is no session 998") and texts.has("is no trainee that is here")
	is_true(_pair.until(is_answered), "%d" % number)


func test_one_person_has_one_calibration_at_a_time() -> void:
	var control: InstructorControl = _instructor()
	var ada: LinkPair.End = _trainee("Ada")
	for _again: int in 3:
		control.calibrate(ada.link.session, 0, 0)
	var is_replaced: Callable = func(one: AnswerMessage) -> bool:
		return one.text.contains("another calibration")
	# Trainee and instructor hear by links of their own, in any order.
	is_true(
		_pair.until(
			func() -> bool: return _asked.size() == 3 and _answers.filter(is_replaced).size() == 2
		)
	)
	equal(_control._calibrations.size(), 1, "whoever never answers uses up one")
	equal(_answers.filter(is_replaced).size(), 2)


func test_who_waits_for_room_is_admitted_once() -> void:
	_pair.rules.waiting_room = true
	_pair.rules.max_clients = 1
	var control: InstructorControl = _instructor()
	var ada: LinkPair.End = _pair.add(TRAINEE, "Ada")
	is_true(_pair.until(func() -> bool: return ada.places == [1] and control.roster.size() == 2))
	equal(control.roster[1].state_name(), "waiting")
	control.admit(control.roster[1].peer)
	is_true(_pair.until(func() -> bool: return not _answers.is_empty()))
	equal(_answers[0].text, "Ada: admitted, and waits for room at place 1")
	is_true(_pair.until(func() -> bool: return ada.waits_for == JoinReply.Wait.ROOM))
	is_true(_pair.until(func() -> bool: return control.roster[1].state_name() == "queued"))
	control.admit(control.roster[1].peer)
	is_true(_pair.until(func() -> bool: return _answers.size() == 2))
	equal(_answers[1].text, "Ada: waits for room already, at place 1")
	equal([ada.refusal, ada.loss, ada.joined], ["", "", 0])
	_pair.rules.max_clients = 2
	_pair.await_join(ada)


func test_noise_in_place_of_orders_and_answers() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 5
	var control: InstructorControl = _instructor()
	var ada: LinkPair.End = _trainee("Ada")
	for round: int in 300:
		var noise: PackedByteArray = NetSamples.noise(random, 60)
		control._link.send_reliably(PackedByteArray([Protocol.Message.ORDER]) + noise)
		ada.link.send_reliably(PackedByteArray([Protocol.Message.WEARER]) + noise)
		for kind: int in [Protocol.Message.ANSWER, Protocol.Message.ROSTER]:
			noise.insert(0, kind)
			_pair.server.send_reliably([control._link.session], noise)
			noise.remove_at(0)
		if round % 30 == 0:
			_pair.run(0.05)
	_pair.run(0.3)
	equal(_pair.left.size(), 0)
	is_true(control._link.is_joined() and ada.link.is_joined())


func test_messages_come_back_as_they_were_sent() -> void:
	var order: OrderMessage = OrderMessage.new()
	order.number = 65535
	order.kind = OrderMessage.Kind.CALIBRATE
	order.target = 0x7FFFFFFF
	order.index = 7
	order.pose = 255
	order.argument = "wéll\nthen"
	var bytes: PackedByteArray = order.encode()
	var read: OrderMessage = OrderMessage.decode(bytes)
	equal([read.number, read.kind, read.target], [65535, order.kind, 0x7FFFFFFF])
	equal([read.index, read.pose, read.argument], [7, 255, "wéllthen"])
	for size: int in bytes.size():
		is_true(OrderMessage.decode(bytes.slice(0, size)) == null, "cut to %d" % size)
	is_true(OrderMessage.decode(bytes + PackedByteArray([0])) == null)
	bytes[3] = OrderMessage.Kind.size()
	is_true(OrderMessage.decode(bytes) == null, "no such order")


func _trainee(p_name: String) -> LinkPair.End:
	var end: LinkPair.End = _pair.join(TRAINEE, p_name)
	end.link.calibration_asked.connect(
		func(index: int, kind: int, number: int) -> void:
			_asked.append(Vector2i(index, kind))
			_numbers.append(number)
	)
	return end


func _instructor() -> InstructorControl:
	var end: LinkPair.End = _pair.add(INSTRUCTOR, "Ida")
	var control: InstructorControl = InstructorControl.new(end.link)
	control.answered.connect(func(answer: AnswerMessage) -> void: _answers.append(answer))
	is_true(_pair.until(func() -> bool: return end.joined == 1 and not control.roster.is_empty()))
	return control


func _last() -> Array:
	var answer: AnswerMessage = _answers[-1]
	return [answer.number, answer.outcome, answer.text]


func _failed(p_text: String) -> Array:
	return [AnswerMessage.Outcome.FAILED, p_text]
