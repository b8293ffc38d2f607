class_name JointRange
extends RefCounted
## How far joints of people go, to recognise what cannot be: generous, so that no healthy person is
## ever reported as impossible.

## For mounts whose joint with the mount above ([constant BodyMounts.PARENTS]) is judged: minimum
## and maximum of the rotation vector, degrees, of the left side or the middle, in the axes of the
## reset pose. The right side mirrors it.
const _RANGES: Dictionary[int, Array] = {
	1: [Vector3(-60, -75, -60), Vector3(110, 75, 60)],
	2: [Vector3(-90, -100, -75), Vector3(90, 100, 75)],
	3: [Vector3(-50, -60, -60), Vector3(50, 60, 60)],
	5: [Vector3(-120, -155, -60), Vector3(120, 25, 60)],
	6: [Vector3(-80, -70, -100), Vector3(80, 70, 100)],
	11: [Vector3(-130, -70, -60), Vector3(60, 70, 90)],
	12: [Vector3(-18, -60, -35), Vector3(150, 60, 35)],
	13: [Vector3(-60, -60, -50), Vector3(75, 60, 50)],
}


## Whether the joint above a mount is judged.
static func knows(p_mount: int) -> bool:
	return _RANGES.has(p_mount) or _RANGES.has(BodyMounts.MIRRORS[p_mount])


## By how much a joint is beyond its range, rad: of a mount against the one above it.
static func excess(p_mount: int, p_above: Quaternion, p_rotation: Quaternion) -> float:
	var turn: Vector3 = Rotations.vector(p_above.inverse() * p_rotation) * (180.0 / PI)
	var mount: int = p_mount
	if BodyMounts.side(p_mount) < 0:
		mount = BodyMounts.MIRRORS[p_mount]
		turn = Vector3(turn.x, -turn.y, -turn.z)
	if not _RANGES.has(mount):
		return 0.0
	var least: Vector3 = _RANGES[mount][0]
	var most: Vector3 = _RANGES[mount][1]
	return deg_to_rad((turn - turn.clamp(least, most)).length())
