@tool
extends Control
## Lies over a 3D view while something of the kit is dragged, and takes it.

const KEY: String = "dismount_kit_item"

var _placer: RefCounted = null
var _view: SubViewport = null


func _init(p_placer: RefCounted, p_view: SubViewport) -> void:
	_placer = p_placer
	_view = p_view


func _can_drop_data(p_at: Vector2, p_data: Variant) -> bool:
	if not (p_data is Dictionary and (p_data as Dictionary).has(KEY)):
		return false
	_placer.call("show_ghost", p_data[KEY], _view.get_camera_3d(), _in_view(p_at))
	return true


func _drop_data(p_at: Vector2, p_data: Variant) -> void:
	var node: Node3D = _placer.call("place", p_data[KEY], _view.get_camera_3d(), _in_view(p_at))
	if node != null:
		EditorInterface.get_selection().clear()
		EditorInterface.get_selection().add_node(node)


## A view may be drawn with fewer pixels than it covers.
func _in_view(p_at: Vector2) -> Vector2:
	return p_at * Vector2(_view.size) / size
