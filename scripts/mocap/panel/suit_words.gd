class_name SuitWords
extends RefCounted
## What is said of a suit: whether it works, and whether it is calibrated.


## The state of a suit, or of none, for people; a fault comes with what to do about it.
static func describe(p_suit: SuitSource) -> String:
	if p_suit == null:
		return "no suit"
	if p_suit.feed.error != "":
		return p_suit.feed.error
	if not p_suit.is_calibrated():
		var key: String = InputKeys.name_of(&"calibrate_full")
		return "Not calibrated yet: press %s and follow the figure" % key
	var made: float = p_suit.get_profile().calibration.made_s
	var minutes: int = int((Time.get_unix_time_from_system() - made) / 60.0)
	return "calibrated %d min ago" % minutes if minutes > 0 else "calibrated just now"


## Limbs that something is wrong with, by index in [constant Limbs.BONES]: exchanged or loose.
static func limbs_in_trouble(p_suit: SuitSource) -> PackedInt32Array:
	var found: PackedInt32Array = []
	for swap: Vector2i in p_suit.watch.swaps:
		found.append_array([BodyMounts.LIMBS[swap.x], BodyMounts.LIMBS[swap.y]])
	for mount: int in p_suit.watch.slipped:
		found.append(BodyMounts.LIMBS[mount])
	return found
