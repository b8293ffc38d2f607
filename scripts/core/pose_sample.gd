class_name PoseSample
extends RefCounted
## One sample of a person: calibrated limb orientations, and where the root is.
##
## [member orientations] are rotations in the world from the reset pose (thesis section 6.1: the
## sample times the inverse of the reset pose), so that they suit a body of any build. Frame:
## Godot's, right-handed, Y up.

# Limits of a quaternion's norm, wide enough for all coding.
const _MIN_NORM: float = 0.9
const _MAX_NORM: float = 1.1
const _MAX_ROOT_M: float = 10000.0

## Which of its client's people it belongs to.
var person: int = 0
## Number of the sample at its source; grows by one and wraps at 2^32.
var id: int = 0
## When it was taken, microseconds of Unix time on the wearer's machine.
var time_usec: int = 0
## How long it was held before it was sent, µs; 0 where that is not known.
var held_usec: int = 0
## When it was sent, µs of the server's clock; 0 where that is not known.
var sent_usec: int = 0
## When it arrived at the server, µs of its clock.
var arrival_usec: int = 0
## 4 floats (x, y, z, w) for each of the [constant Limbs.COUNT] limbs.
var orientations: PackedFloat32Array = PackedFloat32Array()
## Position of the hips in the world, m, in the wearer's own size.
var root: Vector3 = Vector3.ZERO
## What else the source knows, or null. It is not sent.
var details: MotionDetails = null


## The rotation of one limb.
func orientation(p_limb: int) -> Quaternion:
	var at: int = p_limb * 4
	return Quaternion(
		orientations[at], orientations[at + 1], orientations[at + 2], orientations[at + 3]
	)


## Sets the rotation of one limb.
func set_orientation(p_limb: int, p_rotation: Quaternion) -> void:
	if orientations.size() != Limbs.COUNT * 4:
		orientations.resize(Limbs.COUNT * 4)
	var at: int = p_limb * 4
	orientations[at] = p_rotation.x
	orientations[at + 1] = p_rotation.y
	orientations[at + 2] = p_rotation.z
	orientations[at + 3] = p_rotation.w


## Turns all limbs in the world; the root stays.
func turn_limbs(p_turn: Quaternion) -> void:
	for limb: int in Limbs.COUNT:
		set_orientation(limb, p_turn * orientation(limb))


## Why this cannot be a pose, or an empty text if it can.
func find_fault() -> String:
	if orientations.size() != Limbs.COUNT * 4:
		return "%d floats instead of %d" % [orientations.size(), Limbs.COUNT * 4]
	var fault: String = find_root_fault()
	if fault != "":
		return fault
	for limb: int in Limbs.COUNT:
		var norm: float = orientation(limb).length()
		# A comparison that NaN fails, too.
		if not (norm > _MIN_NORM and norm < _MAX_NORM):
			return "%s has no rotation (norm %f)" % [Limbs.BONES[limb], norm]
	return ""


## Why the root cannot be one, or an empty text: all that there is to check of a pose whose
## rotations a decoder has made.
func find_root_fault() -> String:
	# A comparison that NaN fails, too.
	return "" if root.length() <= _MAX_ROOT_M else "the root is not within 10 km of the origin"
