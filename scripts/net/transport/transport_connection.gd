class_name TransportConnection
extends RefCounted
## One connection as the transport's thread knows it. Only that thread touches it.

## The stage of the other end.
enum Stage {
	## It may send its join request.
	ARRIVING,
	## The server has admitted it.
	WELCOMED,
	## It has confirmed that: plain bytes and the fast path are open to it.
	ADMITTED,
	## It is being disconnected: everything that it sends is ignored.
	LEAVING,
}

## Seconds between two complaints of one kind about one connection.
const _COMPLAINT_S: float = 1.0

## The peer's id.
var id: int = 0
## ENet's end.
var remote: ENetPacketPeer = null
## IP address of the other end.
var address: String = ""
## When the connection was made, µs.
var since_usec: int = 0
## The stage of the other end.
var stage: Stage = Stage.ARRIVING
## Whether its remote calls are let through.
var may_call: bool = false
## Whether it waits for an instructor's decision.
var kept: bool = false
## When its disconnection began, µs.
var leaving_usec: int = 0
## Packets in this second.
var packets: int = 0
## Fast datagrams of the kinds that [member TransportLimits.max_fast] names, in this second.
var fast: Dictionary[int, int] = {}
## Commands of the multiplayer API in this second.
var calls: int = 0
## Bytes in this second.
var bytes: int = 0
## Packets that wait for the main thread.
var waiting: int = 0
## What was sent reliably and not acknowledged by a receipt yet.
var window: ReceiptWindow = ReceiptWindow.new()

var _complained_usec: Dictionary[String, int] = {}


func _init(p_id: int, p_remote: ENetPacketPeer, p_now_usec: int) -> void:
	id = p_id
	remote = p_remote
	since_usec = p_now_usec
	address = plain_address(p_remote.get_remote_address()) if p_remote != null else ""


## Starts a new second.
func restart_window() -> void:
	packets = 0
	fast.clear()
	calls = 0
	bytes = 0


## Whether it is time for another complaint of this kind.
func may_complain(p_key: String, p_now_usec: int) -> bool:
	var last: int = _complained_usec.get(p_key, -int(_COMPLAINT_S * 1e6))
	if p_now_usec - last < int(_COMPLAINT_S * 1e6):
		return false
	_complained_usec[p_key] = p_now_usec
	return true


## An IPv4 address in its usual form, also where the system writes it as an IPv6 address.
static func plain_address(p_address: String) -> String:
	var mapped: String = p_address.to_lower()
	for prefix: String in ["::ffff:", "0:0:0:0:0:ffff:"]:
		if mapped.begins_with(prefix):
			var rest: String = mapped.trim_prefix(prefix)
			if rest.contains("."):
				return rest
			var words: PackedStringArray = rest.split(":")
			if words.size() == 2:
				var high: int = words[0].hex_to_int()
				var low: int = words[1].hex_to_int()
				return "%d.%d.%d.%d" % [high >> 8, high & 255, low >> 8, low & 255]
	return p_address
