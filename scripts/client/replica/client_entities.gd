class_name ClientEntities
extends EntityHost
## The client's side of all entities: gives them the values and events to display, and sends
## their commands.

## Something strikes something, or scrapes along it, in the tick that is displayed now.
signal struck(p_impact: Impact)

## Period of resending a command that is not acknowledged, and how long it is resent, s.
const _RESEND_S: float = 0.05
const _GIVE_UP_S: float = 3.0

var _stream: StateStream = null
var _replica: WorldReplica = null
var _nodes: Dictionary[int, Entity] = {}
var _sent: Array[EntityCommand] = []
var _next_command: int = 0
var _commanded_s: float = 0.0
var _sent_s: float = 0.0


func _init(p_replica: WorldReplica) -> void:
	_replica = p_replica
	_replica.table.despawned.connect(_on_despawned)


## Sends commands over a stream from now on.
func use(p_stream: StateStream) -> void:
	_stream = p_stream
	restart()


## A connection begins: commands are numbered from the start.
func restart() -> void:
	_sent.clear()
	_next_command = 0


## Registers the node of a row's entity.
func bind(p_row: EntityRow, p_node: Entity) -> void:
	if p_node.type == null or not p_node.type.is_same(p_row.type):
		# The server's type counts; a script may then miss a field, but nothing is misread.
		Log.limited("client", "type", "%s is of another type at the server" % p_row.describe())
		p_node.type = p_row.type
	_nodes[p_row.id] = p_node
	p_node.owner_session = p_row.owner
	p_node.start(self, p_row.id, p_row.values)


## The node of an entity, or null.
func find(p_id: int) -> Entity:
	return _nodes.get(p_id)


## Gives the nodes the present values and events. Call it in every frame.
func advance() -> void:
	for id: int in _replica.active_entities():
		var node: Entity = _nodes.get(id)
		if node != null:
			for index: int in node.type.fields.size():
				node.take_value(index, _replica.field(id, index))
	for event: EntityEvent in _replica.events.take(_replica.shown_tick()):
		_play(event)
	for impact: Impact in _replica.impacts.take(_replica.shown_tick()):
		struck.emit(impact)
	_repeat()


func send_command(p_entity: int, p_command: int, p_values: PackedFloat32Array, p_tick: int) -> void:
	var row: EntityRow = _replica.table.find(p_entity)
	if row == null or _stream == null:
		return
	var command: EntityCommand = EntityCommand.new()
	command.number = _next_command
	_next_command = (_next_command + 1) & 0xFFFF
	command.tick = p_tick if p_tick >= 0 else maxi(int(_replica.shown_tick()), 0)
	command.entity = p_entity
	command.command = p_command
	command.bytes = row.type.commands[p_command].encode(p_values)
	_sent.append(command)
	while _sent.size() > CommandMessage.MAX_REPEATED:
		_sent.pop_front()
	_commanded_s = Time.get_ticks_usec() / 1e6
	_send()


func session() -> int:
	return _stream.session() if _stream != null else 0


func name_of(p_entity: int) -> String:
	var row: EntityRow = _replica.table.find(p_entity)
	return row.title() if row != null else ""


func _on_despawned(p_row: EntityRow) -> void:
	_nodes.erase(p_row.id)


func _send() -> void:
	_sent_s = Time.get_ticks_usec() / 1e6
	_stream.send_fast(CommandMessage.encode(_sent))


## Sends the last commands again until the server has acknowledged the newest.
func _repeat() -> void:
	if _sent.is_empty():
		return
	var now: float = Time.get_ticks_usec() / 1e6
	var newest: int = _sent[-1].number
	if _replica.decoder.get_command_ack() == newest or now - _commanded_s > _GIVE_UP_S:
		_sent.clear()
	elif now - _sent_s > _RESEND_S:
		_send()


func _play(p_event: EntityEvent) -> void:
	var row: EntityRow = _replica.table.find(p_event.entity)
	var node: Entity = _nodes.get(p_event.entity)
	if row == null or node == null or p_event.event >= row.type.events.size():
		return
	var reader: ByteReader = ByteReader.new(p_event.bytes)
	var values: PackedFloat32Array = row.type.events[p_event.event].decode(reader)
	if reader.is_complete():
		node.take_event(p_event.event, values)
