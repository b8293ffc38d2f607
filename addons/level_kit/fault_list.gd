@tool
extends ItemList
## What Check has found; a click shows it in the 3D view.

const Placer: GDScript = preload("placer.gd")

var _level: Level = null


func _init() -> void:
	auto_height = false
	custom_minimum_size.y = 110.0
	item_selected.connect(_on_item_selected)


## Shows what was found in a level.
func show_faults(p_level: Level, p_faults: Array[LevelFault]) -> void:
	_level = p_level
	clear()
	for fault: LevelFault in p_faults:
		var is_fault: bool = fault.severity == LevelFault.Severity.FAULT
		var icon: StringName = &"StatusError" if is_fault else &"StatusWarning"
		var text: String = fault.text
		if not fault.path.is_empty():
			text = "%s: %s" % [String(fault.path).get_file(), text]
		var index: int = add_item(text, get_theme_icon(icon, &"EditorIcons"))
		set_item_tooltip(index, fault.describe())
		set_item_metadata(index, fault)
	visible = not p_faults.is_empty()


func _on_item_selected(p_index: int) -> void:
	var fault: LevelFault = get_item_metadata(p_index)
	if _level == null or not is_instance_valid(_level) or not _level.is_inside_tree():
		return
	EditorInterface.set_main_screen_editor("3D")
	var node: Node = _level.get_node_or_null(fault.path) if not fault.path.is_empty() else null
	var selection: EditorSelection = EditorInterface.get_selection()
	selection.clear()
	if node != null:
		# Inside another scene the editor selects the instance that holds it.
		selection.add_node(node)
		await get_tree().process_frame
		_focus()
	elif fault.place != Vector3.ZERO:
		# The view goes to nodes only.
		var mark: Marker3D = Marker3D.new()
		_level.add_child(mark, false, Node.INTERNAL_MODE_BACK)
		mark.global_position = fault.place
		selection.add_node(mark)
		await get_tree().process_frame
		_focus()
		selection.clear()
		mark.queue_free()


## As if somebody pressed F over the first 3D view: there is no call for it.
static func _focus() -> void:
	var surface: Control = Placer.find_surface()
	if surface == null:
		return
	var key: InputEventKey = InputEventKey.new()
	key.keycode = KEY_F
	key.physical_keycode = KEY_F
	key.pressed = true
	surface.gui_input.emit(key)
	# What is shown is what Delete and the arrow keys are for.
	surface.grab_focus()
