extends SceneTree
## What became of the entities in a recording: [code]--recording=FILE[/code].
##
## Prints JSON: level (names, in order), entities by path or name: type, owner, fields (for each the
## list of different values, in order), events (names with their ticks).

var _replica: WorldReplica = WorldReplica.new()
var _found: Dictionary[String, Dictionary] = {}
var _levels: Array[String] = []


func _init() -> void:
	var path: String = ""
	for argument: String in OS.get_cmdline_user_args():
		path = argument.trim_prefix("--recording=")
	var stream: RecordedStream = RecordedStream.of_file(path)
	var fault: String = stream.open()
	if fault != "":
		printerr(fault)
		quit(1)
		return
	_replica.level_named.connect(
		func(name: String, _fingerprint: PackedByteArray) -> void: _levels.append(name)
	)
	_replica.table.spawned.connect(_on_spawned)
	stream.restarted.connect(_replica.clear)
	stream.received.connect(_take)
	stream.play_all()
	print(JSON.stringify({"levels": _levels, "entities": _found}))
	quit()


func _on_spawned(p_row: EntityRow) -> void:
	var fields: Dictionary[String, Array] = {}
	for index: int in p_row.type.fields.size():
		fields[String(p_row.type.fields[index].name)] = [snappedf(p_row.values[index], 0.001)]
	_found[_key(p_row)] = {
		"type": String(p_row.type.name),
		"owner": p_row.owner,
		"fields": fields,
		"events": [],
	}


func _take(p_bytes: PackedByteArray, p_time_s: float) -> void:
	_replica.take(p_bytes, p_time_s)
	if _replica.newest_tick < 0:
		return
	for event: EntityEvent in _replica.events.take(INF):
		var row: EntityRow = _replica.table.find(event.entity)
		var name: String = String(row.type.events[event.event].name)
		_found[_key(row)]["events"].append([name, event.tick])
	for id: int in _replica.table.rows:
		var row: EntityRow = _replica.table.rows[id]
		for index: int in row.type.fields.size():
			var values: Array = _found[_key(row)]["fields"][String(row.type.fields[index].name)]
			var value: float = snappedf(_replica.field(id, index), 0.001)
			if values[-1] != value:
				values.append(value)


static func _key(p_row: EntityRow) -> String:
	return p_row.person_name if p_row.is_person() else (p_row.path if p_row.path != "" else "world")
