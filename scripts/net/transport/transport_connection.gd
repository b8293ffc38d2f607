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
## Whether it waits for an instructor's decision.
var kept: bool = false
## When its disconnection began, µs.
var leaving_usec: int = 0
## Packets in this second.
var packets: int = 0
## Fast datagrams of the kinds that [member TransportLimits.max_fast] names, in this second.
var fast: Dictionary[int, int] = {}
## Bytes in this second.
var bytes: int = 0
## Packets that wait for the main thread.
var waiting: int = 0
## What was sent reliably and not acknowledged by a receipt yet.
var window: ReceiptWindow = ReceiptWindow.new()

var _complained_usec: Dictionary[String, int] = {}


func _init(p_id: int, p_remote: ENetPacketPeer, p_now_usec: int, p_address: String = "") -> void:
	id = p_id
	remote = p_remote
	since_usec = p_now_usec
	address = p_address


## Starts a new second.
func restart_window() -> void:
	packets = 0
	fast.clear()
	bytes = 0


## Whether it is time for another complaint of this kind.
func may_complain(p_key: String, p_now_usec: int) -> bool:
	var last: int = _complained_usec.get(p_key, -int(_COMPLAINT_S * 1e6))
	if p_now_usec - last < int(_COMPLAINT_S * 1e6):
		return false
	_complained_usec[p_key] = p_now_usec
	return true
