class_name ThreadedPeer
extends TransferSettings
## Godot's multiplayer API over an ENet host that a thread of its own serves.
##
## Authentication, remote calls, spawners and synchronizers run over it unchanged, as over
## [ENetMultiplayerPeer]; their packets come with [method MultiplayerPeer.poll]. Beside them there
## is a fast path for datagrams that must not wait for a frame: [method send_fast] and
## [method take_fast]. The main thread cannot stop it, whatever it does.

## Somebody breaks the rules; for the log.
signal troubled(p_peer: int, p_key: String, p_what: String)
## Somebody goes on from another address, see [method address_of].
signal moved(p_peer: int)
## The port was closed by an error and is open again; all connections are lost.
signal reopened
## A client's connection to the server is over, and why.
signal failed(p_why: String)

## What this end lets through. Set it before creating.
var limits: TransportLimits = TransportLimits.new()
## Checks what arrives, on a server; null lets everything through. Set it before creating.
var guard: TransportGuard = null
## Whether and how datagrams are sealed: the same at both ends. Set it before creating. Of a server
## that is open it changes the passwords alone, for those who come from then on.
var sealing: TransportSealing = TransportSealing.off():
	set(p_sealing):
		sealing = p_sealing
		if _thread != null:
			_thread.set_passwords(sealing.passwords)
## On a server: what it tells clients that look for servers; nothing: it answers none.
var announcement: PackedByteArray = PackedByteArray():
	set(p_bytes):
		announcement = p_bytes
		if _thread != null:
			_thread.announce(p_bytes)
## On a client: whether a thread serves it. Without one [method MultiplayerPeer.poll] does, which
## many clients in one process need. Set it before creating.
var has_thread: bool = true
## What the thread calls. Set it before creating.
var callbacks: TransportCallbacks = TransportCallbacks.new()
## The packets of spawners and synchronizers, on a server.
var engine: EnginePackets = EnginePackets.new()
## On a client: lets them wait for their level.
var inbox: EngineInbox = null
## On a client: whether it has the nodes that the engine's own packets are about.
var takes_engine: bool = true
## On a client: whether the server refuses it, so that trying again is useless; see [signal failed].
var is_refused: bool = false
## On a client that failed: the key that the server has shown instead of the known one, or nothing.
var shown_key: PackedByteArray = PackedByteArray()

var _thread: TransportThread = null
var _unique_id: int = 0
var _port: int = 0
var _address: String = ""
var _status: MultiplayerPeer.ConnectionStatus = CONNECTION_DISCONNECTED
# How everybody joined who is connected.
var _joined: Dictionary[int, TransportEvent] = {}
var _leaving: Dictionary[int, bool] = {}
var _reasons: Dictionary[int, int] = {}
var _events: Array[TransportEvent] = []
var _next_event: int = 0
var _waiting: PacketQueue = PacketQueue.new()


func _init() -> void:
	inbox = EngineInbox.new(_waiting)


func _notification(p_what: int) -> void:
	if p_what == NOTIFICATION_PREDELETE and _thread != null:
		_thread.stop(DisconnectReason.LEFT)


## Opens a server's port. [constant ERR_ALREADY_IN_USE] if this peer is in use,
## [constant ERR_CANT_CREATE] if the port is.
func create_server(p_port: int, p_address: String = "*") -> Error:
	if _thread != null:
		return ERR_ALREADY_IN_USE
	_port = p_port
	_address = p_address
	var thread: TransportThread = _make_thread()
	var error: Error = thread.start_server(p_port, p_address)
	if error != OK:
		return error
	_thread = thread
	_unique_id = TARGET_PEER_SERVER
	_status = CONNECTION_CONNECTED
	return OK


## Begins to connect. The name is looked up in the thread; the outcome comes with
## [method MultiplayerPeer.poll].
func create_client(p_host: String, p_port: int) -> Error:
	if _thread != null:
		return ERR_ALREADY_IN_USE
	var thread: TransportThread = _make_thread()
	thread.has_thread = has_thread
	_unique_id = generate_unique_id()
	var error: Error = thread.start_client(p_host, p_port, _unique_id)
	if error != OK:
		return error
	_thread = thread
	_status = CONNECTION_CONNECTING
	return OK


## Ends everything and says why: a [DisconnectReason]. Takes 0.3 s at most.
func close_with(p_reason: int) -> void:
	if _thread == null:
		return
	_thread.stop(p_reason)
	_thread = null
	_status = CONNECTION_DISCONNECTED
	_joined.clear()
	_leaving.clear()
	_events.clear()
	_next_event = 0
	_waiting.clear()


## Ends a connection after what is still to be sent, and says why: a [DisconnectReason].
func dismiss(p_peer: int, p_reason: int) -> void:
	if _thread != null:
		_thread.disconnect_peer(p_peer, false, p_reason)


## Sends a datagram over the fast path, from any thread; it leaves at once. To one (an id), to
## all (0) or to all except one (minus its id).
func send_fast(p_peer: int, p_bytes: PackedByteArray) -> bool:
	var thread: TransportThread = _thread
	return (
		thread != null
		and p_bytes.size() <= limits.max_datagram
		and thread.send_fast(p_peer, p_bytes)
	)


## Sends datagrams over the fast path, each to the peer of the same index.
func send_fast_each(p_peers: PackedInt32Array, p_datagrams: Array[PackedByteArray]) -> bool:
	for bytes: PackedByteArray in p_datagrams:
		if bytes.size() > limits.max_datagram:
			return false
	var fits: bool = p_peers.size() == p_datagrams.size()
	return fits and _thread != null and _thread.send_fast_each(p_peers, p_datagrams)


## The fast datagrams that have come since the last call.
func take_fast() -> Array[FastPacket]:
	var none: Array[FastPacket] = []
	return _thread.mailbox.take_fast() if _thread != null else none


## Says that a client is welcome: the guard then lets it complete its authentication.
func welcome(p_peer: int) -> void:
	if _thread != null:
		_thread.welcome(p_peer)


## Keeps a client that has not been admitted yet, because an instructor will decide.
func keep(p_peer: int) -> void:
	if _thread != null:
		_thread.keep(p_peer)


## Whether polling again would bring more.
func has_more() -> bool:
	return _next_event < _events.size()


## Whether somebody is connected.
func has_peer(p_peer: int) -> bool:
	return _joined.has(p_peer)


## IP address of somebody, or an empty text.
func address_of(p_peer: int) -> String:
	return _joined[p_peer].key if _joined.has(p_peer) else ""


## What both ends of a sealed connection know, and nobody else: 32 bytes, bound to the role and the
## password. Empty without sealing, and where there is no connection.
func exporter_of(p_peer: int) -> PackedByteArray:
	return _joined[p_peer].exporter if _joined.has(p_peer) else PackedByteArray()


## On a server: the role that a sealed connection was made for.
func role_of(p_peer: int) -> int:
	return _joined[p_peer].role if _joined.has(p_peer) else 0


## On a client whose connection is sealed: how it was made, or null. See
## [member TransportEvent.return_tag] and [member TransportEvent.locked].
func sealed_join() -> TransportEvent:
	var joined: TransportEvent = _joined.get(TARGET_PEER_SERVER)
	return joined if joined != null and not joined.exporter.is_empty() else null


## Why a connection ended: a [DisconnectReason]. Valid while the signal is emitted.
func reason_of(p_peer: int) -> int:
	return _reasons.get(p_peer, DisconnectReason.LOST)


## Stats of the thread: sent_bytes, received_bytes, errors, dropped and more since the start, and
## for each of the peers its round_trip_ms and loss.
func stats() -> Dictionary:
	return _thread.mailbox.stats() if _thread != null else {}


## While a level is loaded: what spawners and synchronizers send waits until [method
## release_engine].
func hold_engine() -> void:
	engine.hold()


## Sends what has waited for other messages, if it need not any more.
func retry_engine() -> void:
	if engine.has_waiting():
		release_engine()


## Sends what has waited since [method hold_engine].
func release_engine() -> void:
	for held: EnginePackets.Held in engine.release():
		_target = held.target
		_channel = held.channel
		_mode = held.mode
		if held.target <= 0 or _joined.has(held.target):
			_put_packet_script(held.bytes)


func _poll() -> void:
	if _thread == null:
		return
	_waiting.drop_taken()
	# Asked first: the thread's last events are there once it has ended.
	var runs: bool = _thread.is_running()
	if _next_event >= _events.size():
		_thread.serve()
		_events = _thread.mailbox.take_events()
		_next_event = 0
	var stands: bool = _status != CONNECTION_DISCONNECTED
	if _events.is_empty() and stands and not runs:
		_revive()
		return
	_reasons.clear()
	while _next_event < _events.size():
		var event: TransportEvent = _events[_next_event]
		# The last packets are read before the connection is over.
		if event.kind == TransportEvent.Kind.GONE and _waiting.has_from(event.peer):
			return
		_next_event += 1
		_take(event)
		if _thread == null:
			return


func _take_packet(p_event: TransportEvent) -> void:
	if _unique_id == TARGET_PEER_SERVER and not engine.expects(p_event.peer, p_event.bytes):
		troubled.emit(p_event.peer, "command", "confirms a path that it was not sent")
		return
	if (
		_unique_id != TARGET_PEER_SERVER
		and not takes_engine
		and EnginePackets.is_one(p_event.bytes)
	):
		return
	if not inbox.keeps(p_event):
		_waiting.push(p_event)


func _take(p_event: TransportEvent) -> void:
	match p_event.kind:
		TransportEvent.Kind.PACKET:
			if _joined.has(p_event.peer) and not _leaving.has(p_event.peer):
				_take_packet(p_event)
		TransportEvent.Kind.JOINED:
			_on_joined(p_event)
		TransportEvent.Kind.GONE:
			_leaving.erase(p_event.peer)
			engine.forget(p_event.peer)
			if _joined.erase(p_event.peer):
				_reasons[p_event.peer] = p_event.code
				if _unique_id != TARGET_PEER_SERVER:
					_status = CONNECTION_DISCONNECTED
				peer_disconnected.emit(p_event.peer)
		TransportEvent.Kind.MOVED:
			if _joined.has(p_event.peer):
				_joined[p_event.peer].key = p_event.key
				moved.emit(p_event.peer)
		TransportEvent.Kind.TROUBLE:
			troubled.emit(p_event.peer, p_event.key, p_event.text)
		TransportEvent.Kind.REOPENED:
			reopened.emit()
		TransportEvent.Kind.FAILED:
			_status = CONNECTION_DISCONNECTED
			is_refused = p_event.final
			shown_key = p_event.server_key
			failed.emit(p_event.text)


func _on_joined(p_event: TransportEvent) -> void:
	if _refuses and _unique_id == TARGET_PEER_SERVER:
		_thread.disconnect_peer(p_event.peer, true, DisconnectReason.THROWN_OUT)
		return
	_leaving.erase(p_event.peer)
	_joined[p_event.peer] = p_event
	if _unique_id != TARGET_PEER_SERVER:
		_status = CONNECTION_CONNECTED
	peer_connected.emit(p_event.peer)


## The thread has failed: all connections are lost, and the port is opened again.
func _revive() -> void:
	var peers: Array[int] = _joined.keys()
	_thread.stop(DisconnectReason.LOST)
	_thread = _make_thread()
	var server: bool = _unique_id == TARGET_PEER_SERVER
	if not server or _thread.start_server(_port, _address) != OK:
		_thread = null
		_status = CONNECTION_DISCONNECTED
	_joined.clear()
	for peer: int in peers:
		peer_disconnected.emit(peer)
	if _thread != null:
		reopened.emit()
	else:
		failed.emit("the thread of the transport has ended")


func _make_thread() -> TransportThread:
	var thread: TransportThread = TransportThread.new()
	thread.max_datagram = limits.max_datagram
	thread.guard = guard
	if guard != null:
		guard.limits = limits
	thread.sealing = sealing
	thread.announcement = announcement
	thread.callbacks = callbacks
	return thread


func _get_available_packet_count() -> int:
	return _waiting.size()


func _get_packet_script() -> PackedByteArray:
	var packet: TransportEvent = _waiting.pop()
	return packet.bytes if packet != null else PackedByteArray()


func _get_packet_peer() -> int:
	var packet: TransportEvent = _waiting.front()
	return packet.peer if packet != null else 0


func _get_packet_mode() -> MultiplayerPeer.TransferMode:
	var packet: TransportEvent = _waiting.front()
	return packet.mode if packet != null else TRANSFER_MODE_RELIABLE


func _get_packet_channel() -> int:
	var packet: TransportEvent = _waiting.front()
	return packet.channel if packet != null else 0


func _put_packet_script(p_bytes: PackedByteArray) -> Error:
	if _unique_id == TARGET_PEER_SERVER and engine.keeps(_target, _channel, _mode, p_bytes):
		return OK
	if _status != CONNECTION_CONNECTED or _thread == null:
		return ERR_UNCONFIGURED
	if _channel < 0 or _channel > MAX_TRANSFER_CHANNEL:
		return ERR_INVALID_PARAMETER
	if _target > 0 and not _joined.has(_target):
		return ERR_INVALID_PARAMETER
	if p_bytes.size() > _get_max_packet_size():
		return ERR_OUT_OF_MEMORY
	return OK if _thread.send(_target, _enet_channel(), p_bytes, _enet_flags()) else ERR_BUSY


func _close() -> void:
	close_with(DisconnectReason.LEFT)


func _disconnect_peer(p_peer: int, p_force: bool) -> void:
	if _thread == null:
		return
	# Nobody wants to hear of it any more.
	_waiting.forget(p_peer)
	_leaving[p_peer] = true
	if p_force:
		_joined.erase(p_peer)
	_thread.disconnect_peer(p_peer, p_force, DisconnectReason.LOST)


func _get_connection_status() -> MultiplayerPeer.ConnectionStatus:
	return _status


func _get_unique_id() -> int:
	return _unique_id


func _is_server() -> bool:
	return _unique_id == TARGET_PEER_SERVER
