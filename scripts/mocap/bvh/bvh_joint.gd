class_name BvhJoint
extends RefCounted
## One joint, or end site, of a BVH skeleton, as the file describes it.

## What one number in a row of the file moves.
enum Channel {
	## Position along the file's X axis, file units.
	X_POSITION,
	## Position along the file's Y axis, file units.
	Y_POSITION,
	## Position along the file's Z axis, file units.
	Z_POSITION,
	## Rotation about X, degrees.
	X_ROTATION,
	## Rotation about Y, degrees.
	Y_ROTATION,
	## Rotation about Z, degrees.
	Z_ROTATION,
	## Scale along X; read, kept and otherwise ignored.
	X_SCALE,
	## Scale along Y; read, kept and otherwise ignored.
	Y_SCALE,
	## Scale along Z; read, kept and otherwise ignored.
	Z_SCALE,
}

## The channels' names in the order of [enum Channel], as this project writes them.
const CHANNEL_NAMES: PackedStringArray = [
	"Xposition",
	"Yposition",
	"Zposition",
	"Xrotation",
	"Yrotation",
	"Zrotation",
	"Xscale",
	"Yscale",
	"Zscale",
]

## The joint's name; runs of spaces in it are one space. An end site seldom has one. Not unique in
## some files.
var name: String = ""
## Index of the joint it hangs on, always smaller than its own; -1 for the root.
var parent: int = -1
## Position in the parent's frame while nothing is rotated, file units and file axes.
var offset: Vector3 = Vector3.ZERO
## What its numbers move, in the file's order, each a [enum Channel].
var channels: PackedInt32Array = PackedInt32Array()
## Where its first number stands in a row.
var first_channel: int = 0
## Whether it only marks the end of its parent.
var is_end_site: bool = false


## The [enum Channel] of that name in any case, or -1.
static func channel_from(p_name: String) -> int:
	var wanted: String = p_name.to_lower()
	for channel: int in CHANNEL_NAMES.size():
		if CHANNEL_NAMES[channel].to_lower() == wanted:
			return channel
	return -1


## Whether a channel is a position.
static func is_position(p_channel: int) -> bool:
	return p_channel <= Channel.Z_POSITION


## Whether a channel is a rotation.
static func is_rotation(p_channel: int) -> bool:
	return p_channel >= Channel.X_ROTATION and p_channel <= Channel.Z_ROTATION
