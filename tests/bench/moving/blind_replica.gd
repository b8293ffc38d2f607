extends LoadReplica
## A replica that acknowledges every snapshot without reading more of it than its number: eighty
## clients that decode what they get would take more of a processor than the server.
##
## By docs/protocol.md ("Snapshots", "ACK"): the server takes it for a client that has read all.

## Datagrams that an acknowledgement speaks of besides the newest.
const _BEFORE: int = 32
const _SIZE: int = 9

## Bit i: datagram i + 1 before the newest has come.
var _come: int = 0
var _newest: int = -1
var _waiting: int = 0


func _take_snapshot(p_bytes: PackedByteArray, _p_arrival_s: float) -> bool:
	var at: int = 1 if p_bytes[0] == Protocol.Message.SNAPSHOT_OF_ONE else 3
	if not is_ready() or p_bytes.size() <= at:
		return false
	var number: int = p_bytes[at]
	var ahead: int = (number - _newest) & 0xff
	if _newest < 0:
		_newest = number
	elif ahead < 0x80 and ahead > 0:
		_come = ((_come << 1 | 1) << (ahead - 1)) & 0xffffffff
		_newest = number
	elif ahead >= 0x100 - _BEFORE:
		_come |= 1 << (0xff - ahead)
	_waiting += 1
	datagrams += 1
	return true


func acknowledgement(p_now_usec: int, _viewpoint: Vector3) -> PackedByteArray:
	var is_early: bool = p_now_usec - _acked_usec < ACK_PERIOD_USEC
	if _waiting == 0 or is_early and _waiting < MAX_UNACKNOWLEDGED / 2:
		return PackedByteArray()
	_waiting = 0
	_acked_usec = p_now_usec
	var ack: PackedByteArray = []
	ack.resize(_SIZE)
	ack[0] = Protocol.Message.ACK
	ack[2] = _newest
	ack.encode_u32(3, _come)
	ack.encode_u16(7, table.version & 0xffff)
	return ack


func clear() -> void:
	super()
	_come = 0
	_newest = -1
	_waiting = 0
