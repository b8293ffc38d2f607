class_name EnginePackets
extends RefCounted
## Filters the engine's own packets on a server: of spawners, synchronizers and the paths of their
## nodes.
##
## Clients send one kind only: that they know a path. The engine reports an error for each one that
## it does not expect, so that others are dropped here. While a level is loaded, what is sent waits:
## clients must have that level first.

const _COMMAND_MASK: int = 7
const _SIMPLIFY_PATH: int = 1
const _CONFIRM_PATH: int = 2
const _RAW: int = 3
const _SYSTEM: int = 7
## Offset of a path's id: behind the command and the checksum of the node's methods.
const _ID_AT: int = 34
const _CONFIRM_SIZE: int = 6

## Whether other messages to a peer still wait, so that these have to wait too:
## [code]func(peer: int) -> bool[/code].
var is_behind: Callable = Callable()

var _holds: bool = false
var _held: Array[Held] = []
## The ids of paths that were sent: peer to ids.
var _paths: Dictionary[int, Dictionary] = {}


## A packet that waits.
class Held:
	var target: int = 0
	var channel: int = 0
	var mode: MultiplayerPeer.TransferMode = MultiplayerPeer.TRANSFER_MODE_RELIABLE
	var bytes: PackedByteArray = PackedByteArray()


## Whether a packet is one of these that a client may send at all.
static func is_confirmation(p_bytes: PackedByteArray) -> bool:
	var command: int = p_bytes[0] & _COMMAND_MASK if not p_bytes.is_empty() else -1
	return command == _CONFIRM_PATH and p_bytes.size() == _CONFIRM_SIZE


## Whether a packet is about nodes: neither the program's own nor about who is here.
static func is_one(p_bytes: PackedByteArray) -> bool:
	var command: int = p_bytes[0] & _COMMAND_MASK if not p_bytes.is_empty() else _RAW
	return command != _RAW and command != _SYSTEM


## Begins to hold packets back.
func hold() -> void:
	_holds = true


## The packets that have waited, in their order; further ones do not wait.
func release() -> Array[Held]:
	var held: Array[Held] = _held
	_held = []
	_holds = false
	return held


## Whether a packet to somebody has to wait; it is kept then.
func keeps(
	p_target: int, p_channel: int, p_mode: MultiplayerPeer.TransferMode, p_bytes: PackedByteArray
) -> bool:
	var command: int = p_bytes[0] & _COMMAND_MASK if not p_bytes.is_empty() else _RAW
	if command == _SIMPLIFY_PATH and p_bytes.size() >= _ID_AT + 4:
		var ids: Dictionary = _paths.get_or_add(p_target, {})
		ids[p_bytes.decode_u32(_ID_AT)] = true
	if not is_one(p_bytes) or not (_holds or _is_behind(p_target)):
		return false
	var held: Held = Held.new()
	held.target = p_target
	held.channel = p_channel
	held.mode = p_mode
	held.bytes = p_bytes
	_held.append(held)
	return true


## Whether something waits that may be tried again: no level is being loaded.
func has_waiting() -> bool:
	return not _held.is_empty() and not _holds


## Whether the engine expects a packet of somebody.
func expects(p_peer: int, p_bytes: PackedByteArray) -> bool:
	if p_bytes.is_empty() or p_bytes[0] & _COMMAND_MASK != _CONFIRM_PATH:
		return true
	if not is_confirmation(p_bytes) or p_bytes[1] != 1 or not _paths.has(p_peer):
		return false
	return _paths[p_peer].has(p_bytes.decode_u32(2))


## Somebody has gone.
func forget(p_peer: int) -> void:
	_paths.erase(p_peer)


func _is_behind(p_target: int) -> bool:
	if is_behind.is_valid() and is_behind.call(p_target):
		return true
	# What follows stays behind what waits.
	return _held.any(func(held: Held) -> bool: return held.target == p_target)
