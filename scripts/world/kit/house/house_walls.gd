class_name HouseWalls
extends RefCounted
## The outer walls of a [House], with their openings and what fills them.

const STONE: SurfaceLayers.Layer = SurfaceLayers.Layer.CONCRETE
const INNER: SurfaceLayers.Layer = SurfaceLayers.Layer.PLASTER_PALE

var _mesh: BlockMesh
var _plan: HousePlan
var _fillings: HouseOpenings


func _init(p_mesh: BlockMesh, p_plan: HousePlan) -> void:
	_mesh = p_mesh
	_plan = p_plan
	_fillings = HouseOpenings.new(p_mesh, p_plan)


## Adds all walls.
func build() -> void:
	for storey: int in _plan.storeys:
		for wall: int in 4:
			_add_wall(storey, wall as HousePlan.Facade)
	if not _plan.is_entered:
		_mesh.solid(
			Vector3(0.0, 0.0, -_plan.depth),
			Vector3(_plan.width, _plan.storeys * HousePlan.STOREY_M, 0.0)
		)


## Adds the faces that are seen from within a house that is entered.
func build_inner_faces() -> void:
	for storey: int in _plan.storeys:
		for number: int in 4:
			var wall: HousePlan.Facade = number as HousePlan.Facade
			var right: Vector3 = HousePlan.along(wall)
			var extent: Vector2 = Vector2(_plan.length_of(wall), HousePlan.STOREY_M)
			var from: Vector3 = _plan.corner_of(wall, storey * HousePlan.STOREY_M)
			from += right * extent.x - right.cross(Vector3.UP) * HousePlan.WALL_M
			var holes: PackedVector4Array = []
			for opening: HousePlan.Opening in _plan.openings[storey][wall]:
				var rect: Rect2 = opening.rect
				var x: float = extent.x - rect.end.x
				holes.append(Vector4(x, rect.position.y, rect.size.x, rect.size.y))
			_mesh.face(from, -right, Vector3.UP, extent, INNER, SurfaceTints.Tint.PLAIN, holes)


func _add_wall(p_storey: int, p_wall: HousePlan.Facade) -> void:
	var from: Vector3 = _plan.corner_of(p_wall, p_storey * HousePlan.STOREY_M)
	var right: Vector3 = HousePlan.along(p_wall)
	var extent: Vector2 = Vector2(_plan.length_of(p_wall), HousePlan.STOREY_M)
	var openings: Array[HousePlan.Opening] = _plan.openings[p_storey][p_wall]
	var holes: PackedVector4Array = []
	for opening: HousePlan.Opening in openings:
		var rect: Rect2 = opening.rect
		holes.append(Vector4(rect.position.x, rect.position.y, rect.size.x, rect.size.y))
	_mesh.face(from, right, Vector3.UP, extent, _plan.surface, _plan.tint, holes)
	if _plan.is_entered:
		_add_solids(from, right, extent, openings)
	for opening: HousePlan.Opening in openings:
		_add_reveal(from, right, opening.rect)
		_fillings.fill(from, right, opening, p_storey)


## Boxes for the wall: columns between the openings, and what is over and under them.
func _add_solids(
	p_from: Vector3, p_right: Vector3, p_extent: Vector2, p_openings: Array[HousePlan.Opening]
) -> void:
	var sorted: Array[HousePlan.Opening] = p_openings.duplicate()
	sorted.sort_custom(
		func(p_a: HousePlan.Opening, p_b: HousePlan.Opening) -> bool:
			return p_a.rect.position.x < p_b.rect.position.x
	)
	var x: float = 0.0
	for opening: HousePlan.Opening in sorted:
		var rect: Rect2 = opening.rect
		_add_slab(p_from, p_right, Rect2(x, 0.0, rect.position.x - x, p_extent.y))
		_add_slab(p_from, p_right, Rect2(rect.position.x, 0.0, rect.size.x, rect.position.y))
		_add_slab(
			p_from,
			p_right,
			Rect2(rect.position.x, rect.end.y, rect.size.x, p_extent.y - rect.end.y)
		)
		x = rect.end.x
	_add_slab(p_from, p_right, Rect2(x, 0.0, p_extent.x - x, p_extent.y))


func _add_slab(p_from: Vector3, p_right: Vector3, p_rect: Rect2) -> void:
	if p_rect.size.x < 0.03 or p_rect.size.y < 0.02:
		return
	var out: Vector3 = p_right.cross(Vector3.UP)
	var low: Vector3 = p_from + p_right * p_rect.position.x + Vector3.UP * p_rect.position.y
	var high: Vector3 = p_from + p_right * p_rect.end.x + Vector3.UP * p_rect.end.y
	_mesh.solid(low, high - out * HousePlan.WALL_M)


## The sides of an opening through the wall.
func _add_reveal(p_from: Vector3, p_right: Vector3, p_rect: Rect2) -> void:
	var out: Vector3 = p_right.cross(Vector3.UP)
	var left: Vector3 = p_from + p_right * p_rect.position.x + Vector3.UP * p_rect.position.y
	var right: Vector3 = left + p_right * p_rect.size.x
	var deep: float = HousePlan.WALL_M
	var side: Vector2 = Vector2(deep, p_rect.size.y)
	var lintel: Vector2 = Vector2(p_rect.size.x, deep)
	_mesh.set_finest(0.6)
	_mesh.face(left, -out, Vector3.UP, side, _plan.surface, _plan.tint)
	_mesh.face(right - out * deep, out, Vector3.UP, side, _plan.surface, _plan.tint)
	_mesh.face(
		right + Vector3.UP * p_rect.size.y, -p_right, -out, lintel, _plan.surface, _plan.tint
	)
	_mesh.face(left, p_right, -out, lintel, STONE, _plan.trim)
	_mesh.set_finest(1.25)
