class_name Session
extends RefCounted
## One client's stay on a server; it outlasts a lost connection for a while.

## Number of the session; the rest of the program knows clients by it.
var id: int = 0
## What the client is.
var role: Roles.Role = Roles.Role.OBSERVER
## Shown to the others.
var name: String = ""
## Snapshots per second that the client wants; 0 as the server does.
var rate: int = 0
## IP address of the client.
var address: String = ""
## What it counts as: see [method AddressNetwork.of].
var network: String = ""
## The network of its site: see [method AddressNetwork.site_of].
var site: String = ""
## Lets the client come back.
var token: PackedByteArray = PackedByteArray()
## The peer's id; 0 while the connection is lost.
var peer: int = 0
## Whether the client has confirmed its admission.
var is_here: bool = false
## Whether it was here before.
var was_here: bool = false
## Reads the motion that it sends.
var motion: SampleReader = SampleReader.new()
## The level that was sent to the client when it was admitted, as [LevelMessage].
var welcome_level: PackedByteArray = PackedByteArray()
## What the client says of its suit; empty: nothing.
var suit: String = ""
## When the connection was lost, µs.
var lost_usec: int = 0


## What the rest of the program knows of a client: name, role and rate.
func hello() -> Dictionary:
	return {"name": name, "role": role, "rate": rate}


## For the log.
func describe() -> String:
	return "%s '%s' (%d) from %s" % [Roles.name_of(role), name, id, address]


## Whether the client may do something.
func can(p_capability: Roles.Capability) -> bool:
	return Roles.can(role, p_capability)
