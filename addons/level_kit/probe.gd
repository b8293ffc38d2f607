@tool
extends Node
## Tells a program that plays a user where things are on the screen: see tools/tutorial.
##
## It only looks, when it is asked: by a number in a file beside the one that it tells in, which is
## removed then. The plugin makes one where the environment names a file for it.

var _dock: Control = null
var _gizmos: EditorNode3DGizmoPlugin = null
var _path: String = ""


## Takes over what it tells of.
func configure(p_path: String, p_dock: Control, p_gizmos: EditorNode3DGizmoPlugin) -> void:
	_path = p_path
	_dock = p_dock
	_gizmos = p_gizmos


func _process(_delta: float) -> void:
	var asked: String = _path + ".asked"
	if not FileAccess.file_exists(asked):
		return
	var number: int = FileAccess.get_file_as_string(asked).to_int()
	DirAccess.remove_absolute(asked)
	var state: Dictionary = {
		"number": number,
		"frame": Engine.get_process_frames(),
		"is_scanning": EditorInterface.get_resource_filesystem().is_scanning(),
		"dock": _dock.is_visible_in_tree(),
		"controls": _controls(),
		"lists": _lists(),
		"view": _view(),
		"scene": _scene(),
		"windows": _windows(get_tree().root),
	}
	# As a whole or not at all: somebody reads it all the time.
	var file: FileAccess = FileAccess.open(_path + ".new", FileAccess.WRITE)
	file.store_string(JSON.stringify(state))
	file.close()
	DirAccess.rename_absolute(_path + ".new", _path)


## What can be pressed or written into, by its text or by the label before it.
func _controls() -> Dictionary:
	var found: Dictionary = {}
	var label: String = ""
	for node: Node in _dock.find_children("*", "Control", true, false):
		var control: Control = node as Control
		if not control.is_visible_in_tree():
			continue
		if control is Label:
			label = (control as Label).text
			if control.get_parent() == _dock:
				found["note"] = {"rect": _numbers(_rect(control)), "text": label}
		elif control is Button:
			var is_shut: bool = (control as Button).disabled
			var text: String = (control as Button).text
			var key: String = label if control is OptionButton else text
			found[key] = {"rect": _numbers(_rect(control)), "is_shut": is_shut, "text": text}
			if control is OptionButton:
				found[key]["marked"] = _marked((control as OptionButton).get_popup())
		elif control is LineEdit:
			var edit: LineEdit = control
			var key: String = edit.placeholder_text if edit.placeholder_text == "Search" else label
			found[key] = {
				"rect": _numbers(_rect(edit)), "text": edit.text, "has_focus": edit.has_focus()
			}
	for bar: ProgressBar in _dock.find_children("*", "ProgressBar", true, false):
		found["progress"] = {"rect": _numbers(_rect(bar)), "is_shown": bar.is_visible_in_tree()}
	return found


## The entry of an open list that the return key would take; an empty text for none, null while the
## list is shut.
func _marked(p_list: PopupMenu) -> Variant:
	if not p_list.visible:
		return null
	var index: int = p_list.get_focused_item()
	return p_list.get_item_text(index) if index >= 0 else ""


## Entries of the dock's lists, as far as they are in sight.
func _lists() -> Array:
	var lists: Array = []
	for list: ItemList in _dock.find_children("*", "ItemList", true, false):
		var rows: Array = []
		for index: int in list.item_count if list.is_visible_in_tree() else 0:
			var rect: Rect2 = list.get_item_rect(index)
			rect.position.y -= list.get_v_scroll_bar().value
			if rect.get_center().y < list.size.y:
				rect.position += _rect(list)[0]
				rows.append({"text": list.get_item_text(index), "rect": [rect.position, rect.size]})
		lists.append(rows)
	return lists.map(func(rows: Array) -> Array: return rows.map(_flat))


## The first 3D view and its camera.
func _view() -> Dictionary:
	var view: SubViewport = EditorInterface.get_editor_viewport_3d(0)
	var container: Control = view.get_parent() as Control
	var camera: Camera3D = view.get_camera_3d()
	if container == null or camera == null:
		return {}
	var at: Transform3D = camera.global_transform
	return {
		"rect": _numbers(_rect(container)),
		"is_shown": container.is_visible_in_tree(),
		"fov": camera.fov,
		"origin": _vector(at.origin),
		"axes": [_vector(at.basis.x), _vector(at.basis.y), _vector(at.basis.z)],
	}


## The level that is edited, what is selected and its handles.
func _scene() -> Dictionary:
	var root: Node = EditorInterface.get_edited_scene_root()
	if root == null:
		return {}
	var selected: PackedStringArray = []
	var handles: Array = []
	for node: Node in EditorInterface.get_selection().get_selected_nodes():
		selected.append(root.get_path_to(node))
		if node is Node3D and _gizmos._has_gizmo(node):
			for row: RefCounted in _gizmos._rows(node):
				var at: Vector3 = (node as Node3D).global_transform * (row.get("place") as Vector3)
				handles.append({"title": row.get("title"), "at": _vector(at)})
	var paths: PackedStringArray = []
	for node: Node in root.find_children("*", "Node3D", true, true):
		# What lies within a scene that was placed is no thing of its own.
		if node.owner == root:
			paths.append(root.get_path_to(node))
	return {
		"path": root.scene_file_path,
		"file": ProjectSettings.globalize_path(root.scene_file_path),
		"nodes": paths,
		"selected": selected,
		"handles": handles,
	}


## Dialogs that are open, with their buttons.
func _windows(p_node: Node) -> Array:
	var found: Array = []
	for node: Node in p_node.find_children("*", "AcceptDialog", true, false):
		var dialog: AcceptDialog = node as AcceptDialog
		if dialog.visible:
			var rect: Array = _numbers(_rect(dialog.get_ok_button()))
			var is_shut: bool = dialog.get_ok_button().disabled
			found.append({"title": dialog.title, "ok": rect, "is_shut": is_shut})
	return found


## Position and size on the screen, pixels.
static func _rect(p_control: Control) -> Array:
	var at: Vector2 = p_control.get_global_transform_with_canvas().origin
	var window: Window = p_control.get_window()
	if window.is_embedded():
		at += Vector2(window.position)
	return [at, p_control.size]


static func _flat(p_row: Dictionary) -> Dictionary:
	return {"text": p_row["text"], "rect": _numbers(p_row["rect"])}


static func _numbers(p_rect: Array) -> Array:
	return [p_rect[0].x, p_rect[0].y, p_rect[1].x, p_rect[1].y]


static func _vector(p_at: Vector3) -> Array:
	return [p_at.x, p_at.y, p_at.z]
