class_name TransportLimits
extends RefCounted
## Limits of what an end of the transport lets through; set them before it is created. All but
## [member max_datagram] bind a [TransportGuard] only.

## The least that [member max_clients] should be: so many clients cost next to nothing.
const MIN_CLIENTS: int = 512

## Largest datagram of the fast path, bytes: this many pass every usual network in one piece.
var max_datagram: int = 1200
## Clients that have room on a server besides those that are just arriving; ENet looks at all the
## slots that it has for them several times in a tick.
var max_clients: int = MIN_CLIENTS
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
## Largest packet for the multiplayer API, bytes.
var max_packet: int = 16384
## Packets of a client that wait for the main thread; one that has more is disconnected.
var max_waiting: int = 512
