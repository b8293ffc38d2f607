@tool
@abstract class_name Armour
extends Node
## What something can bear that shells hit: a child of the body that is hit. Only the server
## decides.


## The armour of a body, or null.
static func find_in(p_body: Node) -> Armour:
	for child: Node in p_body.get_children():
		if child is Armour:
			return child
	return null


## A hit at a place, in the world: velocity of the shell (m/s), where it hit and the surface's
## normal there. Returns how much of what it needed the shell had.
@abstract func take_hit(
	p_ammunition: Ammunition, p_velocity: Vector3, p_place: Vector3, p_normal: Vector3
) -> float

## Fragments of a shell that burst near, which fly in a direction: they pierce what is thin.
@abstract
func take_fragments(p_ammunition: Ammunition, p_direction: Vector3, p_place: Vector3) -> void
