class_name SessionControl
extends RefCounted
## Carries out what instructors order, on a server: see [OrderMessage]. Each order is answered, by
## name and outcome. [InstructorControl] is the counterpart.

## An instructor asks for another level; the callable gets what becomes of it:
## [code]func(outcome: AnswerMessage.Outcome, text: String) -> void[/code].
signal level_requested(p_name: String, p_reply: Callable)
## An instructor sets fields of the world's own entity; the callable gets the reason why not, or an
## empty text.
signal fields_requested(p_values: Dictionary[StringName, float], p_answer: Callable)

## Seconds between two notices about one session.
const NOTICE_S: float = 5.0
## Seconds between two lists of who is here, for those that change it often.
const ROSTER_S: float = 0.25
## Calibrations that are going on at one time.
const MAX_CALIBRATIONS: int = 256

## Adds what the rest of the server knows of a client to its row: [code]func(row: RosterRow)[/code].
var describer: Callable = Callable()

var _link: ServerLink = null
var _noticed_s: Dictionary[int, float] = {}
var _calibrations: Dictionary[int, Calibrating] = {}
var _next_number: int = 1
var _is_roster_due: bool = false
var _roster_s: float = 0.0


## A calibration that an instructor has ordered.
class Calibrating:
	## Session of the instructor, and the number of its order.
	var instructor: int = 0
	var order: int = 0
	## Session of the trainee, which of its people, and its name.
	var session: int = 0
	var index: int = 0
	var name: String = ""


func _init(p_link: ServerLink) -> void:
	_link = p_link
	_link.roster_changed.connect(_on_roster_changed)
	_link.client_left.connect(_on_left)
	_link.handle(Protocol.Message.ORDER, MessageHandlers.Path.RELIABLE, _on_order)
	_link.handle(
		Protocol.Message.WEARER,
		MessageHandlers.Path.RELIABLE,
		_on_wearer,
		Roles.Capability.SEND_MOTION
	)


## Sends instructors who is here, if that has changed. Call it once a tick.
func advance() -> void:
	var now: float = Time.get_ticks_usec() / 1e6
	if _is_roster_due and now - _roster_s > ROSTER_S:
		_is_roster_due = false
		_roster_s = now
		_send_roster(_instructors())


## Tells all instructors what a session did wrong. Each session is named at most once in
## [constant NOTICE_S].
func tell_instructors(p_session: int, p_text: String) -> void:
	var now: float = Time.get_ticks_usec() / 1e6
	if now - _noticed_s.get(p_session, -NOTICE_S) < NOTICE_S:
		return
	_noticed_s[p_session] = now
	_link.send_reliably(
		_instructors(), AnswerMessage.encode(0, AnswerMessage.Outcome.NOTICE, p_text)
	)


func _on_order(p_caller: Session, p_bytes: PackedByteArray, _arrival_usec: int) -> String:
	var order: OrderMessage = OrderMessage.decode(p_bytes)
	if order == null:
		return "an order that is none"
	if not p_caller.can(_needed(order.kind)):
		return "an order that its role may not give"
	if not _may_now(p_caller, order):
		return ""
	match order.kind:
		OrderMessage.Kind.WHO:
			_send_roster([p_caller.id])
		OrderMessage.Kind.ADMIT, OrderMessage.Kind.REFUSE:
			_decide(p_caller, order)
		OrderMessage.Kind.KICK, OrderMessage.Kind.BAN:
			_dismiss(p_caller, order)
		OrderMessage.Kind.CALIBRATE:
			_calibrate(p_caller, order)
		OrderMessage.Kind.LEVEL:
			level_requested.emit(
				order.argument.left(Protocol.MAX_LEVEL_NAME),
				func(outcome: AnswerMessage.Outcome, text: String) -> void:
					_reply(p_caller, order.number, outcome, text)
			)
		OrderMessage.Kind.FIELDS:
			var values: Dictionary[StringName, float] = OrderMessage.read_fields(order.argument)
			fields_requested.emit(
				values,
				func(fault: String) -> void:
					_answer(p_caller, order, fault, "the world has %s" % order.argument)
			)
	return ""


## Whether an order does not come too soon; if it does, its sender gets a notice.
func _may_now(p_caller: Session, p_order: OrderMessage) -> bool:
	var now: float = Time.get_ticks_usec() / 1e6
	var what: StringName = MessageRates.OF_ORDERS[p_order.kind]
	var may: bool = false
	if p_order.kind == OrderMessage.Kind.LEVEL:
		# Those who change levels decide which of them are carried out, and when.
		may = _link.rates.take_of_session(what, p_caller.id, now)
	else:
		may = _link.rates.take(what, p_caller.id, now)
	if not may:
		_link.complain(p_caller, "haste", "gives orders too soon after one another")
		if _link.rates.take(&"refusals", p_caller.id, now):
			var text: String = MessageRates.describe(what)
			var bytes: PackedByteArray = AnswerMessage.encode(
				p_order.number, AnswerMessage.Outcome.FAILED, text
			)
			_link.send_reliably([p_caller.id], bytes)
	return may


func _needed(p_kind: OrderMessage.Kind) -> Roles.Capability:
	var directing: Array[OrderMessage.Kind] = [
		OrderMessage.Kind.CALIBRATE, OrderMessage.Kind.LEVEL, OrderMessage.Kind.FIELDS
	]
	if directing.has(p_kind):
		return Roles.Capability.DIRECT
	return Roles.Capability.MODERATE


func _decide(p_caller: Session, p_order: OrderMessage) -> void:
	var name: String = "nobody"
	for row: RosterRow in _link.roster():
		if row.session == 0 and row.peer == p_order.target:
			name = row.name
	if p_order.kind == OrderMessage.Kind.ADMIT:
		var fault: String = _link.admit(p_order.target)
		var place: int = _link.place_of(p_order.target)
		var done: String = "%s: admitted" % name
		if place > 0:
			done += ", and waits for room at place %d" % place
		_answer(p_caller, p_order, fault, done, name)
		return
	var why: String = "refused by %s" % _sign(p_caller, p_order.argument)
	_answer(p_caller, p_order, _link.refuse(p_order.target, why), "%s: sent away" % name, name)


func _dismiss(p_caller: Session, p_order: OrderMessage) -> void:
	var session: Session = _link.session(p_order.target)
	var name: String = session.name if session != null else ""
	if p_order.kind == OrderMessage.Kind.KICK:
		var kicked: String = "kicked by %s" % _sign(p_caller, p_order.argument)
		_answer(p_caller, p_order, _link.kick(p_order.target, kicked), "%s: kicked" % name, name)
		return
	var why: String = "banned by %s" % _sign(p_caller, p_order.argument)
	var address: String = session.address if session != null else ""
	var done: String = "%s: banned, with the address %s" % [name, address]
	var fault: String = "there is no session %d" % p_order.target
	if session != null:
		fault = _link.rules.bans.add(address)
		_link.kick(session.id, why)
	_answer(p_caller, p_order, fault, done, name)


func _calibrate(p_caller: Session, p_order: OrderMessage) -> void:
	var session: Session = _link.session(p_order.target)
	var name: String = session.name if session != null else ""
	var fault: String = _find_calibration_fault(session, p_order)
	if fault == "":
		_replace_calibration(session.id, p_order.index)
		if _calibrations.size() >= MAX_CALIBRATIONS:
			fault = "too many calibrations are going on"
	if fault != "":
		_answer(p_caller, p_order, fault, "", name)
		return
	var number: int = _next_number
	_link.send_reliably([session.id], NoticeMessage.calibrate(p_order.index, p_order.pose, number))
	_next_number = _next_number % 0xFFFF + 1
	var calibrating: Calibrating = Calibrating.new()
	calibrating.instructor = p_caller.id
	calibrating.order = p_order.number
	calibrating.session = session.id
	calibrating.index = p_order.index
	calibrating.name = name
	_calibrations[number] = calibrating
	_reply(p_caller, p_order.number, AnswerMessage.Outcome.BEGUN, "%s: calibrating" % name)


## A person has one calibration at a time: clients that never answer must not use up all.
func _replace_calibration(p_session: int, p_index: int) -> void:
	for number: int in _calibrations.keys():
		var asked: Calibrating = _calibrations[number]
		if asked.session == p_session and asked.index == p_index:
			_calibrations.erase(number)
			_conclude(asked, false, "another calibration was asked for")


## Which poses there are the client knows.
func _find_calibration_fault(p_session: Session, p_order: OrderMessage) -> String:
	if p_session == null or not p_session.can(Roles.Capability.SEND_MOTION) or p_session.peer == 0:
		return "is no trainee that is here"
	if p_order.index >= PersonCard.MAX_PEOPLE:
		return "there is no person %d" % p_order.index
	return ""


func _on_wearer(p_session: Session, p_bytes: PackedByteArray, _arrival_usec: int) -> String:
	var message: WearerMessage = WearerMessage.decode(p_bytes)
	if message == null:
		return "a report on a suit that is none"
	if message.number == 0:
		_is_roster_due = _is_roster_due or p_session.suit != message.text
		p_session.suit = message.text
		return ""
	var asked: Calibrating = _calibrations.get(message.number)
	if asked == null or asked.session != p_session.id:
		return "the outcome of a calibration that nobody asked for"
	_calibrations.erase(message.number)
	_conclude(asked, message.accepted, message.text)
	return ""


func _conclude(p_asked: Calibrating, p_accepted: bool, p_text: String) -> void:
	var done: AnswerMessage.Outcome = AnswerMessage.Outcome.DONE
	if not p_accepted:
		done = AnswerMessage.Outcome.FAILED
	var instructor: Session = _link.session(p_asked.instructor)
	if instructor != null:
		_reply(instructor, p_asked.order, done, "%s: %s" % [p_asked.name, p_text])


func _on_roster_changed() -> void:
	_is_roster_due = true


func _on_left(p_session: int) -> void:
	_noticed_s.erase(p_session)
	for number: int in _calibrations.keys():
		if _calibrations[number].session == p_session:
			_conclude(_calibrations[number], false, "left during the calibration")
			_calibrations.erase(number)


func _sign(p_caller: Session, p_why: String) -> String:
	return "instructor '%s'%s" % [p_caller.name, ": " + p_why if p_why != "" else ""]


## Answers that something failed, or what was done.
func _answer(
	p_caller: Session, p_order: OrderMessage, p_fault: String, p_done: String, p_name: String = ""
) -> void:
	if p_fault == "":
		_reply(p_caller, p_order.number, AnswerMessage.Outcome.DONE, p_done)
		return
	var text: String = "%s: %s" % [p_name, p_fault] if p_name != "" else p_fault
	_reply(p_caller, p_order.number, AnswerMessage.Outcome.FAILED, text)


func _reply(
	p_caller: Session, p_number: int, p_outcome: AnswerMessage.Outcome, p_text: String
) -> void:
	Log.info("net", "%s gave an order: %s" % [p_caller.describe(), p_text])
	_link.send_reliably([p_caller.id], AnswerMessage.encode(p_number, p_outcome, p_text))


func _instructors() -> PackedInt32Array:
	var ids: PackedInt32Array = []
	for row: RosterRow in _link.roster():
		if row.can(Roles.Capability.MODERATE):
			ids.append(row.session)
	return ids


func _send_roster(p_to: PackedInt32Array) -> void:
	if p_to.is_empty():
		return
	var rows: Array[RosterRow] = _link.roster()
	for row: RosterRow in rows:
		if describer.is_valid() and row.session != 0:
			describer.call(row)
	_link.send_reliably(p_to, RosterMessage.encode(rows))
