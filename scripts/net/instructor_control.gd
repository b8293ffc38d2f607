class_name InstructorControl
extends RefCounted
## Gives an instructor's orders to a server and hears the answers, on a client. The server's end is
## [SessionControl].

## Who is here, lost or waiting has changed, or the list was asked for: see [member roster].
signal roster_changed
## An answer to an order, or something that instructors should know.
signal answered(p_answer: AnswerMessage)

## Who is here, lost or waiting.
var roster: Array[RosterRow] = []

var _link: ClientLink = null
var _number: int = 0


func _init(p_link: ClientLink) -> void:
	_link = p_link
	_link.handle(Protocol.Message.ANSWER, MessageHandlers.Path.RELIABLE, _on_answer)
	_link.handle(Protocol.Message.ROSTER, MessageHandlers.Path.RELIABLE, _on_roster)


## Asks who is here.
func ask_who() -> int:
	return _give(OrderMessage.Kind.WHO)


## Asks that a waiting peer be admitted. Returns the number of the order, as all of these do; 0 if
## there is no connection.
func admit(p_peer: int) -> int:
	return _give(OrderMessage.Kind.ADMIT, p_peer)


## Asks that a waiting peer be sent away.
func refuse(p_peer: int, p_why: String) -> int:
	return _give(OrderMessage.Kind.REFUSE, p_peer, p_why)


## Asks that a client be dismissed.
func kick(p_session: int, p_why: String) -> int:
	return _give(OrderMessage.Kind.KICK, p_session, p_why)


## Asks that a client be dismissed and its address banned.
func ban(p_session: int, p_why: String) -> int:
	return _give(OrderMessage.Kind.BAN, p_session, p_why)


## Asks that one of a trainee's people be calibrated; [param p_pose] is one of those that clients
## know.
func calibrate(p_session: int, p_index: int, p_pose: int) -> int:
	var order: OrderMessage = OrderMessage.new()
	order.index = p_index
	order.pose = p_pose
	return _give(OrderMessage.Kind.CALIBRATE, p_session, "", order)


## Asks for another level, by its name.
func change_level(p_name: String) -> int:
	return _give(OrderMessage.Kind.LEVEL, 0, p_name)


## Asks that fields of the world's own entity get values, such as its time of day.
func set_fields(p_values: Dictionary[StringName, float]) -> int:
	return _give(OrderMessage.Kind.FIELDS, 0, OrderMessage.write_fields(p_values))


## Sends the file of an effect, for all clients; 0 if it is too large, too.
func send_effect(p_name: String, p_text: String) -> int:
	if not _link.is_joined():
		return 0
	var number: int = _number % 0xFFFF + 1
	var parts: Array[PackedByteArray] = EffectMessage.split(number, p_name, p_text.to_utf8_buffer())
	for part: PackedByteArray in parts:
		_link.send_reliably(part)
	if parts.is_empty():
		return 0
	_number = number
	return _number


func _give(
	p_kind: OrderMessage.Kind,
	p_target: int = 0,
	p_argument: String = "",
	p_order: OrderMessage = OrderMessage.new()
) -> int:
	if not _link.is_joined():
		return 0
	_number = _number % 0xFFFF + 1
	p_order.number = _number
	p_order.kind = p_kind
	p_order.target = p_target
	p_order.argument = p_argument
	_link.send_reliably(p_order.encode())
	return _number


func _on_answer(p_bytes: PackedByteArray, _arrival_usec: int) -> bool:
	var answer: AnswerMessage = AnswerMessage.decode(p_bytes)
	if answer != null:
		answered.emit(answer)
	return answer != null


func _on_roster(p_bytes: PackedByteArray, _arrival_usec: int) -> bool:
	var message: RosterMessage = RosterMessage.decode(p_bytes)
	if message == null:
		return false
	roster = message.rows
	roster_changed.emit()
	return true
