class_name EntityEvent
extends RefCounted
## Something that happens at a tick of the simulation: a shot, a hit, a door that slams.

## Counts the server's events; wraps at 65536.
var number: int = 0
## The server's tick at which it happens.
var tick: int = 0
## The entity that it happens to.
var entity: int = 0
## Position of the event in its type's list.
var event: int = 0
## Values of the event's schema, as bytes.
var bytes: PackedByteArray = PackedByteArray()
