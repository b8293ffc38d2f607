class_name VisibilityCells
extends RefCounted
## Which parts of a world can be seen from which: a grid of cells, tested with rays against
## static bodies (potentially visible sets, thesis sections 4.2.2 and 7.2).

## Maximum of cells; a larger world gets larger ones.
const MAX_CELLS: int = 256
## Smallest edge of a cell, m.
const MIN_M: float = 4.0
## Maximum extent of a world, m.
const FARTHEST_M: float = 2000.0

## Corner of the grid with the least coordinates, m.
var origin: Vector3 = Vector3.ZERO
## Edge of a cell, m.
var size: float = MIN_M
## Cells along each axis.
var counts: Vector3i = Vector3i.ZERO
## A byte for each pair of cells (from, to): 1 where something of the one can be seen from
## somewhere in the other. Cells are in the order x, then z, then y from slow to fast.
var visible: PackedByteArray = PackedByteArray()

var _world: Node3D = null
var _bodies: Array[Node] = []
var _next: int = 0
var _box: AABB = AABB()
var _layers: int = 0
var _query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.new()
var _from: int = 0
var _to: int = 0
var _is_done: bool = false


## The cells of the static bodies below a node, or null if there are none. Needs the physics space
## to have been stepped since the bodies came.
static func survey(p_world: Node3D) -> VisibilityCells:
	var cells: VisibilityCells = begin(p_world)
	cells.advance_until(1 << 62)
	return cells if not cells.visible.is_empty() else null


## The cells that were baked with a level, which are done at once; where none were, as
## [method begin].
static func begin_level(p_level: Level) -> VisibilityCells:
	var bake: LevelBake = p_level.bake
	if bake == null or bake.seen_cells.is_empty():
		return begin(p_level)
	var cells: VisibilityCells = VisibilityCells.new()
	cells._world = p_level
	cells.origin = p_level.global_position + bake.cell_origin
	cells.size = bake.cell_size
	cells.counts = bake.cell_counts
	cells.visible = bake.seen_cells
	cells._is_done = true
	return cells


## Begins to look at the static bodies below a node; see [method advance_until].
static func begin(p_world: Node3D) -> VisibilityCells:
	var cells: VisibilityCells = VisibilityCells.new()
	cells._world = p_world
	cells._bodies = p_world.find_children("*", "StaticBody3D", true, false)
	return cells


## Goes on until a moment of [method Time.get_ticks_usec], by one body or one pair of cells at
## least. Returns whether it is done; where there is nothing to see, [member visible] is empty then.
func advance_until(p_usec: int) -> bool:
	while not _is_done:
		if not is_instance_valid(_world):
			visible.clear()
			_is_done = true
		elif _next < _bodies.size():
			if is_instance_valid(_bodies[_next]):
				_add_body(_bodies[_next])
			_next += 1
		elif visible.is_empty():
			_begin_pairs()
		else:
			_try_pair()
		if Time.get_ticks_usec() >= p_usec:
			break
	return _is_done


## Share of the pairs that see each other.
func openness() -> float:
	return float(visible.count(1)) / maxi(visible.size(), 1)


func _divide(p_box: AABB) -> void:
	size = MIN_M
	while true:
		counts = Vector3i((p_box.size / size).ceil().max(Vector3.ONE))
		if counts.x * counts.y * counts.z <= MAX_CELLS:
			break
		size *= 1.25
	origin = p_box.get_center() - Vector3(counts) * size / 2.0


func _begin_pairs() -> void:
	_is_done = _box.size == Vector3.ZERO or _box.get_longest_axis_size() > FARTHEST_M
	if _is_done:
		return
	_divide(_box)
	var count: int = counts.x * counts.y * counts.z
	visible.resize(count * count)
	_query.collision_mask = _layers
	_query.hit_from_inside = false


## Finds whether the next two cells see each other.
func _try_pair() -> void:
	var count: int = counts.x * counts.y * counts.z
	if _sees(_world.get_world_3d().direct_space_state, _query, _from, _to):
		visible[_from * count + _to] = 1
		visible[_to * count + _from] = 1
	_to += 1
	if _to == count:
		_from += 1
		_to = _from
		_is_done = _from == count


func _sees(
	p_space: PhysicsDirectSpaceState3D, p_query: PhysicsRayQueryParameters3D, p_a: int, p_b: int
) -> bool:
	var apart: Vector3i = (_cell_index(p_a) - _cell_index(p_b)).abs()
	if maxi(apart.x, maxi(apart.y, apart.z)) <= 1:
		return true
	for from: Vector3 in _points(p_a):
		for to: Vector3 in _points(p_b):
			p_query.from = from
			p_query.to = to
			if p_space.intersect_ray(p_query).is_empty():
				return true
	return false


## A few points of a cell: its middle and four of its corners, moved inwards a little.
func _points(p_cell: int) -> Array[Vector3]:
	var middle: Vector3 = origin + (Vector3(_cell_index(p_cell)) + Vector3.ONE * 0.5) * size
	var points: Array[Vector3] = [middle]
	for corner: Vector3 in [
		Vector3(1, 1, 1), Vector3(-1, 1, -1), Vector3(1, -1, -1), Vector3(-1, -1, 1)
	]:
		points.append(middle + corner * size * 0.4)
	return points


func _cell_index(p_cell: int) -> Vector3i:
	var y: int = p_cell % counts.y
	var rest: int = p_cell / counts.y
	return Vector3i(rest / counts.z, y, rest % counts.z)


func _add_body(p_body: StaticBody3D) -> void:
	_layers |= p_body.collision_layer
	for child: Node in p_body.get_children(true):
		var shape: CollisionShape3D = child as CollisionShape3D
		if shape == null or shape.shape == null:
			continue
		var part: AABB = shape.global_transform * _bounds_of(shape.shape)
		_box = part if _box.size == Vector3.ZERO else _box.merge(part)


## A mesh for a box would cost a hundred times as much.
static func _bounds_of(p_shape: Shape3D) -> AABB:
	var box: BoxShape3D = p_shape as BoxShape3D
	if box != null:
		return AABB(-box.size / 2.0, box.size)
	return p_shape.get_debug_mesh().get_aabb()
