class_name HouseRoof
extends RefCounted
## The flat roof of a [House] with its parapet, and the hut over the end of its stairs.

const STONE: SurfaceLayers.Layer = SurfaceLayers.Layer.CONCRETE
## How far the parapet's cap stands over, m, and how thick the parapet is.
const LIP_M: float = 0.05
const THICK_M: float = 0.25
## Height of the hut, m.
const HUT_M: float = 2.45

var _mesh: BlockMesh
var _plan: HousePlan
var _y: float


func _init(p_mesh: BlockMesh, p_plan: HousePlan) -> void:
	_mesh = p_mesh
	_plan = p_plan
	_y = p_plan.storeys * HousePlan.STOREY_M


## Adds what is seen from below: the parapet from outside.
func build_edge() -> void:
	_mesh.set_finest(0.9)
	for wall: int in 4:
		_add_parapet(wall as HousePlan.Facade)
	_mesh.set_finest(1.25)


## Adds what is seen from above: the roof, the parapet from within and the hut.
func build_top() -> void:
	_mesh.set_finest(0.9)
	_add_roof()
	for wall: int in 4:
		_add_inner_parapet(wall as HousePlan.Facade)
	if _plan.has_stairs():
		_add_hut()
	_mesh.set_finest(1.25)


## The solid boxes of a floor whose top is at a height, without the stairs.
static func slab_boxes(p_plan: HousePlan, p_y: float) -> Array[AABB]:
	var low: float = p_y - HousePlan.FLOOR_M
	var wall: float = HousePlan.WALL_M
	var inner: Rect2 = Rect2(wall, wall, p_plan.width - 2.0 * wall, p_plan.depth - 2.0 * wall)
	var rects: Array[Rect2] = [inner]
	if p_plan.has_stairs():
		var stairs: Rect2 = p_plan.stairs_rect()
		rects = [
			Rect2(inner.position, Vector2(stairs.position.x - wall, inner.size.y)),
			Rect2(stairs.position.x, wall, stairs.size.x, stairs.position.y - wall),
			Rect2(stairs.position.x, stairs.end.y, stairs.size.x, inner.end.y - stairs.end.y),
		]
	var boxes: Array[AABB] = []
	for rect: Rect2 in rects:
		boxes.append(
			AABB(
				Vector3(rect.position.x, low, -rect.end.y),
				Vector3(rect.size.x, HousePlan.FLOOR_M, rect.size.y)
			)
		)
	return boxes


func _add_roof() -> void:
	var holes: PackedVector4Array = []
	if _plan.has_stairs():
		var stairs: Rect2 = _plan.stairs_rect()
		holes.append(Vector4(stairs.position.x, stairs.position.y, stairs.size.x, stairs.size.y))
	# Seen from above: x to the right, up away from the front.
	_mesh.face(
		Vector3(0.0, _y, 0.0),
		Vector3.RIGHT,
		Vector3.FORWARD,
		Vector2(_plan.width, _plan.depth),
		SurfaceLayers.Layer.DIRT,
		SurfaceTints.Tint.PLAIN,
		holes
	)
	if not _plan.is_entered:
		return
	for box: AABB in slab_boxes(_plan, _y):
		_mesh.solid(box.position, box.end)


func _add_parapet(p_wall: HousePlan.Facade) -> void:
	var from: Vector3 = _plan.corner_of(p_wall, _y)
	var right: Vector3 = HousePlan.along(p_wall)
	var length: float = _plan.length_of(p_wall)
	var extent: Vector2 = Vector2(length, _plan.parapet)
	_mesh.face(from, right, Vector3.UP, extent, _plan.surface, _plan.tint)
	var frame: WallFrame = WallFrame.new(_mesh, from, right)
	var cap: Rect2 = Rect2(-LIP_M, _plan.parapet, length + 2.0 * LIP_M, 0.09)
	frame.bar(cap, -THICK_M - LIP_M, LIP_M, STONE, _plan.trim)
	frame.bar(Rect2(0.0, -0.16, length, 0.1), 0.0, 0.035, _plan.surface, _plan.trim)
	if _plan.is_entered:
		_mesh.solid(frame.point(0.0, 0.0, -THICK_M), frame.point(length, _plan.parapet + 0.09, 0.0))
	else:
		_mesh.solid(frame.point(0.0, 0.0, -THICK_M), frame.point(length, _plan.parapet, 0.0))


func _add_inner_parapet(p_wall: HousePlan.Facade) -> void:
	var right: Vector3 = HousePlan.along(p_wall)
	var length: float = _plan.length_of(p_wall)
	var from: Vector3 = _plan.corner_of(p_wall, _y) + right * length
	from -= right.cross(Vector3.UP) * THICK_M
	var extent: Vector2 = Vector2(length, _plan.parapet)
	_mesh.face(from, -right, Vector3.UP, extent, _plan.surface, _plan.tint)


## Walls around the stairs' end, open towards the landing in front of the last step.
func _add_hut() -> void:
	const WALL: float = 0.2
	var stairs: Rect2 = _plan.stairs_rect()
	var left: float = stairs.position.x - WALL
	var right: float = _plan.width - THICK_M
	var back: float = -stairs.end.y - WALL
	var front: float = -(stairs.position.y - HousePlan.LANDING_M)
	var top: float = _y + HUT_M
	# The way out is on the left of the landing.
	_add_hut_wall(Vector3(left, _y, back), Vector3(left + WALL, top, -stairs.position.y))
	_add_hut_wall(Vector3(right - WALL, _y, back), Vector3(right, top, front + WALL))
	_add_hut_wall(Vector3(left, _y, back), Vector3(right, top, back + WALL))
	_add_hut_wall(Vector3(left, _y, front), Vector3(right, top, front + WALL))
	_mesh.box(
		Vector3(left - 0.12, top, back - 0.12),
		Vector3(right + 0.1, top + 0.14, front + WALL + 0.12),
		STONE,
		_plan.trim,
		0,
		true
	)


func _add_hut_wall(p_from: Vector3, p_to: Vector3) -> void:
	_mesh.box(p_from, p_to, _plan.surface, _plan.tint, BlockMesh.FACE_BOTTOM, true)
