@tool
class_name SeatGeometry
extends Interactable
## Where a seat is, how it holds who sits there, and the ways in and out.
##
## It may move in its body, as below a turret: who sits there goes with it. The occupant faces its
## +Z. Scripts of special seats, which extend [Seat], override [method hold],
## [method frame_in_body] and the ways in and out.

## Which of the entity's seats it is. The first one, 0, possesses the entity.
@export_range(0, 31) var index: int = 0
## Whether the occupant's people are carried along. If not, they stay where they are, and the
## session only commands from there.
@export var carries_people: bool = true


## Where the seat is in the frame of the entity's body, m, turned as the occupant is to face: +Z.
func frame_in_body() -> Transform3D:
	# Node by node: the body's own transform in the tree may be a tick old, its parts' are not.
	var frame: Transform3D = transform
	var node: Node3D = get_parent_node_3d()
	while node != null and node != entity.get_body():
		frame = node.transform * frame
		node = node.get_parent_node_3d()
	return frame.orthonormalized()


## How the occupant's body is held; null: it is not, only its motion goes with the seat.
func hold() -> SeatHold:
	return null


## The path of the feet from a position to [method mouth]: points in the body's frame, m. Empty: the
## occupant is put into the seat at once.
func way_in(_from: Vector3) -> PackedVector3Array:
	return PackedVector3Array()


## The path of the feet from [method mouth] to a free position. [param p_is_free] takes a point in
## the body's frame. Empty: the occupant stays where the seat is.
func way_out(_is_free: Callable) -> PackedVector3Array:
	return PackedVector3Array()


## Position of the feet before they go down into the seat, m, in the body's frame.
func mouth() -> Vector3:
	return frame_in_body().origin


## Bodies besides the entity's that whoever climbs must not push, such as wheels.
func neighbours() -> Array[RID]:
	return []


## Why an occupant with a body cannot leave now, for people; empty: it can be left.
func find_hindrance() -> String:
	return ""
