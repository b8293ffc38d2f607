@tool
extends RefCounted
## Shapes and paints the selected [Terrain] by the mouse in the 3D view. One pull of the mouse is
## one step to undo; the file of heights is written after it.

const Placer: GDScript = preload("placer.gd")
## Points along an edge of new ground, and their distance, m: 100 x 100 m.
const NEW_POINTS: int = 201
const NEW_CELL_M: float = 0.5
## Between two changes while the mouse is pulled, ms.
const STROKE_MS: int = 60

## What a pull does; null: nothing, the mouse is the editor's.
var brush: HeightBrush = null

var _undo: EditorUndoRedoManager = null
var _terrain: Terrain = null
var _before: HeightField = null
var _area: Rect2i = Rect2i()
var _stroke_ms: int = 0


func _init(p_undo: EditorUndoRedoManager) -> void:
	_undo = p_undo


## The selected ground, or null.
static func find_selected() -> Terrain:
	for node: Node in EditorInterface.get_selection().get_selected_nodes():
		if node is Terrain:
			return node
	return null


## Gives ground without heights a flat file beside the level, and takes away the blocks whose top
## would lie in it. Returns what is wrong, or an empty text.
func make_flat(p_terrain: Terrain) -> String:
	var root: Node = EditorInterface.get_edited_scene_root()
	if root == null or root.scene_file_path == "":
		return "Save the level first: the heights lie beside it."
	var path: String = root.scene_file_path.get_basename() + ".height"
	if FileAccess.file_exists(path):
		return "There is %s already: choose it for 'Height File'." % path.get_file()
	var field: HeightField = HeightField.create(NEW_POINTS, NEW_POINTS, NEW_CELL_M)
	var fault: String = HeightFile.write(path, field)
	if fault == "":
		_undo.create_action("Make flat ground", UndoRedo.MERGE_DISABLE, p_terrain)
		_undo.add_do_property(p_terrain, &"height_file", path)
		_undo.add_undo_property(p_terrain, &"height_file", p_terrain.height_file)
		for block: Block in _find_covered(root as Level, p_terrain, field):
			var parent: Node = block.get_parent()
			_undo.add_do_method(parent, &"remove_child", block)
			_undo.add_undo_method(parent, &"add_child", block, true)
			_undo.add_undo_method(parent, &"move_child", block, block.get_index())
			# What leaves the tree loses its owner, and would not be saved any more.
			_undo.add_undo_property(block, &"owner", block.owner)
			for below: Node in block.find_children("*", "", true, true):
				if below.owner == block.owner:
					_undo.add_undo_property(below, &"owner", below.owner)
			_undo.add_undo_reference(block)
		_undo.commit_action()
	return fault


## What the 3D view is told before the editor itself. Returns whether the editor shall not get it.
func take_input(p_camera: Camera3D, p_event: InputEvent) -> bool:
	var button: InputEventMouseButton = p_event as InputEventMouseButton
	if button != null and button.button_index == MOUSE_BUTTON_LEFT:
		if button.pressed:
			return _begin(p_camera, button.position)
		return _end()
	var motion: InputEventMouseMotion = p_event as InputEventMouseMotion
	if motion == null or _terrain == null:
		return false
	if Time.get_ticks_msec() - _stroke_ms >= STROKE_MS:
		_stroke(p_camera, motion.position)
	return true


## Puts a part of the ground back as it was at another time.
func put_back(p_terrain: Terrain, p_patch: HeightPatch) -> void:
	p_patch.put_back(p_terrain.field)
	p_terrain.update_field()
	_write(p_terrain)


## Level blocks whose whole top would lie in flat ground: both would flicker.
static func _find_covered(p_level: Level, p_terrain: Terrain, p_field: HeightField) -> Array[Block]:
	var found: Array[Block] = []
	if p_level == null or p_level.static_root == null:
		return found
	var size: Vector2 = p_field.size()
	var flat: AABB = AABB(
		p_terrain.global_position - Vector3(size.x / 2.0, FlickerCheck.NEAR_M, size.y / 2.0),
		Vector3(size.x, 2.0 * FlickerCheck.NEAR_M, size.y)
	)
	for node: Node in p_level.static_root.find_children("*", "StaticBody3D", true, false):
		var block: Block = node as Block
		if block == null or block.owner != p_level:
			continue
		var half: Vector3 = block.size / 2.0
		var top: AABB = AABB(
			Vector3(-half.x, half.y, -half.z), Vector3(block.size.x, 0.0, block.size.z)
		)
		if flat.encloses(block.global_transform * top):
			found.append(block)
	return found


func _begin(p_camera: Camera3D, p_at: Vector2) -> bool:
	_terrain = find_selected() if brush != null else null
	if _terrain == null or _terrain.field == null:
		_terrain = null
		return false
	_before = _terrain.field.duplicate()
	_area = Rect2i()
	_stroke(p_camera, p_at)
	return true


func _end() -> bool:
	if _terrain == null:
		return false
	if _area.has_area():
		var after: HeightPatch = HeightPatch.take(_terrain.field, _area)
		_undo.create_action("Shape the ground", UndoRedo.MERGE_DISABLE, _terrain)
		_undo.add_do_method(self, &"put_back", _terrain, after)
		_undo.add_undo_method(self, &"put_back", _terrain, HeightPatch.take(_before, _area))
		_undo.commit_action(false)
		_write(_terrain)
	_terrain = null
	_before = null
	return true


func _stroke(p_camera: Camera3D, p_at: Vector2) -> void:
	_stroke_ms = Time.get_ticks_msec()
	var from: Vector3 = p_camera.project_ray_origin(p_at)
	var to: Vector3 = from + p_camera.project_ray_normal(p_at) * Placer.REACH_M
	var hit: Dictionary = Placer.find_hit(p_camera, from, to)
	if hit.is_empty() or not _terrain.covers(hit["position"]):
		return
	var own: Vector3 = (hit["position"] as Vector3) - _terrain.global_position
	var patch: HeightPatch = brush.stroke(_terrain.field, own.x, own.z)
	if patch != null:
		_area = _area.merge(patch.area) if _area.has_area() else patch.area
		_terrain.update_field()


func _write(p_terrain: Terrain) -> void:
	var fault: String = HeightFile.write(p_terrain.height_file, p_terrain.field)
	if fault != "":
		EditorInterface.get_editor_toaster().push_toast(fault, EditorToaster.SEVERITY_ERROR)
