extends RefCounted
## A client that commands a vehicle over the network: as it should, or with bytes that no client of
## ours makes.

var _port: int = 0
var _link: ClientLink = ClientLink.new()
var _request: JoinRequest = JoinRequest.new()
var _replica: LoadReplica = LoadReplica.new(SharedTables.new())
var _waiting: Array[EntityCommand] = []
var _number: int = 0


func _init(p_name: String, p_port: int) -> void:
	_port = p_port
	_request.name = p_name
	_request.role = Roles.Role.OBSERVER
	_link.state_received.connect(_on_state)
	_link.open("127.0.0.1", p_port, _request)


## Whether it knows of a vehicle.
func knows(p_vehicle: String) -> bool:
	return _link.is_joined() and _row(p_vehicle) != null


## Its session.
func session() -> int:
	return _link.session


## Sends a command of a vehicle, with [method poll].
func command(p_vehicle: String, p_name: StringName, p_values: PackedFloat32Array = []) -> void:
	var type: EntityType = _row(p_vehicle).type
	var index: int = type.find_command(p_name)
	forge(p_vehicle, index, type.commands[index].encode(p_values))


## Sends a command by its number, with any bytes.
func forge(p_vehicle: String, p_command: int, p_bytes: PackedByteArray) -> void:
	var made: EntityCommand = EntityCommand.new()
	made.number = _number
	_number = (_number + 1) & 0xFFFF
	made.tick = maxi(_replica.newest_tick, 0)
	made.entity = _row(p_vehicle).id
	made.command = p_command
	made.bytes = p_bytes
	_waiting.append(made)


## Number of a command of a vehicle.
func number_of(p_vehicle: String, p_name: StringName) -> int:
	return _row(p_vehicle).type.find_command(p_name)


## Takes what has come, and sends what waits.
func poll() -> void:
	_link.poll()
	if not _link.is_joined():
		return
	var ack: PackedByteArray = _replica.acknowledgement(Time.get_ticks_usec(), Vector3.ZERO)
	if not ack.is_empty():
		_link.send_fast(ack)
	while not _waiting.is_empty():
		var few: Array[EntityCommand] = _waiting.slice(0, CommandMessage.MAX_REPEATED)
		_waiting = _waiting.slice(few.size())
		_link.send_fast(CommandMessage.encode(few))


## Leaves.
func leave() -> void:
	_link.leave()


func _row(p_vehicle: String) -> EntityRow:
	for row: EntityRow in _replica.table.rows.values():
		if row.title() == p_vehicle:
			return row
	return null


func _on_state(p_bytes: PackedByteArray, p_arrival_usec: int) -> void:
	_replica.take(p_bytes, p_arrival_usec / 1e6)
