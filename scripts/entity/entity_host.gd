@abstract class_name EntityHost
extends RefCounted
## What an [Entity] needs from its program: the server, or a client.

## Whether this is the server, which decides what is true.
@abstract func is_authority() -> bool

## Number of the client's session; 0 on a server.
@abstract func session() -> int

## Sets a field, on the server. See [method Entity.set_value].
@abstract func set_field(p_entity: int, p_field: int, p_value: float) -> void

## Sends an event, on the server. See [method Entity.send_event].
@abstract func send_event(p_entity: int, p_event: int, p_values: PackedFloat32Array) -> void

## Sends a command, on a client. See [method Entity.send_command].
@abstract func send_command(p_entity: int, p_command: int, p_values: PackedFloat32Array) -> void

## Who possesses what, on the server; null on a client.
@abstract func possession() -> Possession

## Carries the people of a session in the frame of an entity's body from now on, on the server;
## [param p_seat] is where they sit in it. See [Seat].
@abstract func attach(p_session: int, p_entity: int, p_seat: Transform3D) -> void

## Ends what [method attach] began.
@abstract func detach(p_session: int) -> void

## Carries a person in the frame of an entity's body from now on, as the person stands there, on the
## server; [param p_limb] is one of the person's bodies. See [CarryArea].
@abstract func carry(p_limb: Node3D, p_entity: int) -> void

## Puts a person whom the entity carries back on the ground, on the server.
@abstract func put_down(p_limb: Node3D, p_entity: int) -> void

## Number of the entity to whose body a node belongs, on the server; -1 if it is part of none.
@abstract func find_by_body(p_body: Node3D) -> int

## What people call an entity: a person's name, or that of the node; empty if there is none.
@abstract func name_of(p_entity: int) -> String
