class_name CameraView
extends RefCounted
## How a camera sees a person: how far away he is, and how far the camera looks down. Both are found
## from the person, who is about as large as people are, and mostly upright.

## A camera on a desk or a screen looks down by about this much, and is off by this, degrees.
const USUAL_TILT_DEG: float = 5.0
const TILT_SPREAD_DEG: float = 8.0
## How far a straight body is off the vertical at any moment, degrees.
const LEAN_SPREAD_DEG: float = 5.0
## Bend of the body at hips and knees at which it says little about the vertical, degrees.
const BEND_DEG: float = 12.0
## Straight moments that count at most, s: the camera may be moved.
const MEMORY_S: float = 20.0
## How well points must be seen to say where somebody is.
const MIN_SEEN: float = 0.5
## Nobody is nearer or further than this, m.
const NEAREST_M: float = 0.4
const FURTHEST_M: float = 30.0

## How far the camera looks down, rad.
var tilt: float = deg_to_rad(USUAL_TILT_DEG)

var _weight_s: float = 0.0
var _mean: float = 0.0


## Where the hips' middle is from the camera, m, by points in the world and the rays to them;
## [constant Vector3.INF] where too few are seen.
static func place(
	p_places: PackedVector3Array, p_rays: PackedVector3Array, p_seen: PackedFloat32Array
) -> Vector3:
	# Each point at p, with the hips at t, is on its ray: p.x + t.x = -u (p.z + t.z). Least squares
	# of this is linear in t.
	var sums: Array[float] = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
	for point: int in p_places.size():
		if p_seen[point] < MIN_SEEN:
			continue
		var weight: float = p_seen[point]
		var u: float = p_rays[point].x
		var v: float = p_rays[point].y
		var right: float = -u * p_places[point].z - p_places[point].x
		var up: float = -v * p_places[point].z - p_places[point].y
		var terms: Array[float] = [1.0, u, v, u * u + v * v, right, up, u * right + v * up]
		for term: int in sums.size():
			sums[term] += weight * terms[term]
	if sums[0] < 3.0:
		return Vector3.INF
	# t.x + u t.z = right and t.y + v t.z = up: t.x and t.y are taken out.
	var spread: float = sums[3] - (sums[1] * sums[1] + sums[2] * sums[2]) / sums[0]
	if spread < 1e-6:
		return Vector3.INF
	var deep: float = sums[6] - (sums[1] * sums[4] + sums[2] * sums[5]) / sums[0]
	deep = clampf(deep / spread, -FURTHEST_M, -NEAREST_M)
	return Vector3((sums[4] - sums[1] * deep) / sums[0], (sums[5] - sums[2] * deep) / sums[0], deep)


## Learns from a moment of a length, s, which way is up: [param p_trunk] and [param p_legs] point up
## along them, [param p_knees] is how far the knees are bent, rad.
func learn_up(p_trunk: Vector3, p_legs: Vector3, p_knees: float, p_step_s: float) -> void:
	var bend: float = rad_to_deg(p_trunk.angle_to(p_legs) + p_knees) / BEND_DEG
	var weight: float = exp(-bend * bend) * clampf(p_step_s, 0.0, 0.1)
	var up: Vector3 = p_trunk.normalized() + p_legs.normalized()
	var lean: float = atan2(up.z, up.y)
	if absf(lean) > 1.0:
		return
	_weight_s = minf(_weight_s + weight, MEMORY_S)
	_mean += (lean - _mean) * weight / maxf(_weight_s, 1e-6)
	# A second of straight moments says as much as one can.
	var known: float = minf(_weight_s, 1.0)
	var trust: float = TILT_SPREAD_DEG * TILT_SPREAD_DEG * known
	trust /= trust + LEAN_SPREAD_DEG * LEAN_SPREAD_DEG
	tilt = lerpf(deg_to_rad(USUAL_TILT_DEG), _mean, trust)


## Turns what the camera sees to where up is up.
func level() -> Basis:
	return Basis(Vector3.RIGHT, -tilt)
