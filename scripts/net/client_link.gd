class_name ClientLink
extends RefCounted
## A client's end of the connection, the counterpart of [ServerLink].
##
## It says who it is, then sends samples and receives snapshots. Polled by hand.

## The server has admitted us.
signal joined
## The server does not want us, and says why. Trying again is of no use.
signal refused(p_why: String)
## There is no server, or no longer; trying again may help.
signal lost(p_why: String)
## New positions of bodies. The bytes are those of the datagram, for a recorder.
signal snapshot_received(p_snapshot: Snapshot, p_bytes: PackedByteArray)
## Which bodies there are now. The bytes are those of the packet, for a recorder.
signal world_received(p_world: WorldDescription, p_bytes: PackedByteArray)

## How far a connection has come.
enum State {
	## There is none.
	CLOSED,
	## The server has not admitted us yet.
	CONNECTING,
	## The server has admitted us.
	JOINED,
}

## Seconds to wait for a server's answer.
const PATIENCE_S: float = 5.0

## Bytes in and out.
var traffic: TrafficMeter = TrafficMeter.new()

var _api: SceneMultiplayer = null
var _enet: ENetMultiplayerPeer = null
var _hello: PackedByteArray = PackedByteArray()
var _state: State = State.CLOSED
var _parts: PacketParts = PacketParts.new()
var _began_usec: int = 0
var _where: String = ""


## Begins to connect; the outcome comes as a signal from [method poll].
func open(p_host: String, p_port: int, p_hello: PackedByteArray) -> void:
	_where = "%s:%d" % [p_host, p_port]
	_hello = p_hello
	_began_usec = Time.get_ticks_usec()
	_state = State.CONNECTING
	_enet = ENetMultiplayerPeer.new()
	_api = SceneMultiplayer.new()
	_api.root_path = ^"/root"
	_api.server_relay = false
	_api.allow_object_decoding = false
	_api.auth_callback = _on_answer
	_api.auth_timeout = PATIENCE_S
	_api.peer_authenticating.connect(_on_reached)
	_api.connected_to_server.connect(_on_joined)
	_api.peer_packet.connect(_on_packet)
	var error: Error = _enet.create_client(p_host, p_port)
	if error != OK:
		_enet = null
		return
	_api.multiplayer_peer = _enet


## Whether the server has admitted us.
func is_joined() -> bool:
	return _state == State.JOINED


## Takes in what has arrived and finds out whether the connection still stands.
func poll() -> void:
	if _state == State.CLOSED:
		return
	if _enet == null:
		_end("%s is no address that can be connected to" % _where)
		return
	_api.poll()
	if _state == State.CLOSED:
		return
	if _is_active():
		traffic.read(_enet.host)
	if not _is_active():
		var joined_before: bool = _state == State.JOINED
		_end(
			(
				"the connection to %s is lost" % _where
				if joined_before
				else "no server answers at %s" % _where
			)
		)
	elif _state == State.CONNECTING and _age_s() > PATIENCE_S:
		_end("no server answers at %s" % _where)


## Sends a sample, if we are joined.
func send_pose(p_sample: PoseSample) -> void:
	if _state == State.JOINED:
		_api.send_bytes(PosePacket.encode(p_sample), 1, MultiplayerPeer.TRANSFER_MODE_UNRELIABLE)


## Leaves.
func close() -> void:
	_state = State.CLOSED
	if _is_active():
		_enet.host.flush()
		_enet.close()
		_api.multiplayer_peer = null


func _on_reached(p_peer: int) -> void:
	if p_peer != 1:
		return
	# Notice a dead server within a few seconds.
	_enet.get_peer(1).set_timeout(32, 1000, 3000)
	_api.send_auth(1, _hello)


func _on_answer(p_peer: int, p_bytes: PackedByteArray) -> void:
	if p_peer != 1:
		return
	var why: String = Protocol.decode_answer(p_bytes)
	if why == "":
		_api.complete_auth(1)
		return
	close.call_deferred()
	_state = State.CLOSED
	refused.emit(why)


func _on_joined() -> void:
	_state = State.JOINED
	traffic.restart()
	joined.emit()


func _on_packet(p_peer: int, p_bytes: PackedByteArray) -> void:
	if p_peer != 1 or p_bytes.is_empty():
		return
	match p_bytes[0]:
		Protocol.Message.SNAPSHOT:
			var snapshot: Snapshot = SnapshotPacket.decode(p_bytes)
			if snapshot != null:
				snapshot_received.emit(snapshot, p_bytes)
				return
		Protocol.Message.PART:
			var whole: PackedByteArray = _parts.join(p_bytes)
			if whole.is_empty():
				return
			var world: WorldDescription = WorldDescription.decode(whole)
			if world != null:
				world_received.emit(world, whole)
				return
	Log.limited("net", "server", "%s sent %d bytes that make no sense" % [_where, p_bytes.size()])


func _end(p_why: String) -> void:
	close()
	lost.emit(p_why)


## Whether there is a host; without one the engine reports an error to whoever asks for it.
func _is_active() -> bool:
	return (
		_enet != null and _enet.get_connection_status() != MultiplayerPeer.CONNECTION_DISCONNECTED
	)


func _age_s() -> float:
	return (Time.get_ticks_usec() - _began_usec) / 1e6
