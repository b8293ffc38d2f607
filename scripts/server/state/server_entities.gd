class_name ServerEntities
extends SeatAuthority
## The server's side of all entities: sets their fields, gives them the commands of clients, and
## sends their events.

## A session sent a command that it may not, or that is invalid.
signal command_refused(p_session: int, p_why: String)

## Ticks for which an unreliable event is repeated.
const REPEATS: int = 4
## Maximum of events in one tick.
const MAX_EVENTS_PER_TICK: int = 64
## What a body knows of its entity.
const _NUMBER: StringName = &"entity_number"

var _link: ServerLink = null
var _table: EntityTable = null
var _people: ServerPeople = null
var _encoder: SnapshotEncoder = null
var _possession: Possession = Possession.new()
var _nodes: Dictionary[int, Entity] = {}
var _queues: Dictionary[int, CommandQueue] = {}
var _refusals: Dictionary[int, int] = {}
var _tick: int = 0
var _next_event: int = 0
var _reliable: Array[EntityEvent] = []
var _unreliable: Array[EntityEvent] = []


func _init(
	p_link: ServerLink, p_table: EntityTable, p_people: ServerPeople, p_encoder: SnapshotEncoder
) -> void:
	_link = p_link
	_table = p_table
	_people = p_people
	_encoder = p_encoder
	_table.despawned.connect(_on_despawned)
	_people.person_added.connect(_on_person_added)
	# Not by our own member: possession would hold us, as we hold it.
	_possession.has_people = func(session: int) -> bool:
		return p_people.list().any(func(each: ServerPerson) -> bool: return each.session == session)
	_possession.refused.connect(_on_refused)
	_link.handle(
		Protocol.Message.COMMAND, MessageHandlers.Path.FAST, _on_commands, Roles.Capability.COMMAND
	)


## Registers the node of a row's entity.
func bind(p_row: EntityRow, p_node: Entity) -> void:
	_nodes[p_row.id] = p_node
	p_node.owner_session = p_row.owner
	p_node.start(self, p_row.id, p_row.values)


## Notes the body of a row's entity.
func note_body(p_row: EntityRow, p_body: PhysicsBody3D) -> void:
	p_body.set_meta(_NUMBER, p_row.id)


## Gives the entities the commands that are due. Call it once a tick, before the step.
func advance(p_tick: int, p_tick_rate: int) -> void:
	_tick = p_tick
	for session: int in _queues:
		var queue: CommandQueue = _queues[session]
		for command: EntityCommand in queue.take(p_tick, p_tick_rate):
			_apply(session, command)
		if queue.applied >= 0:
			_encoder.set_command_ack(session, queue.applied)


## The messages of a tick's events: the reliable one and the other one; empty bytes for none.
func take_messages() -> Array[PackedByteArray]:
	var messages: Array[PackedByteArray] = [PackedByteArray(), PackedByteArray()]
	if not _reliable.is_empty():
		messages[0] = EventMessage.encode(_reliable)
		_reliable.clear()
	while not _unreliable.is_empty() and _unreliable[0].tick + REPEATS <= _tick:
		_unreliable.pop_front()
	if not _unreliable.is_empty():
		messages[1] = EventMessage.encode(_fitting())
	return messages


## A session has come, or has come back with a new connection: its commands are numbered anew.
func add_session(p_session: int) -> void:
	_queues[p_session] = CommandQueue.new()


## A session is gone for good: whatever it possesses is free again.
func remove_session(p_session: int) -> void:
	_queues.erase(p_session)
	_refusals.erase(p_session)
	var seat: Seat = _possession.seat_of(p_session) as Seat
	if seat != null:
		seat.vacate()
	_possession.forget(p_session)


## Commands of a session that were refused.
func refused_commands(p_session: int) -> int:
	var queue: CommandQueue = _queues.get(p_session)
	return _refusals.get(p_session, 0) + (queue.refused if queue != null else 0)


## The level goes: what waits does not apply to the next one.
func forget_waiting() -> void:
	_reliable.clear()
	_unreliable.clear()
	for session: int in _queues:
		_queues[session].forget_waiting()


func set_field(p_entity: int, p_field: int, p_value: float) -> void:
	_encoder.set_field(p_entity, p_field, p_value)


func send_event(p_entity: int, p_event: int, p_values: PackedFloat32Array) -> void:
	var row: EntityRow = _table.find(p_entity)
	if row == null:
		return
	var schema: EntitySchema = row.type.events[p_event]
	var waiting: int = _reliable.size() if schema.is_reliable else _unreliable.size()
	if waiting >= MAX_EVENTS_PER_TICK * (1 if schema.is_reliable else REPEATS):
		Log.limited("server", "events", "too many events: some are left out")
		return
	var event: EntityEvent = EntityEvent.new()
	event.number = _next_event
	_next_event = (_next_event + 1) & 0xFFFF
	# Events that are sent during a tick are seen with the state at the tick's end.
	event.tick = _tick
	event.entity = p_entity
	event.event = p_event
	event.bytes = schema.encode(p_values)
	if schema.is_reliable:
		_reliable.append(event)
	else:
		_unreliable.append(event)


func send_command(
	_entity: int, _command: int, _values: PackedFloat32Array, _tick_wanted: int
) -> void:
	push_error("The server does not command: it sets what is true.")


func session() -> int:
	return 0


func carry(p_limb: Node3D, p_entity: int, p_holds: bool) -> void:
	var node: Entity = _nodes.get(p_entity)
	var person: ServerPerson = _people.find_by_limb(p_limb)
	if node == null or node.get_body() == null or person == null or person.carrier != null:
		return
	if p_holds:
		var frame: Transform3D = person.ragdoll.motor.get_frame()
		var to_body: Transform3D = node.get_body().global_transform.affine_inverse()
		_people.attach_person(person, p_entity, node.get_body(), to_body * frame)
	else:
		_people.attach_person(person, p_entity, node.get_body(), Transform3D.IDENTITY, true)


func put_down(p_limb: Node3D, p_entity: int) -> void:
	var node: Entity = _nodes.get(p_entity)
	var person: ServerPerson = _people.find_by_limb(p_limb)
	if person == null or node == null or person.carrier != node.get_body():
		return
	# An occupant whose seat leaves the area stays in it.
	if person.sitting == null:
		_people.detach_person(person)


func find_by_body(p_body: Node3D) -> int:
	var person: ServerPerson = _people.find_by_limb(p_body)
	return person.id if person != null else int(p_body.get_meta(_NUMBER, -1))


func name_of(p_entity: int) -> String:
	var row: EntityRow = _table.find(p_entity)
	return row.title() if row != null else ""


func possession() -> Possession:
	return _possession


func attach(p_session: int, p_entity: int, p_seat: SeatGeometry) -> void:
	var node: Entity = _nodes.get(p_entity)
	if node != null and node.get_body() != null:
		_people.attach(p_session, p_entity, node.get_body(), p_seat)


func detach(p_session: int) -> void:
	_people.detach(p_session)


func _on_refused(p_session: int, p_why: String) -> void:
	var session: Session = _link.session(p_session)
	if session != null:
		_link.complain(session, "seat", p_why)
		command_refused.emit(p_session, "%s: %s" % [session.describe(), p_why])


## A session may have taken a seat before its people had bodies.
func _on_person_added(p_person: ServerPerson) -> void:
	var seat: SeatGeometry = _possession.seat_of(p_person.session)
	if seat != null and seat.carries_people:
		attach(p_person.session, seat.entity.id, seat)


func _on_despawned(p_row: EntityRow) -> void:
	_nodes.erase(p_row.id)
	_possession.forget_entity(p_row.id)


func _on_commands(p_session: Session, p_bytes: PackedByteArray, _arrival_usec: int) -> String:
	var queue: CommandQueue = _queues.get(p_session.id)
	var known: int = queue.newest if queue != null else -1
	var newest: int = CommandMessage.newest_in(p_bytes)
	if known >= 0 and not CommandQueue.is_newer(newest, known):
		# It was overtaken, and all that it has is known: it is only checked.
		known = -1
	var commands: Array[EntityCommand] = CommandMessage.decode(p_bytes, known)
	if commands.is_empty():
		return "commands that are none"
	if queue == null:
		return ""
	var refused: int = queue.refused
	for command: EntityCommand in commands:
		queue.push(command, _tick)
	if queue.refused > refused:
		_link.complain(
			p_session,
			"commands",
			"sends more than %d commands a second" % CommandQueue.MAX_PER_SECOND
		)
	return ""


func _apply(p_session: int, p_command: EntityCommand) -> void:
	var row: EntityRow = _table.find(p_command.entity)
	var node: Entity = _nodes.get(p_command.entity)
	var fault: String = _find_fault(p_session, p_command, row, node)
	if fault == "":
		var schema: EntitySchema = row.type.commands[p_command.command]
		var reader: ByteReader = ByteReader.new(p_command.bytes)
		var values: PackedFloat32Array = schema.decode(reader)
		if reader.is_complete():
			node.take_command(p_session, p_command.command, values)
			return
		fault = "values that '%s' cannot have" % schema.name
	_refusals[p_session] = _refusals.get(p_session, 0) + 1
	var session: Session = _link.session(p_session)
	if session != null:
		_link.complain(session, "command", "sent a command that was refused: %s" % fault)
		command_refused.emit(
			p_session, "%s sent a command that was refused: %s" % [session.describe(), fault]
		)


func _find_fault(
	p_session: int, p_command: EntityCommand, p_row: EntityRow, p_node: Entity
) -> String:
	if p_row == null or p_node == null:
		return "there is no entity %d that takes commands" % p_command.entity
	if p_command.command >= p_row.type.commands.size():
		return "%s has no command %d" % [p_row.describe(), p_command.command]
	# The node's type, not the row's: what is only the server's business is not sent.
	var wanted: EntitySchema = p_node.type.commands[p_command.command]
	var session: Session = _link.session(p_session)
	if wanted.capability != 0 and (session == null or not session.can(wanted.capability)):
		return "'%s' is not for its role" % wanted.name
	var seat: StringName = wanted.seat
	if seat != &"":
		var is_occupant: bool = int(p_node.get_value(seat)) == p_session
		return "" if is_occupant else "the session does not sit in the %s's seat" % seat
	match p_row.type.commanded_by:
		EntityType.CommandedBy.NOBODY:
			return "nobody commands %s" % p_row.describe()
		EntityType.CommandedBy.POSSESSOR:
			var name: StringName = p_row.type.commands[p_command.command].name
			var is_own: bool = p_row.is_person() and p_row.owner == p_session
			if name != Seat.TAKE and not is_own and _possession.possessor_of(p_row.id) != p_session:
				return "%s is not possessed by the session" % p_row.describe()
	return ""


## The newest unreliable events that fit a datagram.
func _fitting() -> Array[EntityEvent]:
	var fitting: Array[EntityEvent] = []
	var size: int = 2
	for index: int in range(_unreliable.size() - 1, -1, -1):
		size += EventMessage.HEAD_BYTES + _unreliable[index].bytes.size()
		if size > Protocol.MAX_DATAGRAM or fitting.size() == 255:
			break
		fitting.push_front(_unreliable[index])
	return fitting
