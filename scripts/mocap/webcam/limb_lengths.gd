class_name LimbLengths
extends RefCounted
## Keeps the lengths of a person's forearms and shanks, which the model foreshortens: what a picture
## shows of a limb is never longer than the limb, so the longest that it shows is the length.

## Limbs whose lengths are kept: the landmarks at their ends, and their usual share of the trunk,
## from the hips' middle to the shoulders'.
const LIMBS: Dictionary[Vector2i, float] = {
	Vector2i(LandmarkPose.ELBOW, LandmarkPose.WRIST): 0.52,
	Vector2i(LandmarkPose.KNEE, LandmarkPose.ANKLE): 0.86,
}
## What moves with the far ends of limbs.
const BEYOND: Dictionary[int, Vector2i] = {
	LandmarkPose.WRIST: Vector2i(LandmarkPose.PINKY, LandmarkPose.INDEX),
	LandmarkPose.ANKLE: Vector2i(LandmarkPose.HEEL, LandmarkPose.TOE),
}
## How fast a length grows to what is seen, and falls back, 1/s.
const GROWTH: float = 4.0
const DECAY: float = 0.02
## How far it may be from the usual, as a share.
const LEAST: float = 0.85
const MOST: float = 1.2
## Errors of a limb across the view and along it, m: what is less sure gives way.
const ACROSS_M: float = 0.025
const ALONG_M: float = 0.07
const MIN_SEEN: float = 0.6

var _trunk_m: float = 0.5
var _lengths: Dictionary[Vector2i, float] = {}


## Learns from points that are where the picture shows them, during a time, s.
func learn(p_places: PackedVector3Array, p_seen: PackedFloat32Array, p_step_s: float) -> void:
	var hips: Vector3 = p_places[LandmarkPose.HIP] + p_places[LandmarkPose.HIP + 1]
	var neck: Vector3 = p_places[LandmarkPose.SHOULDER] + p_places[LandmarkPose.SHOULDER + 1]
	var trunk: float = (neck - hips).length() / 2.0
	_trunk_m = lerpf(_trunk_m, maxf(trunk, _trunk_m * 0.9), minf(p_step_s, 1.0))
	for limb: Vector2i in LIMBS:
		var usual: float = LIMBS[limb] * _trunk_m
		var length: float = _lengths.get(limb, usual)
		for side: int in 2:
			if minf(p_seen[limb.x + side], p_seen[limb.y + side]) < MIN_SEEN:
				continue
			var seen: Vector3 = p_places[limb.y + side] - p_places[limb.x + side]
			var across: float = Vector2(seen.x, seen.y).length()
			var rate: float = GROWTH if across > length else DECAY
			length = lerpf(length, across, minf(rate * p_step_s, 1.0))
		_lengths[limb] = clampf(length, usual * LEAST, usual * MOST)


## The length of a limb, m.
func of(p_limb: Vector2i) -> float:
	return _lengths.get(p_limb, LIMBS[p_limb] * _trunk_m)


## Moves the far ends of limbs so that they are as long as they are, mostly along the view.
func keep(r_places: PackedVector3Array, p_seen: PackedFloat32Array) -> void:
	for limb: Vector2i in LIMBS:
		for side: int in 2:
			if p_seen[limb.y + side] < 0.2:
				continue
			var start: Vector3 = r_places[limb.x + side]
			var along: Vector3 = r_places[limb.y + side] - start
			var change: Vector3 = _stretched(along, of(limb)) - along
			r_places[limb.y + side] += change
			r_places[BEYOND[limb.y].x + side] += change
			r_places[BEYOND[limb.y].y + side] += change


## The vector of a length that is nearest to another one, by how sure it is across and along.
static func _stretched(p_vector: Vector3, p_length: float) -> Vector3:
	var ratio: float = ACROSS_M * ACROSS_M / (ALONG_M * ALONG_M)
	var scale: Vector3 = Vector3(ratio, ratio, 1.0)
	# v / (1 + k s) for the k that gives the length: longer by less than 0, shorter by more.
	var low: float = -0.98
	var high: float = 40.0
	if (p_vector / (Vector3.ONE + scale * low)).length() < p_length:
		var flat: float = Vector2(p_vector.x, p_vector.y).length()
		var deep: float = sqrt(maxf(p_length * p_length - flat * flat, 0.0))
		return Vector3(p_vector.x, p_vector.y, deep if p_vector.z >= 0.0 else -deep)
	for _step: int in 24:
		var middle: float = (low + high) / 2.0
		if (p_vector / (Vector3.ONE + scale * middle)).length() > p_length:
			low = middle
		else:
			high = middle
	return p_vector / (Vector3.ONE + scale * low)
