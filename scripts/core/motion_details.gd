class_name MotionDetails
extends RefCounted
## What a source knows about a moment besides the limbs' rotations. All of it is optional.

## What may be known about a foot.
enum Contact {
	## The source does not know.
	UNKNOWN,
	## The foot is off the ground.
	OFF,
	## The foot stands.
	ON,
}

## The device's own count of its samples, or -1.
var counter: int = -1
## Rates of turn of the limbs in the world, rad/s, by [Limbs]; empty if not known.
var rates: PackedVector3Array = PackedVector3Array()
## Where the limbs begin in the world, m, by [Limbs]; empty if not known.
var positions: PackedVector3Array = PackedVector3Array()
## Of the left and the right foot.
var contacts: Array[Contact] = [Contact.UNKNOWN, Contact.UNKNOWN]
## Rotations from the reset pose of joints that are no limb of their own, by
## [enum XRBodyTracker.Joint]: shoulders, neck, toes, fingers.
var joints: Dictionary[int, Quaternion] = {}
## Which limbs were measured and not filled from their neighbours: 1 or 0, by [Limbs]; empty if all
## were.
var measured: PackedByteArray = PackedByteArray()


## Whether the rates of all limbs were measured.
func knows_all_rates() -> bool:
	return rates.size() == Limbs.COUNT and not measured.has(0)
