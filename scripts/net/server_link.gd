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

## Datagrams of motion that a client may send per second; more are dropped.
const MAX_POSES: int = 600

## Time between two checks for overdue sessions and peers, µs.
const _LOOK_USEC: int = 100000

## Bytes in and out.
var traffic: TrafficMeter = TrafficMeter.new()
## Whom the server admits.
var rules: ServerRules = ServerRules.new()

var _api: SceneMultiplayer = null
var _peer: ThreadedPeer = null
var _sessions: SessionTable = SessionTable.new()
var _handshake: Handshake = null
var _strikes: RpcErrorLimiter = null
var _message_number: int = 0
var _handlers: MessageHandlers = MessageHandlers.new()
var _ticks: TickClock = TickClock.new()
var _looked_usec: int = 0


func _init() -> void:
	_add_handlers()


## Opens the port. Returns [constant ERR_CANT_CREATE] where it is in use, and
## [constant ERR_UNAVAILABLE] where DTLS is asked for and the engine has none.
func listen(p_port: int, p_rules: ServerRules) -> Error:
	close()
	rules = p_rules
	_peer = ThreadedPeer.new()
	_peer.guard = TransportGuard.new()
	_peer.limits.max_datagram = Protocol.MAX_DATAGRAM
	_peer.limits.max_fast = {Protocol.Message.MOTION: MAX_POSES}
	_peer.limits.high_from = Protocol.BASED_MOTION
	_peer.limits.high_kind = Protocol.Message.MOTION
	_peer.tls = rules.tls
	_peer.instant_kind = Protocol.Message.CLOCK
	_peer.instant = _ticks.answer
	var error: Error = _peer.create_server(p_port)
	if error != OK:
		_peer = null
		return error
	_peer.troubled.connect(_on_trouble)
	_peer.reopened.connect(_on_reopened)
	_api = SceneMultiplayer.new()
	_api.root_path = ^"/root"
	_api.server_relay = false
	_api.allow_object_decoding = false
	_api.peer_connected.connect(_on_connected)
	_api.peer_disconnected.connect(_on_disconnected)
	_api.peer_packet.connect(_on_packet)
	_handshake = Handshake.new(_api, _peer, rules, _sessions)
	_handshake.changed.connect(roster_changed.emit)
	_api.multiplayer_peer = _peer
	_strikes = RpcErrorLimiter.new(_peer)
	OS.add_logger(_strikes)
	return OK


## Processes what has arrived. Call it once per physics tick, before the simulation needs it.
func poll() -> void:
	if _api == null:
		return
	var now: int = Time.get_ticks_usec()
	_strikes.begin()
	_api.poll()
	for _more: int in 64:
		if _peer.has_more():
			_api.poll()
	_throw_out(_strikes.end())
	for packet: FastPacket in _peer.take_fast():
		_on_fast(packet)
	if now - _looked_usec > _LOOK_USEC:
		_looked_usec = now
		_look_after_sessions(now)
		traffic.read(_peer.stats())


## Whether the port is open.
func is_listening() -> bool:
	return _peer != null and _peer.get_connection_status() == MultiplayerPeer.CONNECTION_CONNECTED


## The multiplayer API, for nodes that call each other; see [SessionControl].
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
	return stats


## Says which tick begins, and when, [method Time.get_ticks_usec]: clients ask for it.
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


## Sends a message of any size to sessions, reliably and in order with the others.
func send_reliably(p_sessions: PackedInt32Array, p_bytes: PackedByteArray) -> void:
	_message_number += 1
	var parts: Array[PackedByteArray] = MessageParts.split(p_bytes, _message_number)
	for id: int in p_sessions:
		var session: Session = _sessions.find(id)
		if session != null and session.is_here:
			for part: PackedByteArray in parts:
				_send_reliably(session.peer, part)


## Registers the handler of a kind of message; see [method MessageHandlers.add].
## [code]func(session: Session, bytes: PackedByteArray, arrival_usec: int) -> String[/code] returns
## what is wrong with it, or an empty text.
func handle(
	p_kind: int, p_path: MessageHandlers.Path, p_handler: Callable, p_capability: int = 0
) -> void:
	_handlers.add(p_kind, p_path, p_handler, p_capability)


## Sessions that are here.
func session_ids() -> PackedInt32Array:
	var ids: PackedInt32Array = []
	for session: Session in _sessions.here():
		ids.append(session.id)
	return ids


## A session by its number, or null.
func session(p_id: int) -> Session:
	return _sessions.find(p_id)


## Everybody, for an instructor: dictionaries with session (0 while waiting), peer, name, role,
## address and state (here, lost or waiting).
func roster() -> Array[Dictionary]:
	var rows: Array[Dictionary] = _sessions.rows()
	if _handshake != null:
		rows.append_array(_handshake.rows())
	return rows


## The session of a connection, or null.
func session_of_peer(p_peer: int) -> Session:
	return _sessions.of_peer(p_peer)


## Admits a waiting peer, by its id. Returns why not, or an empty text.
func admit(p_peer: int) -> String:
	return _handshake.admit(p_peer)


## Refuses a waiting peer, by its id. Returns why not, or an empty text.
func refuse(p_peer: int, p_why: String) -> String:
	return _handshake.refuse(p_peer, p_why)


## Dismisses a client, which is told why. Returns why not, or an empty text.
func kick(p_session: int, p_why: String) -> String:
	var session: Session = _sessions.find(p_session)
	if session == null:
		return "there is no session %d" % p_session
	Log.info("net", "%s: %s" % [session.describe(), p_why])
	if session.peer != 0:
		var text: PackedByteArray = ByteReader.text_bytes(p_why.left(JoinReply.MAX_WHY))
		var bytes: PackedByteArray = [Protocol.Message.CONTROL, Protocol.Notice.DISMISSED]
		_send_reliably(session.peer, bytes + text)
		_peer.dismiss(session.peer, DisconnectReason.DISMISSED)
	_end(session)
	return ""


## Asks a trainee's client to calibrate one of its people in a pose (the client knows which poses
## there are). Returns why not, or an empty text.
func ask_calibration(p_session: int, p_index: int, p_pose: int) -> String:
	var session: Session = _sessions.find(p_session)
	if session == null or not session.can(Roles.Capability.SEND_MOTION) or session.peer == 0:
		return "session %d is no trainee that is here" % p_session
	if p_index < 0 or p_index >= PersonCard.MAX_PEOPLE or p_pose < 0 or p_pose > 255:
		return "there is no person %d or no pose %d" % [p_index, p_pose]
	var bytes: PackedByteArray = [
		Protocol.Message.CONTROL, Protocol.Notice.CALIBRATE, p_index, p_pose
	]
	_send_reliably(session.peer, bytes)
	return ""


## Bans a client's address and dismisses it. Returns what went wrong, or an empty text.
func ban(p_session: int, p_why: String) -> String:
	var session: Session = _sessions.find(p_session)
	if session == null:
		return "there is no session %d" % p_session
	var fault: String = rules.bans.add(session.address)
	kick(p_session, p_why)
	return fault


## Closes all connections and the port.
func close() -> void:
	if _strikes != null:
		OS.remove_logger(_strikes)
		_strikes = null
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
	client_lost.emit(session.id)
	roster_changed.emit()


func _end(p_session: Session) -> void:
	_sessions.close(p_session)
	if p_session.was_here:
		Log.info("net", "%s left" % p_session.describe())
		client_left.emit(p_session.id)
		roster_changed.emit()


func _on_reopened() -> void:
	Log.limited("net", "reopened", "a network error closed the port: it is open again")


func _on_fast(p_packet: FastPacket) -> void:
	var session: Session = _sessions.of_peer(p_packet.peer)
	if session != null and session.is_here:
		_handle(session, p_packet.bytes, MessageHandlers.Path.FAST, p_packet.arrival_usec)


func _on_packet(p_peer: int, p_bytes: PackedByteArray) -> void:
	var session: Session = _sessions.of_peer(p_peer)
	if session != null and session.is_here:
		_handle(session, p_bytes, MessageHandlers.Path.RELIABLE, Time.get_ticks_usec())


func _handle(
	p_session: Session, p_bytes: PackedByteArray, p_path: MessageHandlers.Path, p_arrival_usec: int
) -> void:
	var entry: MessageHandlers.Handler = _handlers.find(p_bytes, p_path)
	var kind: int = Protocol.kind_of(p_bytes)
	if entry == null:
		var parts: Array = [p_bytes.size(), kind]
		complain(p_session, "kind", "sent %d bytes of unknown kind %d" % parts)
		return
	if entry.capability != 0 and Roles.ROWS[p_session.role][1] & entry.capability == 0:
		var what: String = Protocol.Message.find_key(kind)
		complain(p_session, "role", "sent %s, which its role may not" % what)
		return
	var fault: String = entry.handler.call(p_session, p_bytes, p_arrival_usec)
	if fault != "":
		complain(p_session, "message %d" % kind, "sent " + fault)


func _add_handlers() -> void:
	var fast: MessageHandlers.Path = MessageHandlers.Path.FAST
	var motion: int = Roles.Capability.SEND_MOTION
	handle(Protocol.Message.ACK, fast, _on_ack)
	handle(Protocol.Message.MOTION, fast, _on_motion, motion)
	handle(Protocol.Message.STATS, fast, _on_stats)
	handle(Protocol.Message.PEOPLE, MessageHandlers.Path.RELIABLE, _on_people, motion)


func _on_ack(p_session: Session, p_bytes: PackedByteArray, p_arrival_usec: int) -> String:
	ack_received.emit(p_session.id, p_bytes, p_arrival_usec)
	return ""


func _on_stats(p_session: Session, p_bytes: PackedByteArray, _arrival_usec: int) -> String:
	stats_received.emit(p_session.id, StatsMessage.decode(p_bytes))
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


func _throw_out(p_peers: Array[int]) -> void:
	for peer: int in p_peers:
		var session: Session = _sessions.of_peer(peer)
		if session != null:
			complain(session, "calls", "was thrown out: its calls make no sense")
			_peer.dismiss(peer, DisconnectReason.THROWN_OUT)
			_end(session)


func _send_reliably(p_peer: int, p_bytes: PackedByteArray) -> void:
	if _peer.has_peer(p_peer) and _api.get_peers().has(p_peer):
		_api.send_bytes(p_bytes, p_peer, MultiplayerPeer.TRANSFER_MODE_RELIABLE)


func _on_trouble(p_peer: int, p_key: String, p_what: String) -> void:
	var session: Session = _sessions.of_peer(p_peer)
	if session != null:
		complain(session, p_key, p_what)
	elif p_peer != 0:
		var parts: Array = [_peer.address_of(p_peer), p_what]
		Log.limited("net", p_key, "a client from %s %s" % parts)
	else:
		Log.limited("net", p_key, p_what)


## Logs what a client did wrong; [param p_key] limits how often.
func complain(p_about: Session, p_key: String, p_what: String) -> void:
	Log.limited("net", "%s %d" % [p_key, p_about.id], "%s %s" % [p_about.describe(), p_what])
