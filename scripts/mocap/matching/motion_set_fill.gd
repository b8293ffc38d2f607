class_name MotionSetFill
extends RefCounted
## What a set lacks and another one has: clips of stances, directions and speeds of which it has
## none of its own.

## Speeds that are further apart than this factor are others: a clip is played at 0.8 to 1.2 times
## its speed, with longer or shorter strides.
const FACTOR: float = 1.5


## Lines of a table that take what [param p_set] lacks from the file [param p_from], as [param
## p_other] holds it. Both must have been loaded.
static func find(p_set: MotionSet, p_other: MotionSet, p_from: String) -> Array[MotionSetTable.Row]:
	var rows: Array[MotionSetTable.Row] = []
	for clip: int in p_other.get_clip_count():
		if _has_like(p_set, p_other, clip):
			continue
		var row: MotionSetTable.Row = MotionSetTable.Row.new()
		row.file = p_from
		row.stance = p_other.get_clip_stance(clip) as MotionMatcher.Stance
		row.name = p_other.get_clip_name(clip)
		rows.append(row)
	return rows


## What a walker cannot do without and a set does not have, in words; all else can be made of these
## or by rules. The set must have been loaded.
static func find_missing(p_set: MotionSet) -> PackedStringArray:
	var missing: PackedStringArray = ["standing", "walking ahead"]
	for clip: int in p_set.get_clip_count():
		if p_set.get_clip_stance(clip) != MotionMatcher.STAND:
			continue
		var sector: int = _sector(p_set, clip)
		if sector <= 1:
			missing.erase("standing" if sector < 0 else "walking ahead")
		if missing.is_empty():
			break
	return missing


static func _has_like(p_set: MotionSet, p_other: MotionSet, p_clip: int) -> bool:
	for clip: int in p_set.get_clip_count():
		if p_set.get_clip_stance(clip) != p_other.get_clip_stance(p_clip):
			continue
		if p_set.get_clip_name(clip) in ["start", "stop"]:
			continue
		if _sector(p_set, clip) != _sector(p_other, p_clip):
			continue
		var ratio: float = p_set.get_clip_speed(clip) / maxf(p_other.get_clip_speed(p_clip), 0.01)
		if _sector(p_set, clip) < 0 or (ratio > 1.0 / FACTOR and ratio < FACTOR):
			return true
	return false


## The direction of a clip or its mirrored twin, in eighths of a circle; -1 where it stands.
static func _sector(p_set: MotionSet, p_clip: int) -> int:
	if p_set.get_clip_speed(p_clip) < MotionTrack.STILL_SPEED + 0.05:
		return -1
	return absi(roundi(p_set.get_clip_travel(p_clip) / (PI / 4.0)))
