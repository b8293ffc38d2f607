class_name ThreadedPeer
extends MultiplayerPeerExtension
## Godot's multiplayer API over an ENet host that a thread of its own serves.
##
## Authentication, remote calls, spawners and synchronizers run over it unchanged, as over
## [ENetMultiplayerPeer]; their packets come with [method MultiplayerPeer.poll]. Beside them there
## is a fast path for datagrams that must not wait for a frame: [method send_fast] and
## [method take_fast]. The main thread cannot stop it, whatever it does.

## Somebody breaks the rules; for the log.
signal troubled(p_peer: int, p_key: String, p_what: String)
## The port was closed by an error and is open again; all connections are lost.
signal reopened
## A client's connection to the server is over, and why.
signal failed(p_why: String)

## Transfer channels that can be used beside 0.
const MAX_TRANSFER_CHANNEL: int = TransportHost.CHANNELS - TransportHost.FAST_CHANNEL - 1

## What this end lets through. Set it before creating.
var limits: TransportLimits = TransportLimits.new()
## Checks what arrives, on a server; null lets everything through. Set it before creating.
var guard: TransportGuard = null
## DTLS for both ends, or null. Set it before creating.
var tls: TLSOptions = null
## See [member TransportThread.instant]. Set it before creating.
var instant: Callable = Callable()
## See [member TransportThread.instant_kind]. Set it before creating.
var instant_kind: int = -1
## See [member TransportThread.watcher]. Set it before creating.
var watcher: Callable = Callable()
## See [member TransportThread.beacon]. Set it before creating.
var beacon: Callable = Callable()
## See [member TransportThread.beacon_period]. Set it before creating.
var beacon_period: Callable = Callable()

## The sender of the remote call that the multiplayer API reads now; 0 if it reads none.
var reading_call_of: int = 0

var _thread: TransportThread = null
var _unique_id: int = 0
var _port: int = 0
var _address: String = ""
var _status: MultiplayerPeer.ConnectionStatus = CONNECTION_DISCONNECTED
var _addresses: Dictionary[int, String] = {}
var _leaving: Dictionary[int, bool] = {}
var _reasons: Dictionary[int, int] = {}
var _events: Array[TransportEvent] = []
var _next_event: int = 0
var _waiting: Array[TransportEvent] = []
var _next_waiting: int = 0
var _target: int = 0
var _channel: int = 0
var _mode: MultiplayerPeer.TransferMode = TRANSFER_MODE_RELIABLE
var _refuses: bool = false


func _notification(p_what: int) -> void:
	if p_what == NOTIFICATION_PREDELETE and _thread != null:
		_thread.stop(DisconnectReason.LEFT)


## Opens a server's port. [constant ERR_ALREADY_IN_USE] if this peer is in use,
## [constant ERR_CANT_CREATE] if the port is, [constant ERR_UNAVAILABLE] if DTLS is asked for and
## the engine has none.
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
	_addresses.clear()
	_leaving.clear()
	_events.clear()
	_next_event = 0
	_waiting.clear()
	_next_waiting = 0


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
		and thread.send(
			p_peer, TransportHost.FAST_CHANNEL, p_bytes, ENetPacketPeer.FLAG_UNSEQUENCED
		)
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
func welcome(p_peer: int, p_may_call: bool) -> void:
	if _thread != null:
		_thread.welcome(p_peer, p_may_call)


## Keeps a client that has not been admitted yet, because an instructor will decide.
func keep(p_peer: int) -> void:
	if _thread != null:
		_thread.keep(p_peer)


## Whether polling again would bring more.
func has_more() -> bool:
	return _next_event < _events.size()


## Whether somebody is connected.
func has_peer(p_peer: int) -> bool:
	return _addresses.has(p_peer)


## IP address of somebody, or an empty text.
func address_of(p_peer: int) -> String:
	return _addresses.get(p_peer, "")


## Why a connection ended: a [DisconnectReason]. Valid while the signal is emitted.
func reason_of(p_peer: int) -> int:
	return _reasons.get(p_peer, DisconnectReason.LOST)


## Stats of the thread: sent_bytes, received_bytes, errors, dropped and more since the start, and
## for each of the peers its round_trip_ms and loss.
func stats() -> Dictionary:
	return _thread.mailbox.stats() if _thread != null else {}


func _poll() -> void:
	reading_call_of = 0
	if _thread == null:
		return
	_drop_read()
	# Asked first: the thread's last events are there once it has ended.
	var runs: bool = _thread.is_running()
	if _next_event >= _events.size():
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
		if event.kind == TransportEvent.Kind.GONE and _has_waiting(event.peer):
			return
		_next_event += 1
		_take(event)
		if _thread == null:
			return


func _take(p_event: TransportEvent) -> void:
	match p_event.kind:
		TransportEvent.Kind.PACKET:
			if _addresses.has(p_event.peer) and not _leaving.has(p_event.peer):
				_waiting.append(p_event)
		TransportEvent.Kind.JOINED:
			_on_joined(p_event)
		TransportEvent.Kind.GONE:
			_leaving.erase(p_event.peer)
			if _addresses.erase(p_event.peer):
				_reasons[p_event.peer] = p_event.code
				if _unique_id != TARGET_PEER_SERVER:
					_status = CONNECTION_DISCONNECTED
				peer_disconnected.emit(p_event.peer)
		TransportEvent.Kind.TROUBLE:
			troubled.emit(p_event.peer, p_event.key, p_event.text)
		TransportEvent.Kind.REOPENED:
			reopened.emit()
		TransportEvent.Kind.FAILED:
			_status = CONNECTION_DISCONNECTED
			failed.emit(p_event.text)


func _on_joined(p_event: TransportEvent) -> void:
	if _refuses and _unique_id == TARGET_PEER_SERVER:
		_thread.disconnect_peer(p_event.peer, true, DisconnectReason.THROWN_OUT)
		return
	_leaving.erase(p_event.peer)
	_addresses[p_event.peer] = p_event.key
	if _unique_id != TARGET_PEER_SERVER:
		_status = CONNECTION_CONNECTED
	peer_connected.emit(p_event.peer)


## The thread has failed: all connections are lost, and the port is opened again.
func _revive() -> void:
	var peers: Array[int] = _addresses.keys()
	_thread.stop(DisconnectReason.LOST)
	_thread = _make_thread()
	var server: bool = _unique_id == TARGET_PEER_SERVER
	if not server or _thread.start_server(_port, _address) != OK:
		_thread = null
		_status = CONNECTION_DISCONNECTED
	_addresses.clear()
	for peer: int in peers:
		peer_disconnected.emit(peer)
	if _thread != null:
		reopened.emit()
	else:
		failed.emit("the thread of the transport has ended")


func _has_waiting(p_peer: int) -> bool:
	for i: int in range(_next_waiting, _waiting.size()):
		if _waiting[i].peer == p_peer:
			return true
	return false


func _drop_read() -> void:
	if _next_waiting > 0:
		_waiting = _waiting.slice(_next_waiting)
		_next_waiting = 0


func _make_thread() -> TransportThread:
	var thread: TransportThread = TransportThread.new()
	thread.max_datagram = limits.max_datagram
	thread.guard = guard
	if guard != null:
		guard.limits = limits
	thread.tls = tls
	thread.instant = instant
	thread.instant_kind = instant_kind
	thread.watcher = watcher
	thread.beacon = beacon
	thread.beacon_period = beacon_period
	return thread


func _get_available_packet_count() -> int:
	return _waiting.size() - _next_waiting


func _get_packet_script() -> PackedByteArray:
	if _next_waiting >= _waiting.size():
		return PackedByteArray()
	var event: TransportEvent = _waiting[_next_waiting]
	_next_waiting += 1
	reading_call_of = event.peer if TransportGuard.is_call(event.bytes) else 0
	return event.bytes


func _get_packet_peer() -> int:
	return _waiting[_next_waiting].peer if _next_waiting < _waiting.size() else 0


func _get_packet_mode() -> MultiplayerPeer.TransferMode:
	if _next_waiting < _waiting.size():
		return _waiting[_next_waiting].mode
	return TRANSFER_MODE_RELIABLE


func _get_packet_channel() -> int:
	return _waiting[_next_waiting].channel if _next_waiting < _waiting.size() else 0


func _put_packet_script(p_bytes: PackedByteArray) -> Error:
	if _status != CONNECTION_CONNECTED or _thread == null:
		return ERR_UNCONFIGURED
	if _channel < 0 or _channel > MAX_TRANSFER_CHANNEL:
		return ERR_INVALID_PARAMETER
	if _target > 0 and not _addresses.has(_target):
		return ERR_INVALID_PARAMETER
	if p_bytes.size() > _get_max_packet_size():
		return ERR_OUT_OF_MEMORY
	var flags: int = 0
	match _mode:
		TRANSFER_MODE_RELIABLE:
			flags = ENetPacketPeer.FLAG_RELIABLE
		TRANSFER_MODE_UNRELIABLE:
			flags = ENetPacketPeer.FLAG_UNSEQUENCED | ENetPacketPeer.FLAG_UNRELIABLE_FRAGMENT
		_:
			flags = ENetPacketPeer.FLAG_UNRELIABLE_FRAGMENT
	var enet_channel: int = 0 if _mode == TRANSFER_MODE_RELIABLE else 1
	if _channel > 0:
		enet_channel = TransportHost.FAST_CHANNEL + _channel
	return OK if _thread.send(_target, enet_channel, p_bytes, flags) else ERR_BUSY


func _close() -> void:
	close_with(DisconnectReason.LEFT)


func _disconnect_peer(p_peer: int, p_force: bool) -> void:
	if _thread == null:
		return
	# Nobody wants to hear of it any more.
	_waiting = _waiting.slice(_next_waiting).filter(
		func(event: TransportEvent) -> bool: return event.peer != p_peer
	)
	_next_waiting = 0
	_leaving[p_peer] = true
	if p_force:
		_addresses.erase(p_peer)
	_thread.disconnect_peer(p_peer, p_force, DisconnectReason.LOST)


func _get_connection_status() -> MultiplayerPeer.ConnectionStatus:
	return _status


func _get_max_packet_size() -> int:
	return 1 << 24


func _get_unique_id() -> int:
	return _unique_id


func _is_server() -> bool:
	return _unique_id == TARGET_PEER_SERVER


func _is_server_relay_supported() -> bool:
	return false


func _set_target_peer(p_peer: int) -> void:
	_target = p_peer


func _get_transfer_channel() -> int:
	return _channel


func _set_transfer_channel(p_channel: int) -> void:
	_channel = p_channel


func _get_transfer_mode() -> MultiplayerPeer.TransferMode:
	return _mode


func _set_transfer_mode(p_mode: MultiplayerPeer.TransferMode) -> void:
	_mode = p_mode


func _is_refusing_new_connections() -> bool:
	return _refuses


func _set_refuse_new_connections(p_refuse: bool) -> void:
	_refuses = p_refuse
