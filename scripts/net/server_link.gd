class_name ServerLink
extends RefCounted
## The server's end of all connections: its sessions, what they send and what they receive.
##
## This is the seam behind which the transport may change: nobody else handles peers' packets. The
## rest of the program knows clients by the numbers of their sessions. Godot's multiplayer API runs
## over a [ThreadedPeer], polled by hand in the physics tick, without relaying between clients;
## poses, acknowledgements and snapshots take its fast path. Everything that arrives is checked;
## what is invalid is dropped with a log line that names the client.

## A client was admitted. [param p_hello] has name, role and rate.
signal client_joined(p_session: int, p_hello: Dictionary)
## A client's connection is lost; its session is kept for [constant SessionTable.KEPT_S] seconds.
signal client_lost(p_session: int)
## A client is back, after its connection was lost or because it has a new one.
signal client_returned(p_session: int)
## A client is gone for good.
signal client_left(p_session: int)
## A trainee says whose motion it sends from now on.
signal people_declared(p_session: int, p_people: Array[PersonCard])
## A trainee sent a sample that is a valid pose. It arrived at [method Time.get_ticks_usec].
signal pose_received(p_session: int, p_sample: PoseSample, p_arrival_usec: int)
## A client acknowledges snapshots; the bytes begin with [constant Protocol.Message.ACK].
signal ack_received(p_session: int, p_bytes: PackedByteArray, p_arrival_usec: int)
## A client's own stats have come: see [method StatsMessage.decode].
signal stats_received(p_session: int, p_stats: Dictionary)
## Who is here, lost or waiting has changed; see [method roster].
signal roster_changed

## Time between two checks for overdue sessions and peers, µs.
const _LOOK_USEC: int = 100000

## Bytes in and out.
var traffic: TrafficMeter = TrafficMeter.new()
## What clients that look for servers get, from now on: see [ServerAnnouncement].
var announcement: PackedByteArray = PackedByteArray():
	set(p_bytes):
		announcement = p_bytes
		if _peer != null:
			_peer.announcement = p_bytes
## Whom the server admits.
var rules: ServerRules = ServerRules.new()
## Number of messages that were refused since the start, by the key of the complaint.
var refused: Dictionary[String, int]:
	get:
		return _inbox.refused

## Limits of how often sessions may send each message.
var rates: MessageRates:
	get:
		return _inbox.rates

var _api: SceneMultiplayer = null
var _peer: ThreadedPeer = null
var _sessions: SessionTable = SessionTable.new()
var _handshake: ServerHandshake = null
var _message_number: int = 0
var _paced: PacedParts = PacedParts.new()
var _inbox: SessionInbox = SessionInbox.new()
var _ticks: TickClock = TickClock.new()
var _looked_usec: int = 0


func _init() -> void:
	_add_handlers()
	_inbox.overrun.connect(_on_overrun)


## Opens the port at an address of this machine, by default at all. Returns
## [constant ERR_CANT_CREATE] where it is in use, or the address is not this machine's.
func listen(p_port: int, p_rules: ServerRules, p_address: String = "*") -> Error:
	close()
	rules = p_rules
	_peer = ThreadedPeer.new()
	_peer.guard = TransportGuard.new()
	_peer.limits.max_datagram = Protocol.MAX_DATAGRAM
	_peer.limits.max_clients = maxi(TransportLimits.MIN_CLIENTS, rules.max_clients)
	_peer.limits.max_fast = {Protocol.Message.MOTION: MessageRates.MOTIONS}
	_peer.limits.high_from = Protocol.BASED_MOTION
	_peer.limits.high_kind = Protocol.Message.MOTION
	_peer.sealing = rules.sealing()
	_peer.callbacks.instant_kind = Protocol.Message.CLOCK
	_peer.callbacks.instant = _ticks.answer
	var error: Error = _peer.create_server(p_port, p_address)
	if error != OK:
		_peer = null
		return error
	_peer.engine.is_behind = _is_behind
	_peer.troubled.connect(_on_trouble)
	_peer.reopened.connect(_on_reopened)
	_peer.moved.connect(_on_moved)
	_api = SceneMultiplayer.new()
	_api.root_path = ^"/root"
	_api.server_relay = false
	_api.allow_object_decoding = false
	_api.peer_connected.connect(_on_connected)
	_api.peer_disconnected.connect(_on_disconnected)
	_api.peer_packet.connect(_on_packet)
	_handshake = ServerHandshake.new(_api, _peer, rules, _sessions)
	_handshake.changed.connect(roster_changed.emit)
	_handshake.displaced.connect(_end)
	_handshake.refused.connect(_inbox.count.bind("join request"))
	_api.multiplayer_peer = _peer
	return OK


## Takes over changed passwords of [member rules] for clients that connect from now on.
func renew_passwords() -> void:
	if _peer != null:
		_peer.sealing = rules.sealing()


## Processes what has arrived. Call it once per physics tick, before the simulation needs it.
func poll() -> void:
	if _api == null:
		return
	var now: int = Time.get_ticks_usec()
	_inbox.begin_turns()
	_api.poll()
	for _more: int in 64:
		if _peer.has_more():
			_api.poll()
	for packet: FastPacket in _peer.take_fast():
		_on_fast(packet)
	_paced.advance(_send_part)
	_peer.retry_engine()
	if now - _looked_usec > _LOOK_USEC:
		_looked_usec = now
		_look_after_sessions(now)
		traffic.read(_peer.stats())


## Whether the port is open.
func is_listening() -> bool:
	return _peer != null and _peer.get_connection_status() == MultiplayerPeer.CONNECTION_CONNECTED


## The multiplayer API.
func api() -> SceneMultiplayer:
	return _api


## The transport's stats: see [method ThreadedPeer.stats]; peers are named by their sessions.
func stats() -> Dictionary:
	if _peer == null:
		return {}
	var stats: Dictionary = _peer.stats()
	var by_session: Dictionary = {}
	for peer: int in stats.get("peers", {}):
		var session: Session = _sessions.of_peer(peer)
		if session != null:
			by_session[session.id] = stats["peers"][peer]
	stats["peers"] = by_session
	stats["dropped_out_of_turn"] = _inbox.dropped
	return stats


## Sets the present tick and when it began, [method Time.get_ticks_usec]: clients ask for both.
func publish_tick(p_tick: int, p_usec: int, p_tick_rate: int = 60) -> void:
	_ticks.publish(p_tick, p_usec, p_tick_rate)


## Sends datagrams of at most [constant Protocol.MAX_DATAGRAM] bytes, unreliably, each to the
## session of the same index; all at once, as handing over one by one takes longer than sending.
func send_datagrams(p_sessions: PackedInt32Array, p_datagrams: Array[PackedByteArray]) -> void:
	var peers: PackedInt32Array = PackedInt32Array()
	for id: int in p_sessions:
		var session: Session = _sessions.find(id)
		# No peer has the number 0 here.
		peers.append(session.peer if session != null and session.is_here else 0)
	if _peer != null and not peers.is_empty():
		_peer.send_fast_each(peers, p_datagrams)


## Sends a message of any size to sessions, reliably and in order with the others. Paced, a large
## one goes in the next ticks, so that handing it over delays no tick.
func send_reliably(
	p_sessions: PackedInt32Array, p_bytes: PackedByteArray, p_is_paced: bool = false
) -> void:
	_message_number += 1
	var parts: Array[PackedByteArray] = MessageParts.split(p_bytes, _message_number)
	for id: int in p_sessions:
		if p_is_paced or _paced.has(id):
			_paced.add(id, parts)
		else:
			for part: PackedByteArray in parts:
				_send_part(id, part)


## Sends a message that fits into a datagram to a session, reliably, in order with the others.
func send_whole(p_session: int, p_bytes: PackedByteArray) -> void:
	_send_part(p_session, p_bytes)


## Registers the handler of a kind of message; see [method SessionInbox.handle].
func handle(
	p_kind: int, p_path: MessageHandlers.Path, p_handler: Callable, p_capability: int = 0
) -> void:
	_inbox.handle(p_kind, p_path, p_handler, p_capability)


## See [method SessionInbox.complain].
func complain(p_about: Session, p_key: String, p_what: String) -> void:
	_inbox.complain(p_about, p_key, p_what)


## Sessions that are here.
func session_ids() -> PackedInt32Array:
	var ids: PackedInt32Array = []
	for session: Session in _sessions.here():
		ids.append(session.id)
	return ids


## A session by its number, or null.
func session(p_id: int) -> Session:
	return _sessions.find(p_id)


## Everybody who is here, lost or waiting, for an instructor.
func roster() -> Array[RosterRow]:
	var rows: Array[RosterRow] = _sessions.rows()
	if _handshake != null:
		rows.append_array(_handshake.rows())
	return rows


## Admits a waiting peer, by its id. Returns why not, or an empty text.
func admit(p_peer: int) -> String:
	return _handshake.admit(p_peer)


## Position of a peer among those who wait for room, from 1; 0 if it does not wait.
func place_of(p_peer: int) -> int:
	return _handshake.place_of(p_peer)


## Refuses a waiting peer, by its id. Returns why not, or an empty text.
func refuse(p_peer: int, p_why: String) -> String:
	return _handshake.refuse(p_peer, p_why)


## Dismisses a client, which gets a notice with the reason. Returns why not, or an empty text.
func kick(p_session: int, p_why: String) -> String:
	var session: Session = _sessions.find(p_session)
	if session == null:
		return "there is no session %d" % p_session
	Log.info("net", "%s: %s" % [session.describe(), p_why])
	if session.peer != 0:
		_send_reliably(session.peer, NoticeMessage.dismiss(p_why))
		_peer.dismiss(session.peer, DisconnectReason.DISMISSED)
	_end(session)
	return ""


## Closes all connections and the port.
func close() -> void:
	if _peer != null:
		_peer.close_with(DisconnectReason.CLOSED)
		_api.multiplayer_peer = null
	_peer = null
	_api = null
	_handshake = null
	for session: Session in _sessions.all():
		_end(session)


func _look_after_sessions(p_now_usec: int) -> void:
	_handshake.look_after(p_now_usec)
	for session: Session in _sessions.overdue(p_now_usec):
		_end(session)


func _on_connected(p_peer: int) -> void:
	_handshake.forget(p_peer)
	var session: Session = _sessions.of_peer(p_peer)
	if session == null:
		_peer.disconnect_peer(p_peer, true)
		return
	session.is_here = true
	_paced.forget(session.id)
	_inbox.forget(session)
	Log.info("net", "%s %s" % [session.describe(), "is back" if session.was_here else "joined"])
	if session.was_here:
		client_returned.emit(session.id)
	else:
		session.was_here = true
		client_joined.emit(session.id, session.hello())
	roster_changed.emit()


func _on_disconnected(p_peer: int) -> void:
	var session: Session = _sessions.of_peer(p_peer)
	if session == null:
		return
	if _peer.reason_of(p_peer) != DisconnectReason.LOST:
		_end(session)
		return
	Log.info("net", "%s is lost" % session.describe())
	_sessions.detach(session, Time.get_ticks_usec())
	_inbox.forget(session)
	client_lost.emit(session.id)
	roster_changed.emit()


func _end(p_session: Session) -> void:
	_sessions.close(p_session)
	_paced.forget(p_session.id)
	_inbox.forget(p_session)
	rates.forget(p_session.id)
	if p_session.was_here:
		Log.info("net", "%s left" % p_session.describe())
		client_left.emit(p_session.id)
		roster_changed.emit()


## Whether parts of messages to a peer still wait: nodes of a level are not to come before it.
func _is_behind(p_peer: int) -> bool:
	var session: Session = _sessions.of_peer(p_peer)
	return session != null and _paced.has(session.id)


func _on_reopened() -> void:
	Log.limited("net", "reopened", "a network error closed the port: it is open again")


func _on_moved(p_peer: int) -> void:
	var session: Session = _sessions.of_peer(p_peer)
	if session == null:
		return
	var before: String = session.describe()
	_sessions.move(session, _peer.address_of(p_peer))
	Log.limited("net", "moved", "%s goes on from %s" % [before, session.address])
	if rules.bans.has(session.address):
		_on_overrun(session)


func _on_overrun(p_session: Session) -> void:
	_peer.dismiss(p_session.peer, DisconnectReason.THROWN_OUT)
	_end(p_session)


func _on_fast(p_packet: FastPacket) -> void:
	var session: Session = _sessions.of_peer(p_packet.peer)
	if session != null and session.is_here:
		_inbox.take(session, p_packet, MessageHandlers.Path.FAST)


func _on_packet(p_peer: int, p_bytes: PackedByteArray) -> void:
	var session: Session = _sessions.of_peer(p_peer)
	if session != null and session.is_here:
		var packet: FastPacket = FastPacket.new()
		packet.bytes = p_bytes
		packet.arrival_usec = Time.get_ticks_usec()
		_inbox.take(session, packet, MessageHandlers.Path.RELIABLE)


func _add_handlers() -> void:
	var fast: MessageHandlers.Path = MessageHandlers.Path.FAST
	var motion: int = Roles.Capability.SEND_MOTION
	handle(Protocol.Message.ACK, fast, _on_ack)
	handle(Protocol.Message.MOTION, fast, _on_motion, motion)
	handle(Protocol.Message.STATS, fast, _on_stats)
	handle(Protocol.Message.LEAVE, MessageHandlers.Path.RELIABLE, _on_leave)
	handle(Protocol.Message.PEOPLE, MessageHandlers.Path.RELIABLE, _on_people, motion)


func _on_ack(p_session: Session, p_bytes: PackedByteArray, p_arrival_usec: int) -> String:
	ack_received.emit(p_session.id, p_bytes, p_arrival_usec)
	return ""


func _on_stats(p_session: Session, p_bytes: PackedByteArray, _arrival_usec: int) -> String:
	var stats: Dictionary = StatsMessage.decode(p_bytes)
	if stats.is_empty():
		return "stats that are none"
	stats_received.emit(p_session.id, stats)
	return ""


func _on_motion(p_session: Session, p_bytes: PackedByteArray, p_arrival_usec: int) -> String:
	for sample: PoseSample in p_session.motion.read(p_bytes):
		pose_received.emit(p_session.id, sample, p_arrival_usec)
	if not p_session.motion.rider.is_empty():
		ack_received.emit(p_session.id, p_session.motion.rider, p_arrival_usec)
	return p_session.motion.error


func _on_people(p_session: Session, p_bytes: PackedByteArray, _arrival_usec: int) -> String:
	var people: Array[PersonCard] = PeopleMessage.decode(p_bytes)
	if PeopleMessage.error == "":
		people_declared.emit(p_session.id, people)
	return PeopleMessage.error


## A client that leaves proves that the session is its own: what ENet says of it can be forged.
func _on_leave(p_session: Session, p_bytes: PackedByteArray, _arrival_usec: int) -> String:
	if not Crypto.new().constant_time_compare(p_session.token, p_bytes.slice(1)):
		return "a farewell without its token"
	_peer.dismiss(p_session.peer, DisconnectReason.LEFT)
	_end(p_session)
	return ""


func _send_part(p_session: int, p_part: PackedByteArray) -> void:
	var session: Session = _sessions.find(p_session)
	# Who is here is a peer of the API, which need not be asked.
	if session != null and session.is_here and _peer.has_peer(session.peer):
		_api.send_bytes(p_part, session.peer, MultiplayerPeer.TRANSFER_MODE_RELIABLE)


func _send_reliably(p_peer: int, p_bytes: PackedByteArray) -> void:
	if _peer.has_peer(p_peer) and _api.get_peers().has(p_peer):
		_api.send_bytes(p_bytes, p_peer, MultiplayerPeer.TRANSFER_MODE_RELIABLE)


func _on_trouble(p_peer: int, p_key: String, p_what: String) -> void:
	var session: Session = _sessions.of_peer(p_peer)
	if session != null:
		_inbox.log_about(session, p_key, p_what)
	elif p_peer != 0:
		var parts: Array = [_peer.address_of(p_peer), p_what]
		Log.limited("net", p_key, "a client from %s %s" % parts)
	else:
		Log.limited("net", p_key, p_what)
