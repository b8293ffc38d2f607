class_name SharedCalls
extends RefCounted
## Checks calls between server and clients before they are made, and says in words what is wrong.


## The node of a path below the shared one, or null. No path leads out of it.
static func find(p_root: Node, p_path: String) -> Node:
	for part: String in p_path.split("/"):
		var is_strange: bool = part == "" or part.begins_with("%") or part.contains(":")
		if is_strange or part == ".." or (part == "." and p_path != "."):
			return null
	return p_root.get_node_or_null(NodePath(p_path))


## Why a client of a role may not make a call, or an empty text.
static func find_refusal(p_root: SharedNodes, p_call: CallMessage, p_role: Roles.Role) -> String:
	var fault: String = find_fault(p_root, p_call)
	if fault != "":
		return fault
	var config: Dictionary = SharedNodes.config_of(find(p_root, p_call.path))
	if config[StringName(p_call.method)]["rpc_mode"] != MultiplayerAPI.RPC_MODE_ANY_PEER:
		return "'%s' is for the server alone to call" % p_call.method
	var permission: CallPermission = p_root.permission_of(p_call.method)
	if permission == null:
		return "'%s' has no permission in the level's SharedNodes" % p_call.method
	if not permission.allows(p_role):
		return "a role of %s may not call '%s'" % [Roles.name_of(p_role), p_call.method]
	return ""


## Why a call makes no sense, whoever makes it, or an empty text.
static func find_fault(p_root: SharedNodes, p_call: CallMessage) -> String:
	var node: Node = find(p_root, p_call.path)
	if node == null:
		return "there is no shared node '%s'" % p_call.path
	if not SharedNodes.config_of(node).has(StringName(p_call.method)):
		return "'%s' has no method '%s' with @rpc" % [p_call.path, p_call.method]
	for method: Dictionary in node.get_method_list():
		if method["name"] == p_call.method:
			return _find_argument_fault(method, p_call.arguments)
	return "'%s' has no method '%s'" % [p_call.path, p_call.method]


static func _find_argument_fault(p_method: Dictionary, p_arguments: Array) -> String:
	var wanted: Array = p_method["args"]
	var least: int = wanted.size() - (p_method["default_args"] as Array).size()
	if p_arguments.size() < least or p_arguments.size() > wanted.size():
		var numbers: Array = [p_method["name"], wanted.size(), p_arguments.size()]
		return "'%s' takes %d arguments, not %d" % numbers
	for index: int in p_arguments.size():
		var type: int = wanted[index]["type"]
		var given: int = typeof(p_arguments[index])
		var is_number: bool = type == TYPE_FLOAT and given == TYPE_INT
		if type != TYPE_NIL and type != given and not is_number:
			var words: Array = [wanted[index]["name"], type_string(type), type_string(given)]
			return "'%s' is %s, not %s" % words
	return ""
