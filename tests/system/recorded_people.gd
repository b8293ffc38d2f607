extends SceneTree
## Who is in an observer's recording, and how they move: [code]--recording=FILE[/code].
##
## Prints JSON: for each name a list with an entry for each half second of the recording in which
## snapshots told of that person: time_s since the recording's begin, hips (x, y, z; m), turned_deg
## (how far all limbs turned on average since the entry before; degrees).

const STEP_S: float = 0.5

var _replica: WorldReplica = WorldReplica.new()
var _found: Dictionary[String, Array] = {}
var _last: Dictionary[int, PackedFloat32Array] = {}
var _step: Dictionary[int, int] = {}


func _init() -> void:
	var path: String = ""
	for argument: String in OS.get_cmdline_user_args():
		path = argument.trim_prefix("--recording=")
	var player: RecordedStream = RecordedStream.of_file(path)
	var fault: String = player.open()
	if fault != "":
		printerr(fault)
		quit(1)
		return
	player.restarted.connect(_replica.clear)
	player.received.connect(_take)
	player.play_all()
	print(JSON.stringify(_found))
	quit()


func _take(p_bytes: PackedByteArray, p_time_s: float) -> void:
	if not _replica.take(p_bytes, p_time_s) or not Protocol.SNAPSHOTS.has(int(p_bytes[0])):
		return
	for actor: int in _replica.decoder.get_people():
		var step: int = floori(p_time_s / STEP_S)
		if _step.get(actor, -1) == step:
			continue
		_step[actor] = step
		var floats: PackedFloat32Array = _replica.person_floats(actor, true)
		var turned: float = 0.0
		for limb: int in Limbs.COUNT if _last.has(actor) else 0:
			var before: Quaternion = _turn(_last[actor], limb)
			turned += Rotations.between_deg(_turn(floats, limb), before) / Limbs.COUNT
		_last[actor] = floats
		var entry: Dictionary = {"time_s": p_time_s, "turned_deg": turned}
		entry["hips"] = [floats[0], floats[1], floats[2]]
		var row: EntityRow = _replica.table.find(actor)
		_found.get_or_add(row.person_name if row != null else "", []).append(entry)


static func _turn(p_floats: PackedFloat32Array, p_limb: int) -> Quaternion:
	var at: int = p_limb * WorldReplica.FLOATS + 3
	var turn: Quaternion = Quaternion(
		p_floats[at], p_floats[at + 1], p_floats[at + 2], p_floats[at + 3]
	)
	return turn.normalized()
