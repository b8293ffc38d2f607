class_name TransportLimits
extends RefCounted
## Limits of what an end of the transport lets through; set them before it is created. All but
## [member max_datagram] bind a [TransportGuard] only.

## Largest datagram of the fast path, bytes: this many pass every usual network in one piece.
var max_datagram: int = 1200
## Fast datagrams that a client may send per second, by their first byte; more are
## dropped. Those of other first bytes count as packets only.
var max_fast: Dictionary[int, int] = {}
## Fast datagrams whose first byte is this or above count as [member high_kind] all together; 256:
## none.
var high_from: int = 256
## The first byte that they count as.
var high_kind: int = 0
## Packets of any kind that a client may send per second; more are dropped.
var max_packets: int = 1000
## A client that sends this many packets in a second is disconnected.
var flood_packets: int = 3000
## Bytes that a client may send per second; more are dropped.
var max_bytes: int = 1 << 20
## A client that sends this many bytes in a second is disconnected.
var flood_bytes: int = 1 << 24
## Remote calls, and what belongs to them, per second.
var max_calls: int = 30
## Largest packet for the multiplayer API, bytes.
var max_packet: int = 16384
## Packets of a client that wait for the main thread; one that has more is disconnected.
var max_waiting: int = 512
