class_name LevelAssembly
extends RefCounted
## Puts a level into the tree piece by piece, so that no tick and no frame waits for all of it.
##
## What never moves and the props are taken out of the level while it is outside the tree, and put
## back, in their order, when its root is inside. All else (lights, spawn points, shared nodes)
## enters with the root.

## Pieces in all.
var count: int = 0

# Where a piece belongs: parent, piece, index among the parent's children, owner; index -1 for what
# the parent adds itself.
var _pieces: Array[Array] = []
var _next: int = 0


## Takes a level apart that is not in the tree. A thread may do it.
static func take_apart(p_level: Level) -> LevelAssembly:
	var assembly: LevelAssembly = LevelAssembly.new()
	if p_level.static_root != null and p_level.static_root != p_level:
		assembly._take_children(p_level.static_root)
	if p_level.props_root != null and p_level.props_root != p_level:
		assembly._take_children(p_level.props_root)
	assembly.count = assembly._pieces.size()
	return assembly


## Puts pieces in until a moment of [method Time.get_ticks_usec], one at least. Returns whether all
## are in.
func add_until(p_usec: int) -> bool:
	while _next < count:
		var parent: Node = _pieces[_next][0]
		var piece: Node = _pieces[_next][1]
		var index: int = _pieces[_next][2]
		if index < 0:
			parent.call(&"add_piece", piece)
		else:
			parent.add_child(piece)
			piece.owner = _pieces[_next][3]
			if piece.get_index() != index:
				parent.move_child(piece, index)
		_next += 1
		if Time.get_ticks_usec() >= p_usec:
			break
	return _next == count


## Share of the pieces that are in, 0 to 1.
func progress() -> float:
	return float(_next) / maxi(count, 1)


## Frees what has not been put in.
func free_rest() -> void:
	while _next < count:
		(_pieces[_next][1] as Node).free()
		_next += 1


## Whether a node only holds others. Bodies, nodes with scripts and scenes with entities stay whole:
## they may rely on what is in them.
static func is_group(p_node: Node) -> bool:
	if p_node.get_script() != null or p_node is CollisionObject3D:
		return false
	return (
		p_node.scene_file_path == "" or p_node.find_children("*", "Entity", true, false).is_empty()
	)


func _take_children(p_parent: Node) -> void:
	var children: Array[Node] = p_parent.get_children()
	for index: int in children.size():
		var child: Node = children[index]
		# It has to know its nodes when the root enters.
		if child is SharedNodes or SharedNodes.find_in(child) != null:
			continue
		_pieces.append([p_parent, child, index, child.owner])
		# The engine warns of owners that are not above when a node is added.
		child.owner = null
		p_parent.remove_child(child)
		# Some nodes give what takes the engine long to take in.
		if child.has_method(&"take_pieces"):
			for piece: Node in child.call(&"take_pieces") as Array[Node]:
				_pieces.append([child, piece, -1, null])
		if is_group(child):
			_take_children(child)
