class_name MagneticWatch
extends RefCounted
## How good the magnetic field is at each sensor of a suit: its strength and dip against those right
## after the calibration. Iron and currents nearby change both, and with them where north seems to
## be.

## What can be said of a field.
enum Verdict {
	## The sensor has no magnetometer, or nothing has been calibrated.
	UNKNOWN,
	## As in the calibration.
	GOOD,
	## Another field: its north is not used.
	DISTURBED,
}

## Names for people, by [enum Verdict].
const NAMES: PackedStringArray = ["unknown", "good", "disturbed"]

var _drift: HeadingDrift = null


func _init(p_drift: HeadingDrift) -> void:
	_drift = p_drift


## The field at a mount of [BodyMounts].
func judge(p_mount: int) -> Verdict:
	if not _drift.is_field_known(p_mount):
		return Verdict.UNKNOWN
	return Verdict.GOOD if _drift.is_field_good(p_mount) else Verdict.DISTURBED


## The same in a word.
func word(p_mount: int) -> String:
	return NAMES[judge(p_mount)]


## Strength of the field, in strengths that it had in the calibration.
func strength(p_mount: int) -> float:
	return _drift.get_field_strength(p_mount)


## How much steeper the field is than in the calibration, degrees.
func dip_deg(p_mount: int) -> float:
	return rad_to_deg(_drift.get_field_dip(p_mount))


## For people: the word, and the numbers where there are some.
func describe(p_mount: int) -> String:
	if judge(p_mount) == Verdict.UNKNOWN:
		return word(p_mount)
	var parts: Array = [word(p_mount), 100.0 * strength(p_mount), dip_deg(p_mount)]
	return "%s (%.0f %%, %+.0f°)" % parts
