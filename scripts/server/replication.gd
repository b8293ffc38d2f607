class_name Replication
extends RefCounted
## Tells all clients where people and props are, each as far as its share of the network goes.

var _encoder: SnapshotEncoder = SnapshotEncoder.new()
var _registry: BodyRegistry = BodyRegistry.new()
var _link: ServerLink = null
var _actors: ServerPeople = null
var _bits_per_second: float = 0.0
var _error_deg: float = Protocol.POSE_ERROR_DEG
## Who is there: session to the id of its person, -1 without a body.
var _clients: Dictionary[int, int] = {}
var _sessions: PackedInt32Array = PackedInt32Array()
var _known: Dictionary[int, bool] = {}
## When a client came or returned, µs, and what it has told of itself.
var _since_usec: Dictionary[int, int] = {}
var _told: Dictionary[int, Dictionary] = {}


func _init(
	p_link: ServerLink,
	p_actors: ServerPeople,
	p_tick_rate: int,
	p_bits_per_second: float,
	p_error_deg: float
) -> void:
	_link = p_link
	_actors = p_actors
	_bits_per_second = p_bits_per_second
	_error_deg = p_error_deg
	_encoder.configure(PackedInt32Array(Limbs.PARENTS), p_error_deg, p_tick_rate)
	_link.ack_received.connect(_on_ack)
	_link.stats_received.connect(_on_stats)


## Takes a world in, and finds out which parts of it can be seen from which.
func watch_world(p_world: Node3D) -> void:
	_registry.add_world(p_world)
	_registry.watch_world(_encoder)
	var begin: int = Time.get_ticks_usec()
	var cells: VisibilityCells = VisibilityCells.survey(p_world)
	if cells == null:
		return
	_encoder.set_cells(cells.origin, cells.size, cells.counts, cells.visible)
	var parts: Array = [
		cells.counts.x * cells.counts.y * cells.counts.z,
		100.0 * cells.openness(),
		(Time.get_ticks_usec() - begin) / 1000.0,
	]
	Log.info("server", "%d cells, %.0f %% of pairs in sight of each other (%.0f ms)" % parts)


## Takes a client in, also one that returns: it knows nothing yet. A rate of 0 means every tick.
func add_client(p_session: int, p_rate: int) -> void:
	_clients[p_session] = -1
	_since_usec[p_session] = Time.get_ticks_usec()
	_sessions = PackedInt32Array(_clients.keys())
	_encoder.add_client(p_session, p_rate, _bits_per_second)


## Forgets a client.
func remove_client(p_session: int) -> void:
	_clients.erase(p_session)
	_told.erase(p_session)
	_sessions = PackedInt32Array(_clients.keys())
	_encoder.remove_client(p_session)


## Tells everybody which bodies there are now.
func announce() -> void:
	var people: Array[ServerPeople.Person] = _actors.list()
	var here: Dictionary[int, bool] = {}
	for person: ServerPeople.Person in people:
		here[person.id] = true
		if not _known.has(person.id):
			_known[person.id] = true
			BodyRegistry.watch_person(_encoder, person)
		# Of several people of a client the first one's surroundings count most.
		if _clients.has(person.session) and person.card.index == 0:
			_clients[person.session] = person.id
			_encoder.set_own_person(person.session, person.id)
	for id: int in _known.keys():
		if not here.has(id):
			_known.erase(id)
			_encoder.remove_person(id)
	var world: WorldDescription = _registry.describe(people)
	world.pose_error_deg = _error_deg
	_link.send_world(world)


## Tells everybody what a tick has changed. The time is that of the tick's end, µs.
func send(p_tick: int, p_now_usec: int) -> void:
	_actors.hand_poses(_encoder)
	_encoder.capture(p_tick)
	_actors.mark(_encoder, p_now_usec)
	var datagrams: Array[PackedByteArray] = []
	var sessions: PackedInt32Array = _encoder.encode_each(
		_sessions, Time.get_ticks_usec(), datagrams
	)
	_link.send_datagrams(sessions, datagrams)


## Stats of a client since it came, for a status; empty if it is not here.
func stats_of(p_session: int) -> Dictionary:
	var sent: Dictionary = _encoder.get_stats(p_session) if _clients.has(p_session) else {}
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
	stats.merge(_told.get(p_session, {}))
	return stats


func _on_ack(p_session: int, p_bytes: PackedByteArray, _p_arrival_usec: int) -> void:
	if not _encoder.take_ack(p_session, p_bytes):
		Log.limited("net", "ack %d" % p_session, "session %d acknowledges nonsense" % p_session)


func _on_stats(p_session: int, p_stats: Dictionary) -> void:
	if _clients.has(p_session):
		_told[p_session] = p_stats
