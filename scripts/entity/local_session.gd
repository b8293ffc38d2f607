@icon("res://scenes/entity/icons/entity.svg")
class_name LocalSession
extends Node
## Runs the entities of a scene without a server: for examples, and for trying a part of a level in
## the editor (F6).
##
## This machine is both server and client. This machine's session has the number
## [constant SESSION].

## Number of the only session.
const SESSION: int = 1

var _host: Host = Host.new()


## The program, when there is no network.
class Host:
	extends SeatAuthority
	var nodes: Dictionary[int, Entity] = {}
	var possessed: Possession = Possession.new()

	func session() -> int:
		return SESSION

	func set_field(_entity: int, _field: int, _value: float) -> void:
		pass

	func send_event(_entity: int, _event: int, _values: PackedFloat32Array) -> void:
		pass

	func send_command(
		p_entity: int, p_command: int, p_values: PackedFloat32Array, _tick_wanted: int
	) -> void:
		nodes[p_entity].take_command(SESSION, p_command, p_values)

	func possession() -> Possession:
		return possessed

	func attach(_session: int, _entity: int, _seat: SeatGeometry) -> void:
		pass

	func detach(_session: int) -> void:
		pass

	func carry(_limb: Node3D, _entity: int, _holds: bool) -> void:
		pass

	func put_down(_limb: Node3D, _entity: int) -> void:
		pass

	func find_by_body(p_body: Node3D) -> int:
		for id: int in nodes:
			if nodes[id].get_body() == p_body:
				return id
		return -1

	func name_of(p_entity: int) -> String:
		var entity: Entity = nodes.get(p_entity)
		return String(entity.get_parent().name) if entity != null else ""


func _ready() -> void:
	var root: Node = get_parent()
	await root.ready
	for node: Node in root.find_children("*", "Node", true, false):
		var entity: Entity = node as Entity
		if entity != null and entity.type != null:
			var id: int = EntityTable.FIRST_OTHER + _host.nodes.size()
			_host.nodes[id] = entity
			entity.owner_session = _host.session()
			entity.start(_host, id, entity.type.spawn_schema().defaults())
