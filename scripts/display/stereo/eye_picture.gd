class_name EyePicture
extends MeshInstance2D
## Draws an eye's picture, or both eyes' as one, into a rectangle of a window in one pass: pixel by
## pixel, where nothing warps it.

## How both eyes share the picture.
enum Mix {
	## One eye alone.
	LEFT,
	## Red and cyan glasses.
	ANAGLYPH,
	## The left eye has the even rows of the panel, counted from 0 at its top, the right the odd.
	ROWS,
	## Likewise by columns.
	COLUMNS,
	## Likewise by the sum of row and column.
	CHECKERBOARD,
}

const _SHADER: Shader = preload("res://assets/shaders/eye_picture.gdshader")

var _material: ShaderMaterial = ShaderMaterial.new()
var _frame: Rect2i = Rect2i()


func _init() -> void:
	_material.shader = _SHADER
	material = _material


## Takes what is seen by each eye; one that is alone is given twice.
func show_eyes(p_left: Texture2D, p_right: Texture2D, p_mix: Mix) -> void:
	_material.set_shader_parameter(&"left_eye", p_left)
	_material.set_shader_parameter(&"right_eye", p_right)
	_material.set_shader_parameter(&"mix_mode", p_mix)


## Fills a rectangle of the window, pixels.
func fill(p_frame: Rect2i) -> void:
	if p_frame == _frame:
		return
	_frame = p_frame
	var from: Vector2 = p_frame.position
	var to: Vector2 = p_frame.end
	var points: PackedVector2Array = [from, Vector2(to.x, from.y), to, Vector2(from.x, to.y)]
	var places: PackedVector2Array = [Vector2.ZERO, Vector2.RIGHT, Vector2.ONE, Vector2.DOWN]
	draw_triangles(points, places, PackedInt32Array([0, 1, 2, 0, 2, 3]), PackedColorArray())


## Fills triangles: corners in pixels of the window, points in the picture (0..1, from its upper
## left), three indices each, and a factor of the values for each corner, if there are any.
func draw_triangles(
	p_points: PackedVector2Array,
	p_places: PackedVector2Array,
	p_indices: PackedInt32Array,
	p_colors: PackedColorArray
) -> void:
	var arrays: Array = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = p_points
	arrays[Mesh.ARRAY_TEX_UV] = p_places
	arrays[Mesh.ARRAY_INDEX] = p_indices
	if not p_colors.is_empty():
		arrays[Mesh.ARRAY_COLOR] = p_colors
	var made: ArrayMesh = ArrayMesh.new()
	made.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	mesh = made


## Uses a part of the eyes' pictures only, as shares of them.
func crop_to(p_part: Rect2) -> void:
	var part: Vector4 = Vector4(p_part.position.x, p_part.position.y, p_part.size.x, p_part.size.y)
	_material.set_shader_parameter(&"crop", part)


## Warps by a homography, from the frame (0..1) to the picture.
func warp_by(p_to_picture: Basis) -> void:
	_material.set_shader_parameter(&"warp", p_to_picture)


## Fades the edges (left, right, top, bottom: shares of the picture) for a projector of a gamma, and
## lifts the black outside of them by so much light.
func fade_edges(p_blend: Vector4, p_gamma: float, p_black_lift: float) -> void:
	_material.set_shader_parameter(&"blend", p_blend)
	_material.set_shader_parameter(&"gamma", p_gamma)
	_material.set_shader_parameter(&"black_lift", p_black_lift)


## Has interlaced eyes follow the pixels of the panel that a window is on, wherever the window is.
func follow_panel(p_window: Window) -> void:
	var origin: Vector2i = DisplayServer.screen_get_position(p_window.current_screen)
	_material.set_shader_parameter(&"panel_origin", p_window.position - origin)
