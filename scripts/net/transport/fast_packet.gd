class_name FastPacket
extends RefCounted
## A datagram that came over the fast path.

## Who sent it: a peer's id, 1 for the server.
var peer: int = 0
## What it holds; the first byte says of which kind it is.
var bytes: PackedByteArray = PackedByteArray()
## When the thread took it from the socket, [method Time.get_ticks_usec], µs.
var arrival_usec: int = 0
