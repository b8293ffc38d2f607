class_name MotionSource
extends RefCounted
## Where a person's motion comes from: a file, a suit, a network stream. Sources derive from it.
##
## A source converts its own frame and units to Godot's, applies the calibration, and numbers its
## samples. Everything behind it sees only [PoseSample]s.

## Why there is no motion, or an empty text.
var error: String = ""

var _next_id: int = 0


## The pose at a moment (Unix time, µs), or null while there is none. A live source does not know
## what is not measured yet: it gives the pose of a moment shortly before, with that time, and null
## if there is nothing newer than it has given ([LivePoses]).
func sample(p_time_usec: int) -> PoseSample:
	var taken: PoseSample = _read(p_time_usec)
	if taken != null:
		taken.id = _next_id
		if taken.time_usec == 0:
			taken.time_usec = p_time_usec
		_next_id = (_next_id + 1) & 0xFFFFFFFF
	return taken


## Whether it asks the physics world, for rays or the ground, as only the main thread may. Then it
## is sampled in physics frames, not in the thread of the [MotionSampler].
func needs_world() -> bool:
	return false


## Whether the server needs the samples: not of those whom it moves itself.
func is_sent() -> bool:
	return true


## Height of the wearer's hips above the ground when standing, m.
func get_hip_height() -> float:
	return 0.95


## Lengths of the wearer's limbs, m, by index in [constant Limbs.BONES], 0 where it is not known;
## empty where none is. From a limb's joint to its end in [constant Limbs.TAILS], as in [member
## PersonCard.lengths]: the hand to the middle knuckle, the foot from ankle to ball, the head from
## its joint to the crown; hips, spine and chest count as one sum.
func get_limb_lengths() -> PackedFloat32Array:
	return PackedFloat32Array()


## The wearer's size.
func get_body() -> BodySize:
	return BodySize.of_hip_height(get_hip_height())


## One line for people: what the source is.
func describe() -> String:
	return "no motion"


## Reads the pose at a moment, or the newest one if [member PoseSample.time_usec] says of when it
## is. Sources override it.
func _read(_p_time_usec: int) -> PoseSample:
	return null
