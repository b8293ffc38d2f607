class_name PhysicsWorld
extends Node3D
## Draws the collision shapes of everything as wire frames, exactly where the newest snapshot has
## them: no smoothing, no meshes (thesis section 4.2.3).

## Colour of people's limbs.
const LIMBS: Color = Color(0.2, 1.0, 0.35)
## Colour of what moves.
const PROPS: Color = Color(1.0, 0.75, 0.2)
## Colour of what never moves.
const FIXED: Color = Color(0.35, 0.6, 1.0)
## Colour of what never moves where this machine's level is not the server's.
const DIFFERS: Color = Color(1.0, 0.2, 0.2)

## Name of the metadata in which a shape keeps its wire frame.
const _WIRES: StringName = &"wires"
## Most lines along a side of a map of heights.
const _MAP_LINES: int = 125

## How much of the wire frames is seen: 0 to 1.
var opacity: float = 1.0:
	set = set_opacity

var _materials: Dictionary[Color, StandardMaterial3D] = {}
## The bodies of an entity: one, or one for each limb of a person.
var _bodies: Dictionary[int, Array] = {}
## Frames of an entity, one for each of its bodies, made when they are first shown: they are costly,
## and few look at this world.
var _frames: Dictionary[int, Array] = {}
var _fixed: Array[Node3D] = []


## Draws the static bodies of a level again; [param p_differs] if the server's level differs.
func set_level(p_level: Level, p_differs: bool = false) -> void:
	for frame: Node3D in _fixed:
		frame.free()
	_fixed.clear()
	if p_level == null:
		return
	for body: StaticBody3D in p_level.get_static_bodies():
		var frame: Node3D = _make_frame(body, DIFFERS if p_differs else FIXED)
		frame.transform = body.global_transform
		_fixed.append(frame)


## Draws a body that moves, under the number of its entity, once it is known where it is.
func add_body(p_id: int, p_body: PhysicsBody3D) -> void:
	remove(p_id)
	_bodies[p_id] = [p_body]


## Draws a person's bodies, in the order of the limbs, under the number of the person, once it is
## known where they are.
func add_person(p_id: int, p_bodies: Array[PhysicsBody3D]) -> void:
	remove(p_id)
	_bodies[p_id] = p_bodies


## Removes an entity.
func remove(p_id: int) -> void:
	for frame: Node3D in _frames.get(p_id, []):
		frame.free()
	_frames.erase(p_id)
	_bodies.erase(p_id)


## Moves the frames of an entity to where its bodies are.
func set_transforms(p_id: int, p_transforms: Array[Transform3D]) -> void:
	if not _frames.has(p_id) and _bodies.has(p_id):
		var colour: Color = LIMBS if _bodies[p_id].size() > 1 else PROPS
		_frames[p_id] = _bodies[p_id].map(_make_frame.bind(colour))
	var frames: Array = _frames.get(p_id, [])
	for index: int in mini(frames.size(), p_transforms.size()):
		frames[index].transform = p_transforms[index]


## Makes the wire frames more or less transparent; 1 is not transparent at all.
func set_opacity(p_opacity: float) -> void:
	opacity = clampf(p_opacity, 0.0, 1.0)
	for material: StandardMaterial3D in _materials.values():
		_apply_opacity(material)


## Where a frame of an entity is, for tests and measurements.
func get_frame_transform(p_id: int, p_index: int = 0) -> Transform3D:
	return _frames[p_id][p_index].transform


func _make_frame(p_body: PhysicsBody3D, p_colour: Color) -> Node3D:
	var frame: Node3D = Node3D.new()
	add_child(frame)
	for child: Node in p_body.get_children(true):
		var shape: CollisionShape3D = child as CollisionShape3D
		if shape != null and shape.shape != null:
			var wires: MeshInstance3D = _make_wires(shape.shape, shape.transform)
			wires.material_override = _material_of(p_colour)
			frame.add_child(wires)
	return frame


func _material_of(p_colour: Color) -> StandardMaterial3D:
	if not _materials.has(p_colour):
		var material: StandardMaterial3D = StandardMaterial3D.new()
		material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
		material.albedo_color = p_colour
		_apply_opacity(material)
		_materials[p_colour] = material
	return _materials[p_colour]


func _apply_opacity(p_material: StandardMaterial3D) -> void:
	p_material.albedo_color.a = opacity
	p_material.transparency = (
		BaseMaterial3D.TRANSPARENCY_DISABLED
		if opacity == 1.0
		else BaseMaterial3D.TRANSPARENCY_ALPHA
	)


static func _make_wires(p_shape: Shape3D, p_transform: Transform3D) -> MeshInstance3D:
	var wires: MeshInstance3D = MeshInstance3D.new()
	# Many bodies share a shape.
	if not p_shape.has_meta(_WIRES):
		var map: HeightMapShape3D = p_shape as HeightMapShape3D
		var lines: ArrayMesh = _lines_of(map) if map != null else null
		p_shape.set_meta(_WIRES, lines if map != null else _keep_lines(p_shape.get_debug_mesh()))
	wires.mesh = p_shape.get_meta(_WIRES)
	wires.transform = p_transform
	wires.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	return wires


## Lines over a map of heights, few enough to be drawn: the engine's own are millions.
static func _lines_of(p_map: HeightMapShape3D) -> ArrayMesh:
	var columns: int = p_map.map_width
	var rows: int = p_map.map_depth
	var step: int = maxi(ceili(maxi(columns, rows) / float(_MAP_LINES)), 1)
	var heights: PackedFloat32Array = p_map.map_data
	var middle: Vector3 = Vector3(columns - 1, 0.0, rows - 1) / 2.0
	var points: PackedVector3Array = []
	for row: int in range(0, rows, step):
		for column: int in range(0, columns, step):
			var place: Vector3 = Vector3(column, heights[row * columns + column], row) - middle
			for next: Vector2i in [Vector2i(column + step, row), Vector2i(column, row + step)]:
				if next.x < columns and next.y < rows:
					var height: float = heights[next.y * columns + next.x]
					points.append(place)
					points.append(Vector3(next.x, height, next.y) - middle)
	var arrays: Array = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = points
	var lines: ArrayMesh = ArrayMesh.new()
	lines.add_surface_from_arrays(Mesh.PRIMITIVE_LINES, arrays)
	return lines


## The lines of a debug mesh, which fills its faces too.
static func _keep_lines(p_mesh: ArrayMesh) -> ArrayMesh:
	var lines: ArrayMesh = ArrayMesh.new()
	for surface: int in p_mesh.get_surface_count():
		if p_mesh.surface_get_primitive_type(surface) == Mesh.PRIMITIVE_LINES:
			var arrays: Array = p_mesh.surface_get_arrays(surface)
			lines.add_surface_from_arrays(Mesh.PRIMITIVE_LINES, arrays)
	return lines
