@tool
extends EditorPlugin
## The effects studio as a main screen of the editor, beside 2D, 3D and Script. It is the same scene
## as that of ./run studio.
##
## It is made when it is seen for the first time: a process that tries effects belongs to it.

const SCENE: String = "res://scenes/studio/studio.tscn"
const ICON: String = "GPUParticles3D"

var _studio: Control = null


func _exit_tree() -> void:
	if _studio != null:
		_studio.queue_free()
		_studio = null


func _has_main_screen() -> bool:
	return true


func _make_visible(p_is_visible: bool) -> void:
	if _studio == null and p_is_visible and DisplayServer.get_name() != "headless":
		_studio = (load(SCENE) as PackedScene).instantiate()
		EditorInterface.get_editor_main_screen().add_child(_studio)
	if _studio != null:
		_studio.visible = p_is_visible
		_studio.process_mode = (
			Node.PROCESS_MODE_INHERIT if p_is_visible else Node.PROCESS_MODE_DISABLED
		)


func _get_plugin_name() -> String:
	return "Effects"


func _get_plugin_icon() -> Texture2D:
	return EditorInterface.get_editor_theme().get_icon(ICON, &"EditorIcons")
