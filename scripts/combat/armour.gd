@tool
@abstract class_name Armour
extends Node
## What a body withstands when shells hit it: a child of that body. Only the server decides.


## The armour of a body, or null.
static func find_in(p_body: Node) -> Armour:
	for child: Node in p_body.get_children():
		if child is Armour:
			return child
	return null


## A hit: velocity of the shell (m/s), point (m) and surface normal there, in the world. Returns the
## shell's penetration as a share of what piercing needed.
@abstract func take_hit(
	p_ammunition: Ammunition, p_velocity: Vector3, p_place: Vector3, p_normal: Vector3
) -> float

## Fragments of a shell that burst near by fly in a direction: they pierce thin armour.
@abstract
func take_fragments(p_ammunition: Ammunition, p_direction: Vector3, p_place: Vector3) -> void
