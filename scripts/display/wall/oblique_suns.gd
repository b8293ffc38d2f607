class_name ObliqueSuns
extends RefCounted
## Gives all suns their simple shadows ([constant DirectionalLight3D.SHADOW_ORTHOGONAL]), also those
## of levels that are loaded later: the parts of the others are fitted to a view that is not
## oblique, and leave dark or bright patches in one that is.

var _tree: SceneTree = null
# How the shadows of each were, by its instance.
var _kept: Dictionary[int, DirectionalLight3D.ShadowMode] = {}


## Begins, in a tree.
func begin(p_tree: SceneTree) -> void:
	_tree = p_tree
	for node: Node in _tree.root.find_children("*", "DirectionalLight3D", true, false):
		_take(node)
	_tree.node_added.connect(_take)


## Gives those that are still there the shadows that they had.
func end() -> void:
	if _tree == null:
		return
	_tree.node_added.disconnect(_take)
	_tree = null
	for id: int in _kept:
		var sun: DirectionalLight3D = instance_from_id(id) as DirectionalLight3D
		if sun != null:
			sun.directional_shadow_mode = _kept[id]
	_kept.clear()


func _take(p_node: Node) -> void:
	var sun: DirectionalLight3D = p_node as DirectionalLight3D
	if sun == null:
		return
	for id: int in _kept.keys():
		if not is_instance_id_valid(id):
			_kept.erase(id)
	var known: int = sun.get_instance_id()
	if not _kept.has(known):
		_kept[known] = sun.directional_shadow_mode
	sun.directional_shadow_mode = DirectionalLight3D.SHADOW_ORTHOGONAL
