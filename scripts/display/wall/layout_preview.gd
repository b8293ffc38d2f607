@tool
class_name LayoutPreview
extends Node3D
## Draws a station of a layout file in the editor: its screens, the eyes, and what each screen shows
## of the world as a frustum. For designers: put it where the viewer will stand.
##
## Colours: screens white, edges that fade yellow, the eyes red, frusta blue.

const _MARK_M: float = 0.08

## The layout file of the station.
@export_global_file("*.cfg") var layout_file: String = "":
	set(p_value):
		layout_file = p_value
		reload()
## How far beyond the screens the frusta are drawn.
@export_range(0.0, 100.0, 0.1, "suffix:m") var reach: float = 2.0:
	set(p_value):
		reach = p_value
		reload()
## Reads the file again, when it has been changed.
@export_tool_button("Reload") var reload_button: Callable = reload

var _layout: WallLayout = null
var _lines: MeshInstance3D = null


func _ready() -> void:
	reload()


## Reads the layout again and draws it.
func reload() -> void:
	_layout = LayoutReader.read(layout_file) if layout_file != "" else null
	update_configuration_warnings()
	if not is_inside_tree():
		return
	if _lines == null:
		_lines = MeshInstance3D.new()
		add_child(_lines, false, Node.INTERNAL_MODE_BACK)
	_lines.mesh = _draw()


func _get_configuration_warnings() -> PackedStringArray:
	if layout_file == "":
		return ["Choose the layout file of a station, such as the one of ./run wall --layout=FILE."]
	return PackedStringArray() if _layout == null else _layout.faults


func _draw() -> Mesh:
	var mesh: ImmediateMesh = ImmediateMesh.new()
	# Screens of a layout that is wrong are drawn where they can be: that shows what is wrong.
	if _layout == null or _layout.screens.is_empty():
		return mesh
	var material: StandardMaterial3D = StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.vertex_color_use_as_albedo = true
	mesh.surface_begin(Mesh.PRIMITIVE_LINES, material)
	for screen: WallScreen in _layout.screens:
		_draw_screen(mesh, screen)
	for axis: Vector3 in [Vector3.RIGHT, Vector3.UP, Vector3.BACK]:
		_line(mesh, _layout.eye - axis * _MARK_M, _layout.eye + axis * _MARK_M, Color.RED)
	mesh.surface_end()
	return mesh


func _draw_screen(p_mesh: ImmediateMesh, p_screen: WallScreen) -> void:
	var right: Vector3 = p_screen.bottom_right - p_screen.bottom_left
	var up: Vector3 = p_screen.top_left - p_screen.bottom_left
	var corners: PackedVector3Array = [
		p_screen.bottom_left,
		p_screen.bottom_right,
		p_screen.bottom_right + up,
		p_screen.top_left,
	]
	for at: int in 4:
		_line(p_mesh, corners[at], corners[(at + 1) % 4], Color.WHITE)
		var out: Vector3 = (corners[at] - _layout.eye).normalized() * reach
		_line(p_mesh, _layout.eye, corners[at] + out, Color.DODGER_BLUE)
	# Up is where the arrow points, so that a screen that stands on its head is seen.
	var middle: Vector3 = p_screen.bottom_left + 0.5 * right
	_line(p_mesh, middle, middle + 0.2 * up, Color.WHITE)
	var blend: Vector4 = p_screen.blend
	var starts: Array[Vector3] = [corners[0] + right * blend.x, corners[1] - right * blend.y]
	if blend.x > 0.0:
		_line(p_mesh, starts[0], starts[0] + up, Color.YELLOW)
	if blend.y > 0.0:
		_line(p_mesh, starts[1], starts[1] + up, Color.YELLOW)
	if blend.z > 0.0:
		_line(p_mesh, corners[3] - up * blend.z, corners[2] - up * blend.z, Color.YELLOW)
	if blend.w > 0.0:
		_line(p_mesh, corners[0] + up * blend.w, corners[1] + up * blend.w, Color.YELLOW)


static func _line(p_mesh: ImmediateMesh, p_from: Vector3, p_to: Vector3, p_color: Color) -> void:
	p_mesh.surface_set_color(p_color)
	p_mesh.surface_add_vertex(p_from)
	p_mesh.surface_set_color(p_color)
	p_mesh.surface_add_vertex(p_to)
