extends EntityHost
## A client that entities live in, without a server behind it.


func session() -> int:
	return LocalSession.SESSION


func send_command(_entity: int, _command: int, _values: PackedFloat32Array, _at: int) -> void:
	pass


func name_of(_entity: int) -> String:
	return ""
