@tool
class_name RagdollDescription
extends Resource
## What a ragdoll is made of: its limbs with shapes, joints and masses (thesis section 6.2).

## The limbs, parents before children, the root first.
@export var limbs: Array[LimbShape] = []
## Mass of the whole body.
@export_range(1.0, 300.0, 0.1, "suffix:kg") var mass: float = 80.0


## The limb that moves a bone, or null.
func find(p_bone: StringName) -> LimbShape:
	for limb: LimbShape in limbs:
		if limb.bone == p_bone:
			return limb
	return null


## Why this cannot be a ragdoll, or an empty text if it can.
func find_fault() -> String:
	if limbs.is_empty():
		return "there are no limbs"
	var seen: Array[StringName] = []
	var total: float = 0.0
	for limb: LimbShape in limbs:
		var fault: String = limb.find_fault()
		if fault != "":
			return fault
		if seen.has(limb.bone):
			return "%s is there twice" % limb.bone
		if seen.is_empty() != (limb.parent_bone == &""):
			return "%s: the first limb, and only the first, must be without a parent" % limb.bone
		if limb.parent_bone != &"" and not seen.has(limb.parent_bone):
			return "%s comes before its parent %s" % [limb.bone, limb.parent_bone]
		seen.append(limb.bone)
		total += limb.mass_fraction
	if absf(total - 1.0) > 0.01:
		return "the mass fractions add up to %f instead of 1" % total
	return ""
