@tool
extends RefCounted
## Puts things into the edited level: where the pointer is, snapped, and so that it can be undone.

## Told when placing by clicks begins or ends: the item, or null.
signal item_changed(p_item: RefCounted)

const DropArea: GDScript = preload("drop_area.gd")
## How far the pointer's ray goes, m.
const REACH_M: float = 2000.0
## The upward part of a normal below which nothing stands on a face.
const STEEP: float = 0.7
## How far from a face its foot is looked for, m.
const BESIDE_M: float = 0.02
## How far away things are put where the ray meets nothing, m.
const AIR_M: float = 15.0

## The kit's own grid, m; 0 for none. The editor's snap goes before it.
var grid_m: float = 0.25

var _undo: EditorUndoRedoManager = null
var _item: RefCounted = null
var _ghost: Node3D = null
var _turn: float = 0.0
var _areas: Array[Control] = []


func _init(p_undo: EditorUndoRedoManager) -> void:
	_undo = p_undo


## Each click in the 3D view places one more, until Escape or the right button.
func start(p_item: RefCounted) -> void:
	stop()
	_item = p_item
	item_changed.emit(_item)
	# R and Escape are for the view from now on.
	var surface: Control = find_surface()
	if surface != null:
		surface.grab_focus.call_deferred()


## Places no more.
func stop() -> void:
	_drop_ghost()
	_turn = 0.0
	if _item != null:
		_item = null
		item_changed.emit(null)


## The part of the first 3D view that takes input, or null.
static func find_surface() -> Control:
	var view: Node = EditorInterface.get_editor_viewport_3d(0).get_parent().get_parent()
	for child: Node in view.get_children():
		if child is Control and not child is SubViewportContainer:
			return child
	return null


## What the 3D view is told before the editor itself. Returns whether the editor shall not get it.
func take_input(p_camera: Camera3D, p_event: InputEvent) -> bool:
	var is_taken: bool = _item != null and _take_placing(p_camera, p_event)
	if is_taken:
		# Else R is the editor's own key too.
		EditorInterface.get_base_control().get_viewport().set_input_as_handled()
	return is_taken


## While something is dragged from the dock, the 3D views take it.
func begin_drag() -> void:
	end_drag()
	for index: int in 4:
		var view: SubViewport = EditorInterface.get_editor_viewport_3d(index)
		var container: Control = view.get_parent() as Control
		if container != null and container.is_visible_in_tree():
			var area: Control = DropArea.new(self, view)
			container.get_parent().add_child(area)
			area.set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
			_areas.append(area)


## Ends what [method begin_drag] has begun.
func end_drag() -> void:
	for area: Control in _areas:
		area.queue_free()
	_areas.clear()
	_drop_ghost()


## Shows where something would stand.
func show_ghost(p_item: RefCounted, p_camera: Camera3D, p_at: Vector2) -> void:
	var root: Node3D = EditorInterface.get_edited_scene_root() as Node3D
	if root == null:
		return
	if _ghost == null:
		_ghost = p_item.make()
		var body: CollisionObject3D = _ghost as CollisionObject3D
		if body != null:
			body.collision_layer = 0
		root.add_child(_ghost, false, Node.INTERNAL_MODE_BACK)
	_ghost.global_transform = find_place(p_item, p_camera, p_at)


## Puts something where the pointer is; one step to undo. Returns it, or null.
func place(p_item: RefCounted, p_camera: Camera3D, p_at: Vector2) -> Node3D:
	var root: Node3D = EditorInterface.get_edited_scene_root() as Node3D
	_drop_ghost()
	if root == null:
		return null
	var parent: Node3D = find_parent(root, p_item.place)
	var node: Node3D = p_item.make()
	node.transform = parent.global_transform.affine_inverse() * find_place(p_item, p_camera, p_at)
	_undo.create_action("Place " + p_item.title, UndoRedo.MERGE_DISABLE, root)
	_undo.add_do_method(parent, &"add_child", node, true)
	_undo.add_do_property(node, &"owner", root)
	_undo.add_do_reference(node)
	_undo.add_undo_method(parent, &"remove_child", node)
	_undo.commit_action()
	return node


## Where something stands that is put under the pointer: on what is there, snapped along it.
func find_place(p_item: RefCounted, p_camera: Camera3D, p_at: Vector2) -> Transform3D:
	var from: Vector3 = p_camera.project_ray_origin(p_at)
	var way: Vector3 = p_camera.project_ray_normal(p_at)
	var at: Vector3 = from + way * AIR_M
	var hit: Dictionary = find_hit(p_camera, from, from + way * REACH_M)
	if not hit.is_empty() and absf((hit["normal"] as Vector3).y) < STEEP:
		# The side of something: it stands at its foot.
		var beside: Vector3 = hit["position"] + hit["normal"] * BESIDE_M
		var foot: Dictionary = find_hit(p_camera, beside, beside + Vector3.DOWN * REACH_M)
		hit["position"].y = foot["position"].y if not foot.is_empty() else 0.0
	var ground: Variant = Plane(Vector3.UP, 0.0).intersects_ray(from, way)
	if not hit.is_empty():
		at = hit["position"]
	elif ground is Vector3 and from.distance_to(ground) < REACH_M:
		at = ground
	at = snap(at, grid_m)
	return Transform3D(Basis(Vector3.UP, _turn), at + Vector3.UP * p_item.lift)


## What a ray from one place to another meets first, as the engine tells it; empty: nothing.
static func find_hit(p_camera: Camera3D, p_from: Vector3, p_to: Vector3) -> Dictionary:
	var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		p_from, p_to, PhysicsLayers.STATIC | PhysicsLayers.PROPS
	)
	return p_camera.get_world_3d().direct_space_state.intersect_ray(ray)


## The next point of the grid, at the same height: things stand on what is below them.
static func snap(p_at: Vector3, p_grid: float) -> Vector3:
	var step: float = p_grid
	if EditorInterface.is_node_3d_snap_enabled():
		step = EditorInterface.get_node_3d_translate_snap()
	return Vector3(snappedf(p_at.x, step), snappedf(p_at.y, 0.001), snappedf(p_at.z, step))


## The node of a level below which something belongs.
static func find_parent(p_root: Node3D, p_place: int) -> Node3D:
	var level: Level = p_root as Level
	if level == null:
		return p_root
	var found: Node3D = null
	match p_place:
		KitItem.Place.STATIC:
			found = level.static_root
		KitItem.Place.PROPS:
			found = level.props_root
		KitItem.Place.SPAWNS:
			found = level.get_node_or_null(^"Spawns")
	return found if found != null else level


func _take_placing(p_camera: Camera3D, p_event: InputEvent) -> bool:
	var key: InputEventKey = p_event as InputEventKey
	if key != null and key.pressed and key.keycode == KEY_ESCAPE:
		stop()
		return true
	if key != null and key.pressed and key.keycode == KEY_R:
		_turn = wrapf(_turn + PI / 2.0, -PI, PI)
		return true
	if p_event is InputEventMouseMotion:
		show_ghost(_item, p_camera, (p_event as InputEventMouse).position)
		return false
	var button: InputEventMouseButton = p_event as InputEventMouseButton
	if button == null or not button.pressed:
		return false
	if button.button_index == MOUSE_BUTTON_RIGHT:
		stop()
		return true
	if button.button_index == MOUSE_BUTTON_LEFT:
		place(_item, p_camera, button.position)
		return true
	return false


func _drop_ghost() -> void:
	if _ghost != null and is_instance_valid(_ghost):
		_ghost.get_parent().remove_child(_ghost)
		_ghost.queue_free()
	_ghost = null
