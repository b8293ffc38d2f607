class_name ClientLink
extends RefCounted
## A client's end of the connection, the counterpart of [ServerLink].
##
## It joins by a [ClientHandshake], then sends samples and receives snapshots. Polled by hand; what
## arrives in between is kept with its time of arrival. If the connection is lost, [method open]
## brings the client back into its session.

## The server has admitted us.
signal joined
## We wait; our position among those who wait for the same, from 1.
signal waiting(p_position: int, p_for: JoinReply.Wait)
## The server refuses us, and says why. Trying again is useless.
signal refused(p_why: String)
## The server does not answer, is gone, or cannot admit us now; trying again may help.
signal lost(p_why: String)
## A message about the state of the world that arrived at [method Time.get_ticks_usec]: a snapshot's
## datagram, a change of the entity table, events, a level. Not checked yet.
signal state_received(p_bytes: PackedByteArray, p_arrival_usec: int)
## An instructor asks that one of our people be calibrated; the number is for the answer, a
## [WearerMessage].
signal calibration_asked(p_index: int, p_pose: int, p_number: int)
## The server has something to say to our user.
signal notified(p_text: String)

## The state of a connection.
enum State {
	## There is none.
	CLOSED,
	## The server has not admitted us yet.
	CONNECTING,
	## We wait for an instructor, or for room.
	WAITING,
	## The server has admitted us.
	JOINED,
}

## Seconds to wait for a server's answer.
const PATIENCE_S: float = 5.0

## Bytes in and out.
var traffic: TrafficMeter = TrafficMeter.new()
## The server's clock.
var clock: ClockSync = ClockSync.new()
## Number of our session, once joined.
var session: int = 0
## Whether that is the session that we had before the connection was lost.
var came_back: bool:
	get:
		return _handshake.came_back
## Whether the connection is sealed.
var seals: bool:
	get:
		return _handshake.seals
	set(p_seals):
		_handshake.seals = p_seals
## Whether the server has asked us to come later, in the connection before.
var was_put_off: bool = false
## Whether a thread serves the connection; see [member ThreadedPeer.has_thread].
var has_thread: bool = true
## Whether there is a level whose shared nodes take what the server's spawners and synchronizers
## send; without one that is dropped. Set it before [method open].
var takes_shared: bool = false
## Keeps the session's token, so that a client whose program crashed can come back; null keeps it in
## memory only.
var token_file: SessionTokenFile:
	get:
		return _handshake.token_file
	set(p_file):
		_handshake.token_file = p_file

## Decides which keys of servers are trusted.
var trust: ServerTrust:
	get:
		return _handshake.trust
	set(p_trust):
		_handshake.trust = p_trust
## The key because of which this end refused the server, after [signal refused]; else null.
var other_key: OtherServerKey:
	get:
		return _handshake.trust.other

var _api: SceneMultiplayer = null
var _peer: ThreadedPeer = null
var _handshake: ClientHandshake = ClientHandshake.new()
var _fast: ClientFastPath = ClientFastPath.new()
var _state: State = State.CLOSED
var _parts: MessageParts = MessageParts.new()
var _began_usec: int = 0
var _where: String = ""
var _why: String = ""
var _over: bool = false
var _refusal: String = ""
var _level: PackedByteArray = PackedByteArray()
var _handlers: MessageHandlers = MessageHandlers.new()


func _init() -> void:
	_handshake.welcomed.connect(_on_welcome)
	_handshake.waiting.connect(_on_waiting)
	_handshake.refused.connect(_give_up)
	_handshake.put_off.connect(_come_later)
	_add_handlers()


## Begins to connect; the outcome comes as a signal from [method poll].
func open(p_host: String, p_port: int, p_request: JoinRequest, p_password: String = "") -> void:
	close()
	_where = "%s:%d" % [p_host, p_port]
	_handshake.prepare(KnownServers.address(p_host, p_port), p_request, p_password)
	_began_usec = Time.get_ticks_usec()
	_state = State.CONNECTING
	_why = ""
	_over = false
	was_put_off = false
	_refusal = ""
	clock.clear()
	_parts = MessageParts.new()
	_peer = ThreadedPeer.new()
	_peer.takes_engine = takes_shared
	_peer.has_thread = has_thread
	_peer.limits.max_datagram = Protocol.MAX_DATAGRAM
	_peer.sealing = _handshake.sealing()
	_fast.attach(_peer)
	_peer.failed.connect(_on_failed)
	_peer.troubled.connect(_on_troubled)
	_api = SceneMultiplayer.new()
	_api.root_path = ^"/root"
	_api.server_relay = false
	_api.allow_object_decoding = false
	_handshake.attach(_api, _peer)
	_api.connected_to_server.connect(_on_joined)
	_api.peer_packet.connect(_on_packet)
	var error: Error = _peer.create_client(p_host, p_port)
	if error != OK:
		_why = "no connection to %s: %s" % [_where, error_string(error)]
		return
	_api.multiplayer_peer = _peer


## Whether the server has admitted us.
func is_joined() -> bool:
	return _state == State.JOINED


## Whether we wait for an instructor, or for room.
func is_waiting() -> bool:
	return _state == State.WAITING


## The multiplayer API; another one after each [method open].
func api() -> SceneMultiplayer:
	return _api


## Processes what has arrived and checks whether the connection still stands.
func poll() -> void:
	if _state == State.CLOSED:
		return
	if _why == "":
		_api.poll()
		for _more: int in 64:
			if not _over and _state != State.CLOSED and _peer.has_more():
				_api.poll()
	if _state == State.CLOSED:
		return
	traffic.read(_peer.stats())
	_take_fast()
	if _state == State.CLOSED:
		return
	if _over:
		close()
		if _refusal != "":
			refused.emit(_refusal)
		else:
			lost.emit(_why)
		return
	var stands: bool = _peer.get_connection_status() != MultiplayerPeer.CONNECTION_DISCONNECTED
	if not stands or _why != "":
		_end(_why if _why != "" and _state != State.JOINED else _loss())
	elif _state == State.CONNECTING and _age_s() > PATIENCE_S:
		_end(_no_answer())


## Sends the server the cards of the people whose motion we send, if we are joined.
func declare_people(p_people: Array[PersonCard]) -> void:
	send_reliably(PeopleMessage.encode(p_people))


## Sends a message of at most [constant Protocol.MAX_DATAGRAM] bytes, reliably and in order with the
## others, if we are joined.
func send_reliably(p_bytes: PackedByteArray) -> void:
	if _state != State.JOINED:
		return
	# The connection may have ended since the last poll.
	if _peer.get_connection_status() == MultiplayerPeer.CONNECTION_CONNECTED:
		_api.send_bytes(
			p_bytes, MultiplayerPeer.TARGET_PEER_SERVER, MultiplayerPeer.TRANSFER_MODE_RELIABLE
		)


## Lets what the server's spawners and synchronizers send wait while a level loads, or takes it in
## now that it is there.
func hold_shared(p_holds: bool) -> void:
	if _peer != null and p_holds:
		_peer.inbox.hold()
	elif _peer != null:
		_peer.inbox.release()


## Registers the handler of a kind of message of the server, once; see [method MessageHandlers.add].
## [code]func(bytes: PackedByteArray, arrival_usec: int) -> bool[/code] returns whether it is valid.
func handle(p_kind: int, p_path: MessageHandlers.Path, p_handler: Callable) -> void:
	_handlers.add(p_kind, p_path, p_handler)


## Sends a datagram over the fast path, if we are joined. It leaves at once. Any thread may call it.
func send_fast(p_bytes: PackedByteArray) -> void:
	_fast.send(p_bytes)


## Says who takes what the server has of our motion: at once, in the transport's thread, without
## waiting for a frame; the sooner, the smaller the next samples are.
## [code]func(ack: PackedByteArray) -> void[/code], or none.
func set_motion_ack_taker(p_taker: Callable) -> void:
	_fast.set_motion_ack_taker(p_taker)


## Round trip (ms) and loss (0 to 1) of the connection, as ENet sees them.
func quality() -> Dictionary:
	var peers: Dictionary = _peer.stats().get("peers", {}) if _peer != null else {}
	return peers.get(MultiplayerPeer.TARGET_PEER_SERVER, {})


## Leaves for good: nothing is kept to come back with.
func leave() -> void:
	if _state == State.JOINED:
		send_reliably(PackedByteArray([Protocol.Message.LEAVE]) + _handshake.token())
		_handshake.forget_session()
	close()


## Ends the connection; [method open] brings the client back into its session.
func close() -> void:
	_state = State.CLOSED
	_fast.open(null)
	_handshake.detach()
	if _peer != null:
		var peer: ThreadedPeer = _peer
		_peer = null
		peer.close_with(DisconnectReason.LEFT)
		_api.multiplayer_peer = null


func _on_troubled(_peer_number: int, _key: String, p_what: String) -> void:
	notified.emit(p_what)


func _on_failed(p_why: String) -> void:
	if not _peer.shown_key.is_empty():
		_give_up(_handshake.explain_other_key(_peer.shown_key))
	elif _peer.is_refused:
		_give_up(p_why)
	else:
		_why = p_why


func _loss() -> String:
	if _state != State.JOINED:
		return _no_answer()
	match _peer.reason_of(MultiplayerPeer.TARGET_PEER_SERVER):
		DisconnectReason.CLOSED:
			return "the server at %s was closed" % _where
		DisconnectReason.THROWN_OUT:
			return "the server at %s has thrown us out" % _where
		DisconnectReason.REPLACED:
			return "another connection to %s has replaced ours" % _where
	return "the connection to %s is lost%s" % [_where, ": " + _why if _why != "" else ""]


func _no_answer() -> String:
	var excuse: String = _peer.stats().get("excuse", "") if _peer != null else ""
	return excuse if excuse != "" else "no server answers at %s" % _where


func _on_waiting(p_position: int, p_for: JoinReply.Wait) -> void:
	_state = State.WAITING
	waiting.emit(p_position, p_for)


func _on_welcome(p_reply: JoinReply) -> void:
	session = p_reply.session
	_level = LevelMessage.encode(p_reply.level_name, p_reply.level_fingerprint)


func _on_joined() -> void:
	_state = State.JOINED
	Log.info("net", _handshake.describe_security())
	_fast.open(_peer)
	traffic.restart()
	joined.emit()
	# The welcome has named the level; to the rest of the program it is a change of level.
	_on_state(_level, Time.get_ticks_usec())


func _add_handlers() -> void:
	var fast: MessageHandlers.Path = MessageHandlers.Path.FAST
	var reliable: MessageHandlers.Path = MessageHandlers.Path.RELIABLE
	for kind: int in Protocol.SNAPSHOTS:
		_handlers.add(kind, fast, _on_state)
	for kind: int in [Protocol.Message.TABLE, Protocol.Message.LEVEL]:
		_handlers.add(kind, reliable, _on_state)
	_handlers.add(Protocol.Message.EVENTS, MessageHandlers.Path.ANY, _on_state)
	_handlers.add(Protocol.Message.IMPACTS, fast, _on_state)
	_handlers.add(Protocol.Message.CLOCK, fast, _on_clock)
	_handlers.add(Protocol.Message.CONTROL, reliable, _on_control)


func _take_fast() -> void:
	for packet: FastPacket in _peer.take_fast():
		_handle(packet.bytes, MessageHandlers.Path.FAST, packet.arrival_usec)
		if _state == State.CLOSED:
			return


func _on_packet(p_peer: int, p_bytes: PackedByteArray) -> void:
	if p_peer != MultiplayerPeer.TARGET_PEER_SERVER or p_bytes.is_empty() or _over:
		return
	var whole: PackedByteArray = p_bytes
	if p_bytes[0] == Protocol.Message.PART:
		whole = _parts.join(p_bytes)
		if whole.is_empty():
			return
	_handle(whole, MessageHandlers.Path.RELIABLE, Time.get_ticks_usec())


func _handle(p_bytes: PackedByteArray, p_path: MessageHandlers.Path, p_arrival_usec: int) -> void:
	var entry: MessageHandlers.Handler = _handlers.find(p_bytes, p_path)
	if entry == null or not entry.handler.call(p_bytes, p_arrival_usec):
		_complain(p_bytes.size())


func _on_state(p_bytes: PackedByteArray, p_arrival_usec: int) -> bool:
	if _state == State.JOINED:
		state_received.emit(p_bytes, p_arrival_usec)
	return true


func _on_clock(p_bytes: PackedByteArray, p_arrival_usec: int) -> bool:
	var reply: ClockMessage = ClockMessage.decode(p_bytes)
	if reply != null:
		clock.arrived(reply, p_arrival_usec)
	return true


func _on_control(p_bytes: PackedByteArray, _arrival_usec: int) -> bool:
	var notice: NoticeMessage = NoticeMessage.decode(p_bytes)
	if notice == null:
		return false
	match notice.kind:
		Protocol.Notice.CALIBRATE:
			calibration_asked.emit(notice.index, notice.pose, notice.number)
		Protocol.Notice.DISMISSED:
			_handshake.forget_session()
			_give_up(notice.text)
		Protocol.Notice.TELL:
			notified.emit(notice.text)
	return true


func _complain(p_size: int) -> void:
	Log.limited("net", "server", "%s sent %d bytes that make no sense" % [_where, p_size])


## The API is still reading: [method poll] ends it.
func _give_up(p_why: String) -> void:
	if not _over:
		_handshake.detach()
		_over = true
		_refusal = p_why


func _come_later(p_why: String) -> void:
	if not _over:
		_handshake.detach()
		_over = true
		was_put_off = true
		_why = p_why


func _end(p_why: String) -> void:
	close()
	lost.emit(p_why)


func _age_s() -> float:
	return (Time.get_ticks_usec() - _began_usec) / 1e6
