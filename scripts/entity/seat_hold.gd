class_name SeatHold
extends RefCounted
## How a seat holds a person: the room of the hips, the forces that keep them in it, the pose of the
## legs, and what of the body collides with the vehicle. See [method Seat.hold].

## Pose of the legs, whatever the wearer does: the vehicle has no room for more.
enum Legs {
	## They follow the wearer's.
	FREE,
	## They stand below the hips, bent as far as the hips are low.
	STANDING,
	## They are bent as on a chair.
	SITTING,
}

## What the legs do.
var legs: Legs = Legs.FREE
## Whether the arms rest, whatever the wearer does: for seats where arms cannot be seen and have no
## room.
var rests_arms: bool = false
## How far the hips may move from the middle to each side, m.
var room: float = 0.1
## Lowest and highest position of the hips above the seat's origin, m.
var lowest: float = 0.0
## See [member lowest].
var highest: float = 0.0
## Greatest force that carries the hips upwards, N.
var support_force: float = 3000.0
## Greatest force that keeps them from flying up, N.
var down_force: float = 500.0
## Greatest force to each side, N.
var side_force: float = 3000.0
## Whether trunk, head and arms collide with what the seat is part of; hips and legs never do.
var meets_vehicle: bool = false
## Whether the person collides with nothing else either.
var is_enclosed: bool = false
## Height of the roof above the seat's origin, and radius of the hatch in it, m: arms stay above the
## roof or within the hatch. A radius of 0 means that there is no roof.
var rim: float = 0.0
## See [member rim].
var hatch_radius: float = 0.0
## Height above the roof of what stands around the hatch, m: arms stay above that, too.
var cupola: float = 0.0
