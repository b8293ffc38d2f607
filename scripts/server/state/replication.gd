class_name Replication
extends RefCounted
## Sends all clients the entities and their state, each client as much as its share of the network
## allows.

## Ticks between two messages with changes of the table: those of a crowd that joins go together.
const _TABLE_TICKS: int = 3
## Time of a tick for finding what can be seen from where, µs.
const _SURVEY_USEC: int = 2000

## The encoder, which also has the entities' fields.
var encoder: SnapshotEncoder = SnapshotEncoder.new()

var _link: ServerLink = null
var _level: ServerLevel = null
var _people: ServerPeople = null
var _bits_per_second: float = 0.0
var _error_deg: float = Protocol.POSE_ERROR_DEG
var _cache: EntityTableCache = null
## What has changed in the table since the last message.
var _changes: EntityTableMessage = EntityTableMessage.new()
var _fields: PersonFields = null
var _known_types: int = 0
## The tick whose changes were sent last.
var _table_tick: int = -_TABLE_TICKS
var _defined_types: int = 0
## The sessions, and those that have not been sent the whole table yet.
var _sessions: PackedInt32Array = PackedInt32Array()
var _newcomers: PackedInt32Array = PackedInt32Array()
var _recorder: StateRecorder = null
var _survey: VisibilityCells = null
var _survey_usec: int = 0
## When a client came or returned, µs, and its own stats.
var _since_usec: Dictionary[int, int] = {}
var _client_stats: Dictionary[int, Dictionary] = {}


func _init(
	p_link: ServerLink,
	p_level: ServerLevel,
	p_people: ServerPeople,
	p_tick_rate: int,
	p_bits_per_second: float,
	p_error_deg: float
) -> void:
	_link = p_link
	_level = p_level
	_people = p_people
	_bits_per_second = p_bits_per_second
	_error_deg = p_error_deg
	_cache = EntityTableCache.new(p_level.table)
	_fields = PersonFields.new(encoder, p_level.table)
	encoder.configure(PackedInt32Array(Limbs.PARENTS), p_error_deg, p_tick_rate)
	encoder.set_datagram_overhead(_link.rules.sealing().datagram_overhead())
	_link.ack_received.connect(_on_ack)
	_link.stats_received.connect(_on_stats)
	_level.table.spawned.connect(_on_spawned)
	_level.table.despawned.connect(_on_despawned)
	_level.entity_added.connect(_on_entity_added)
	_level.changed.connect(_on_level_changed)
	_level.leaving.connect(func() -> void: _survey = null)
	_people.person_added.connect(_on_person_added)
	_people.person_attached.connect(_on_person_attached)


## Records to a file everything of every tick, without a client's limits; an empty path means none.
## Returns why it cannot, or an empty text.
func record_to(p_path: String) -> String:
	if p_path == "":
		return ""
	_recorder = StateRecorder.new()
	var fault: String = _recorder.open(p_path)
	if fault != "":
		_recorder = null
		return fault
	_recorder.begin()
	encoder.add_recorder(StateRecorder.CLIENT)
	_newcomers.append(StateRecorder.CLIENT)
	return ""


## Ends the recording.
func close() -> void:
	if _recorder != null:
		_recorder.close()


## Begins to find which parts of the level can be seen from which. Needs the physics space to have
## been stepped since the level came.
func survey() -> void:
	_survey = VisibilityCells.begin_level(_level.level)
	_survey_usec = 0


## Goes on with [method survey], for a part of a tick.
func advance_survey() -> void:
	if _survey == null:
		return
	var begin: int = Time.get_ticks_usec()
	var is_done: bool = _survey.advance_until(begin + _SURVEY_USEC)
	_survey_usec += Time.get_ticks_usec() - begin
	if not is_done:
		return
	var cells: VisibilityCells = _survey
	_survey = null
	if cells.visible.is_empty():
		return
	encoder.set_cells(cells.origin, cells.size, cells.counts, cells.visible)
	var parts: Array = [
		cells.counts.x * cells.counts.y * cells.counts.z,
		100.0 * cells.openness(),
		_survey_usec / 1000.0,
	]
	Log.info("server", "%d cells, %.0f %% of pairs in sight of each other (%.0f ms)" % parts)


## Changes each client's share of the network, bit/s.
func set_bandwidth(p_bits_per_second: float) -> void:
	_bits_per_second = p_bits_per_second
	for session: int in _sessions:
		encoder.set_bandwidth(session, p_bits_per_second)


## Adds a client, or one that returns: it has no state yet. A rate of 0 means every tick.
func add_client(p_session: int, p_rate: int) -> void:
	remove_client(p_session)
	_sessions.append(p_session)
	_newcomers.append(p_session)
	_since_usec[p_session] = Time.get_ticks_usec()
	encoder.add_client(p_session, p_rate, _bits_per_second)
	var own: EntityRow = _level.table.person_of(p_session)
	if own != null:
		encoder.set_own_person(p_session, own.id)
	# Another level may have come since the welcome was sent.
	var session: Session = _link.session(p_session)
	if session != null and session.welcome_level != _level.message():
		_link.send_reliably([p_session], _level.message())


## Forgets a client.
func remove_client(p_session: int) -> void:
	_client_stats.erase(p_session)
	_since_usec.erase(p_session)
	_sessions.erase(p_session)
	_newcomers.erase(p_session)
	encoder.remove_client(p_session)


## Sends everybody what a tick has changed. The time is that of the tick's end, µs; of the messages
## the first goes reliably, the others on the fast path, and empty ones not at all.
func send(p_tick: int, p_now_usec: int, p_events: Array[PackedByteArray]) -> void:
	var is_due: bool = p_tick >= _table_tick + _TABLE_TICKS or p_tick < _table_tick
	# A recording is read in its order: a snapshot of who is in no table yet would be lost, and with
	# it all that are coded against it.
	if is_due or _recorder != null:
		_table_tick = p_tick if _send_table() else _table_tick
	_send_events(p_events)
	_people.hand_poses(encoder)
	_fields.advance(p_tick, _people.list())
	encoder.capture(p_tick)
	_people.mark(encoder, p_now_usec)
	_acknowledge_motion()
	var datagrams: Array[PackedByteArray] = []
	var sessions: PackedInt32Array = encoder.encode_each(
		_sessions, Time.get_ticks_usec(), datagrams
	)
	_link.send_datagrams(sessions, datagrams)
	if _recorder != null:
		for bytes: PackedByteArray in encoder.encode(StateRecorder.CLIENT, Time.get_ticks_usec()):
			_recorder.add(bytes)


## Stats of a client since it came, for a status; empty if it is not here.
func stats_of(p_session: int) -> Dictionary:
	var sent: Dictionary = encoder.get_stats(p_session) if _sessions.has(p_session) else {}
	if sent.is_empty():
		return {}
	var seconds: float = (Time.get_ticks_usec() - _since_usec[p_session]) / 1e6
	var counted: int = maxi(sent["acknowledged"] + sent["lost"], 1)
	var stats: Dictionary = {
		"sent_kbit_per_second": sent["bytes"] * 8.0 / 1000.0 / maxf(seconds, 0.001),
		"datagrams": sent["datagrams"],
		"loss_percent": 100.0 * sent["lost"] / counted,
		"round_trip_ms": sent["round_trip_ms"],
	}
	stats.merge(_client_stats.get(p_session, {}))
	return stats


## Sends new clients the whole table, the others its changes. Returns whether there was anything.
func _send_table() -> bool:
	var table: EntityTable = _level.table
	_changes.types = table.types.slice(_known_types)
	_known_types = table.types.size()
	var has_changed: bool = not (_changes.spawned.is_empty() and _changes.despawned.is_empty())
	has_changed = has_changed or not _changes.types.is_empty()
	if has_changed:
		_changes.version = table.version
		_changes.pose_error_deg = _error_deg
		var others: PackedInt32Array = []
		for session: int in _sessions:
			if not _newcomers.has(session):
				others.append(session)
		_send_to(others, _changes.encode())
		_changes = EntityTableMessage.new()
	if _newcomers.is_empty():
		return has_changed
	var newcomers: PackedInt32Array = _newcomers.duplicate()
	_newcomers.clear()
	var bytes: PackedByteArray = _cache.encode(_error_deg)
	if newcomers.has(StateRecorder.CLIENT):
		_recorder.add(_level.message())
		_recorder.add(bytes)
	_link.send_reliably(newcomers, bytes, true)
	return true


func _acknowledge_motion() -> void:
	for id: int in _sessions:
		var session: Session = _link.session(id)
		var ack: PackedByteArray = (
			session.motion.take_ack() if session != null else PackedByteArray()
		)
		if not ack.is_empty():
			encoder.set_motion_ack(id, ack)


func _send_events(p_events: Array[PackedByteArray]) -> void:
	if not p_events[0].is_empty():
		_send_to(_sessions, p_events[0])
	for message: PackedByteArray in p_events.slice(1):
		if message.is_empty():
			continue
		var copies: Array[PackedByteArray] = []
		copies.resize(_sessions.size())
		copies.fill(message)
		_link.send_datagrams(_sessions, copies)
		if _recorder != null:
			_recorder.add(message)


func _send_to(p_sessions: PackedInt32Array, p_bytes: PackedByteArray) -> void:
	_link.send_reliably(p_sessions, p_bytes)
	if _recorder != null and not _newcomers.has(StateRecorder.CLIENT):
		_recorder.add(p_bytes)


func _on_spawned(p_row: EntityRow) -> void:
	_changes.spawned.append(p_row)
	_define_types()
	encoder.add_entity(p_row.id, p_row.type_number, p_row.values, p_row.version)


func _on_despawned(p_row: EntityRow) -> void:
	var index: int = _changes.spawned.find(p_row)
	if index >= 0:
		_changes.spawned.remove_at(index)
	else:
		_changes.despawned.append(p_row.id)
	_fields.forget(p_row.id)
	encoder.remove_entity(p_row.id)


func _on_entity_added(p_row: EntityRow, p_node: Entity, p_body: PhysicsBody3D) -> void:
	if p_body != null:
		encoder.add_body(p_row.id, p_body.get_rid())
	elif p_node != null and p_node.get_parent() is Node3D and p_row.id != EntityTable.WORLD:
		# Clients that are far away get it later.
		encoder.set_position(p_row.id, (p_node.get_parent() as Node3D).global_position)


## Lets the encoder read a person's limbs, in the order of [constant Limbs.BONES].
func _on_person_added(p_person: ServerPerson) -> void:
	var bodies: Array[RID] = []
	var resets: PackedFloat32Array = []
	var joints: PersonSkeleton = p_person.joints
	var order: PackedInt32Array = p_person.ragdoll.get_limb_order()
	for limb: int in Limbs.COUNT:
		bodies.append(p_person.ragdoll.get_bodies()[order[limb]])
		var reset: Quaternion = joints.reset_orientations[limb]
		resets.append_array([reset.x, reset.y, reset.z, reset.w])
	encoder.add_person(p_person.id, bodies, resets)
	# Of a client with several people the surroundings of the first one count most.
	if p_person.card.index == 0 and _sessions.has(p_person.session):
		encoder.set_own_person(p_person.session, p_person.id)
	_on_person_attached(p_person, -1)


func _on_person_attached(p_person: ServerPerson, p_carrier: int) -> void:
	_fields.attach(p_person, p_carrier)


## Everybody starts again in another level.
func _on_level_changed() -> void:
	_changes = EntityTableMessage.new()
	# The visibility of the last level does not apply to this one.
	encoder.set_cells(Vector3.ZERO, 0.0, Vector3i.ZERO, PackedByteArray())
	# Now, while everybody waits anyway, and not in the tick in which somebody joins.
	_cache.encode(_error_deg)
	# The recorder gets it with the table, as at the beginning.
	_link.send_reliably(_sessions, _level.message())
	for session: int in _sessions:
		if not _newcomers.has(session):
			_newcomers.append(session)
	if _recorder != null and not _newcomers.has(StateRecorder.CLIENT):
		_newcomers.append(StateRecorder.CLIENT)


func _define_types() -> void:
	for number: int in range(_defined_types, _level.table.types.size()):
		var type: EntityType = _level.table.types[number]
		type.define(encoder.define_type, number)
	_defined_types = _level.table.types.size()


func _on_ack(p_session: int, p_bytes: PackedByteArray, _p_arrival_usec: int) -> void:
	if not encoder.take_ack(p_session, p_bytes):
		var session: Session = _link.session(p_session)
		if session != null:
			_link.complain(session, "ack", "acknowledges nonsense")


func _on_stats(p_session: int, p_stats: Dictionary) -> void:
	if _sessions.has(p_session):
		_client_stats[p_session] = p_stats
