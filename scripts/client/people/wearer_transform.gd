class_name WearerTransform
extends RefCounted
## Transform of this client's wearer in the world.

## Number of the person.
var actor: int = -1
## Transform of the wearer's own frame, in which samples are, in the world.
var frame: Transform3D = Transform3D.IDENTITY
## From the room that the wearer is in to that frame: where a stick has carried the wearer.
var travel: Transform3D = Transform3D.IDENTITY
## What a stick carries the wearer by now in the world, m/s.
var velocity: Vector3 = Vector3.ZERO
## What carries the person: its number, or -1, and its transform.
var carrier: int = -1
var carrier_frame: Transform3D = Transform3D.IDENTITY


## The room that the wearer is in, in the world.
func room() -> Transform3D:
	return frame * travel
