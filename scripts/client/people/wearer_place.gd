class_name WearerPlace
extends RefCounted
## Where the wearer of this client is in the world.

## The person.
var actor: int = -1
## Where the wearer's own frame, in which samples are, lies in the world.
var frame: Transform3D = Transform3D.IDENTITY
## What carries the person: its number, or -1, and where it is.
var carrier: int = -1
var carrier_frame: Transform3D = Transform3D.IDENTITY
