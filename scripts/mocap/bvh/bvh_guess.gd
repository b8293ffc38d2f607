class_name BvhGuess
extends RefCounted
## Guesses what a BVH file does not say, the unit and the axis that points up, from the body in it
## and its motion.
##
## A guess is always given with its reason, so that a person can see when it is wrong, and both can
## be given instead; see [BvhOptions]. Up is where trunk and legs point over the clip and in the
## rest pose, and where the floor keeps still ([BvhAnatomy]). The unit is the one that gives the
## legs the length of an adult's; where none does, the person is scaled to an adult. Where no person
## is found in the file, the size of the whole skeleton must do.

## What a rest pose usually spans, m: between a person's height and the arms' span.
const USUAL_SPAN: float = 1.7
## Thigh and shank of an adult, m (de Leva 1996, males: 0.4222 + 0.4340).
const USUAL_LEG: float = 0.856
## Shortest and longest legs of an adult, m: statures of 1.32 to 2.24 m by Drillis and Contini's
## ratio ([constant BodySize.RATIOS]).
const MIN_LEG: float = 0.65
const MAX_LEG: float = 1.1
## Shortest legs of somebody small, a child of 1.1 m or a cartoon, m, in a unit that is so common,
## and so far from the others, that a small person is believed in it.
const MIN_SMALL_LEG: float = 0.54
## Shortest and tallest person, m.
const MIN_STATURE: float = 1.0
const MAX_STATURE: float = 2.3
## Height of a man, by thigh and shank (see [constant BodySize.RATIOS]), m.
const USUAL_STATURE: float = 1.743
## Height by legs and trunk of the smallest figure with short legs, m.
const MIN_SMALL_STATURE: float = 0.7

## These units.
const _PLAIN: PackedStringArray = ["m", "cm", "mm"]
## Maximum of frames that are looked at where there is no person.
const _MAX_FRAMES: int = 16
## How much each sign of an axis counts: direction of the body in the motion and in the rest pose, a
## floor that keeps still, and that is at height 0. Where the motion speaks for another axis than
## the rest pose, the person lies, or the hips turn the whole rest pose up: feet that are at 0 tell
## which.
const _BY_MOTION: float = 1.0
const _BY_REST: float = 0.7
const _BY_FLOOR: float = 0.5
const _BY_ZERO: float = 0.9
## What a rest pose counts more if the person is as upright as there for a moment, and what it
## counts if the body is as low lying as standing: who lies first and rises then is not turned by
## the hips.
const _BY_RISING: float = 1.0
const _BY_LYING: float = 0.8
## Least difference of uprightness between lying and standing, and how near to the most and the
## least of a clip a frame counts as standing and lying.
const _RISES: float = 0.5
const _ALIKE: float = 0.25
## How unsteady a floor may be, and how far from 0, to count by 1/e, as a share of the leg.
const _UNSTEADY: float = 0.05
const _OFF_ZERO: float = 0.45
## What an axis is believed beforehand.
const _BEFORE: Dictionary[BvhOptions.UpAxis, float] = {
	BvhOptions.UpAxis.Y: 0.15,
	BvhOptions.UpAxis.Z: 0.1,
	BvhOptions.UpAxis.X: -0.3,
	BvhOptions.UpAxis.Y_DOWN: -0.15,
	BvhOptions.UpAxis.Z_DOWN: -0.2,
	BvhOptions.UpAxis.X_DOWN: -0.35,
}
## Lead by which an axis must win to be certain, and least uprightness of the body along it.
const _SURE: float = 0.3
const _SURE_UPRIGHT: float = 0.6


## Sets unit and up axis of a clip with their reasons: as given by the options, or else guessed.
## Mirrors a mirrored one back ([BvhHandedness], [BvhTravel]).
static func settle(p_clip: BvhClip, p_options: BvhOptions) -> void:
	var map: HumanoidMap = HumanoidMap.from_clip(p_clip)
	var anatomy: BvhAnatomy = null
	if map.error == "":
		anatomy = BvhAnatomy.new(p_clip, map)
		if anatomy.find_fault() != "":
			anatomy = null
	if p_options.up_axis != BvhOptions.UpAxis.GUESS:
		p_clip.up_axis = p_options.up_axis
		p_clip.up_reason = "as given"
	elif anatomy != null:
		_guess_up(p_clip, anatomy)
	else:
		_guess_up_by_size(p_clip)
	if p_options.unit_metres > 0.0:
		p_clip.unit_metres = p_options.unit_metres
		p_clip.unit_reason = "as given"
	elif anatomy != null:
		_guess_unit(p_clip, anatomy)
	else:
		_guess_unit_by_size(p_clip)
	if anatomy != null:
		BvhHandedness.settle(p_clip, map)
		BvhTravel.settle(p_clip, map)


static func _guess_unit(p_clip: BvhClip, p_anatomy: BvhAnatomy) -> void:
	var best: String = ""
	var parts: Array = [String.num(p_anatomy.leg, 3)]
	var is_short_legged: bool = p_anatomy.leg < BvhAnatomy.FOUR_LEGS_BY_TRUNK * p_anatomy.trunk
	for unit: String in BvhOptions.UNITS:
		var metres: float = BvhOptions.UNITS[unit]
		var fits: bool = not is_short_legged and _is_adult(p_anatomy, metres)
		if unit in _PLAIN and is_short_legged:
			fits = p_anatomy.stature() * metres >= MIN_SMALL_STATURE
			fits = fits and p_anatomy.stature() * metres <= MAX_STATURE
		elif unit in _PLAIN and p_anatomy.leg * metres >= MIN_SMALL_LEG:
			fits = fits or _is_adult(p_anatomy, metres * MIN_LEG / MIN_SMALL_LEG)
		if fits and (best == "" or _leg_misfit(p_anatomy, unit) < _leg_misfit(p_anatomy, best)):
			best = unit
	if best != "":
		p_clip.unit_metres = BvhOptions.UNITS[best]
		parts.append_array([p_anatomy.leg * p_clip.unit_metres, USUAL_LEG])
		p_clip.unit_reason = (
			"guess: the legs are %s units long, so %.2f m, of all units the nearest to %.2f m"
			% parts
		)
		return
	var leg: float = USUAL_LEG
	if is_short_legged:
		# Of a figure with short legs the whole is scaled.
		leg = p_anatomy.leg / p_anatomy.stature() * USUAL_STATURE
	p_clip.unit_metres = leg / p_anatomy.leg
	parts.append(leg)
	p_clip.unit_reason = (
		"guess: the legs are %s units long, an adult's in no unit; scaled to %.2f m" % parts
	)
	(
		p_clip
		. notes
		. append(
			(
				"%s: the person has no adult's size in any unit and was scaled; --unit= says the true one"
				% p_clip.source_name
			)
		)
	)


static func _is_adult(p_anatomy: BvhAnatomy, p_metres: float) -> bool:
	var leg: float = p_anatomy.leg * p_metres
	var stature: float = p_anatomy.stature() * p_metres
	return leg >= MIN_LEG and leg <= MAX_LEG and stature >= MIN_STATURE and stature <= MAX_STATURE


static func _leg_misfit(p_anatomy: BvhAnatomy, p_unit: String) -> float:
	return absf(log(p_anatomy.leg * BvhOptions.UNITS[p_unit] / USUAL_LEG))


static func _guess_up(p_clip: BvhClip, p_anatomy: BvhAnatomy) -> void:
	var scores: Array[float] = []
	var best: BvhOptions.UpAxis = BvhOptions.UpAxis.Y
	for axis: BvhOptions.UpAxis in _BEFORE:
		scores.append(_score(p_anatomy, axis) + _BEFORE[axis])
		if scores[-1] >= scores.max():
			best = axis
	scores.sort()
	p_clip.up_axis = best
	p_clip.up_reason = (
		"guess: trunk and legs point along %s, on average by %.2f of 1"
		% [BvhOptions.axis_name(best), _uprightness(p_anatomy, best)]
	)
	if p_anatomy.rest_stands():
		var rest: Vector3 = (p_anatomy.rest_trunk + p_anatomy.rest_legs) / 2.0
		p_clip.up_reason += "; in the rest pose by %.2f" % _along(rest, best)
	var is_upright: bool = p_anatomy.trunks.is_empty()
	is_upright = is_upright or _uprightness(p_anatomy, best) > _SURE_UPRIGHT
	if scores[-1] - scores[-2] < _SURE or not is_upright:
		p_clip.up_reason += "; unsure"
		p_clip.notes.append(
			"%s: which axis points up is unsure; --up= says it" % p_clip.source_name
		)


## How much speaks for an axis.
static func _score(p_anatomy: BvhAnatomy, p_axis: BvhOptions.UpAxis) -> float:
	var upright: PackedFloat32Array = []
	var floors: PackedFloat32Array = []
	for frame: int in p_anatomy.lows.size():
		upright.append(_along(p_anatomy.trunks[frame] + p_anatomy.legs[frame], p_axis) / 2.0)
		var low: float = _along(p_anatomy.lows[frame], p_axis)
		floors.append(minf(low, _along(p_anatomy.highs[frame], p_axis)))
	var score: float = _BY_MOTION * _uprightness(p_anatomy, p_axis)
	if p_anatomy.rest_stands():
		var rest: Vector3 = (p_anatomy.rest_trunk + p_anatomy.rest_legs) / 2.0
		score += _BY_REST * _along(rest, p_axis)
		if not upright.is_empty():
			var most: float = Array(upright).max()
			score += _BY_RISING * maxf(most, 0.0) * maxf(_along(rest, p_axis), 0.0)
	if floors.is_empty():
		return score
	score += _BY_LYING * _lies_low(upright, floors, p_anatomy.leg)
	floors.sort()
	# A jump leaves the floor for less than half of a clip.
	var spread: float = floors[floors.size() / 2] - floors[floors.size() / 10]
	score += _BY_FLOOR * exp(-spread / (_UNSTEADY * p_anatomy.leg))
	return (
		score + _BY_ZERO * exp(-pow(floors[floors.size() / 10] / (_OFF_ZERO * p_anatomy.leg), 2.0))
	)


## Whether the body is as low when it lies as when it stands, 0 to 1; 1 if it does only one of both.
## Along an axis that is not up somebody who lies and stands floats half of the time.
static func _lies_low(
	p_upright: PackedFloat32Array, p_floors: PackedFloat32Array, p_leg: float
) -> float:
	var most: float = Array(p_upright).max()
	var least: float = Array(p_upright).min()
	if most - least < _RISES:
		return 1.0
	var standing: PackedFloat32Array = []
	var lying: PackedFloat32Array = []
	for frame: int in p_upright.size():
		if p_upright[frame] > most - _ALIKE:
			standing.append(p_floors[frame])
		elif p_upright[frame] < least + _ALIKE:
			lying.append(p_floors[frame])
	standing.sort()
	lying.sort()
	var apart: float = standing[standing.size() / 2] - lying[lying.size() / 2]
	return exp(-pow(apart / (_OFF_ZERO * p_leg), 2.0))


## How far trunk and legs point along an axis over the clip, -1 to 1.
static func _uprightness(p_anatomy: BvhAnatomy, p_axis: BvhOptions.UpAxis) -> float:
	var sum: float = 0.0
	for frame: int in p_anatomy.trunks.size():
		sum += _along(p_anatomy.trunks[frame] + p_anatomy.legs[frame], p_axis) / 2.0
	return sum / maxi(p_anatomy.trunks.size(), 1)


## The part of a vector in the file's axes that points up, if that axis does.
static func _along(p_vector: Vector3, p_axis: BvhOptions.UpAxis) -> float:
	return SourceFrames.vector(p_vector, BvhOptions.FRAMES[p_axis]).y


static func _guess_unit_by_size(p_clip: BvhClip) -> void:
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


static func _guess_up_by_size(p_clip: BvhClip) -> void:
	var kinematics: BvhKinematics = BvhKinematics.new(p_clip.joints, p_clip.positions_add_offset)
	kinematics.rest()
	var extent: Vector3 = _extent(kinematics)
	var count: int = mini(p_clip.frame_count, _MAX_FRAMES)
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
