class_name CalibrationResult
extends RefCounted
## What a calibration found, and how good it is.

## A pose with more movement than this should be done again, degrees.
const MOVED_DEG: float = 3.0
## A pose that is off by more than this from the other pose's result is reported, degrees:
## arms and heads, which people hold less exactly, and the rest, which stands still between them.
const OFF_DEG: float = 20.0
const OFF_STANDING_DEG: float = 8.0
## A heading that differs by more than this from its neighbours' is reported, degrees.
const TURNED_DEG: float = 12.0
## A larger difference comes from the sensor's north and not from the wearer's movement, degrees.
const OWN_NORTH_DEG: float = 25.0

## Why there is no result, or an empty text.
var error: String = ""
## The calibration.
var calibration: Calibration = null
## How good each mount is, in the order of the mounts.
var mounts: Array[PlaceQuality] = []
## Pairs of mounts whose sensors look exchanged.
var swaps: Array[Vector2i] = []
## What the wearer should know or do, one sentence each, worst first.
var advice: PackedStringArray = PackedStringArray()


## One mount.
class PlaceQuality:
	## The mount of [BodyMounts].
	var mount: int = -1
	## The sensor there.
	var sensor: String = ""
	## Whether the sensor sent too little or nothing.
	var is_missing: bool = false
	## How far it moved while the pose was held, degrees.
	var movement_deg: float = 0.0
	## How far the other pose was off from what this calibration makes of it, degrees; -1 if there
	## was none.
	var residual_deg: float = -1.0
	## The heading that was found, degrees about the vertical.
	var heading_deg: float = 0.0
	## Whether that heading is the sensor's own, from its movement.
	var is_heading_measured: bool = false

	## In a word: "good", "moved", "off" or "missing".
	func grade() -> String:
		if is_missing:
			return "missing"
		if movement_deg > CalibrationResult.MOVED_DEG:
			return "moved"
		return "off" if is_off() else "good"

	## Whether the other pose was too far off.
	func is_off() -> bool:
		var stands: bool = not ResetPose.hangs(mount) and mount != BodyMounts.HEAD
		if stands:
			return residual_deg > CalibrationResult.OFF_STANDING_DEG
		return residual_deg > CalibrationResult.OFF_DEG


## Whether it can be accepted.
func is_good() -> bool:
	if error != "" or not swaps.is_empty():
		return false
	for quality: PlaceQuality in mounts:
		if quality.grade() != "good":
			return false
	return true


## Quality of a mount, or null.
func find(p_mount: int) -> PlaceQuality:
	for quality: PlaceQuality in mounts:
		if quality.mount == p_mount:
			return quality
	return null


## How good it is in one number, 0 to 1: 1 if nobody moved, 0 if somebody moved by 10 degrees.
func score() -> float:
	var worst: float = 0.0
	for quality: PlaceQuality in mounts:
		worst = maxf(worst, 10.0 if quality.is_missing else quality.movement_deg)
	return 0.0 if error != "" else clampf(1.0 - worst / 10.0, 0.0, 1.0)


## A sentence for the log and for instructors.
func describe() -> String:
	if error != "":
		return "not calibrated: " + error
	var text: String = "calibrated, quality %.0f %%" % (100.0 * score())
	var apart: PackedFloat64Array = []
	for quality: PlaceQuality in mounts:
		if quality.residual_deg >= 0.0:
			apart.append(quality.residual_deg)
	if apart.is_empty():
		return text
	var sum_deg: float = 0.0
	for degrees: float in apart:
		sum_deg += degrees
	return text + ", the poses agree to %.1f°" % (sum_deg / apart.size())


## Fills [member advice] from the mounts.
func judge() -> void:
	var sorted: Array[PlaceQuality] = mounts.duplicate()
	sorted.sort_custom(
		func(a: PlaceQuality, b: PlaceQuality) -> bool: return a.movement_deg > b.movement_deg
	)
	for quality: PlaceQuality in sorted:
		var title: String = BodyMounts.title(quality.mount)
		if quality.is_missing:
			var parts: Array = [title, quality.sensor]
			advice.append("%s: sensor %s says nothing" % parts)
		elif quality.movement_deg > MOVED_DEG:
			var parts: Array = [title, roundi(quality.movement_deg)]
			advice.append("%s moved %d° during the pose: again?" % parts)
	for quality: PlaceQuality in sorted:
		if quality.is_missing or not quality.is_off():
			continue
		var parts: Array = [BodyMounts.title(quality.mount), roundi(quality.residual_deg)]
		if ResetPose.hangs(quality.mount):
			advice.append("%s was %d° away from where it should be in the other pose" % parts)
		else:
			advice.append("%s turned by %d° between the poses: a step, or drift?" % parts)
