@tool
class_name BodyScale
extends RefCounted
## By how much each limb of a [Ragdoll] is longer than in its scene, so that it has a person's size.
##
## A limb's length goes from its joint to where [constant Limbs.TAILS] has its end: that of a hand
## to the knuckle of the middle finger, that of a foot from the ankle to the ball, that of the head
## from its joint to the crown. The trunk (hips, spine, chest) is scaled as a whole by the sum of
## what is known of it: skeletons do not agree on where in the back its joints are.

## Minimum and maximum factor of a limb's length.
const MIN: float = 0.5
const MAX: float = 1.8
## Factors nearer to 1 change nothing.
const TOLERANCE: float = 1e-4

## The limb that goes on where a limb ends, -1 for hands, feet and head.
const NEXT: Array[int] = [1, 2, 3, -1, 5, 6, -1, 8, 9, -1, 11, 12, -1, 14, 15, -1]

const _TRUNK: Array[int] = [Limbs.HIPS, Limbs.SPINE, Limbs.CHEST]

## Factor of each limb's length, in the order of [constant Limbs.BONES].
var along: PackedFloat32Array = PackedFloat32Array()
## Factor of everything across the limbs: thicknesses, width of hips and shoulders.
var across: float = 1.0
## How much taller the person is.
var height: float = 1.0


func _init() -> void:
	along.resize(Limbs.COUNT)
	along.fill(1.0)


## Whether nothing changes.
func is_none() -> bool:
	for factor: float in along:
		if absf(factor - 1.0) > TOLERANCE:
			return false
	return absf(across - 1.0) <= TOLERANCE


## Whether a limb keeps its shape: head, hands and feet, which are scaled in all directions alike.
static func is_uniform(p_limb: int) -> bool:
	return NEXT[p_limb] < 0


## By how much a limb's volume grows.
func volume(p_limb: int) -> float:
	var thick: float = along[p_limb] if is_uniform(p_limb) else across
	return along[p_limb] * thick * thick


## The lengths of a ragdoll's limbs, m, in the order of [constant Limbs.BONES].
static func own_lengths(p_ragdoll: RagdollFigure) -> PackedFloat32Array:
	var figure: RestSkeleton = RestSkeleton.new(p_ragdoll.get_skeleton())
	var lengths: PackedFloat32Array = []
	for limb: int in Limbs.COUNT:
		var length: float = figure.direction(limb).length()
		var shape: RagdollLimb = p_ragdoll.profile.find(Limbs.BONES[limb])
		if length < 0.001 and shape != null:
			var half: float = shape.length / 2.0 + shape.radius
			if shape.type == RagdollLimb.BOX:
				half = shape.size.y / 2.0
			length = (shape.position - shape.anchor).length() + half
		lengths.append(length)
	return lengths


## The scale that gives a ragdoll these lengths, m; 0 where unknown. An unknown limb follows the
## other side, unknown legs follow the height of the hips (m, 0: unknown), others the mean of what
## is known. Nothing known changes nothing. What is out of bounds is limited, with a warning.
static func of_lengths(
	p_ragdoll: RagdollFigure, p_lengths: PackedFloat32Array, p_hip_height: float = 0.0
) -> BodyScale:
	var scale: BodyScale = BodyScale.new()
	var own: PackedFloat32Array = own_lengths(p_ragdoll)
	var given: PackedFloat32Array = scale._known(p_lengths, own)
	if given.count(0.0) == Limbs.COUNT:
		return scale
	scale._limit(given, p_ragdoll.name)
	if _is_length(p_hip_height):
		for limb: int in Limbs.LEGS:
			if given[limb] == 0.0:
				given[limb] = clampf(p_hip_height / p_ragdoll.get_hip_height(), MIN, MAX)
	scale.across = _mean(given, own)
	for limb: int in Limbs.COUNT:
		scale.along[limb] = given[limb] if given[limb] > 0.0 else scale.across
	scale._measure_height(own)
	return scale


## The scale that makes one body's joints out of another's: those of a ragdoll as it is, and those
## that a server sends of one that has been scaled.
static func between(p_own: PersonSkeleton, p_given: PersonSkeleton) -> BodyScale:
	var scale: BodyScale = BodyScale.new()
	if p_own == null or p_given == null or not p_own.is_sound() or not p_given.is_sound():
		return scale
	var lengths: PackedFloat32Array = []
	for limb: int in Limbs.COUNT:
		lengths.append(_reach(p_own, limb))
		scale.along[limb] = _ratio(_reach(p_given, limb), lengths[limb])
	scale.across = _ratio(_hip_width(p_given), _hip_width(p_own))
	scale._measure_height(lengths)
	return scale


## Factors of the lengths that are given, 0 where none is.
func _known(p_lengths: PackedFloat32Array, p_own: PackedFloat32Array) -> PackedFloat32Array:
	var given: PackedFloat32Array = []
	given.resize(Limbs.COUNT)
	if p_lengths.size() != Limbs.COUNT:
		return given
	for limb: int in Limbs.COUNT:
		if _is_length(p_lengths[limb]) and p_own[limb] > 0.001:
			given[limb] = p_lengths[limb] / p_own[limb]
	for limb: int in Limbs.COUNT:
		var other: int = MeshShapes.mirrored(limb)
		if given[limb] == 0.0 and given[other] > 0.0:
			given[limb] = given[other]
	var sums: Vector2 = Vector2.ZERO
	for limb: int in _TRUNK:
		if given[limb] > 0.0:
			sums += Vector2(given[limb] * p_own[limb], p_own[limb])
	for limb: int in _TRUNK:
		given[limb] = sums.x / sums.y if sums.y > 0.0 else 0.0
	return given


func _limit(r_given: PackedFloat32Array, p_name: String) -> void:
	var limited: PackedStringArray = []
	for limb: int in Limbs.COUNT:
		if r_given[limb] == 0.0:
			continue
		if r_given[limb] < MIN - TOLERANCE or r_given[limb] > MAX + TOLERANCE:
			limited.append("%s %.2f" % [Limbs.BONES[limb], r_given[limb]])
		r_given[limb] = clampf(r_given[limb], MIN, MAX)
	if not limited.is_empty():
		var text: String = "%s: limbs may be %.1f to %.1f times as long as the body's own, found %s"
		var parts: Array = [p_name, MIN, MAX, ", ".join(limited)]
		Log.limited("actor", "size", text % parts)


## The mean factor of trunk, arms and legs, by their lengths; 1 where none is known.
static func _mean(p_given: PackedFloat32Array, p_own: PackedFloat32Array) -> float:
	var sums: Vector2 = Vector2.ZERO
	for limb: int in Limbs.COUNT:
		if p_given[limb] > 0.0 and not is_uniform(limb):
			sums += Vector2(p_given[limb] * p_own[limb], p_own[limb])
	return sums.x / sums.y if sums.y > 0.0 else 1.0


## From the soles to the crown: feet, legs, trunk and head; the legs' mean.
func _measure_height(p_own: PackedFloat32Array) -> void:
	var sums: Vector2 = Vector2.ZERO
	for limb: int in Limbs.COUNT:
		if limb <= Limbs.HEAD or Limbs.LEGS.has(limb):
			var length: float = p_own[limb] * (0.5 if limb > 3 else 1.0)
			sums += Vector2(along[limb] * length, length)
	height = sums.x / sums.y if sums.y > 0.0 else 1.0


## From a limb's joint to the next one, or to the middle of the body of a limb that has none, m.
static func _reach(p_joints: PersonSkeleton, p_limb: int) -> float:
	if is_uniform(p_limb):
		return p_joints.joints_in_limb[p_limb].length()
	var end: Vector3 = p_joints.joints_in_parent[NEXT[p_limb]]
	return end.distance_to(p_joints.joints_in_limb[p_limb])


static func _hip_width(p_joints: PersonSkeleton) -> float:
	return p_joints.joints_in_parent[Limbs.LEFT_UPPER_LEG].distance_to(
		p_joints.joints_in_parent[Limbs.RIGHT_UPPER_LEG]
	)


static func _ratio(p_given: float, p_own: float) -> float:
	return clampf(p_given / p_own, MIN, MAX) if p_own > 0.001 else 1.0


static func _is_length(p_metres: float) -> bool:
	# A comparison that NaN fails, too.
	return p_metres > 0.0 and p_metres < INF
