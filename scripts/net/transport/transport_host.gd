class_name TransportHost
extends RefCounted
## The connections of an ENet host and their traffic. Everything here belongs to
## the thread of [TransportThread].

## ENet channels: two that the multiplayer API knows, and five more for its transfer channels.
const CHANNELS: int = 7
## The last of ENet's channels that is none of the API's transfer channels.
const UNRELIABLE_CHANNEL: int = 1
## Maximum of connections that have not been admitted; beyond it the oldest is closed.
const MAX_ARRIVING: int = 512
## When a peer that answers nothing is given up: ENet's limit (2 to the attempts), least and most
## ms. With less, the loss of a fifth of all datagrams would end connections now and then; and
## silence is noticed earlier, see [constant SILENT_MS].
const TIMEOUTS_MS: Array[int] = [64, 6000, 8000]
## Silence after which a server is given up, ms: it sends something every 1.5 s.
const SILENT_MS: int = 5500
## First bytes of a probe and of its receipt, both followed by 8 bytes: see [ReceiptWindow].
const PROBE: PackedByteArray = [0xFF, 0x4D]
## See [constant PROBE].
const RECEIPT: PackedByteArray = [0xFF, 0x52]

# Period of ENet's pings to a silent peer, ms. ENet does not hear what goes beside it: with its own
# 500 ms pings would take 2 kbit/s.
const _PING_MS: int = 1500
const _WINDOW_USEC: int = 1000000
const _LEAVING_USEC: int = 1000000

## See [member TransportLimits.max_datagram].
var max_datagram: int = 1200
## Checks what arrives, on a server; null lets everything through.
var guard: TransportGuard = null
## Whether and how datagrams are sealed.
var sealing: TransportSealing = TransportSealing.off()
## On a server: what it tells clients that look for servers; nothing: it answers none.
var announcement: PackedByteArray = PackedByteArray()
## What the thread calls.
var callbacks: TransportCallbacks = TransportCallbacks.new()

var _socket: SealedSocket = null
var _server: bool = false
var _address: String = ""
var _port: int = 0
var _closing: bool = false
var _connections: Dictionary[int, TransportConnection] = {}
var _events: Array[TransportEvent] = []
var _fast: Array[FastPacket] = []
var _counts: Dictionary[String, int] = {}
var _waiting_bytes: int = 0
var _window_usec: int = 0
# As stats() has them; never altered, as other threads read them.
var _peers: Dictionary = {}


func _on_connect(p_remote: ENetPacketPeer, p_data: int) -> void:
	var id: int = p_data if _server else MultiplayerPeer.TARGET_PEER_SERVER
	if _server and (id < 2 or id > 0x7FFFFFFF):
		# The id is the client's own choice: below 2 it would mean "all" or "all except".
		_count("refused_ids")
		_trouble("id", "refused a client with the forbidden id %d" % id)
		p_remote.peer_disconnect(DisconnectReason.THROWN_OUT)
		return
	if _connections.has(id):
		_count("refused_ids")
		_trouble("id", "refused a client with the id %d, which another has" % id)
		p_remote.peer_disconnect(DisconnectReason.THROWN_OUT)
		return
	if guard != null:
		_make_room()
	var joined: TransportEvent = _describe(id, p_remote)
	if joined == null:
		p_remote.peer_disconnect(DisconnectReason.THROWN_OUT)
		return
	_socket.name(p_remote.get_remote_address(), id)
	var connection: TransportConnection = TransportConnection.new(
		id, p_remote, Time.get_ticks_usec(), joined.key
	)
	_connections[id] = connection
	p_remote.set_meta(&"id", id)
	_set_up(p_remote)
	_events.append(joined)


## The connection behind a loopback address of ENet; null if it has gone already.
func _describe(p_id: int, p_remote: ENetPacketPeer) -> TransportEvent:
	var joined: TransportEvent = TransportEvent.new(TransportEvent.Kind.JOINED, p_id)
	if not _server:
		joined.key = _address
		joined.exporter = _socket.get_exporter()
		joined.locked = _socket.is_locked()
		joined.return_tag = _socket.get_return_tag()
		joined.server_key = _socket.get_server_key() if sealing.seals else PackedByteArray()
		return joined
	var who: Dictionary = _socket.describe(p_remote.get_remote_address())
	if who.is_empty():
		return null
	joined.key = who["address"]
	joined.exporter = who["exporter"]
	joined.role = who["role"]
	return joined


func _on_disconnect(p_remote: ENetPacketPeer, p_code: int) -> void:
	var id: int = p_remote.get_meta(&"id", 0)
	if _connections.has(id) and _connections[id].remote == p_remote:
		# What a client gives for a reason ends no session: anybody could have forged it.
		_drop(_connections[id], DisconnectReason.LOST if _server else p_code)
	elif not _server:
		_fail("no server answers at %s:%d" % [_address, _port])


func _on_receive(p_remote: ENetPacketPeer, p_channel: int) -> void:
	var flags: int = p_remote.get_packet_flags()
	var bytes: PackedByteArray = p_remote.get_packet()
	var from: TransportConnection = _connections.get(p_remote.get_meta(&"id", 0))
	if from == null or from.stage == TransportConnection.Stage.LEAVING:
		return
	if bytes.size() == 10 and bytes[0] == PROBE[0] and p_channel == 0:
		if bytes[1] == RECEIPT[1]:
			from.window.take_receipt(bytes.slice(2))
			return
		if bytes[1] == PROBE[1] and not _server:
			p_remote.send(0, RECEIPT + bytes.slice(2), ENetPacketPeer.FLAG_RELIABLE)
			return
	if guard != null:
		var before: TransportConnection.Stage = from.stage
		if not _is_let_through(from, guard.judge(from, bytes)):
			return
		if from.stage != before and from.stage == TransportConnection.Stage.ADMITTED:
			_socket.admit(p_remote.get_remote_address())
	from.waiting += 1
	_waiting_bytes += bytes.size()
	var event: TransportEvent = TransportEvent.new(TransportEvent.Kind.PACKET, from.id)
	event.bytes = bytes
	event.channel = maxi(p_channel - UNRELIABLE_CHANNEL, 0)
	if flags & ENetPacketPeer.FLAG_RELIABLE:
		event.mode = MultiplayerPeer.TRANSFER_MODE_RELIABLE
	elif flags & ENetPacketPeer.FLAG_UNSEQUENCED:
		event.mode = MultiplayerPeer.TRANSFER_MODE_UNRELIABLE
	else:
		event.mode = MultiplayerPeer.TRANSFER_MODE_UNRELIABLE_ORDERED
	_events.append(event)


## Returns how many they are.
func _receive_all_fast(p_packets: Array[FastPacket]) -> int:
	for packet: FastPacket in p_packets:
		var from: TransportConnection = _connections.get(packet.peer)
		if from != null and from.stage != TransportConnection.Stage.LEAVING:
			_receive_fast(from, packet)
	return p_packets.size()


func _receive_fast(p_from: TransportConnection, p_packet: FastPacket) -> void:
	var bytes: PackedByteArray = p_packet.bytes
	if guard != null:
		var verdict: TransportGuard.Verdict = guard.judge_fast(p_from, bytes)
		if verdict != TransportGuard.Verdict.PASS and not _is_let_through(p_from, verdict):
			return
	if bytes.is_empty() or bytes.size() > max_datagram:
		_count("dropped_in")
		return
	if bytes[0] == callbacks.instant_kind and callbacks.instant.is_valid():
		var answer: PackedByteArray = callbacks.instant.call(bytes, p_packet.arrival_usec)
		if not answer.is_empty():
			_socket.send_fast(p_from.id, answer)
		return
	if callbacks.watcher.is_valid():
		callbacks.watcher.call(bytes)
	_fast.append(p_packet)


func _is_let_through(p_from: TransportConnection, p_verdict: TransportGuard.Verdict) -> bool:
	if p_verdict == TransportGuard.Verdict.PASS:
		return true
	if p_verdict != TransportGuard.Verdict.IGNORE:
		_count("dropped_in")
	if p_verdict == TransportGuard.Verdict.THROW_OUT:
		_throw_out(p_from, guard.reason)
	elif p_verdict == TransportGuard.Verdict.DROP:
		_complain(p_from, guard.key, guard.reason)
	return false


## A flood of connections without join request must not keep others out.
func _make_room() -> void:
	var oldest: TransportConnection = null
	var arriving: int = 0
	for id: int in _connections:
		var connection: TransportConnection = _connections[id]
		if connection.stage == TransportConnection.Stage.ARRIVING and not connection.kept:
			arriving += 1
			if oldest == null:
				oldest = connection
	if arriving >= MAX_ARRIVING:
		_count("evicted")
		_drop(oldest, DisconnectReason.LOST)


func _throw_out(p_connection: TransportConnection, p_why: String) -> void:
	_count("thrown_out")
	_complain(p_connection, "thrown out", "was thrown out: it %s" % p_why)
	_drop(p_connection, DisconnectReason.THROWN_OUT)


## Ends a connection at once; what still waited for it is freed, and the other end is notified. Not
## by peer_disconnect_now() nor reset(): after these ENetConnection.service() follows a freed
## element of its list (Godot 4.6), which ends release builds.
func _drop(p_connection: TransportConnection, p_code: int) -> void:
	_connections.erase(p_connection.id)
	if p_connection.remote.is_active():
		p_connection.remote.peer_disconnect(p_code)
	var event: TransportEvent = TransportEvent.new(TransportEvent.Kind.GONE, p_connection.id)
	event.code = p_code
	_events.append(event)


func _keep_house(p_now_usec: int) -> void:
	for id: int in _connections.keys():
		var connection: TransportConnection = _connections[id]
		if connection.window.is_exceeded():
			_throw_out(connection, "takes in nothing of what it is sent")
		elif (
			connection.stage == TransportConnection.Stage.LEAVING
			and p_now_usec - connection.leaving_usec > _LEAVING_USEC
		):
			_drop(connection, DisconnectReason.LOST)
	var refusal: Dictionary = _socket.take_refusal()
	if not refusal.is_empty():
		_trouble("refused", sealing.describe_refusal(refusal))
	if p_now_usec - _window_usec > _WINDOW_USEC:
		_window_usec = p_now_usec
		for id: int in _connections:
			_connections[id].restart_window()
			_look_where_it_is(_connections[id])
		_peers = _describe_peers()


func _look_where_it_is(p_connection: TransportConnection) -> void:
	if not _server or not p_connection.remote.is_active():
		return
	var who: Dictionary = _socket.describe(p_connection.remote.get_remote_address())
	if not who.is_empty() and who["address"] != p_connection.address:
		p_connection.address = who["address"]
		var event: TransportEvent = TransportEvent.new(TransportEvent.Kind.MOVED, p_connection.id)
		event.key = p_connection.address
		_events.append(event)


func _describe_peers() -> Dictionary:
	var peers: Dictionary = {}
	for id: int in _connections:
		var remote: ENetPacketPeer = _connections[id].remote
		if not remote.is_active():
			continue
		peers[id] = {
			"round_trip_ms": remote.get_statistic(ENetPacketPeer.PEER_ROUND_TRIP_TIME),
			"loss": remote.get_statistic(ENetPacketPeer.PEER_PACKET_LOSS) / 65536.0,
		}
	return peers


func _order_passwords(p_of_roles: PackedStringArray) -> void:
	sealing.passwords = p_of_roles
	_socket.set_passwords(p_of_roles)


func _order_announcement(p_bytes: PackedByteArray) -> void:
	announcement = p_bytes
	_socket.set_announcement(p_bytes)


func _send(
	p_to: TransportConnection, p_channel: int, p_bytes: PackedByteArray, p_flags: int
) -> void:
	if not p_to.remote.is_active() or p_to.stage == TransportConnection.Stage.LEAVING:
		return
	p_to.remote.send(p_channel, p_bytes, p_flags)
	if _server and p_channel == 0 and p_flags & ENetPacketPeer.FLAG_RELIABLE:
		var probe: PackedByteArray = p_to.window.note_sent(p_bytes.size())
		if not probe.is_empty():
			p_to.remote.send(0, PROBE + probe, ENetPacketPeer.FLAG_RELIABLE)


## Notice a dead end within a few seconds, and never thin out datagrams because the round trip
## varies: each can be used alone, and the newest matters most.
func _set_up(p_remote: ENetPacketPeer) -> void:
	p_remote.set_timeout(TIMEOUTS_MS[0], TIMEOUTS_MS[1], TIMEOUTS_MS[2])
	p_remote.ping_interval(_PING_MS)
	if p_remote.get_state() == ENetPacketPeer.STATE_CONNECTED:
		p_remote.throttle_configure(5000, 32, 0)


func _fail(p_why: String, p_final: bool = false) -> void:
	for id: int in _connections.keys():
		_drop(_connections[id], DisconnectReason.LOST)
	_note(TransportEvent.Kind.FAILED, 0, "failed", p_why)
	_events[-1].final = p_final
	# There is only one server: nothing is left to be done.
	_closing = true


func _complain(p_about: TransportConnection, p_key: String, p_what: String) -> void:
	if p_about.may_complain(p_key, Time.get_ticks_usec()):
		_note(TransportEvent.Kind.TROUBLE, p_about.id, p_key, p_what)


func _trouble(p_key: String, p_what: String) -> void:
	_note(TransportEvent.Kind.TROUBLE, 0, p_key, p_what)


func _note(p_kind: TransportEvent.Kind, p_peer: int, p_key: String, p_text: String) -> void:
	var event: TransportEvent = TransportEvent.new(p_kind, p_peer)
	event.key = p_key
	event.text = p_text
	_events.append(event)


func _count(p_what: String, p_more: int = 1) -> void:
	_counts[p_what] = _counts.get(p_what, 0) + p_more
