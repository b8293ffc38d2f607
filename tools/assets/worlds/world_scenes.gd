extends RefCounted
## What the scripts that lay out worlds share: branches of a level, and saving a scene.


## Adds a branch to a level.
static func branch(p_level: Node3D, p_name: String) -> Node3D:
	var node: Node3D = Node3D.new()
	node.name = p_name
	p_level.add_child(node)
	return node


## Saves a scene. Returns whether that was possible; if not, it has said why.
static func save(p_root: Node, p_path: String) -> bool:
	_own(p_root, p_root)
	var packed: PackedScene = PackedScene.new()
	var fault: Error = packed.pack(p_root)
	if fault == OK:
		fault = ResourceSaver.save(packed, p_path)
	if fault != OK:
		printerr("%s: %s" % [p_path, error_string(fault)])
	return fault == OK


## What is below an instance belongs to its own scene.
static func _own(p_node: Node, p_root: Node) -> void:
	for child: Node in p_node.get_children():
		child.owner = p_root
		if child.scene_file_path == "":
			_own(child, p_root)
