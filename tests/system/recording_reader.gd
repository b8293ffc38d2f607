extends SceneTree
## Tells what recordings hold: each line of the standard input names a file, each answer is a line
## of JSON. A file that is still being written is followed: the next answer has what has come since.
## "forget " before its name forgets all but what is there at that moment.
##
## The answer has levels (names, in order); entities by path or name: type, owner, fields (for each
## the list of different values, in order), events (names with their ticks); and people by name: for
## each half second of the recording in which snapshots told of that person time_s since the
## recording's begin, hips (x, y, z; m), turned_deg (how far all limbs turned on average since the
## entry before; degrees).

const STEP_S: float = 0.5
## Bytes before each message: its size and time.
const HEAD: int = 12
const FORGET: String = "forget "

var _recordings: Dictionary[String, Recording] = {}


## One file, as far as it has been read.
class Recording:
	var path: String = ""
	var at: int = StateRecorder.MAGIC.length()
	var replica: WorldReplica = WorldReplica.new()
	var levels: Array[String] = []
	var entities: Dictionary[String, Dictionary] = {}
	var people: Dictionary[String, Array] = {}
	var last: Dictionary[int, PackedFloat32Array] = {}
	var steps: Dictionary[int, int] = {}

	func _init(p_path: String) -> void:
		path = p_path
		replica.level_named.connect(
			func(name: String, _fingerprint: PackedByteArray) -> void: levels.append(name)
		)
		replica.table.spawned.connect(_on_spawned)

	## Takes in what has come since the last time; a record that is not all there has to wait.
	func read_on() -> void:
		var file: FileAccess = FileAccess.open(path, FileAccess.READ)
		if file == null:
			return
		file.seek(at)
		while file.get_length() - file.get_position() >= HEAD:
			var size: int = file.get_32()
			var time_s: float = file.get_64() / 1e6
			if file.get_length() - file.get_position() < size:
				return
			_take(file.get_buffer(size), time_s)
			at = file.get_position()

	## What was before counts no more.
	func forget() -> void:
		levels.assign(levels.slice(-1))
		people.clear()
		steps.clear()
		last.clear()
		var there: Dictionary[String, Dictionary] = {}
		for id: int in replica.table.rows:
			var key: String = _key(replica.table.rows[id])
			there[key] = entities[key]
			there[key]["events"].clear()
			for field: String in there[key]["fields"]:
				there[key]["fields"][field] = there[key]["fields"][field].slice(-1)
		entities = there

	func _on_spawned(p_row: EntityRow) -> void:
		var fields: Dictionary[String, Array] = {}
		for index: int in p_row.type.fields.size():
			fields[String(p_row.type.fields[index].name)] = [snappedf(p_row.values[index], 0.001)]
		entities[_key(p_row)] = {
			"type": String(p_row.type.name),
			"owner": p_row.owner,
			"fields": fields,
			"events": [],
		}

	func _take(p_bytes: PackedByteArray, p_time_s: float) -> void:
		if p_bytes.size() == 1 and p_bytes[0] == StateRecorder.BEGIN:
			replica.clear()
			return
		if replica.take(p_bytes, p_time_s) and Protocol.SNAPSHOTS.has(int(p_bytes[0])):
			_note_people(p_time_s)
		if replica.newest_tick < 0:
			return
		for event: EntityEvent in replica.events.take(INF):
			var row: EntityRow = replica.table.find(event.entity)
			var name: String = String(row.type.events[event.event].name)
			entities[_key(row)]["events"].append([name, event.tick])
		for id: int in replica.table.rows:
			_note_fields(replica.table.rows[id])

	func _note_fields(p_row: EntityRow) -> void:
		var fields: Dictionary = entities[_key(p_row)]["fields"]
		for index: int in p_row.type.fields.size():
			var values: Array = fields[String(p_row.type.fields[index].name)]
			var value: float = snappedf(replica.field(p_row.id, index), 0.001)
			if values[-1] != value:
				values.append(value)

	func _note_people(p_time_s: float) -> void:
		for actor: int in replica.decoder.get_people():
			var step: int = floori(p_time_s / STEP_S)
			if steps.get(actor, -1) == step:
				continue
			steps[actor] = step
			var floats: PackedFloat32Array = replica.person_floats(actor, true)
			var turned: float = 0.0
			for limb: int in Limbs.COUNT if last.has(actor) else 0:
				var before: Quaternion = _turn(last[actor], limb)
				turned += Rotations.between_deg(_turn(floats, limb), before) / Limbs.COUNT
			last[actor] = floats
			var entry: Dictionary = {"time_s": p_time_s, "turned_deg": turned}
			entry["hips"] = [floats[0], floats[1], floats[2]]
			var row: EntityRow = replica.table.find(actor)
			people.get_or_add(row.person_name if row != null else "", []).append(entry)

	static func _turn(p_floats: PackedFloat32Array, p_limb: int) -> Quaternion:
		var from: int = p_limb * WorldReplica.FLOATS + 3
		var turn: Quaternion = Quaternion(
			p_floats[from], p_floats[from + 1], p_floats[from + 2], p_floats[from + 3]
		)
		return turn.normalized()

	static func _key(p_row: EntityRow) -> String:
		if p_row.is_person():
			return p_row.person_name
		return p_row.path if p_row.path != "" else "world"


func _init() -> void:
	while true:
		var line: String = OS.read_string_from_stdin(4096).strip_edges()
		if line == "":
			break
		var path: String = line.trim_prefix(FORGET)
		var recording: Recording = _recordings.get_or_add(path, Recording.new(path))
		recording.read_on()
		if path != line:
			recording.forget()
		print(
			(
				JSON
				. stringify(
					{
						"levels": recording.levels,
						"entities": recording.entities,
						"people": recording.people,
					}
				)
			)
		)
	quit()
