class_name SharedServer
extends RefCounted
## A server's end of the calls of [SharedNodes]: checks what clients call, sends what the server
## calls.

## The API of the level's shared nodes.
var api: SharedApi = SharedApi.new()

var _link: ServerLink = null
var _second_usec: int = 0
## Calls in this second: session and method to number.
var _calls: Dictionary[String, int] = {}


func _init(p_link: ServerLink) -> void:
	_link = p_link
	api.use(p_link.api())
	api.call_wanted.connect(_on_call_wanted)
	_link.handle(Protocol.Message.CALL, MessageHandlers.Path.ANY, _on_call)


func _on_call_wanted(p_target: int, p_call: CallMessage, p_is_reliable: bool) -> void:
	var bytes: PackedByteArray = p_call.encode()
	if p_call.error != "":
		api.refuse(p_call.method, p_call.error)
		return
	var sessions: PackedInt32Array = []
	for id: int in _link.session_ids():
		var peer: int = _link.session(id).peer
		if p_target == peer or p_target == 0 or (p_target < 0 and peer != -p_target):
			sessions.append(id)
	if p_is_reliable:
		_link.send_reliably(sessions, bytes)
		return
	var copies: Array[PackedByteArray] = []
	copies.resize(sessions.size())
	copies.fill(bytes)
	_link.send_datagrams(sessions, copies)


func _on_call(p_session: Session, p_bytes: PackedByteArray, p_arrival_usec: int) -> String:
	var call: CallMessage = CallMessage.decode(p_bytes)
	if call == null:
		return "a call that is none"
	if p_arrival_usec - _second_usec > 1000000:
		_second_usec = p_arrival_usec
		_calls.clear()
	var root: SharedNodes = api.root()
	var why: String = "this level has no shared nodes"
	if root != null:
		why = SharedCalls.find_refusal(root, call, p_session.role)
	if why == "":
		why = _find_haste(root.permission_of(call.method), p_session)
	if why != "":
		_refuse(p_session, call, why)
		return ""
	root.caller_session = p_session.id
	root.caller_name = p_session.name
	api.carry_out(call, p_session.peer)
	if is_instance_valid(root):
		root.caller_session = 0
		root.caller_name = ""
	return ""


func _find_haste(p_permission: CallPermission, p_session: Session) -> String:
	var key: String = "%d %s" % [p_session.id, p_permission.method]
	_calls[key] = _calls.get(key, 0) + 1
	if _calls[key] <= p_permission.calls_per_second:
		return ""
	return "more than %d calls in a second" % p_permission.calls_per_second


func _refuse(p_session: Session, p_call: CallMessage, p_why: String) -> void:
	if _link.rates.take(&"refusals", p_session.id, Time.get_ticks_usec() / 1e6):
		_link.send_reliably([p_session.id], RefusalMessage.encode(p_call.number, p_why))
	_link.complain(p_session, "call", "called '%s': %s" % [p_call.method, p_why])
