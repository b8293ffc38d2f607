class_name ClientLink
extends RefCounted
## A client's end of the connection, the counterpart of [ServerLink].
##
## It does the handshake, then sends samples and receives snapshots. Polled by hand; what arrives in
## between is kept with its time of arrival. If the connection is lost, [method open] brings the
## client back into its session.

## The server has admitted us.
signal joined
## An instructor will decide; our position among those who wait, from 1.
signal waiting(p_position: int)
## The server refuses us, and says why. Trying again is useless.
signal refused(p_why: String)
## The server does not answer, is gone, or cannot admit us now; trying again may help.
signal lost(p_why: String)
## A message about the state of the world that arrived at [method Time.get_ticks_usec]: a snapshot's
## datagram, a change of the entity table, events, a level. Not checked yet.
signal state_received(p_bytes: PackedByteArray, p_arrival_usec: int)
## An instructor asks that one of our people be calibrated in a pose.
signal calibration_asked(p_index: int, p_pose: int)

## The state of a connection.
enum State {
	## There is none.
	CLOSED,
	## The server has not admitted us yet.
	CONNECTING,
	## An instructor has not admitted us yet.
	WAITING,
	## The server has admitted us.
	JOINED,
}

## Seconds to wait for a server's answer.
const PATIENCE_S: float = 5.0

## Periods of the questions for the time: at first, and then.
const _QUICK_QUESTIONS: int = 20

## Bytes in and out.
var traffic: TrafficMeter = TrafficMeter.new()
## The server's clock.
var clock: ClockSync = ClockSync.new()
## Number of our session, once joined.
var session: int = 0
## DTLS, or null.
var tls: TLSOptions = null

var _api: SceneMultiplayer = null
var _peer: ThreadedPeer = null
# The peer while we are joined, for whichever thread has something to send.
var _fast_peer: ThreadedPeer = null
var _sending: Mutex = Mutex.new()
var _motion_ack_taker: Callable = Callable()
# Held while it is called: it is never called once it was taken away.
var _taking: Mutex = Mutex.new()
var _request: JoinRequest = null
var _password: String = ""
var _challenge: PackedByteArray = PackedByteArray()
var _key: PackedByteArray = PackedByteArray()
var _key_salt: PackedByteArray = PackedByteArray()
var _said: Array[PackedByteArray] = []
var _locked: bool = false
var _token: PackedByteArray = PackedByteArray()
var _token_of: String = ""
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
	_add_handlers()


## Begins to connect; the outcome comes as a signal from [method poll].
func open(p_host: String, p_port: int, p_request: JoinRequest, p_password: String = "") -> void:
	close()
	_where = "%s:%d" % [p_host, p_port]
	_request = p_request
	_password = p_password
	_request.token = _token if _token_of == _where else PackedByteArray()
	_began_usec = Time.get_ticks_usec()
	_state = State.CONNECTING
	_challenge = PackedByteArray()
	_why = ""
	_over = false
	_refusal = ""
	clock.clear()
	_parts = MessageParts.new()
	_peer = ThreadedPeer.new()
	_peer.limits.max_datagram = Protocol.MAX_DATAGRAM
	_peer.tls = tls
	_peer.watcher = _watch
	_peer.beacon = _ask_clock
	_peer.beacon_period = _clock_period
	_peer.failed.connect(_on_failed)
	_api = SceneMultiplayer.new()
	_api.root_path = ^"/root"
	_api.server_relay = false
	_api.allow_object_decoding = false
	_api.auth_timeout = 0.0
	_api.auth_callback = _on_handshake
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


## The multiplayer API, for nodes that call each other; see [SessionControl].
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
		_end("no server answers at %s" % _where)


## Sends the server the cards of the people whose motion we send, if we are joined.
func declare_people(p_people: Array[PersonCard]) -> void:
	if _state == State.JOINED:
		_api.send_bytes(
			PeopleMessage.encode(p_people),
			MultiplayerPeer.TARGET_PEER_SERVER,
			MultiplayerPeer.TRANSFER_MODE_RELIABLE
		)


## Sends a datagram over the fast path, if we are joined. It leaves at once. Any thread may call it.
func send_fast(p_bytes: PackedByteArray) -> void:
	_sending.lock()
	if _fast_peer != null:
		_fast_peer.send_fast(MultiplayerPeer.TARGET_PEER_SERVER, p_bytes)
	_sending.unlock()


## Says who takes what the server has of our motion: at once, in the transport's thread, without
## waiting for a frame; the sooner, the smaller the next samples are.
## [code]func(ack: PackedByteArray) -> void[/code], or none.
func set_motion_ack_taker(p_taker: Callable) -> void:
	_taking.lock()
	_motion_ack_taker = p_taker
	_taking.unlock()


## Round trip (ms) and loss (0 to 1) of the connection, as ENet sees them.
func quality() -> Dictionary:
	var peers: Dictionary = _peer.stats().get("peers", {}) if _peer != null else {}
	return peers.get(MultiplayerPeer.TARGET_PEER_SERVER, {})


## Leaves.
func close() -> void:
	_state = State.CLOSED
	_set_fast_peer(null)
	if _peer != null:
		var peer: ThreadedPeer = _peer
		_peer = null
		peer.close_with(DisconnectReason.LEFT)
		_api.multiplayer_peer = null


func _set_fast_peer(p_peer: ThreadedPeer) -> void:
	_sending.lock()
	_fast_peer = p_peer
	_sending.unlock()


## Runs in the transport's thread.
func _watch(p_bytes: PackedByteArray) -> void:
	var ack: PackedByteArray = SnapshotDecoder.find_motion_ack(p_bytes)
	if ack.is_empty():
		return
	_taking.lock()
	if _motion_ack_taker.is_valid():
		_motion_ack_taker.call(ack)
	_taking.unlock()


## Runs in the transport's thread.
func _ask_clock() -> PackedByteArray:
	return ClockMessage.question(Time.get_ticks_usec())


## Runs in the transport's thread.
func _clock_period(p_count: int) -> int:
	return 250000 if p_count < _QUICK_QUESTIONS else 1000000


func _on_failed(p_why: String) -> void:
	_why = p_why


func _loss() -> String:
	if _state != State.JOINED:
		return "no server answers at %s" % _where
	match _peer.reason_of(MultiplayerPeer.TARGET_PEER_SERVER):
		DisconnectReason.CLOSED:
			return "the server at %s was closed" % _where
		DisconnectReason.THROWN_OUT:
			return "the server at %s has thrown us out" % _where
		DisconnectReason.REPLACED:
			return "another connection to %s has replaced ours" % _where
	return "the connection to %s is lost%s" % [_where, ": " + _why if _why != "" else ""]


func _on_handshake(p_peer: int, p_bytes: PackedByteArray) -> void:
	if p_peer != MultiplayerPeer.TARGET_PEER_SERVER or _over:
		return
	if _challenge.is_empty():
		_send_join_request(p_bytes)
		return
	var reply: JoinReply = JoinReply.decode(p_bytes)
	match reply.kind:
		JoinReply.Kind.WELCOME:
			_take_welcome(reply)
		JoinReply.Kind.WAIT:
			_state = State.WAITING
			waiting.emit(reply.position)
		JoinReply.Kind.LATER:
			_come_later(reply.why)
		_:
			_give_up(reply.why)


func _send_join_request(p_bytes: PackedByteArray) -> void:
	var challenge: Challenge = Challenge.decode(p_bytes)
	if challenge.error != "":
		_give_up(challenge.error)
		return
	_challenge = p_bytes
	_locked = challenge.is_locked(_request.role)
	if _key.is_empty() or _key_salt != challenge.salt:
		_key = PasswordKey.derive(_password, challenge.salt, challenge.rounds)
		_key_salt = challenge.salt
	var bytes: PackedByteArray = _request.encode(_challenge, _key)
	_said = [_challenge, bytes]
	_api.send_auth(MultiplayerPeer.TARGET_PEER_SERVER, bytes)


func _take_welcome(p_reply: JoinReply) -> void:
	if _locked and not p_reply.is_proven(_key, _said):
		_give_up("the server does not know the password")
		return
	if _password != "" and not _locked:
		Log.warning("net", "%s asks for no password: it may be another server" % _where)
	session = p_reply.session
	_token = p_reply.token
	_token_of = _where
	_level = LevelMessage.encode(p_reply.level_name, p_reply.level_fingerprint)
	_api.complete_auth(MultiplayerPeer.TARGET_PEER_SERVER)


func _on_joined() -> void:
	_state = State.JOINED
	_set_fast_peer(_peer)
	traffic.restart()
	joined.emit()
	# The welcome has named the level; the rest of the program hears of it as of one that changes.
	_on_state(_level, Time.get_ticks_usec())


func _add_handlers() -> void:
	var fast: MessageHandlers.Path = MessageHandlers.Path.FAST
	var reliable: MessageHandlers.Path = MessageHandlers.Path.RELIABLE
	for kind: int in Protocol.SNAPSHOTS:
		_handlers.add(kind, fast, _on_state)
	for kind: int in [Protocol.Message.TABLE, Protocol.Message.LEVEL]:
		_handlers.add(kind, reliable, _on_state)
	_handlers.add(Protocol.Message.EVENTS, MessageHandlers.Path.ANY, _on_state)
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
	return _take_notice(p_bytes)


## Whether it is a valid notice.
func _take_notice(p_bytes: PackedByteArray) -> bool:
	var reader: ByteReader = ByteReader.new(p_bytes, 1)
	if reader.read_u8() == Protocol.Notice.CALIBRATE:
		var index: int = reader.read_u8()
		var pose: int = reader.read_u8()
		if reader.is_complete():
			calibration_asked.emit(index, pose)
		return reader.is_complete()
	reader = ByteReader.new(p_bytes, 1)
	var what: int = reader.read_u8()
	var why: String = reader.read_text(4 * JoinReply.MAX_WHY)
	if not reader.is_complete() or what != Protocol.Notice.DISMISSED:
		return false
	_token = PackedByteArray()
	_give_up(why)
	return true


func _complain(p_size: int) -> void:
	Log.limited("net", "server", "%s sent %d bytes that make no sense" % [_where, p_size])


## The API is still reading: [method poll] ends it.
func _give_up(p_why: String) -> void:
	if not _over:
		_over = true
		_refusal = p_why


func _come_later(p_why: String) -> void:
	if not _over:
		_over = true
		_why = p_why


func _end(p_why: String) -> void:
	close()
	lost.emit(p_why)


func _age_s() -> float:
	return (Time.get_ticks_usec() - _began_usec) / 1e6
