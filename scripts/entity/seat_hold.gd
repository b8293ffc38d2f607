class_name SeatHold
extends RefCounted
## How a seat holds a person: where the hips may be, with which forces they are held there, what the
## legs do, and what of the body meets the vehicle. See [method Seat.hold].

## What the legs do, whatever the wearer's own do: there is no room for those.
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
## Whether the arms rest, whatever the wearer's own do: nobody sees them, and there is no room.
var rests_arms: bool = false
## How far the hips may be from the middle, to the sides, m.
var room: float = 0.1
## Lowest and highest place of the hips above the seat's origin, m.
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
## Whether nothing else can touch the person either.
var is_enclosed: bool = false
## Height of the roof above the seat's origin, and the radius of the hatch in it, m: arms stay above
## the one or within the other. A radius of 0: there is no roof.
var rim: float = 0.0
## See [member rim].
var hatch_radius: float = 0.0
## How high what stands around the hatch is above the roof, m: arms stay above that, too.
var cupola: float = 0.0
