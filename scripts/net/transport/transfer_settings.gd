class_name TransferSettings
extends MultiplayerPeerExtension
## What the multiplayer API tells a peer before it sends: to whom, how, over which channel.

## Transfer channels that can be used beside 0.
const MAX_TRANSFER_CHANNEL: int = TransportHost.CHANNELS - TransportHost.UNRELIABLE_CHANNEL - 1

var _target: int = 0
var _channel: int = 0
var _mode: MultiplayerPeer.TransferMode = TRANSFER_MODE_RELIABLE
var _refuses: bool = false


func _get_max_packet_size() -> int:
	return 1 << 24


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


## The ENet channel of what is sent now.
func _enet_channel() -> int:
	if _channel > 0:
		return TransportHost.UNRELIABLE_CHANNEL + _channel
	return 0 if _mode == TRANSFER_MODE_RELIABLE else 1


## ENet's flags of what is sent now.
func _enet_flags() -> int:
	match _mode:
		TRANSFER_MODE_RELIABLE:
			return ENetPacketPeer.FLAG_RELIABLE
		TRANSFER_MODE_UNRELIABLE:
			return ENetPacketPeer.FLAG_UNSEQUENCED | ENetPacketPeer.FLAG_UNRELIABLE_FRAGMENT
	return ENetPacketPeer.FLAG_UNRELIABLE_FRAGMENT
