@tool
@icon("res://scenes/world/icons/terrain.svg")
class_name Terrain
extends StaticBody3D
## Ground from a height map, for levels of any rectangular size: its picture, its collision shapes
## and its materials.
##
## The map is a file of its own ([HeightFile]), made by a script or by brushes ([HeightBrush]). Sand
## lies everywhere; paint covers it with gravel, rock, a road or clay, and steep places are
## bare earth. Put it below [code]Static[/code] of a level, not turned and not scaled.

## The heights have been read or changed.
signal changed

## Fewest and most cells along an edge of a shape. The engine makes a shape when it enters the
## world, and nothing else goes on meanwhile: 70 ms for 1000 x 1000 cells.
const SHAPE_CELLS: Vector2i = Vector2i(100, 250)
## Thickness and height of the walls at the edge, m.
const WALL_M: Vector2 = Vector2(4.0, 60.0)

## File with heights and paint.
@export_file("*.height") var height_file: String = "":
	set(p_value):
		height_file = p_value
		if is_inside_tree():
			load_heights()
## What the ground looks like; empty: the sand of all worlds.
@export var material: ShaderMaterial = null:
	set(p_value):
		material = p_value
		if is_inside_tree():
			_build_view()
## Whether hills go on beyond the edge.
@export var has_hills: bool = true:
	set(p_value):
		has_hills = p_value
		if is_inside_tree():
			_build_view()
## Whether walls that nobody sees keep everything on the ground.
@export var has_walls: bool = true:
	set(p_value):
		has_walls = p_value
		if is_inside_tree():
			_build_shapes()
## Stones in a square of 10 x 10 m of gravel, at most.
@export_range(0, 60) var stones: int = 20
## Dry bushes in a square of 20 x 20 m where they grow.
@export_range(0, 20) var bushes: int = 6

## What was read; null without a valid file.
var field: HeightField = null
## Why there are no heights, or an empty text.
var error: String = ""

# What has been read and made before it is needed.
var _ahead: HeightFile = null
var _shapes_ahead: Array[Node] = []
var _made: Array[Node] = []
var _shapes: Array[Node] = []
# Lowest and highest point, m.
var _range: Vector2 = Vector2.ZERO
var _heights: ImageTexture = null
var _paint: ImageTexture = null


func _enter_tree() -> void:
	if field == null:
		load_heights()


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	if height_file == "":
		warnings.append("Choose a file of heights for 'Height File'.")
	elif error != "":
		warnings.append("Its heights cannot be used: %s." % error)
	if not global_basis.is_equal_approx(Basis.IDENTITY):
		warnings.append("It is turned or scaled: only its position may differ.")
	return warnings


## Reads the file before the node enters the tree, which then costs less. A thread may do it: see
## [LevelLoader].
func read_ahead() -> void:
	_ahead = HeightFile.read(height_file) if height_file != "" else null


## Makes the shapes that enter the tree one by one after this node, by [method add_piece]: see
## [LevelAssembly]. A thread may do it, after [method read_ahead].
func take_pieces() -> Array[Node]:
	_shapes_ahead = _make_shapes(_ahead.field) if _ahead != null and _ahead.field != null else []
	return _shapes_ahead


## Adds one of [method take_pieces].
func add_piece(p_piece: Node) -> void:
	_shapes.append(p_piece)
	add_child(p_piece, false, INTERNAL_MODE_FRONT)


## Reads the file again.
func load_heights() -> void:
	var file: HeightFile = _ahead if _ahead != null else HeightFile.new()
	if height_file != "" and _ahead == null:
		file = HeightFile.read(height_file)
	_ahead = null
	error = file.error
	field = file.field
	_show_field(Vector2(file.lowest_m, file.highest_m))
	update_configuration_warnings()


## Shows heights that do not come from the file: for editing, for tests.
func set_field(p_field: HeightField) -> void:
	field = p_field
	_show_field(field.range_of_heights() if field != null else Vector2.ZERO)


## Shows changed heights and paint: after a [HeightBrush].
func update_field() -> void:
	_build_shapes()
	if _heights != null:
		_heights.update(_height_image())
		_paint.update(_paint_image())
	changed.emit()


## Shows as much as the tier of quality says: see [Quality].
func follow_quality() -> void:
	for node: Node in _made:
		if node is MultiMeshInstance3D:
			TerrainScatter.show_share(node as MultiMeshInstance3D)


## Height of the ground at a position in the world, m.
func height_at(p_place: Vector3) -> float:
	if field == null:
		return global_position.y
	var own: Vector3 = p_place - global_position
	return global_position.y + field.height_at(own.x, own.z)


## Normal of the ground at a position in the world.
func normal_at(p_place: Vector3) -> Vector3:
	var own: Vector3 = p_place - global_position
	return field.normal_at(own.x, own.z) if field != null else Vector3.UP


## Key of the ground's material at a position in the world, for sound and dust, such as
## [code]&"sand"[/code].
func surface_at(p_place: Vector3) -> StringName:
	var own: Vector3 = p_place - global_position
	return field.surface_at(own.x, own.z) if field != null else HeightField.SAND


## Whether it covers a position in the world, at any height.
func covers(p_place: Vector3) -> bool:
	var own: Vector3 = p_place - global_position
	return (
		field != null and Rect2(-field.size() / 2.0, field.size()).has_point(Vector2(own.x, own.z))
	)


## Squares that fill a rectangle of cells. Large ones are cut up where that leaves no rest.
static func squares_of(p_cells: Vector2i) -> Array[Rect2i]:
	var squares: Array[Rect2i] = []
	var rest: Rect2i = Rect2i(Vector2i.ZERO, p_cells)
	while rest.size.x > 0 and rest.size.y > 0:
		var side: int = mini(rest.size.x, rest.size.y)
		squares.append_array(_cut(Rect2i(rest.position, Vector2i(side, side))))
		if rest.size.x > rest.size.y:
			rest = Rect2i(rest.position + Vector2i(side, 0), rest.size - Vector2i(side, 0))
		else:
			rest = Rect2i(rest.position + Vector2i(0, side), rest.size - Vector2i(0, side))
	return squares


func _show_field(p_range: Vector2) -> void:
	_range = p_range
	_build_shapes()
	_build_view()
	changed.emit()


func _clear(p_nodes: Array[Node]) -> void:
	for node: Node in p_nodes:
		node.free()
	p_nodes.clear()


## Shapes for the physics: squares, as the engine has no others.
func _build_shapes() -> void:
	_clear(_shapes)
	if field == null:
		return
	# Those that were made ahead come by themselves.
	if _shapes_ahead.is_empty():
		for shape: Node in _make_shapes(field):
			add_piece(shape)
	_shapes_ahead = []
	if has_walls:
		_build_walls()


static func _make_shapes(p_field: HeightField) -> Array[Node]:
	var shapes: Array[Node] = []
	for square: Rect2i in squares_of(Vector2i(p_field.columns - 1, p_field.rows - 1)):
		var shape: HeightMapShape3D = HeightMapShape3D.new()
		shape.map_width = square.size.x + 1
		shape.map_depth = square.size.y + 1
		shape.map_data = _heights_of(p_field, square)
		var node: CollisionShape3D = CollisionShape3D.new()
		node.shape = shape
		node.scale = Vector3(p_field.cell_m, 1.0, p_field.cell_m)
		var middle: Vector2 = Vector2(square.position) + Vector2(square.size) / 2.0
		middle -= Vector2(p_field.columns - 1, p_field.rows - 1) / 2.0
		node.position = Vector3(middle.x, 0.0, middle.y) * p_field.cell_m
		shapes.append(node)
	return shapes


static func _cut(p_square: Rect2i) -> Array[Rect2i]:
	var side: int = p_square.size.x
	var parts: int = ceili(float(side) / SHAPE_CELLS.y)
	while side % parts != 0:
		parts += 1
	var edge: int = side / parts
	if edge < SHAPE_CELLS.x:
		return [p_square]
	var squares: Array[Rect2i] = []
	for row: int in parts:
		for column: int in parts:
			var corner: Vector2i = p_square.position + Vector2i(column, row) * edge
			squares.append(Rect2i(corner, Vector2i(edge, edge)))
	return squares


static func _heights_of(p_field: HeightField, p_square: Rect2i) -> PackedFloat32Array:
	if p_square.size == Vector2i(p_field.columns - 1, p_field.rows - 1):
		return p_field.heights
	var heights: PackedFloat32Array = []
	for row: int in range(p_square.position.y, p_square.end.y + 1):
		var from: int = row * p_field.columns + p_square.position.x
		heights.append_array(p_field.heights.slice(from, from + p_square.size.x + 1))
	return heights


func _build_walls() -> void:
	var half: Vector2 = field.size() / 2.0
	for side: int in 4:
		var along: float = (half.y if side < 2 else half.x) * 2.0 + 2.0 * WALL_M.x
		var box: BoxShape3D = BoxShape3D.new()
		box.size = Vector3(WALL_M.x, WALL_M.y, along)
		if side >= 2:
			box.size = Vector3(along, WALL_M.y, WALL_M.x)
		var out: float = -1.0 if side % 2 == 0 else 1.0
		var node: CollisionShape3D = CollisionShape3D.new()
		node.shape = box
		node.position = Vector3(out * (half.x + WALL_M.x / 2.0), 0.0, 0.0)
		if side >= 2:
			node.position = Vector3(0.0, 0.0, out * (half.y + WALL_M.x / 2.0))
		_shapes.append(node)
		add_child(node, false, INTERNAL_MODE_FRONT)


## Everything that is only seen.
func _build_view() -> void:
	_clear(_made)
	if field == null or DisplayServer.get_name() == "headless":
		return
	_heights = ImageTexture.create_from_image(_height_image())
	_paint = ImageTexture.create_from_image(_paint_image())
	var look: ShaderMaterial = material
	if look == null:
		look = load("res://assets/world/materials/terrain.tres") as ShaderMaterial
	look = look.duplicate() as ShaderMaterial
	look.set_shader_parameter(&"heights", _heights)
	look.set_shader_parameter(&"paint", _paint)
	look.set_shader_parameter(&"open_sky", ImageTexture.create_from_image(_light_image()))
	look.set_shader_parameter(&"cell_m", field.cell_m)
	look.set_shader_parameter(&"corner", global_position - _half())
	_add_pieces(look)
	if has_hills:
		var hills: ShaderMaterial = look.duplicate() as ShaderMaterial
		hills.set_shader_parameter(&"is_hills", true)
		var mesh: ArrayMesh = TerrainMesh.make_hills(field, 5)
		_add_mesh(mesh, hills, Vector3.ZERO, mesh.get_aabb())
	add_to_group(Quality.FOLLOWERS)
	for node: Node3D in TerrainScatter.make(field, stones, bushes):
		_made.append(node)
		add_child(node, false, INTERNAL_MODE_BACK)


func _add_pieces(p_material: ShaderMaterial) -> void:
	var mesh: ArrayMesh = TerrainMesh.make_piece(field.cell_m)
	var edge: float = TerrainMesh.CELLS * field.cell_m
	var tall: float = _range.y - _range.x + 4.0
	for row: int in ceili(float(field.rows - 1) / TerrainMesh.CELLS):
		for column: int in ceili(float(field.columns - 1) / TerrainMesh.CELLS):
			var place: Vector3 = Vector3(column, 0.0, row) * edge - _half()
			var room: AABB = AABB(Vector3(0.0, _range.x - 3.0, 0.0), Vector3(edge, tall, edge))
			_add_mesh(mesh, p_material, place, room)


func _add_mesh(p_mesh: Mesh, p_material: Material, p_place: Vector3, p_room: AABB) -> void:
	var node: MeshInstance3D = MeshInstance3D.new()
	node.mesh = p_mesh
	node.material_override = p_material
	node.position = p_place
	node.custom_aabb = p_room
	node.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	_made.append(node)
	add_child(node, false, INTERNAL_MODE_BACK)


func _half() -> Vector3:
	return Vector3(field.size().x, 0.0, field.size().y) / 2.0


func _height_image() -> Image:
	var bytes: PackedByteArray = field.heights.to_byte_array()
	var image: Image = _image(Image.FORMAT_RF, bytes)
	image.generate_mipmaps()
	return image


func _paint_image() -> Image:
	var image: Image = _image(Image.FORMAT_RGBA8, field.paint)
	image.generate_mipmaps()
	return image


func _light_image() -> Image:
	return _image(Image.FORMAT_R8, field.light)


func _image(p_format: Image.Format, p_bytes: PackedByteArray) -> Image:
	return Image.create_from_data(field.columns, field.rows, false, p_format, p_bytes)
