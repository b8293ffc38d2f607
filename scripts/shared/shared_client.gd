class_name SharedClient
extends RefCounted
## A client's end of the calls of [SharedNodes].

## Calls that are remembered until a refusal may come.
const MAX_REMEMBERED: int = 256

## The API of the level's shared nodes.
var api: SharedApi = SharedApi.new()

var _link: ClientLink = null
var _role: Roles.Role = Roles.Role.OBSERVER
var _number: int = 0
## The methods of the last calls, by number.
var _called: Dictionary[int, StringName] = {}


func _init(p_link: ClientLink, p_role: Roles.Role) -> void:
	_link = p_link
	_link.takes_shared = true
	_role = p_role
	api.call_wanted.connect(_on_call_wanted)
	_link.handle(Protocol.Message.CALL, MessageHandlers.Path.ANY, _on_call)
	_link.handle(Protocol.Message.REFUSAL, MessageHandlers.Path.RELIABLE, _on_refusal)


## A connection is being made: its API is another one.
func reconnect() -> void:
	api.use(_link.api())


func _on_call_wanted(p_target: int, p_call: CallMessage, p_is_reliable: bool) -> void:
	var why: String = SharedCalls.find_refusal(api.root(), p_call, _role)
	if p_target > 1 or p_target == -MultiplayerPeer.TARGET_PEER_SERVER:
		why = "clients call the server only: rpc_id(1, ...)"
	elif not _link.is_joined():
		why = "there is no connection to the server"
	_number = (_number + 1) & 0xFFFF
	p_call.number = _number
	var bytes: PackedByteArray = p_call.encode()
	why = p_call.error if why == "" else why
	if why != "":
		api.refuse(p_call.method, why)
		return
	_called[_number] = p_call.method
	_called.erase((_number - MAX_REMEMBERED) & 0xFFFF)
	if p_is_reliable:
		_link.send_reliably(bytes)
	else:
		_link.send_fast(bytes)


func _on_call(p_bytes: PackedByteArray, _arrival_usec: int) -> bool:
	var call: CallMessage = CallMessage.decode(p_bytes)
	if call == null or api.root() == null:
		return false
	var fault: String = SharedCalls.find_fault(api.root(), call)
	if fault != "":
		Log.limited("shared", call.method, "the server called '%s': %s" % [call.method, fault])
		return true
	api.carry_out(call, MultiplayerPeer.TARGET_PEER_SERVER)
	return true


func _on_refusal(p_bytes: PackedByteArray, _arrival_usec: int) -> bool:
	var refusal: RefusalMessage = RefusalMessage.decode(p_bytes)
	if refusal == null:
		return false
	api.refuse(_called.get(refusal.number, &""), refusal.why)
	return true
