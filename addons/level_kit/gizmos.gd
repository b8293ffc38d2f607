@tool
extends EditorNode3DGizmoPlugin
## Handles of the level kit's blocks: pull them to change sizes. A kind of block is a row of
## [method _rows].

const Marks: GDScript = preload("mark_lines.gd")
const STEP_M: float = 0.05


## A handle: a property, which part of it, where it is and which way it is pulled.
class Handle:
	extends RefCounted
	var property: StringName = &""
	var title: String = ""
	## Where it is, in the block's frame, m.
	var place: Vector3 = Vector3.ZERO
	## Which way it is pulled, in the block's frame; zero: freely.
	var axis: Vector3 = Vector3.ZERO
	## Whether what is pulled freely keeps its height; else it goes over the screen.
	var is_level: bool = false
	## The property's value for the handle at so far along the axis, or, pulled freely, at a point.
	var value_at: Callable = Callable()
	## Where the block goes when it is at so far, in its own frame, m; may be empty.
	var shift_at: Callable = Callable()


var _undo: EditorUndoRedoManager = null
# Where the node was when the pull began.
var _from: Transform3D = Transform3D.IDENTITY
var _begin: Handle = null


func _init(p_undo: EditorUndoRedoManager) -> void:
	_undo = p_undo
	create_material("lines", Color(1.0, 0.75, 0.2))
	create_handle_material("handles")


func _get_gizmo_name() -> String:
	return "Level kit"


func _has_gizmo(p_node: Node3D) -> bool:
	return (
		p_node is Block
		or p_node is Wall
		or p_node is House
		or p_node is Stairs
		or p_node is Road
		or p_node is Wire
		or p_node is TriggerZone
		or p_node is WaypointPath
	)


func _redraw(p_gizmo: EditorNode3DGizmo) -> void:
	p_gizmo.clear()
	var places: PackedVector3Array = []
	for handle: Handle in _rows(p_gizmo.get_node_3d()):
		places.append(handle.place)
	var lines: PackedVector3Array = Marks.of(p_gizmo.get_node_3d())
	if not lines.is_empty():
		p_gizmo.add_lines(lines, get_material("lines", p_gizmo))
		p_gizmo.add_collision_segments(lines)
	if not places.is_empty():
		p_gizmo.add_handles(places, get_material("handles", p_gizmo), [])


func _get_handle_name(p_gizmo: EditorNode3DGizmo, p_id: int, _is_secondary: bool) -> String:
	return _rows(p_gizmo.get_node_3d())[p_id].title


func _get_handle_value(p_gizmo: EditorNode3DGizmo, p_id: int, _is_secondary: bool) -> Variant:
	return p_gizmo.get_node_3d().get(_rows(p_gizmo.get_node_3d())[p_id].property)


func _begin_handle_action(p_gizmo: EditorNode3DGizmo, p_id: int, _is_secondary: bool) -> void:
	_from = p_gizmo.get_node_3d().global_transform
	_begin = _rows(p_gizmo.get_node_3d())[p_id]


func _set_handle(
	p_gizmo: EditorNode3DGizmo, _id: int, _is_secondary: bool, p_camera: Camera3D, p_at: Vector2
) -> void:
	if _begin == null:
		return
	var node: Node3D = p_gizmo.get_node_3d()
	var inverse: Transform3D = _from.affine_inverse()
	var from: Vector3 = inverse * p_camera.project_ray_origin(p_at)
	var way: Vector3 = inverse.basis * p_camera.project_ray_normal(p_at)
	if _begin.axis == Vector3.ZERO:
		var facing: Vector3 = inverse.basis * p_camera.global_basis.z
		if _begin.is_level:
			facing = inverse.basis * Vector3.UP
		var hit: Variant = Plane(facing, _begin.place).intersects_ray(from, way)
		if hit is Vector3:
			node.set(_begin.property, _begin.value_at.call((hit as Vector3).snappedf(STEP_M)))
		return
	var ends: PackedVector3Array = Geometry3D.get_closest_points_between_segments(
		_begin.place - _begin.axis * 500.0,
		_begin.place + _begin.axis * 500.0,
		from,
		from + way * 2000.0
	)
	var step: float = STEP_M
	if EditorInterface.is_node_3d_snap_enabled():
		step = EditorInterface.get_node_3d_translate_snap()
	var along: float = snappedf(ends[0].dot(_begin.axis), step)
	node.set(_begin.property, _begin.value_at.call(along))
	if _begin.shift_at.is_valid():
		node.global_position = _from * (_begin.shift_at.call(along) as Vector3)


func _commit_handle(
	p_gizmo: EditorNode3DGizmo,
	_id: int,
	_is_secondary: bool,
	p_restore: Variant,
	p_is_cancelled: bool
) -> void:
	var node: Node3D = p_gizmo.get_node_3d()
	if _begin == null:
		return
	if p_is_cancelled:
		node.set(_begin.property, p_restore)
		node.global_transform = _from
		return
	_undo.create_action("Change " + _begin.title)
	_undo.add_do_property(node, _begin.property, node.get(_begin.property))
	_undo.add_do_property(node, &"global_position", node.global_position)
	_undo.add_undo_property(node, _begin.property, p_restore)
	_undo.add_undo_property(node, &"global_position", _from.origin)
	_undo.commit_action()
	_begin = null


static func _rows(p_node: Node3D) -> Array[Handle]:
	if p_node is Block:
		return _block_rows(p_node)
	if p_node is Wall:
		return _wall_rows(p_node)
	if p_node is House:
		return _house_rows(p_node)
	if p_node is Stairs:
		return _stairs_rows(p_node)
	if p_node is Road:
		return _road_rows(p_node)
	if p_node is TriggerZone:
		return _zone_rows(p_node)
	if p_node is WaypointPath:
		return _path_rows(p_node)
	var wire: Wire = p_node as Wire
	return [_row(&"end", "end", wire.end, Vector3.ZERO, func(at: Vector3) -> Vector3: return at)]


## The six faces: the opposite one stays where it is.
static func _block_rows(p_block: Block) -> Array[Handle]:
	var rows: Array[Handle] = []
	var size: Vector3 = p_block.size
	for axis: int in 3:
		for side: float in [1.0, -1.0]:
			var way: Vector3 = Vector3.ZERO
			way[axis] = side
			var half: float = size[axis] / 2.0
			var value_at: Callable = func(along: float) -> Vector3:
				var changed: Vector3 = size
				changed[axis] = maxf(along + half, STEP_M)
				return changed
			var row: Handle = _row(&"size", "size", way * half, way, value_at)
			row.shift_at = func(along: float) -> Vector3:
				return way * (maxf(along + half, STEP_M) / 2.0 - half)
			rows.append(row)
	return rows


## The four sides and the top: the opposite side stays where it is, the bottom on the ground.
static func _zone_rows(p_zone: TriggerZone) -> Array[Handle]:
	var rows: Array[Handle] = []
	var size: Vector3 = p_zone.size
	var box: AABB = p_zone.get_box()
	var round: bool = p_zone.form == TriggerZone.Form.CYLINDER
	for way: Vector3 in [Vector3.RIGHT, Vector3.LEFT, Vector3.BACK, Vector3.FORWARD, Vector3.UP]:
		var axis: int = way.abs().max_axis_index()
		# A cylinder has one width, and stays around its middle.
		var part: int = 0 if round and axis == 2 else axis
		var half: float = box.size[axis] / 2.0
		var value_at: Callable = func(along: float) -> Vector3:
			var changed: Vector3 = size
			var keeps_middle: bool = round and axis != 1
			changed[part] = along if axis == 1 else along * 2.0 if keeps_middle else along + half
			return changed.max(Vector3.ONE * TriggerZone.MIN_M)
		var row: Handle = _row(
			&"size", "size", box.get_center() * (Vector3.ONE - way.abs()), way, value_at
		)
		row.place += way * (box.size.y if axis == 1 else half)
		if axis != 1 and not round:
			row.shift_at = func(along: float) -> Vector3:
				return way * (maxf(along + half, TriggerZone.MIN_M) / 2.0 - half)
		rows.append(row)
	return rows


## The points, and between two of them one that adds a point.
static func _path_rows(p_path: WaypointPath) -> Array[Handle]:
	var rows: Array[Handle] = []
	var points: PackedVector3Array = p_path.points
	for index: int in points.size():
		var moved: Callable = func(at: Vector3) -> PackedVector3Array:
			var changed: PackedVector3Array = points.duplicate()
			changed[index] = at
			return changed
		rows.append(_row(&"points", "point %d" % index, points[index], Vector3.ZERO, moved))
		rows[-1].is_level = true
	var corners: PackedVector3Array = p_path.get_corners()
	for index: int in corners.size() - 1:
		var added: Callable = func(at: Vector3) -> PackedVector3Array:
			var changed: PackedVector3Array = points.duplicate()
			changed.insert(index + 1, at)
			return changed
		var half: Vector3 = (corners[index] + corners[index + 1]) / 2.0
		rows.append(_row(&"points", "a new point", half, Vector3.ZERO, added))
		rows[-1].is_level = true
	return rows


static func _wall_rows(p_wall: Wall) -> Array[Handle]:
	var rows: Array[Handle] = []
	var size: Vector3 = p_wall.size
	var places: Array[Vector3] = [
		Vector3(size.x, size.y / 2.0, 0.0), Vector3(size.x / 2.0, size.y, 0.0)
	]
	for axis: int in 2:
		var way: Vector3 = Vector3.ZERO
		way[axis] = 1.0
		var value_at: Callable = func(along: float) -> Vector3:
			var changed: Vector3 = size
			changed[axis] = along
			return changed
		rows.append(_row(&"size", "size", places[axis], way, value_at))
	return rows


static func _house_rows(p_house: House) -> Array[Handle]:
	var size: Vector2 = p_house.size
	var height: float = p_house.storeys * HousePlan.STOREY_M
	var wide: Callable = func(along: float) -> Vector2: return Vector2(along, size.y)
	var deep: Callable = func(along: float) -> Vector2: return Vector2(size.x, along)
	var high: Callable = func(along: float) -> int: return roundi(along / HousePlan.STOREY_M)
	var middle: Vector3 = Vector3(size.x / 2.0, 1.0, -size.y / 2.0)
	return [
		_row(&"size", "width", Vector3(size.x, 1.0, middle.z), Vector3.RIGHT, wide),
		_row(&"size", "depth", Vector3(middle.x, 1.0, -size.y), Vector3.FORWARD, deep),
		_row(&"storeys", "storeys", Vector3(middle.x, height, middle.z), Vector3.UP, high),
	]


static func _stairs_rows(p_stairs: Stairs) -> Array[Handle]:
	var rise: float = p_stairs.rise
	var top: Vector3 = Vector3(0.0, p_stairs.steps * rise, -p_stairs.steps * p_stairs.going)
	var back: Vector3 = top + Vector3.FORWARD * p_stairs.landing
	var wide: Callable = func(along: float) -> float: return along * 2.0
	var high: Callable = func(along: float) -> int: return roundi(along / rise)
	var deep: Callable = func(along: float) -> float: return along + top.z
	var side: Vector3 = Vector3(p_stairs.width / 2.0, top.y / 2.0, top.z / 2.0)
	return [
		_row(&"width", "width", side, Vector3.RIGHT, wide),
		_row(&"steps", "steps", top, Vector3.UP, high),
		_row(&"landing", "landing", back, Vector3.FORWARD, deep),
	]


## Its far end, and a side: the middle stays where it is.
static func _road_rows(p_road: Road) -> Array[Handle]:
	var size: Vector2 = p_road.size
	var wide: Callable = func(along: float) -> Vector2: return Vector2(along * 2.0, size.y)
	var long: Callable = func(along: float) -> Vector2: return Vector2(size.x, along)
	var side: Vector3 = Vector3(size.x / 2.0, p_road.height, -size.y / 2.0)
	return [
		_row(&"size", "width", side, Vector3.RIGHT, wide),
		_row(&"size", "length", Vector3(0.0, p_road.height, -size.y), Vector3.FORWARD, long),
	]


static func _row(
	p_property: StringName, p_title: String, p_place: Vector3, p_axis: Vector3, p_value_at: Callable
) -> Handle:
	var row: Handle = Handle.new()
	row.property = p_property
	row.title = p_title
	row.place = p_place
	row.axis = p_axis
	row.value_at = p_value_at
	return row
