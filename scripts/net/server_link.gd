class_name ServerLink
extends RefCounted
## The server's end of all connections: who is there, what they sent, what they get.
##
## This is the seam behind which the transport may change: nobody else knows of peers' packets. It
## uses Godot's multiplayer API over ENet, polled by hand in the physics tick, without relaying
## between clients. Everything that comes in is checked; what is bad is dropped with a log line that
## names the peer.

## A client was admitted. [param p_hello] has name, role and hip_height.
signal client_joined(p_peer: int, p_hello: Dictionary)
## A client is gone, whatever the reason.
signal client_left(p_peer: int)
## A trainee sent a sample that is a valid pose.
signal pose_received(p_peer: int, p_sample: PoseSample)

## Poses that a client may send per second; what is above it is dropped.
const MOST_POSES: int = 300
## A client that sends this many packets in a second is thrown out.
const FLOOD: int = 3000
## Milliseconds after which a silent client is gone: ENet's limit, least and most.
const _TIMEOUTS_MS: Array[int] = [32, 1000, 2000]
## Seconds that a client has to say who it is.
const _GREETING_S: float = 3.0
## First byte of the multiplayer API's packets: the kind of command is in its low bits. Of the kinds
## only plain bytes are used, and the system's, whose second byte is 0 for greetings.
const _COMMAND_MASK: int = 7
const _COMMAND_RAW: int = 3
const _COMMAND_SYSTEM: int = 7
const _SYSTEM_GREETING: int = 0
## Spare places for clients that are just arriving, or just pretend to.
const _SPARE_SLOTS: int = 64

## Bytes in and out.
var traffic: TrafficMeter = TrafficMeter.new()

var _api: SceneMultiplayer = null
var _enet: ENetMultiplayerPeer = ENetMultiplayerPeer.new()
var _peer: GuardedPeer = null
var _most_clients: int = Protocol.DEFAULT_MAX_CLIENTS
var _greeted: Dictionary[int, Dictionary] = {}
var _completed: Dictionary[int, bool] = {}
var _hellos: Dictionary[int, Dictionary] = {}
var _refused: Dictionary[int, int] = {}
var _packets: Dictionary[int, int] = {}
var _window_usec: int = 0
var _world_number: int = 0


## Opens the port, also again after a network error has closed it: whoever was there has left then
## and may come back. Returns [constant ERR_CANT_CREATE] where the port is in use.
func listen(p_port: int, p_most_clients: int) -> Error:
	for peer: int in _hellos.keys():
		_on_disconnected(peer)
	_greeted.clear()
	_completed.clear()
	_refused.clear()
	_most_clients = p_most_clients
	_enet = ENetMultiplayerPeer.new()
	_api = SceneMultiplayer.new()
	var error: Error = _enet.create_server(p_port, p_most_clients + _SPARE_SLOTS)
	if error != OK:
		return error
	_api.root_path = ^"/root"
	_api.server_relay = false
	_api.allow_object_decoding = false
	_api.auth_timeout = _GREETING_S
	_api.auth_callback = _on_greeting
	_api.peer_authenticating.connect(_on_arriving)
	_api.peer_authentication_failed.connect(_forget)
	_api.peer_connected.connect(_on_connected)
	_api.peer_disconnected.connect(_on_disconnected)
	_api.peer_packet.connect(_on_packet)
	_peer = GuardedPeer.new(_enet)
	_peer.guard = _lets_through
	_api.multiplayer_peer = _peer
	return OK


## Takes in what has arrived. Call it once per physics tick, before the simulation needs it.
func poll() -> void:
	var now: int = Time.get_ticks_usec()
	if now - _window_usec > 1000000:
		_window_usec = now
		_throw_out_floods()
		_packets.clear()
		_drop_refused(now)
	if _api != null:
		_api.poll()
	if is_listening():
		traffic.read(_enet.host)


## Whether the port is open; a transport error closes it.
func is_listening() -> bool:
	return _enet.get_connection_status() == MultiplayerPeer.CONNECTION_CONNECTED


## Number of admitted clients.
func client_count() -> int:
	return _hellos.size()


## Sends everybody where the bodies are.
func send_snapshot(p_snapshot: Snapshot) -> void:
	if _hellos.is_empty():
		return
	for bytes: PackedByteArray in SnapshotPacket.encode(p_snapshot):
		for peer: int in _hellos:
			if _is_open(peer):
				_api.send_bytes(bytes, peer, MultiplayerPeer.TRANSFER_MODE_UNRELIABLE)


## Tells everybody which bodies there are.
func send_world(p_world: WorldDescription) -> void:
	_world_number += 1
	for bytes: PackedByteArray in PacketParts.split(p_world.encode(), _world_number):
		for peer: int in _hellos:
			if _is_open(peer):
				_api.send_bytes(bytes, peer, MultiplayerPeer.TRANSFER_MODE_RELIABLE)


## Closes all connections and the port.
func close() -> void:
	if is_listening():
		for peer: int in _hellos:
			_enet.get_peer(peer).peer_disconnect_now()
		_enet.close()
	_hellos.clear()


func _on_arriving(p_peer: int) -> void:
	# The id is the client's own choice: below 2 it would mean "all" or "all except".
	if p_peer < 2:
		Log.limited("net", "id", "refused a client with the forbidden id %d" % p_peer)
		_enet.disconnect_peer(p_peer, true)
		return
	_enet.get_peer(p_peer).set_timeout(_TIMEOUTS_MS[0], _TIMEOUTS_MS[1], _TIMEOUTS_MS[2])


func _on_greeting(p_peer: int, p_bytes: PackedByteArray) -> void:
	if _greeted.has(p_peer) or _refused.has(p_peer) or p_peer < 2:
		return
	var hello: Dictionary = Protocol.decode_hello(p_bytes)
	if not hello.has("error") and _greeted.size() >= _most_clients:
		hello = {"error": "the server is full (%d clients)" % _most_clients}
	if hello.has("error"):
		Log.limited("net", "greeting", "refused %s: %s" % [_describe(p_peer), hello["error"]])
		_api.send_auth(p_peer, Protocol.encode_answer(hello["error"]))
		# It gets a moment to read why.
		_refused[p_peer] = Time.get_ticks_usec()
		return
	_greeted[p_peer] = hello
	_api.send_auth(p_peer, Protocol.encode_answer(""))
	_api.complete_auth(p_peer)


func _on_connected(p_peer: int) -> void:
	if _greeted.has(p_peer):
		_hellos[p_peer] = _greeted[p_peer]
		Log.info("net", "%s joined" % _describe(p_peer))
		client_joined.emit(p_peer, _hellos[p_peer])


func _on_disconnected(p_peer: int) -> void:
	_forget(p_peer)
	if _hellos.has(p_peer):
		Log.info("net", "%s left" % _describe(p_peer))
		_hellos.erase(p_peer)
		client_left.emit(p_peer)


func _forget(p_peer: int) -> void:
	_refused.erase(p_peer)
	_greeted.erase(p_peer)
	_completed.erase(p_peer)


## Decides which packets the multiplayer API gets to see: greetings of clients that have not been
## admitted yet, plain bytes of those that have, and no more of them than a trainee needs.
func _lets_through(p_peer: int, p_bytes: PackedByteArray) -> bool:
	_packets[p_peer] = _packets.get(p_peer, 0) + 1
	if _packets[p_peer] > MOST_POSES:
		_complain(p_peer, "rate", "sends more than %d packets a second" % MOST_POSES)
		return false
	var command: int = p_bytes[0] & _COMMAND_MASK if not p_bytes.is_empty() else -1
	if command == _COMMAND_RAW and _completed.has(p_peer):
		return true
	var greets: bool = command == _COMMAND_SYSTEM and p_bytes.size() > 1
	if greets and p_bytes[1] == _SYSTEM_GREETING and not _completed.has(p_peer):
		# After our answer an empty greeting says that the client has taken it in.
		if p_bytes.size() == 2 and _greeted.has(p_peer):
			_completed[p_peer] = true
		return true
	_complain(p_peer, "command", "sent %d bytes of no use (%d)" % [p_bytes.size(), command])
	return false


func _on_packet(p_peer: int, p_bytes: PackedByteArray) -> void:
	if not _hellos.has(p_peer):
		return
	if p_bytes.is_empty() or p_bytes[0] != Protocol.Message.POSE:
		var kind: int = p_bytes[0] if not p_bytes.is_empty() else -1
		_complain(p_peer, "kind", "sent %d bytes of unknown kind %d" % [p_bytes.size(), kind])
		return
	if _hellos[p_peer]["role"] != Protocol.Role.TRAINEE:
		_complain(p_peer, "role", "sent a pose, but is no trainee")
		return
	var sample: PoseSample = PosePacket.decode(p_bytes)
	if sample == null:
		_complain(p_peer, "pose", "sent " + PosePacket.error)
		return
	pose_received.emit(p_peer, sample)


func _throw_out_floods() -> void:
	for peer: int in _packets:
		if _packets[peer] > FLOOD and _is_known(peer):
			Log.warning("net", "%s was thrown out: %d packets" % [_describe(peer), _packets[peer]])
			_enet.disconnect_peer(peer)


func _drop_refused(p_now_usec: int) -> void:
	for peer: int in _refused.keys():
		if p_now_usec - _refused[peer] > 500000:
			_refused.erase(peer)
			if _api.get_authenticating_peers().has(peer):
				_api.disconnect_peer(peer)


func _complain(p_peer: int, p_key: String, p_what: String) -> void:
	Log.limited("net", "%s %d" % [p_key, p_peer], "%s %s" % [_describe(p_peer), p_what])


func _describe(p_peer: int) -> String:
	var who: String = "client %d" % p_peer
	if _hellos.has(p_peer):
		var role: int = _hellos[p_peer]["role"]
		who = (
			"%s '%s' (%d)"
			% [(Protocol.Role.find_key(role) as String).to_lower(), _hellos[p_peer]["name"], p_peer]
		)
	var remote: ENetPacketPeer = _enet.get_peer(p_peer) if _is_known(p_peer) else null
	return who + (" from %s" % remote.get_remote_address() if remote != null else "")


## Whether a client's connection still stands; the API hears of its end only at the next poll.
func _is_open(p_peer: int) -> bool:
	if not is_listening():
		return false
	var remote: ENetPacketPeer = _enet.get_peer(p_peer)
	return remote != null and remote.get_state() == ENetPacketPeer.STATE_CONNECTED


func _is_known(p_peer: int) -> bool:
	return (
		p_peer > 1 and (_api.get_peers().has(p_peer) or _api.get_authenticating_peers().has(p_peer))
	)
