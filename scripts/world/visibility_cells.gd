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


## The cells of the static bodies below a node, or null if there are none. Needs the physics space
## to have been stepped since the bodies came.
static func survey(p_world: Node3D) -> VisibilityCells:
	var box: AABB = _bounds(p_world)
	if box.size == Vector3.ZERO or box.get_longest_axis_size() > FARTHEST_M:
		return null
	var cells: VisibilityCells = VisibilityCells.new()
	cells._divide(box)
	cells._try_out(p_world.get_world_3d().direct_space_state, _static_layers(p_world))
	return cells


## Share of the pairs that see each other.
func openness() -> float:
	var open: int = 0
	for byte: int in visible:
		open += byte
	return float(open) / maxi(visible.size(), 1)


func _divide(p_box: AABB) -> void:
	size = MIN_M
	while true:
		counts = Vector3i((p_box.size / size).ceil().max(Vector3.ONE))
		if counts.x * counts.y * counts.z <= MAX_CELLS:
			break
		size *= 1.25
	origin = p_box.get_center() - Vector3(counts) * size / 2.0


func _try_out(p_space: PhysicsDirectSpaceState3D, p_layers: int) -> void:
	var count: int = counts.x * counts.y * counts.z
	visible.resize(count * count)
	var query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.new()
	query.collision_mask = p_layers
	query.hit_from_inside = false
	for from: int in count:
		for to: int in range(from, count):
			if _sees(p_space, query, from, to):
				visible[from * count + to] = 1
				visible[to * count + from] = 1


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


static func _bounds(p_world: Node3D) -> AABB:
	var box: AABB = AABB()
	for body: Node in p_world.find_children("*", "StaticBody3D", true, false):
		for child: Node in body.get_children(true):
			var shape: CollisionShape3D = child as CollisionShape3D
			if shape == null or shape.shape == null:
				continue
			var part: AABB = shape.global_transform * shape.shape.get_debug_mesh().get_aabb()
			box = part if box.size == Vector3.ZERO else box.merge(part)
	return box


static func _static_layers(p_world: Node3D) -> int:
	var layers: int = 0
	for body: Node in p_world.find_children("*", "StaticBody3D", true, false):
		layers |= (body as StaticBody3D).collision_layer
	return layers
