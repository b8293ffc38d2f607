class_name EntityTableCache
extends RefCounted
## The whole entity table as bytes, kept up to date: a late joiner must not cost a tick, however
## many entities there are.

var _table: EntityTable = null
## Everything but people, who come and go: joined once, and appended to.
var _others: PackedByteArray = PackedByteArray()
var _other_count: int = 0
var _is_valid: bool = false


func _init(p_table: EntityTable) -> void:
	_table = p_table
	_table.spawned.connect(_on_spawned)
	_table.despawned.connect(_on_despawned)


## The message with the whole table.
func encode(p_error_deg: float) -> PackedByteArray:
	if not _is_valid:
		_join()
	var rows: PackedByteArray = _others.duplicate()
	var people: Array[EntityRow] = _table.people()
	for row: EntityRow in people:
		rows.append_array(EntityTableMessage.row_bytes(row))
	var message: EntityTableMessage = EntityTableMessage.of_table(_table, p_error_deg)
	return message.encode_with(rows, _other_count + people.size())


func _join() -> void:
	_others = PackedByteArray()
	_other_count = 0
	_is_valid = true
	for id: int in _table.rows:
		_on_spawned(_table.rows[id])


func _on_spawned(p_row: EntityRow) -> void:
	if _is_valid and not p_row.is_person():
		_others.append_array(EntityTableMessage.row_bytes(p_row))
		_other_count += 1


func _on_despawned(p_row: EntityRow) -> void:
	_is_valid = _is_valid and p_row.is_person()
