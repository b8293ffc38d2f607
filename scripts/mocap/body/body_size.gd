class_name BodySize
extends RefCounted
## A person's size: height and lengths of limbs, measured or derived from the height.
##
## Lengths that were not measured follow from the height by the ratios of Drillis and Contini
## (1966), as printed in Winter's "Biomechanics and Motor Control of Human Movement".

## What can be measured, and its usual share of the height.
const RATIOS: Dictionary[StringName, float] = {
	&"hip_height": 0.530,
	&"trunk": 0.288,
	&"head": 0.182,
	&"shoulder_width": 0.259,
	&"hip_width": 0.191,
	&"upper_arm": 0.186,
	&"forearm": 0.146,
	&"hand": 0.108,
	&"thigh": 0.245,
	&"shank": 0.246,
	&"foot_height": 0.039,
	&"foot_length": 0.152,
}
## Explanation of each, for people who measure.
const HINTS: Dictionary[StringName, String] = {
	&"hip_height": "floor to the bone that sticks out at the side of the hip",
	&"trunk": "hip joint to shoulder joint",
	&"head": "shoulder joint to the top of the head",
	&"shoulder_width": "shoulder joint to shoulder joint",
	&"hip_width": "hip bone to hip bone, at the side",
	&"upper_arm": "shoulder joint to elbow",
	&"forearm": "elbow to wrist",
	&"hand": "wrist to the tip of the middle finger",
	&"thigh": "hip joint to knee",
	&"shank": "knee to ankle",
	&"foot_height": "ankle to floor",
	&"foot_length": "heel to toes",
}
## Height of the eyes, part of the person's own.
const EYE_HEIGHT: float = 0.936
## Smallest and largest height of a person, m.
const MIN_HEIGHT: float = 0.8
const MAX_HEIGHT: float = 2.5
## Height of somebody whose height is not given, m.
const USUAL_HEIGHT: float = 1.75
## Minimum and maximum of a measure, as multiples of what is usual for the height.
const MIN_PART: float = 0.5
const MAX_PART: float = 1.8

## Height, m.
var height: float = USUAL_HEIGHT:
	set(p_height):
		if p_height >= MIN_HEIGHT and p_height <= MAX_HEIGHT:
			height = p_height
## What was measured, m; the rest is usual for the height.
var measured: Dictionary[StringName, float] = {}


## The size of somebody of whom only the height is known, m.
static func of_height(p_height: float) -> BodySize:
	var size: BodySize = BodySize.new()
	size.height = p_height
	return size


## The size of somebody of whom only the height of the hips is known, m.
static func of_hip_height(p_hips: float) -> BodySize:
	var usual: float = RATIOS[&"hip_height"]
	return of_height(clampf(p_hips / usual, MIN_HEIGHT, MAX_HEIGHT))


## A measure of [constant RATIOS], m.
func length(p_name: StringName) -> float:
	return measured.get(p_name, RATIOS[p_name] * height)


## Sets a measure, m. Returns why not, or an empty text.
func measure(p_name: StringName, p_metres: float) -> String:
	if not RATIOS.has(p_name):
		return "there is no measure '%s', only %s" % [p_name, ", ".join(RATIOS.keys())]
	var usual: float = RATIOS[p_name] * height
	# A comparison that NaN fails, too.
	if not (p_metres >= usual * MIN_PART and p_metres <= usual * MAX_PART):
		var parts: Array = [p_name, usual * MIN_PART, usual * MAX_PART, height, p_metres]
		return "%s is between %.2f and %.2f m for a height of %.2f m, found %.2f m" % parts
	measured[p_name] = p_metres
	return ""


## Sets the height, m. Measures that no longer fit it are forgotten. Returns why not, or an empty
## text.
func set_height(p_metres: float) -> String:
	if not (p_metres >= MIN_HEIGHT and p_metres <= MAX_HEIGHT):
		var parts: Array = [MIN_HEIGHT, MAX_HEIGHT, p_metres]
		return "a person is between %.1f and %.1f m tall, found %.2f m" % parts
	height = p_metres
	var old: Dictionary[StringName, float] = measured
	measured = {}
	for name: StringName in old:
		measure(name, old[name])
	return ""


## A copy that can be changed.
func duplicate() -> BodySize:
	var size: BodySize = BodySize.of_height(height)
	size.measured = measured.duplicate()
	return size


## Length of a limb of [Limbs], m, from its joint to the next.
func limb_length(p_limb: int) -> float:
	match p_limb:
		0:
			return length(&"trunk") * 0.2
		1:
			return length(&"trunk") * 0.3
		2:
			return length(&"trunk") * 0.5
		3:
			return length(&"head")
		4, 7:
			return length(&"upper_arm")
		5, 8:
			return length(&"forearm")
		6, 9:
			return length(&"hand")
		10, 13:
			return length(&"thigh")
		11, 14:
			return length(&"shank")
	return length(&"foot_length")


## Lengths of arms and legs for a [PersonCard], m, 0 for all others: what is a trunk, a head, a hand
## differs from skeleton to skeleton. Empty for somebody whose size is not given.
func limb_lengths() -> PackedFloat32Array:
	var lengths: PackedFloat32Array = PackedFloat32Array()
	if measured.is_empty() and is_equal_approx(height, USUAL_HEIGHT):
		return lengths
	lengths.resize(Limbs.COUNT)
	for limb: int in Limbs.ARMS + Limbs.LEGS:
		lengths[limb] = limb_length(limb)
	return lengths


## Where each limb begins in the reset pose, m: facing +Z, the hips' middle above the origin, the
## soles at 0.
func joints() -> PackedVector3Array:
	var hips: float = length(&"hip_height")
	var shoulders: float = hips + length(&"trunk")
	var found: PackedVector3Array = PackedVector3Array()
	found.resize(Limbs.COUNT)
	found[Limbs.HIPS] = Vector3(0.0, hips, 0.0)
	found[Limbs.SPINE] = Vector3(0.0, hips + limb_length(Limbs.HIPS), 0.0)
	found[Limbs.CHEST] = found[Limbs.SPINE] + Vector3(0.0, limb_length(Limbs.SPINE), 0.0)
	found[Limbs.HEAD] = Vector3(0.0, shoulders + length(&"head") * 0.15, 0.0)
	for side: int in 2:
		var mirror: float = 1.0 - 2.0 * side
		var arm: int = 4 + 3 * side
		var reach: float = length(&"shoulder_width") / 2.0
		for part: int in 3:
			found[arm + part] = Vector3(mirror * reach, shoulders, 0.0)
			reach += limb_length(arm + part)
		var leg: int = 10 + 3 * side
		# The hip joints are nearer to each other than the bones at the side.
		var across: float = mirror * length(&"hip_width") * 0.5 * 0.9
		found[leg] = Vector3(across, hips, 0.0)
		var ankle: float = length(&"foot_height")
		var legs: float = length(&"thigh") + length(&"shank")
		var knee: float = ankle + (hips - ankle) * length(&"shank") / legs
		found[leg + 1] = Vector3(across, knee, 0.0)
		found[leg + 2] = Vector3(across, ankle, 0.0)
	return found


## Where each limb ends in the reset pose, m.
func tails() -> PackedVector3Array:
	var bases: PackedVector3Array = joints()
	var found: PackedVector3Array = bases.duplicate()
	for limb: int in [Limbs.HIPS, Limbs.SPINE] + Limbs.ARMS + Limbs.LEGS:
		found[limb] = bases[limb + 1]
	found[Limbs.CHEST] = Vector3(0.0, length(&"hip_height") + length(&"trunk"), 0.0)
	found[Limbs.HEAD] = Vector3(0.0, found[Limbs.CHEST].y + length(&"head"), 0.0)
	found[Limbs.LEFT_HAND] += Vector3.RIGHT * length(&"hand")
	found[Limbs.RIGHT_HAND] += Vector3.LEFT * length(&"hand")
	for foot: int in Limbs.FEET:
		found[foot] += Vector3(0.0, -length(&"foot_height") * 0.8, length(&"foot_length") * 0.7)
	return found


## For files.
func to_dictionary() -> Dictionary:
	var lengths: Dictionary = {}
	for name: StringName in measured:
		lengths[String(name)] = measured[name]
	return {"height_m": height, "measured_m": lengths}
