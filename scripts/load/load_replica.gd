class_name LoadReplica
extends WorldReplica
## A client's copy of the world without what only a display needs: it takes in and acknowledges all
## that comes, but makes no motion smooth.

var _tables: SharedTables = null


## Clients of a process share what they decode.
func _init(p_tables: SharedTables) -> void:
	_tables = p_tables
	super()


func _take_motion(_p_arrival_s: float) -> void:
	pass


func _decode_table(p_bytes: PackedByteArray) -> EntityTableMessage:
	return _tables.decode(p_bytes, table.types)


func _set_skeleton(_p_row: EntityRow) -> void:
	pass
