@tool
extends EditorPlugin
## The level kit in the editor: a dock with blocks to place, Check, Bake, Try, and handles to pull.
##
## What costs time is made when the dock is seen for the first time.

const DOCK_PATH: String = "res://addons/level_kit/dock.gd"
const GIZMOS_PATH: String = "res://addons/level_kit/gizmos.gd"
## Frames after which the editor has laid its docks out.
const LAYOUT_FRAMES: int = 30
const PLACER_PATH: String = "res://addons/level_kit/placer.gd"

const BRUSH_PATH: String = "res://addons/level_kit/terrain_brush.gd"
const PROBE_PATH: String = "res://addons/level_kit/probe.gd"
## Where a program that plays a user is told what is on the screen; see probe.gd.
const PROBE_VARIABLE: String = "DISMOUNT_KIT_PROBE"

var _dock: EditorDock = null
var _placer: RefCounted = null
var _brush: RefCounted = null
var _gizmos: EditorNode3DGizmoPlugin = null


func _enter_tree() -> void:
	# An import, an export: there is nothing to show.
	if DisplayServer.get_name() == "headless":
		return
	_placer = (load(PLACER_PATH) as GDScript).new(get_undo_redo())
	var content: Control = (load(DOCK_PATH) as GDScript).new()
	content.call("configure", _placer)
	_brush = (load(BRUSH_PATH) as GDScript).new(get_undo_redo())
	content.call("add_brush", _brush)
	_dock = EditorDock.new()
	_dock.title = "Level kit"
	_dock.layout_key = "dismount_level_kit"
	_dock.default_slot = EditorDock.DOCK_SLOT_LEFT_BL
	_dock.add_child(content)
	add_dock(_dock)
	_show_dock()
	_gizmos = (load(GIZMOS_PATH) as GDScript).new(get_undo_redo())
	add_node_3d_gizmo_plugin(_gizmos)
	if OS.has_environment(PROBE_VARIABLE):
		var probe: Node = (load(PROBE_PATH) as GDScript).new()
		probe.call("configure", OS.get_environment(PROBE_VARIABLE), content, _gizmos)
		_dock.add_child(probe)
	# Clicks place copies whatever is selected.
	set_input_event_forwarding_always_enabled()


func _exit_tree() -> void:
	if _dock == null:
		return
	_placer.call("stop")
	remove_node_3d_gizmo_plugin(_gizmos)
	remove_dock(_dock)
	_dock.queue_free()


## The editor lays its docks out after plugins come, and hides those that it has not seen before.
func _show_dock() -> void:
	while EditorInterface.get_resource_filesystem().is_scanning():
		await get_tree().process_frame
	for frame: int in LAYOUT_FRAMES:
		await get_tree().process_frame
	if is_instance_valid(_dock):
		_dock.open()
		_dock.make_visible()


func _forward_3d_gui_input(p_camera: Camera3D, p_event: InputEvent) -> int:
	var is_taken: bool = _placer != null and _placer.call("take_input", p_camera, p_event)
	is_taken = is_taken or (_brush != null and _brush.call("take_input", p_camera, p_event))
	return EditorPlugin.AFTER_GUI_INPUT_STOP if is_taken else EditorPlugin.AFTER_GUI_INPUT_PASS
