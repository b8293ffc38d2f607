class_name ThingOrders
extends RefCounted
## What an instructor has done with things of the level, by their names: a vehicle put upright,
## repaired. Each is a command of the thing's entity, which the server takes from instructors only.

## The orders, which are commands of entities: [InstructorConsole] says what each does.
const COMMANDS: PackedStringArray = ["upright", "repair"]

var _replica: WorldReplica = null
var _entities: ClientEntities = null


func _init(p_replica: WorldReplica, p_entities: ClientEntities) -> void:
	_replica = p_replica
	_entities = p_entities


## Names of the things for which there is an order.
func names(p_command: String) -> PackedStringArray:
	var found: PackedStringArray = []
	if _replica == null:
		return found
	for row: EntityRow in _replica.table.rows.values():
		if not row.is_person() and row.type.find_command(p_command) >= 0:
			found.append(row.title())
	found.sort()
	return found


## Gives an order for the things of a name, whole or shortened, or all (*). Returns what is said of
## it.
func give(p_command: String, p_name: String) -> String:
	var wanted: String = p_name.to_lower()
	var known: PackedStringArray = names(p_command)
	var done: PackedStringArray = []
	for row: EntityRow in [] if _replica == null else _replica.table.rows.values():
		var index: int = row.type.find_command(p_command)
		var title: String = row.title()
		var is_meant: bool = title.to_lower() == wanted or wanted == "*"
		if not is_meant and not known.has(p_name):
			is_meant = wanted != "" and title.to_lower().begins_with(wanted)
		if is_meant and index >= 0 and not row.is_person():
			_entities.send_command(row.id, index, [], -1)
			done.append(title)
	if not done.is_empty():
		return "%s: %s" % [p_command, ", ".join(done)]
	if known.is_empty():
		return "there is nothing to %s in this level" % p_command
	return "nothing to %s is called '%s': %s" % [p_command, p_name, ", ".join(known)]
