@abstract class_name EntityHost
extends RefCounted
## What an [Entity] needs from its program, be it the server ([EntityAuthority]) or a client.

## Number of the client's session; 0 on a server.
@abstract func session() -> int

## Sends a command for a tick, on a client. See [method Entity.send_command].
@abstract
func send_command(p_entity: int, p_command: int, p_values: PackedFloat32Array, p_at: int) -> void

## What people call an entity: a person's name, or that of the node; empty if there is none.
@abstract func name_of(p_entity: int) -> String
