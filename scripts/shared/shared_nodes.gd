@tool
class_name SharedNodes
extends Node3D
## The part of a level in which Godot's own multiplayer works: nodes below it have the same paths at
## the server and at every client, whatever their role.
##
## There: methods with [code]@rpc[/code], [MultiplayerSpawner] and [MultiplayerSynchronizer]. The
## server is the authority of everything; clients call the server only, and only what
## [member permissions] allow. Each call that is refused is an error at its caller: see
## [signal call_refused]. One such node in a level. Needs no session to be tried in the editor.

## At a client: the server has not carried out a call, or it could not be sent.
signal call_refused(p_method: StringName, p_why: String)

## What clients may call. A method that is missing here is called by nobody.
@export var permissions: Array[CallPermission] = []:
	set(p_value):
		permissions = p_value
		update_configuration_warnings()

## While a call of a client is carried out, on the server: number of the client's session, else 0.
var caller_session: int = 0
## While a call of a client is carried out, on the server: its name, which no other has.
var caller_name: String = ""


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	for node: Node in [self] + find_children("*", "Node", true, false):
		var config: Dictionary = config_of(node)
		for method: StringName in config:
			var is_open: bool = config[method]["rpc_mode"] == MultiplayerAPI.RPC_MODE_ANY_PEER
			if is_open and permission_of(method) == null:
				var text: String = "Nobody can call '%s' of %s: add a permission for it."
				warnings.append(text % [method, node.name])
	for permission: CallPermission in permissions:
		if permission == null or permission.method == &"":
			warnings.append("A permission has no method: name one, or remove it.")
	return warnings


## What clients may do with a method, or null.
func permission_of(p_method: StringName) -> CallPermission:
	for permission: CallPermission in permissions:
		if permission != null and permission.method == p_method:
			return permission
	return null


## The methods of a node that can be called: name to Godot's [code]rpc_mode[/code],
## [code]transfer_mode[/code] and [code]call_local[/code].
static func config_of(p_node: Node) -> Dictionary:
	var script: Script = p_node.get_script()
	var config: Dictionary = {}
	if script != null and script.get_rpc_config() is Dictionary:
		config.merge(script.get_rpc_config())
	if p_node.get_node_rpc_config() is Dictionary:
		config.merge(p_node.get_node_rpc_config(), true)
	return config


## The shared part of the level that a node is in, or null.
static func above(p_node: Node) -> SharedNodes:
	var node: Node = p_node
	while node != null and node is not SharedNodes:
		node = node.get_parent()
	return node as SharedNodes


## The shared part of a level, or null.
static func find_in(p_level: Node) -> SharedNodes:
	# By class in the engine: a level has thousands of nodes.
	for node: Node in p_level.find_children("*", "SharedNodes", true, false):
		return node as SharedNodes
	return null
