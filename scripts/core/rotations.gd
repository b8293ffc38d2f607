class_name Rotations
extends RefCounted
## Functions of rotations for calibration, exact for small angles too.
##
## [method Quaternion.angle_to] goes by an arc cosine, which in single precision cannot distinguish
## angles below 0.04 degrees.


## The angle of a rotation, rad, 0 to PI.
static func angle(p_rotation: Quaternion) -> float:
	var along: float = Vector3(p_rotation.x, p_rotation.y, p_rotation.z).length()
	return 2.0 * atan2(along, absf(p_rotation.w))


## The angle between two rotations, rad, 0 to PI.
static func between(p_first: Quaternion, p_second: Quaternion) -> float:
	return angle(p_first.inverse() * p_second)


## The angle between two rotations, degrees.
static func between_deg(p_first: Quaternion, p_second: Quaternion) -> float:
	return rad_to_deg(between(p_first, p_second))


## A rotation as a vector: along its axis, as long as its angle, rad.
static func vector(p_rotation: Quaternion) -> Vector3:
	var along: Vector3 = Vector3(p_rotation.x, p_rotation.y, p_rotation.z)
	var length: float = along.length()
	if length < 1e-9:
		return along * 2.0
	var half: float = atan2(length, p_rotation.w)
	if half > PI / 2.0:
		half -= PI
	return along * (2.0 * half / length)


## The rotation that is a vector's; see [method vector].
static func from_vector(p_vector: Vector3) -> Quaternion:
	var length: float = p_vector.length()
	if length < 1e-9:
		return Quaternion(p_vector.x / 2.0, p_vector.y / 2.0, p_vector.z / 2.0, 1.0).normalized()
	return Quaternion(p_vector / length, length)


## Rotation about the vertical by an angle, rad.
static func yaw(p_angle: float) -> Quaternion:
	return Quaternion(Vector3.UP, p_angle)


## How far a rotation turns about the vertical, rad, the rest being a tilt (swing and twist).
static func yaw_of(p_rotation: Quaternion) -> float:
	if p_rotation.y * p_rotation.y + p_rotation.w * p_rotation.w < 1e-12:
		return 0.0
	return wrapf(2.0 * atan2(p_rotation.y, p_rotation.w), -PI, PI)


## Which way a rotation that is known only about the vertical faces: the angle from +Z of where +Z
## goes, rad.
static func facing_of(p_rotation: Quaternion) -> float:
	var ahead: Vector3 = p_rotation * Vector3.BACK
	return atan2(ahead.x, ahead.z)


## The mean of rotations, weights given or all alike. Those that are far off count less (iterated
## weights by the distance, [param p_robust_rad] is where a weight has halved; 0: all alike).
static func mean(p_rotations: Array[Quaternion], p_robust_rad: float = 0.0) -> Quaternion:
	if p_rotations.is_empty():
		return Quaternion.IDENTITY
	var found: Quaternion = _middle_most(p_rotations)
	for _round: int in 8:
		var sum: Vector3 = Vector3.ZERO
		var weights: float = 0.0
		for rotation: Quaternion in p_rotations:
			var off: Vector3 = vector(found.inverse() * rotation)
			var weight: float = 1.0
			if p_robust_rad > 0.0:
				weight = 1.0 / (1.0 + off.length_squared() / (p_robust_rad * p_robust_rad))
			sum += off * weight
			weights += weight
		var step: Vector3 = sum / weights
		found = (found * from_vector(step)).normalized()
		if step.length() < 2e-6:
			break
	return found


## A start value for the mean that is no outlier: of a few, the one that is nearest to the others.
static func _middle_most(p_rotations: Array[Quaternion]) -> Quaternion:
	var few: Array[Quaternion] = []
	for at: int in range(0, p_rotations.size(), maxi(p_rotations.size() / 12, 1)):
		few.append(p_rotations[at])
	var best: Quaternion = few[0]
	var best_sum: float = INF
	for rotation: Quaternion in few:
		var sum: float = 0.0
		for other: Quaternion in few:
			sum += between(rotation, other)
		if sum < best_sum:
			best_sum = sum
			best = rotation
	return best
