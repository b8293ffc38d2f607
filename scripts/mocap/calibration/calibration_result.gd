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
## Errors up to these are good and fair, degrees; beyond they are poor.
const GOOD_DEG: float = 4.0
const FAIR_DEG: float = 8.0
## Calibrations that are worse are not taken where nobody is asked, degrees: in the mean of the
## limbs, and of any limb, without what norths add that nothing showed.
const ACCEPTED_DEG: float = 15.0
const ACCEPTED_LIMB_DEG: float = 20.0

## Why there is no result, or an empty text.
var error: String = ""
## The calibration.
var calibration: Calibration = null
## How far limbs will probably be off, degrees: the mean over all that are worn.
var error_deg: float = 0.0
## The part of [member error_deg] that stands for norths that nothing showed: how far they usually
## are apart.
var unseen_deg: float = 0.0
## How good each mount is, in the order of the mounts.
var mounts: Array[PlaceQuality] = []
## Where each sensor seems to be worn, by the order of the sensors: a mount of [BodyMounts], or -1
## where that is not known. As it was, if nothing speaks against it.
var assignment: PackedInt32Array = PackedInt32Array()
## How sure that is, 0 to 1, by the order of the sensors.
var confidences: PackedFloat32Array = PackedFloat32Array()
## Where each sensor was taken to be worn, as [member assignment].
var present: PackedInt32Array = PackedInt32Array()
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
	## How far the limb will probably be off, degrees.
	var error_deg: float = 0.0
	## The part of it that stands for a north that nothing showed, degrees.
	var unseen_deg: float = 0.0
	## The heading that was found, degrees about the vertical.
	var heading_deg: float = 0.0
	## Whether that heading is the sensor's own, from its movement.
	var is_heading_measured: bool = false

	## In a word: "missing", "moved", "off", or how far the limb will be off as in
	## [method CalibrationResult.word].
	func grade() -> String:
		if is_missing:
			return "missing"
		if movement_deg > CalibrationResult.MOVED_DEG:
			return "moved"
		return "off" if is_off() else CalibrationResult.word_for(error_deg)

	## Whether the other pose was too far off.
	func is_off() -> bool:
		var stands: bool = not ResetPose.hangs(mount) and mount != BodyMounts.HEAD
		if stands:
			return residual_deg > CalibrationResult.OFF_STANDING_DEG
		return residual_deg > CalibrationResult.OFF_DEG


## Whether sensors seem to be worn elsewhere than was taken.
func is_reassigned() -> bool:
	return assignment != present


## The exchanges of two mounts that lead from the present mounts to [member assignment], one after
## the other.
func exchanges() -> Array[Vector2i]:
	var found: Array[Vector2i] = []
	var now: PackedInt32Array = present.duplicate()
	for sensor: int in now.size():
		var there: int = now.find(assignment[sensor])
		if now[sensor] >= 0 and assignment[sensor] != now[sensor] and there >= 0:
			var pair: Array = [now[sensor], now[there]]
			found.append(Vector2i(pair.min(), pair.max()))
			now[there] = now[sensor]
			now[sensor] = assignment[sensor]
	return found


## In a word, by [member error_deg]: "good", "fair" or "poor".
func word() -> String:
	return word_for(error_deg)


## A word for an error, degrees.
static func word_for(p_error_deg: float) -> String:
	if p_error_deg <= GOOD_DEG:
		return "good"
	return "fair" if p_error_deg <= FAIR_DEG else "poor"


## Whether nothing stands against it: no sensor is missing or elsewhere, everybody stood still, and
## limbs will be off by no more than is fair.
func is_good() -> bool:
	if error != "" or is_reassigned() or error_deg > FAIR_DEG:
		return false
	for quality: PlaceQuality in mounts:
		if ["missing", "moved", "off"].has(quality.grade()):
			return false
	return true


## Whether it can be taken where nobody is asked. Norths that nothing showed do not count: the
## wearer did as asked, and doing it again shows no more.
func is_acceptable() -> bool:
	for quality: PlaceQuality in mounts:
		if quality.error_deg - quality.unseen_deg > ACCEPTED_LIMB_DEG:
			return false
	return error == "" and not is_reassigned() and error_deg - unseen_deg <= ACCEPTED_DEG


## Quality of a mount, or null.
func find(p_mount: int) -> PlaceQuality:
	for quality: PlaceQuality in mounts:
		if quality.mount == p_mount:
			return quality
	return null


## A sentence for the log and for instructors.
func describe() -> String:
	if error != "":
		return "not calibrated: " + error
	var text: String = "calibrated, %s: limbs are off by about %.0f°" % [word(), error_deg]
	if unseen_deg >= 1.0:
		text += ", of that %.0f° as norths were not measured" % unseen_deg
	return text


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
	_sum_up()
	for quality: PlaceQuality in sorted:
		if quality.is_missing or not quality.is_off():
			continue
		var parts: Array = [BodyMounts.title(quality.mount), roundi(quality.residual_deg)]
		if ResetPose.hangs(quality.mount):
			advice.append("%s was %d° away from where it should be in the other pose" % parts)
		else:
			advice.append("%s turned by %d° between the poses: a step, or drift?" % parts)


## The means over all mounts that sent.
func _sum_up() -> void:
	var known: int = 0
	error_deg = 0.0
	unseen_deg = 0.0
	for quality: PlaceQuality in mounts:
		if not quality.is_missing:
			error_deg += quality.error_deg
			unseen_deg += quality.unseen_deg
			known += 1
	error_deg /= maxi(known, 1)
	unseen_deg /= maxi(known, 1)
