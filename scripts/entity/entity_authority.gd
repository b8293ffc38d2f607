@abstract class_name EntityAuthority
extends EntityHost
## What an [Entity] needs from the program that decides what is true: the server.

## Sets a field. See [method Entity.set_value].
@abstract func set_field(p_entity: int, p_field: int, p_value: float) -> void

## Sends an event. See [method Entity.send_event].
@abstract func send_event(p_entity: int, p_event: int, p_values: PackedFloat32Array) -> void

## Carries a person in the frame of an entity's body from now on, as the person stands there;
## [param p_limb] is one of the person's bodies. With [param p_holds] the motion goes with the body,
## otherwise as far as feet or back hold on it. See [CarryArea].
@abstract func carry(p_limb: Node3D, p_entity: int, p_holds: bool) -> void

## Puts a person whom the entity carries back on the ground.
@abstract func put_down(p_limb: Node3D, p_entity: int) -> void

## Number of the entity to whose body a node belongs; -1 if it is part of none.
@abstract func find_by_body(p_body: Node3D) -> int
