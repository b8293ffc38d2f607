class_name GuardedPeer
extends MultiplayerPeerExtension
## A peer that shows the multiplayer API only those packets that a guard lets through.
##
## Godot's [SceneMultiplayer] reports an engine error for nearly every packet that it does not
## expect, so that any client could flood the log. Everything else is left to the peer inside.

## Asked for each packet that arrives: [code]func(peer: int, bytes: PackedByteArray) -> bool[/code].
var guard: Callable = Callable()

var _inner: MultiplayerPeer = null
var _waiting: Array[Packet] = []


## A packet that was let through.
class Packet:
	var sender: int = 0
	var bytes: PackedByteArray = PackedByteArray()
	var mode: MultiplayerPeer.TransferMode = MultiplayerPeer.TRANSFER_MODE_RELIABLE
	var channel: int = 0


func _init(p_inner: MultiplayerPeer = null) -> void:
	if p_inner != null:
		_inner = p_inner
		_inner.peer_connected.connect(peer_connected.emit)
		_inner.peer_disconnected.connect(peer_disconnected.emit)


func _poll() -> void:
	_inner.poll()
	while _inner.get_available_packet_count() > 0:
		var packet: Packet = Packet.new()
		packet.sender = _inner.get_packet_peer()
		packet.mode = _inner.get_packet_mode()
		packet.channel = _inner.get_packet_channel()
		packet.bytes = _inner.get_packet()
		if guard.call(packet.sender, packet.bytes):
			_waiting.append(packet)


func _get_available_packet_count() -> int:
	return _waiting.size()


func _get_packet_script() -> PackedByteArray:
	return (_waiting.pop_front() as Packet).bytes if not _waiting.is_empty() else PackedByteArray()


func _get_packet_peer() -> int:
	return _waiting[0].sender if not _waiting.is_empty() else 0


func _get_packet_mode() -> MultiplayerPeer.TransferMode:
	return _waiting[0].mode if not _waiting.is_empty() else TRANSFER_MODE_RELIABLE


func _get_packet_channel() -> int:
	return _waiting[0].channel if not _waiting.is_empty() else 0


func _put_packet_script(p_bytes: PackedByteArray) -> Error:
	return _inner.put_packet(p_bytes)


func _close() -> void:
	_waiting.clear()
	_inner.close()


func _disconnect_peer(p_peer: int, p_force: bool) -> void:
	_inner.disconnect_peer(p_peer, p_force)


func _get_connection_status() -> MultiplayerPeer.ConnectionStatus:
	return _inner.get_connection_status()


func _get_max_packet_size() -> int:
	return 1 << 24


func _get_unique_id() -> int:
	return _inner.get_unique_id()


func _is_server() -> bool:
	return _inner.get_unique_id() == TARGET_PEER_SERVER


func _is_server_relay_supported() -> bool:
	return false


func _set_target_peer(p_peer: int) -> void:
	_inner.set_target_peer(p_peer)


func _get_transfer_channel() -> int:
	return _inner.transfer_channel


func _set_transfer_channel(p_channel: int) -> void:
	_inner.transfer_channel = p_channel


func _get_transfer_mode() -> MultiplayerPeer.TransferMode:
	return _inner.transfer_mode


func _set_transfer_mode(p_mode: MultiplayerPeer.TransferMode) -> void:
	_inner.transfer_mode = p_mode


func _is_refusing_new_connections() -> bool:
	return _inner.refuse_new_connections


func _set_refuse_new_connections(p_refuse: bool) -> void:
	_inner.refuse_new_connections = p_refuse
