extends SceneTree
## How far a person in an observer's recording is from a motion file, degrees.
##
## --recording=FILE --bvh=FILE --from=S --to=S (of the clip). The recording begins at some moment
## of the clip: the one at which they agree best, found first coarsely, then exactly, is taken. Time
## is the server's by its ticks. On a machine that is too slow for 60 ticks a second that is no
## clock: with --slack=S time is that of the observer, and a pose may be so much earlier or later.
## Prints JSON: mean and p95 of the limbs that a suit of 17 trackers measures, offset_s, limbs (mean
## of each), quartiles (the lower one of each limb), count.

const ClipMatch: GDScript = preload("res://tests/bench/suit/clip_match.gd")
## Step of the search for the moment of a single pose, s, and how many poses are looked at.
const SLACK_STEP_S: float = 0.02
const SLACK_LOOKS: int = 60
## The limb that no tracker of a suit sits on.
const FILLED: int = 1

var _replica: WorldReplica = WorldReplica.new()
var _match: ClipMatch = ClipMatch.new()
var _from: float = 0.0
var _until: float = 0.0
var _slack_s: float = 0.0


func _init() -> void:
	var options: Dictionary[String, String] = {}
	for argument: String in OS.get_cmdline_user_args():
		var parts: PackedStringArray = argument.trim_prefix("--").split("=", true, 1)
		options[parts[0]] = parts[1] if parts.size() > 1 else ""
	_match.clip.open(options.get("bvh", ""))
	var player: RecordedStream = RecordedStream.of_file(options.get("recording", ""))
	var fault: String = _match.clip.error
	if fault == "":
		fault = player.open()
	if fault != "":
		printerr(fault)
		quit(1)
		return
	_from = options.get("from", "0").to_float()
	_until = options.get("to", "1e9").to_float()
	_slack_s = options.get("slack", "0").to_float()
	player.restarted.connect(_replica.clear)
	player.received.connect(_take)
	player.play_all()
	if _match.poses.is_empty():
		printerr("nobody is in the recording at that time")
		quit(1)
		return
	for limb: int in Limbs.COUNT:
		if limb != FILLED:
			_match.limbs.append(limb)
	_print(_match.best_offset())
	quit()


func _take(p_bytes: PackedByteArray, p_time_s: float) -> void:
	if not _replica.take(p_bytes, p_time_s) or not Protocol.SNAPSHOTS.has(int(p_bytes[0])):
		return
	var people: PackedInt32Array = _replica.decoder.get_people()
	var time: float = p_time_s if _slack_s > 0.0 else _replica.decoder.get_tick() / 60.0
	if people.is_empty() or (not _match.times.is_empty() and time <= _match.times[-1]):
		return
	var floats: PackedFloat32Array = _replica.person_floats(people[0], true)
	var turns: Array[Quaternion] = []
	for limb: int in Limbs.COUNT:
		var at: int = limb * WorldReplica.FLOATS + 3
		turns.append(Quaternion(floats[at], floats[at + 1], floats[at + 2], floats[at + 3]))
	_match.times.append(time)
	_match.poses.append(turns)


## The errors at the moment, within the slack, at which they are least.
func _least_errors(p_at: int, p_offset_s: float) -> PackedFloat64Array:
	var best: PackedFloat64Array = _match.errors(p_at, p_offset_s)
	for step: int in range(-floori(_slack_s / SLACK_STEP_S), floori(_slack_s / SLACK_STEP_S) + 1):
		var errors: PackedFloat64Array = _match.errors(p_at, p_offset_s + step * SLACK_STEP_S)
		if _sum(errors) < _sum(best):
			best = errors
	return best


static func _sum(p_values: PackedFloat64Array) -> float:
	var sum: float = 0.0
	for value: float in p_values:
		sum += value
	return sum


func _print(p_offset_s: float) -> void:
	var all: Statistics = Statistics.new()
	var limbs: Dictionary[StringName, float] = {}
	var quartiles: Dictionary[StringName, float] = {}
	var of_limbs: Array[Statistics] = []
	for _limb: int in Limbs.COUNT:
		of_limbs.append(Statistics.new())
	var count: int = 0
	var every: int = maxi(_match.poses.size() / SLACK_LOOKS, 1) if _slack_s > 0.0 else 1
	for at: int in range(0, _match.poses.size(), every):
		var moment: float = _match.times[at] - _match.times[0] + p_offset_s
		if moment < _from or moment > _until:
			continue
		count += 1
		var errors: PackedFloat64Array = _least_errors(at, p_offset_s)
		for limb: int in Limbs.COUNT:
			if limb != FILLED:
				all.add(errors[limb])
			of_limbs[limb].add(errors[limb])
	for limb: int in Limbs.COUNT if count > 0 else 0:
		limbs[Limbs.BONES[limb]] = of_limbs[limb].mean()
		quartiles[Limbs.BONES[limb]] = of_limbs[limb].percentile(0.25)
	var found: Dictionary = {
		"mean": all.mean(),
		"p95": all.percentile(0.95),
		"offset_s": p_offset_s,
		"count": count,
		"limbs": limbs,
		"quartiles": quartiles,
	}
	print(JSON.stringify(found))
