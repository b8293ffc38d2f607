class_name CalibrationOptions
extends RefCounted
## How a calibration is begun, finds the wearer's facing, and which sensors share a north.

## How the wearer's facing is known.
enum Facing {
	## The arms' movement from T to N, or, where there is none, the calibration before this one.
	MOVEMENT,
	## The wearer faces the magnetic north.
	NORTH,
	## The wearer faces [member heading_deg].
	HEADING,
}

## Which way the sensors' own norths point.
enum Align {
	## How far they are apart is estimated, and each sensor's own with it.
	AUTO,
	## All have the same north, for certain: one heading for all.
	COMMON,
	## Nothing is known of them: each has what its movements tell, and a limb that did not move the
	## common heading.
	EACH,
}

## Names for people, by [enum Align].
const ALIGN_NAMES: PackedStringArray = ["as movements show", "one for all", "each its own"]
## Names for people, by [enum Facing].
const FACING_NAMES: PackedStringArray = ["from the arms' movement", "north", "compass heading"]

## How the wearer's facing is known.
var facing: Facing = Facing.MOVEMENT
## Compass heading of the wearer: degrees clockwise from north, for HEADING.
var heading_deg: float = 0.0
## Which north the sensors have.
var align: Align = Align.AUTO
## Time to get ready for the first pose, s; who is alone needs some to walk there.
var ready_s: float = CalibrationGuide.COUNTDOWN_S
## The pose that becomes the reference where both were held.
var pose: ResetPose.Kind = ResetPose.Kind.T


## The heading of the wearer that is given, rad about Godot's vertical, for NORTH and HEADING.
func given_heading() -> float:
	return -deg_to_rad(heading_deg) if facing == Facing.HEADING else 0.0
