@tool
class_name StudioSession
extends RefCounted
## Sends effects from the studio into a running session, as an instructor.

## Something to tell the user.
signal notified(p_text: String)

## Server, with its port.
var address: String = "127.0.0.1:%d" % Protocol.DEFAULT_PORT
## Password of instructors; the environment's by default.
var password: String = OS.get_environment("DISMOUNT_PASSWORD")

var _link: ClientLink = null
## Server of [member _link].
var _joined_address: String = ""
var _control: InstructorControl = null
var _waiting: PackedStringArray = []


## Sends an effect; joins the session at [member address] first, if that has not happened yet.
func send(p_name: String, p_text: String) -> void:
	if _link != null and _joined_address != address:
		close()
	_waiting = [p_name, p_text]
	if _link == null:
		_join()
	elif _link.is_joined():
		_send()


## Goes on; call it in every frame.
func advance() -> void:
	if _link != null:
		_link.poll()


## Leaves the session.
func close() -> void:
	if _link != null:
		_link.leave()
	_link = null
	_control = null


func _join() -> void:
	var parts: PackedStringArray = address.rsplit(":", true, 1)
	var port: int = parts[1].to_int() if parts.size() == 2 else Protocol.DEFAULT_PORT
	var request: JoinRequest = JoinRequest.new()
	request.role = Roles.Role.INSTRUCTOR
	request.name = "Studio"
	_joined_address = address
	_link = ClientLink.new()
	_link.trust.servers = KnownServers.new()
	_link.joined.connect(_send)
	_link.refused.connect(_on_ended)
	_link.lost.connect(_on_ended)
	_control = InstructorControl.new(_link)
	_control.answered.connect(_on_answered)
	notified.emit("joining the session at %s" % address)
	_link.open(parts[0], port, request, password)


func _send() -> void:
	if _waiting.is_empty():
		return
	if _control.send_effect(_waiting[0], _waiting[1]) == 0:
		notified.emit("the effect is too large to be sent")
	_waiting.clear()


func _on_answered(p_answer: AnswerMessage) -> void:
	notified.emit(p_answer.text)


func _on_ended(p_why: String) -> void:
	notified.emit("not sent: " + p_why)
	_link = null
	_control = null
