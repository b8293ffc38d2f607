extends TestCase
## The preview of a layout in the editor.

const _SCENE: PackedScene = preload("res://scenes/display/wall/layout_preview.tscn")
const _FILE: String = "user://test_layout_preview.cfg"
const _SCREEN: String = """[screen s]
bottom-left = -1 0 -1
bottom-right = 1 0 -1
top-left = -1 2 -1
size = 100 100
blend-left = 0.1
"""


func after_each() -> void:
	DirAccess.remove_absolute(_FILE)


func _write(p_text: String) -> void:
	var file: FileAccess = FileAccess.open(_FILE, FileAccess.WRITE)
	file.store_string(p_text)
	file.close()


func test_it_draws_the_screens_and_says_what_is_wrong() -> void:
	var preview: LayoutPreview = _SCENE.instantiate()
	add_child(preview)
	contains(preview._get_configuration_warnings()[0], "Choose the layout file")
	_write(_SCREEN)
	preview.layout_file = _FILE
	equal(preview._get_configuration_warnings().size(), 0)
	var drawn: MeshInstance3D = preview.get_child(0, true)
	var box: AABB = drawn.mesh.get_aabb()
	is_true(box.grow(0.01).encloses(AABB(Vector3(-1, 0, -1), Vector3(2, 2, 1))), str(box))
	_write(_SCREEN.replace("top-left = -1 2", "top-left = 3 0"))
	preview.reload()
	contains(preview._get_configuration_warnings()[0], "its corners are in a line")
	preview.free()
