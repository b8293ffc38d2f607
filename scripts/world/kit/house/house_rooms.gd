class_name HouseRooms
extends RefCounted
## What is inside a [House]: floors, ceilings, stairs with railings, inner walls and furniture.

const STONE: SurfaceLayers.Layer = SurfaceLayers.Layer.CONCRETE
const TILES: SurfaceLayers.Layer = SurfaceLayers.Layer.TILES
const WOOD: SurfaceLayers.Layer = SurfaceLayers.Layer.WOOD
const PLASTER: SurfaceLayers.Layer = SurfaceLayers.Layer.PLASTER_PALE
const PLAIN: int = SurfaceTints.Tint.PLAIN
## Thickness of inner walls and railings, m.
const THIN_M: float = 0.14
## Width and height of inner doorways, m.
const DOORWAY: Vector2 = Vector2(1.15, 2.15)

var _mesh: BlockMesh
var _plan: HousePlan
var _inner: Rect2


func _init(p_mesh: BlockMesh, p_plan: HousePlan) -> void:
	_mesh = p_mesh
	_plan = p_plan
	var wall: float = HousePlan.WALL_M
	_inner = Rect2(wall, wall, p_plan.width - 2.0 * wall, p_plan.depth - 2.0 * wall)


## Where the lamp of a storey hangs, in the house's frame.
static func lamp_place(p_plan: HousePlan, p_storey: int) -> Vector3:
	var left: float = HousePlan.WALL_M
	var right: float = p_plan.width - HousePlan.WALL_M
	if p_plan.has_stairs():
		right = p_plan.stairs_rect().position.x
	var y: float = (p_storey + 1) * HousePlan.STOREY_M - HousePlan.FLOOR_M - 0.55
	return Vector3((left + right) / 2.0, y, -p_plan.depth * 0.32)


## Where the middle of the inner doorway is, in the house's frame, m; 0 where there is one room.
static func doorway_middle(p_plan: HousePlan) -> float:
	var living: Rect2 = living_rect(p_plan)
	if living.size.y < 6.0 or living.size.x < 2.6:
		return 0.0
	return living.end.x - 0.3 - DOORWAY.x / 2.0


## Adds all rooms.
func build() -> void:
	_mesh.set_finest(0.7)
	for storey: int in _plan.storeys:
		_add_floor(storey)
		_add_ceiling(storey)
		_add_lamp(lamp_place(_plan, storey))
		if _plan.has_stairs():
			_add_stairs(storey)
			_add_railing(storey)
		HouseFurniture.new(_mesh, _plan, living_rect(_plan), storey).build()
		_add_inner_wall(storey)
	_mesh.set_finest(1.25)


## The part of a storey where people live, seen from above: left of the stairs.
static func living_rect(p_plan: HousePlan) -> Rect2:
	var wall: float = HousePlan.WALL_M
	var right: float = p_plan.width - wall
	if p_plan.has_stairs():
		right = p_plan.stairs_rect().position.x - THIN_M
	return Rect2(wall, wall, right - wall, p_plan.depth - 2.0 * wall)


func _add_floor(p_storey: int) -> void:
	var y: float = p_storey * HousePlan.STOREY_M
	var holes: PackedVector4Array = []
	if p_storey == 0:
		y = HousePlan.GROUND_FLOOR_M
		_mesh.solid(Vector3(0.0, -0.3, -_plan.depth), Vector3(_plan.width, y, 0.0))
	else:
		holes = _stairs_hole(false)
		for box: AABB in HouseRoof.slab_boxes(_plan, y):
			_mesh.solid(box.position, box.end)
	_mesh.face(
		Vector3(_inner.position.x, y, -_inner.position.y),
		Vector3.RIGHT,
		Vector3.FORWARD,
		_inner.size,
		TILES if p_storey == 0 or _plan.dice.randf() < 0.5 else STONE,
		PLAIN,
		holes
	)


func _add_ceiling(p_storey: int) -> void:
	var y: float = (p_storey + 1) * HousePlan.STOREY_M - HousePlan.FLOOR_M
	_mesh.face(
		Vector3(_inner.position.x, y, -_inner.end.y),
		Vector3.RIGHT,
		Vector3.BACK,
		_inner.size,
		WOOD if p_storey == _plan.storeys - 1 else PLASTER,
		PLAIN,
		_stairs_hole(true)
	)
	if _plan.has_stairs():
		_add_hole_edge(y)


## The edges of the floor around the hole for the stairs.
func _add_hole_edge(p_y: float) -> void:
	var stairs: Rect2 = _plan.stairs_rect()
	var high: float = HousePlan.FLOOR_M
	_mesh.face(
		Vector3(stairs.position.x, p_y, -stairs.end.y),
		Vector3.BACK,
		Vector3.UP,
		Vector2(stairs.size.y, high),
		PLASTER,
		PLAIN
	)
	_mesh.face(
		Vector3(stairs.position.x, p_y, -stairs.position.y),
		Vector3.RIGHT,
		Vector3.UP,
		Vector2(stairs.size.x, high),
		PLASTER,
		PLAIN
	)
	_mesh.face(
		Vector3(stairs.end.x, p_y, -stairs.end.y),
		Vector3.LEFT,
		Vector3.UP,
		Vector2(stairs.size.x, high),
		PLASTER,
		PLAIN
	)


## The hole for the stairs in the rectangle of the rooms, from the front or from the back.
func _stairs_hole(p_from_back: bool) -> PackedVector4Array:
	if not _plan.has_stairs():
		return []
	var stairs: Rect2 = _plan.stairs_rect()
	var x: float = stairs.position.x - _inner.position.x
	var y: float = stairs.position.y - _inner.position.y
	if p_from_back:
		y = _inner.end.y - stairs.end.y
	return [Vector4(x, y, stairs.size.x, stairs.size.y)]


## A flight from the back to the front.
func _add_stairs(p_storey: int) -> void:
	var stairs: Rect2 = _plan.stairs_rect()
	var bottom: float = p_storey * HousePlan.STOREY_M
	var rise: float = HousePlan.STOREY_M / HousePlan.STEPS
	for step: int in HousePlan.STEPS:
		var z: float = -stairs.end.y + HousePlan.GOING_M * step
		var top: float = bottom + rise * (step + 1)
		var under: float = maxf(bottom, top - 0.45)
		_mesh.box(
			Vector3(stairs.position.x, under, z),
			Vector3(stairs.end.x, top, z + HousePlan.GOING_M),
			STONE,
			_plan.trim,
			0,
			true
		)


## Along the open side of the flight, and of the hole above it.
func _add_railing(p_storey: int) -> void:
	const HIGH: float = 0.95
	var stairs: Rect2 = _plan.stairs_rect()
	var x: float = stairs.position.x
	var y: float = (p_storey + 1) * HousePlan.STOREY_M
	if p_storey < _plan.storeys - 1:
		_mesh.box(
			Vector3(x - THIN_M, y, -stairs.end.y),
			Vector3(x, y + HIGH, -stairs.position.y),
			PLASTER,
			PLAIN,
			BlockMesh.FACE_BOTTOM,
			true
		)


func _add_inner_wall(p_storey: int) -> void:
	var living: Rect2 = living_rect(_plan)
	if doorway_middle(_plan) <= 0.0:
		return
	var z: float = -(living.position.y + living.size.y * 0.55)
	var low: float = p_storey * HousePlan.STOREY_M
	var high: float = HousePlan.STOREY_M - HousePlan.FLOOR_M
	var door: float = living.size.x - DOORWAY.x - 0.3
	var hole: PackedVector4Array = [Vector4(door, 0.0, DOORWAY.x, DOORWAY.y)]
	var back_hole: PackedVector4Array = [
		Vector4(living.size.x - door - DOORWAY.x, 0.0, DOORWAY.x, DOORWAY.y)
	]
	var from: Vector3 = Vector3(living.position.x, low, z)
	var extent: Vector2 = Vector2(living.size.x, high)
	_mesh.face(from, Vector3.RIGHT, Vector3.UP, extent, PLASTER, PLAIN, hole)
	_mesh.face(
		from + Vector3(living.size.x, 0.0, -THIN_M),
		Vector3.LEFT,
		Vector3.UP,
		extent,
		PLASTER,
		PLAIN,
		back_hole
	)
	for part: Rect2 in [
		Rect2(0.0, 0.0, door, high),
		Rect2(door, DOORWAY.y, DOORWAY.x, high - DOORWAY.y),
		Rect2(door + DOORWAY.x, 0.0, living.size.x - door - DOORWAY.x, high),
	]:
		var corner: Vector3 = from + Vector3(part.position.x, part.position.y, -THIN_M)
		_mesh.solid(corner, corner + Vector3(part.size.x, part.size.y, THIN_M))
	var jamb: Vector2 = Vector2(THIN_M, DOORWAY.y)
	var left: Vector3 = from + Vector3(door, 0.0, 0.0)
	var right: Vector3 = left + Vector3(DOORWAY.x, 0.0, -THIN_M)
	_mesh.face(left, Vector3.FORWARD, Vector3.UP, jamb, WOOD, PLAIN)
	_mesh.face(right, Vector3.BACK, Vector3.UP, jamb, WOOD, PLAIN)
	_mesh.face(
		right + Vector3(0.0, DOORWAY.y, THIN_M),
		Vector3.LEFT,
		Vector3.FORWARD,
		Vector2(DOORWAY.x, THIN_M),
		WOOD,
		PLAIN
	)
	_mesh.face(
		from + Vector3(living.size.x, 0.0, 0.0),
		Vector3.FORWARD,
		Vector3.UP,
		Vector2(THIN_M, high),
		PLASTER,
		PLAIN
	)


func _add_lamp(p_place: Vector3) -> void:
	_mesh.rod(
		p_place,
		p_place + Vector3.UP * 0.55,
		0.008,
		0.008,
		SurfaceLayers.Layer.STEEL,
		SurfaceTints.Tint.BLACK,
		4,
		false
	)
	_mesh.rod(
		p_place - Vector3.UP * 0.02,
		p_place + Vector3.UP * 0.16,
		0.19,
		0.05,
		PLASTER,
		SurfaceTints.Tint.LAMP,
		12
	)
