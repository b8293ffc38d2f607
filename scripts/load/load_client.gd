class_name LoadClient
extends RefCounted
## One client of a load run: it does what a client does, but keeps nothing that only a display
## needs.

## Seconds between two attempts to reach the server.
const RETRY_S: float = 2.0
## The ages are sampled once in this many polls: of many clients each seldom.
const AGES_EVERY: int = 3
const MANY_CLIENTS: int = 32
## With more clients those that only watch have no threads of their own: two processors cannot wake
## so many for each datagram, and are busy with nothing else.
const MAX_THREADED: int = 64

## Shown to the others.
var name: String = ""
## What the server has sent.
var replica: LoadReplica = null
## What has been counted since [method begin_counting].
var stats: LoadStats = LoadStats.new()
## Why the server refuses this client, or an empty text.
var refusal: String = ""

var _options: Options = null
var _link: ClientLink = ClientLink.new()
var _request: JoinRequest = JoinRequest.new()
var _motion: ClientMotion = null
var _sender: MotionSender = null
var _walker: LoadWalker = null
var _agreement: LoadAgreement = null
var _viewpoint: Vector3 = Vector3.ZERO
var _newest: Dictionary[int, int] = {}
var _retry_usec: int = 0
var _was_joined: bool = false
var _polls: int = 0
var _ages_every: int = AGES_EVERY


func _init(
	p_name: String, p_options: Options, p_agreement: LoadAgreement, p_tables: SharedTables
) -> void:
	name = p_name
	replica = LoadReplica.new(p_tables)
	var clients: int = LoadOptions.count_clients(p_options)
	_ages_every = AGES_EVERY * maxi(ceili(float(clients) / MANY_CLIENTS), 1)
	_link.has_thread = clients <= MAX_THREADED
	_options = p_options
	_agreement = p_agreement
	_request.name = p_name
	_request.rate = p_options.number("snapshot-rate")
	_link.joined.connect(_on_joined)
	_link.lost.connect(_on_lost)
	_link.refused.connect(_on_refused)
	_link.waiting.connect(_on_waiting)
	_link.state_received.connect(_on_state)
	replica.marked.connect(_on_marked)


## Makes it a trainee who moves by a source. Its samples leave between two polls.
func wear(p_source: MotionSource) -> void:
	_link.has_thread = true
	_request.role = Roles.Role.TRAINEE
	_motion = ClientMotion.new()
	_sender = MotionSender.new()
	_sender.start(_options.number("rate"), _link)
	_motion.start(p_source, _sender, _link)


## Makes it a trainee without a suit, who walks; each number walks elsewhere.
func walk(p_number: int) -> void:
	_request.role = Roles.Role.TRAINEE
	_walker = LoadWalker.new(_link, replica, p_number)


## Sets from where the client looks, m.
func look_from(p_position: Vector3) -> void:
	_viewpoint = p_position


## Sets what knows the server by its key; all clients of a program can have the same.
func trust_by(p_trust: ServerTrust) -> void:
	_link.trust = p_trust


## Begins to connect.
func open() -> void:
	_retry_usec = 0
	_link.open(_options.text("host"), _options.number("port"), _request, _options.text("password"))


## Whether it is on its way: it has begun to join, and is neither admitted nor waiting for its next
## attempt.
func is_joining() -> bool:
	return not _link.is_joined() and _retry_usec == 0


## Whether the server has admitted it.
func is_joined() -> bool:
	return _link.is_joined()


## Processes what has arrived, acknowledges it, and counts.
func poll() -> void:
	_link.poll()
	var now: int = Time.get_ticks_usec()
	if _retry_usec > 0 and now > _retry_usec:
		open()
	if not _link.is_joined():
		return
	var bytes: PackedByteArray = replica.acknowledgement(now, _viewpoint)
	if not bytes.is_empty() and _motion == null:
		_link.send_fast(bytes)
	if _motion != null:
		_motion.keep_in_step()
		if not bytes.is_empty():
			_sender.send_ack(bytes)
	if _walker != null:
		_walker.advance()
	_polls += 1
	if _polls % _ages_every == 0:
		_sample_ages(now)


## Forgets what was counted.
func begin_counting() -> void:
	stats = LoadStats.new()


## The people who are there and whose state is known.
func people_known() -> int:
	var known: int = 0
	for row: EntityRow in replica.table.people():
		known += 1 if _newest.has(row.id) else 0
	return known


## The stats for a report.
func report() -> Dictionary:
	var result: Dictionary = {
		"name": name,
		"role": name.get_slice(" ", 0),
		"session": _link.session,
		"joined": is_joined(),
		"people_known": people_known(),
		"round_trip_ms": _link.clock.round_trip_usec / 1000.0,
		"clock_jitter_ms": _link.clock.jitter_usec / 1000.0,
	}
	result.merge(stats.report())
	if _motion != null:
		result["samples"] = _motion.stats()
	return result


## Leaves.
func close() -> void:
	if _motion != null:
		_motion.stop()
		_sender.stop()
	_link.leave()


## For each person, how long ago the tick of the newest known pose began.
func _sample_ages(p_now_usec: int) -> void:
	if not _link.clock.is_known():
		return
	for row: EntityRow in replica.table.people():
		if _newest.has(row.id):
			var began: int = _link.clock.local_usec_of_tick(_newest[row.id])
			stats.ages.add((p_now_usec - began) / 1000.0)
		else:
			stats.unknown += 1


func _on_joined() -> void:
	if _was_joined:
		stats.returned += 1
	_was_joined = true
	replica.clear()
	_newest.clear()
	if _motion != null:
		_link.declare_people([_motion.card] as Array[PersonCard])
		_sender.restart()
		_sender.set_sending(true)
	if _walker != null:
		_link.declare_people([PersonCard.of(name, 0.95)] as Array[PersonCard])
		_walker.restart()


func _on_refused(p_why: String) -> void:
	refusal = p_why if _link.other_key != null else "the server refused us: %s" % p_why


func _on_waiting(p_position: int, p_for: JoinReply.Wait) -> void:
	var what: String = "an instructor" if p_for == JoinReply.Wait.INSTRUCTOR else "room"
	Log.limited("load", name, "%s waits for %s, position %d" % [name, what, p_position])


func _on_lost(p_why: String) -> void:
	Log.limited("load", name, "%s: %s" % [name, p_why])
	if _was_joined:
		stats.lost += 1
	if _motion != null:
		_sender.set_sending(false)
	_retry_usec = Time.get_ticks_usec() + int(RETRY_S * 1e6)


func _on_state(p_bytes: PackedByteArray, p_arrival_usec: int) -> void:
	var useful: bool = replica.take(p_bytes, p_arrival_usec / 1e6)
	var kind: int = p_bytes[0]
	if not Protocol.SNAPSHOTS.has(kind):
		return
	stats.took(replica.outcome, p_bytes.size())
	if not useful:
		return
	var tick: int = replica.decoder.get_tick()
	for person: int in replica.decoder.get_people():
		_newest[person] = maxi(_newest.get(person, -1), tick)
		if _agreement.wants(tick, person):
			_agreement.take(tick, person, _fingerprint_of(person))


func _on_marked(p_mark: LatencyMark) -> void:
	if _link.clock.is_known():
		p_mark.arrival_usec = _link.clock.server_usec(p_mark.arrival_usec)
		stats.marked(p_mark)


## A number that is the same at every client whose last datagram had the same of a person: the
## root's position and the limbs' orientations.
func _fingerprint_of(p_person: int) -> int:
	var decoder: SnapshotDecoder = replica.decoder
	return hash([decoder.get_root(p_person), decoder.get_orientations(p_person)])
