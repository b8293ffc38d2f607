class_name SharedApi
extends MultiplayerAPIExtension
## Godot's multiplayer API for the [SharedNodes] of a level, at a server or a client.
##
## Spawners and synchronizers run over the session's own [SceneMultiplayer]. Calls do not: the
## engine reports an error for each one that a client makes wrongly; ours are messages that are
## checked first.

## A call is to be sent: to a peer, to all (0), or to all but one (minus its id).
signal call_wanted(p_target: int, p_call: CallMessage, p_is_reliable: bool)

## Root of the session's API while there are no shared nodes.
const NO_SHARED_ROOT: NodePath = ^"/root"

## The session's API; null while there is none.
var base: SceneMultiplayer = null
## Session of the caller whose call is being carried out; 0 if none is.
var sender: int = 0

var _path: NodePath = NodePath()
var _tree: SceneTree = null
var _registered: Dictionary[Object, bool] = {}


## Takes over the shared nodes of a level, which enters the tree below a node after this. Without
## shared nodes nothing happens.
func attach(p_parent: Node, p_level: Node) -> void:
	detach()
	var shared: SharedNodes = SharedNodes.find_in(p_level)
	if shared == null or base == null:
		return
	_tree = p_parent.get_tree()
	var below: String = str(p_level.get_path_to(shared))
	_path = NodePath("%s/%s/%s" % [p_parent.get_path(), p_level.name, below])
	_tree.multiplayer_poll = false
	_tree.set_multiplayer(self, _path)
	if base.multiplayer_peer is ThreadedPeer:
		(base.multiplayer_peer as ThreadedPeer).hold_engine()


## Everybody knows of the level now: what was spawned in it meanwhile may follow.
func release() -> void:
	if base != null and base.multiplayer_peer is ThreadedPeer:
		(base.multiplayer_peer as ThreadedPeer).release_engine()


## The level is gone.
func detach() -> void:
	if not _path.is_empty():
		_tree.set_multiplayer(null, _path)
		# The engine forgets the root, without which each packet of a client is an error.
		if base != null:
			base.root_path = NO_SHARED_ROOT
	_path = NodePath()
	_registered.clear()


## The program ends: what is shared goes first, as the engine reports errors for what goes with the
## whole tree.
func close() -> void:
	if root() != null:
		root().free()
	detach()


## The session's API has changed: nothing is registered with the new one.
func use(p_base: SceneMultiplayer) -> void:
	_registered.clear()
	base = p_base
	if base != null and not _path.is_empty():
		base.root_path = _path


## The shared nodes of the present level, or null.
func root() -> SharedNodes:
	return _tree.root.get_node_or_null(_path) if not _path.is_empty() else null


## Carries out a call that was checked.
func carry_out(p_call: CallMessage, p_sender: int) -> void:
	var node: Node = SharedCalls.find(root(), p_call.path)
	sender = p_sender
	node.callv(p_call.method, p_call.arguments)
	sender = 0


## Says at the caller why a call was not carried out.
func refuse(p_method: StringName, p_why: String) -> void:
	Log.limited("shared", p_method, "the call of '%s' was refused: %s" % [p_method, p_why])
	if root() != null:
		root().call_refused.emit(p_method, p_why)


func _rpc(p_peer: int, p_object: Object, p_method: StringName, p_arguments: Array) -> Error:
	var shared: SharedNodes = root()
	var node: Node = p_object as Node
	if shared == null or node == null or base == null:
		return ERR_UNCONFIGURED
	var call: CallMessage = CallMessage.new()
	call.path = str(shared.get_path_to(node))
	call.method = p_method
	call.arguments = p_arguments
	var fault: String = SharedCalls.find_fault(shared, call)
	if fault != "":
		refuse(p_method, fault)
		return ERR_INVALID_PARAMETER
	var config: Dictionary = SharedNodes.config_of(node)[p_method]
	var own: int = base.get_unique_id()
	var reaches_us: bool = p_peer == own or p_peer == 0 or (p_peer < 0 and p_peer != -own)
	if p_peer != own:
		var mode: int = config["transfer_mode"]
		var is_reliable: bool = mode == MultiplayerPeer.TRANSFER_MODE_RELIABLE
		call_wanted.emit(p_peer, call, is_reliable)
	if reaches_us and config["call_local"]:
		carry_out(call, own)
	return OK


func _poll() -> Error:
	return OK  # The links poll the session's API.


func _object_configuration_add(p_object: Object, p_configuration: Variant) -> Error:
	if base == null:
		return OK
	if p_object != null:
		_registered[p_object] = true
	return base.object_configuration_add(p_object, p_configuration)


func _object_configuration_remove(p_object: Object, p_configuration: Variant) -> Error:
	# What belonged to a connection that is gone is not known to the present one.
	if base == null or (p_object != null and not _registered.has(p_object)):
		return OK
	return base.object_configuration_remove(p_object, p_configuration)


func _set_multiplayer_peer(p_peer: MultiplayerPeer) -> void:
	if base != null:
		base.multiplayer_peer = p_peer


func _get_multiplayer_peer() -> MultiplayerPeer:
	return base.multiplayer_peer if base != null else null


func _get_unique_id() -> int:
	return base.get_unique_id() if base != null else 1


func _get_peer_ids() -> PackedInt32Array:
	return base.get_peers() if base != null else PackedInt32Array()


func _get_remote_sender_id() -> int:
	return sender
