extends SceneTree
## How near the person of a name in an observer's recording comes to poses of a motion file, one
## after the other.
##
## Options: --recording=FILE --bvh=FILE --name=NAME --at=S,S,... --mean=DEG --worst=DEG.
## For each moment of the clip the first pose that is so near to it, over all limbs with a tracker,
## is looked for behind that of the moment before. Prints JSON, a list: is_struck, mean_deg and
## worst_deg of the pose that was found, or of the nearest one where none was.

## The limb that no tracker of a suit sits on.
const FILLED: int = 1

var _replica: WorldReplica = WorldReplica.new()
var _poses: Array[Array] = []
var _name: String = ""


func _init() -> void:
	var options: Dictionary[String, String] = {}
	for argument: String in OS.get_cmdline_user_args():
		var parts: PackedStringArray = argument.trim_prefix("--").split("=", true, 1)
		options[parts[0]] = parts[1] if parts.size() > 1 else ""
	_name = options["name"]
	var clip: BvhSource = BvhSource.new()
	clip.open(options["bvh"])
	var player: RecordedStream = RecordedStream.of_file(options["recording"])
	var fault: String = clip.error
	if fault == "":
		fault = player.open()
	if fault != "":
		printerr(fault)
		quit(1)
		return
	player.restarted.connect(_replica.clear)
	player.received.connect(_take)
	player.play_all()
	print(JSON.stringify(_find_all(clip, options)))
	quit()


func _take(p_bytes: PackedByteArray, p_time_s: float) -> void:
	if not _replica.take(p_bytes, p_time_s) or not Protocol.SNAPSHOTS.has(int(p_bytes[0])):
		return
	for person: int in _replica.decoder.get_people():
		var row: EntityRow = _replica.table.find(person)
		if row == null or row.person_name != _name:
			continue
		var floats: PackedFloat32Array = _replica.person_floats(person, true)
		var turns: Array[Quaternion] = []
		for limb: int in Limbs.COUNT:
			var at: int = limb * WorldReplica.FLOATS + 3
			var turn: Quaternion = Quaternion(
				floats[at], floats[at + 1], floats[at + 2], floats[at + 3]
			)
			turns.append(turn.normalized())
		_poses.append(turns)


func _find_all(p_clip: BvhSource, p_options: Dictionary[String, String]) -> Array[Dictionary]:
	var all: Array[Dictionary] = []
	var at: int = 0
	for moment: String in p_options["at"].split(","):
		var wanted: PoseSample = p_clip.pose_at(moment.to_float())
		var best: Dictionary = {"mean_deg": 180.0, "worst_deg": 180.0, "is_struck": false}
		while at < _poses.size() and not best["is_struck"]:
			var found: Dictionary = _errors(_poses[at], wanted)
			found["is_struck"] = (
				found["mean_deg"] <= p_options["mean"].to_float()
				and found["worst_deg"] <= p_options["worst"].to_float()
			)
			if found["mean_deg"] < best["mean_deg"] or found["is_struck"]:
				best = found
			at += 1
		all.append(best)
	return all


static func _errors(p_turns: Array, p_wanted: PoseSample) -> Dictionary:
	var sum: float = 0.0
	var worst: float = 0.0
	for limb: int in Limbs.COUNT:
		if limb == FILLED:
			continue
		var turn: Quaternion = p_turns[limb]
		var off: float = Rotations.between_deg(turn, p_wanted.orientation(limb))
		sum += off
		worst = maxf(worst, off)
	return {"mean_deg": sum / (Limbs.COUNT - 1), "worst_deg": worst}
