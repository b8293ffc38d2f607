class_name BvhGuess
extends RefCounted
## Guesses what a BVH file does not say, the unit and the axis that points up, from the skeleton.
##
## A guess is always given with its reason, so that a person can see when it is wrong, and both can
## be given instead; see [BvhOptions]. The unit is the one that brings the largest extent of the
## rest pose nearest to a person's; the axis is Z where the skeleton is longer along Z than along Y,
## in the rest pose and over the clip together.

## What a rest pose usually spans, m: between a person's height and the arms' span.
const USUAL_SPAN: float = 1.7
## Maximum of frames that are looked at.
const MAX_FRAMES: int = 16


## Sets unit and up axis of a clip with their reasons: as given by the options, or else guessed.
static func settle(p_clip: BvhClip, p_options: BvhOptions) -> void:
	if p_options.up_axis == BvhOptions.UpAxis.GUESS:
		_guess_up(p_clip)
	else:
		p_clip.up_axis = p_options.up_axis
		p_clip.up_reason = "as given"
	if p_options.unit_metres > 0.0:
		p_clip.unit_metres = p_options.unit_metres
		p_clip.unit_reason = "as given"
	else:
		_guess_unit(p_clip)


static func _guess_unit(p_clip: BvhClip) -> void:
	var kinematics: BvhKinematics = BvhKinematics.new(p_clip.joints, false)
	kinematics.rest()
	var extent: Vector3 = _extent(kinematics)
	var span: float = maxf(extent.x, maxf(extent.y, extent.z))
	if span <= 0.0:
		p_clip.unit_metres = BvhOptions.UNITS["cm"]
		p_clip.unit_reason = "guess: the skeleton has no size, and this unit is the most common"
		return
	var best: String = "cm"
	for unit: String in BvhOptions.UNITS:
		if _misfit(span, unit) < _misfit(span, best):
			best = unit
	p_clip.unit_metres = BvhOptions.UNITS[best]
	p_clip.unit_reason = (
		"guess: the rest pose spans %s units, so %.2f m, of all units the nearest to %.1f m"
		% [String.num(span, 3), span * p_clip.unit_metres, USUAL_SPAN]
	)


static func _misfit(p_span: float, p_unit: String) -> float:
	return absf(log(p_span * BvhOptions.UNITS[p_unit] / USUAL_SPAN))


static func _guess_up(p_clip: BvhClip) -> void:
	var kinematics: BvhKinematics = BvhKinematics.new(p_clip.joints, p_clip.positions_add_offset)
	kinematics.rest()
	var extent: Vector3 = _extent(kinematics)
	var count: int = mini(p_clip.frame_count, MAX_FRAMES)
	var posed: Vector3 = Vector3.ZERO
	for index: int in count:
		var frame: int = index * p_clip.frame_count / count
		kinematics.solve(p_clip.values, frame * p_clip.channel_count)
		posed += _extent(kinematics) / count
	extent = (extent + posed) * (0.5 if count > 0 else 1.0)
	var is_z: bool = extent.z > extent.y
	p_clip.up_axis = BvhOptions.UpAxis.Z if is_z else BvhOptions.UpAxis.Y
	p_clip.up_reason = (
		"guess: the skeleton is %s units long along Y and %s along Z"
		% [String.num(extent.y, 3), String.num(extent.z, 3)]
	)


static func _extent(p_kinematics: BvhKinematics) -> Vector3:
	var positions: PackedVector3Array = p_kinematics.positions()
	var low: Vector3 = positions[0]
	var high: Vector3 = positions[0]
	for position: Vector3 in positions:
		low = low.min(position)
		high = high.max(position)
	return high - low
