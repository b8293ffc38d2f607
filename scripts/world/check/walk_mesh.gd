class_name WalkMesh
extends RefCounted
## Where people can walk in a level, as islands: polygons of a navigation mesh that hang together.

## Width and height of the cells that the level is cut into, m.
const CELL_M: float = 0.15
const CELL_HEIGHT_M: float = 0.1
## A person: radius, height, highest step, m; steepest slope, degrees.
const RADIUS_M: float = 0.3
const HEIGHT_M: float = 1.8
const CLIMB_M: float = 0.2
const SLOPE: float = 45.0
## Most cells; of a larger level they are larger.
const MAX_CELLS: float = 6.0e6
## What is looked at around blocks where the ground is terrain, m.
const AROUND_M: float = 12.0
const _GROUP: StringName = &"level_check_walk"

## Corners of the polygons.
var vertices: PackedVector3Array = []
## Polygons, as numbers of corners.
var polygons: Array[PackedInt32Array] = []
## The island of each polygon: the number of one of its polygons.
var islands: PackedInt32Array = []
## Area of each island, m2.
var areas: Dictionary[int, float] = {}
## What was looked at.
var bounds: AABB = AABB()


## Works it out for what never moves in a level.
func build(p_level: Level, p_places: PackedVector3Array) -> void:
	var bodies: Array[StaticBody3D] = p_level.get_static_bodies()
	for body: StaticBody3D in bodies:
		body.add_to_group(_GROUP)
	var mesh: NavigationMesh = _make_settings()
	var source: NavigationMeshSourceGeometryData3D = NavigationMeshSourceGeometryData3D.new()
	NavigationServer3D.parse_source_geometry_data(mesh, source, p_level)
	for body: StaticBody3D in bodies:
		body.remove_from_group(_GROUP)
	if not source.has_data():
		return
	bounds = source.get_bounds()
	_limit(mesh, bodies, p_places)
	NavigationServer3D.bake_from_source_geometry_data(mesh, source)
	vertices = mesh.get_vertices()
	for index: int in mesh.get_polygon_count():
		polygons.append(mesh.get_polygon(index))
	_join()


## The polygon on which somebody who is at a point stands, or -1.
func find_polygon(p_at: Vector3, p_reach: float = 0.5, p_height: float = 0.5) -> int:
	var best: int = -1
	var least: float = p_reach
	for index: int in polygons.size():
		var distance: float = _distance(index, p_at, p_height)
		if distance < least:
			least = distance
			best = index
	return best


## Middle of a polygon.
func middle(p_polygon: int) -> Vector3:
	var sum: Vector3 = Vector3.ZERO
	for corner: int in polygons[p_polygon]:
		sum += vertices[corner]
	return sum / polygons[p_polygon].size()


## Whether some polygon of an island comes into a box that stands upright.
func comes_into(p_island: int, p_box: AABB) -> bool:
	var low: Vector2 = Vector2(p_box.position.x, p_box.position.z)
	var high: Vector2 = Vector2(p_box.end.x, p_box.end.z)
	var frame: PackedVector2Array = [low, Vector2(high.x, low.y), high, Vector2(low.x, high.y)]
	for index: int in polygons.size():
		if islands[index] != p_island:
			continue
		var heights: Vector2 = _heights(index)
		if heights.x > p_box.end.y or heights.y < p_box.position.y:
			continue
		if not Geometry2D.intersect_polygons(_flat(index), frame).is_empty():
			return true
	return false


func _make_settings() -> NavigationMesh:
	var mesh: NavigationMesh = NavigationMesh.new()
	mesh.geometry_parsed_geometry_type = NavigationMesh.PARSED_GEOMETRY_STATIC_COLLIDERS
	mesh.geometry_source_geometry_mode = NavigationMesh.SOURCE_GEOMETRY_GROUPS_EXPLICIT
	mesh.geometry_source_group_name = _GROUP
	mesh.geometry_collision_mask = PhysicsLayers.STATIC
	mesh.cell_size = CELL_M
	mesh.cell_height = CELL_HEIGHT_M
	mesh.agent_radius = RADIUS_M
	mesh.agent_height = HEIGHT_M
	mesh.agent_max_climb = CLIMB_M
	mesh.agent_max_slope = SLOPE
	return mesh


## Ground goes on for hundreds of metres: only what is around blocks and places is looked at.
func _limit(
	p_mesh: NavigationMesh, p_bodies: Array[StaticBody3D], p_places: PackedVector3Array
) -> void:
	var terrains: Array = p_bodies.filter(func(body: Node) -> bool: return body is Terrain)
	if not terrains.is_empty():
		var points: PackedVector3Array = p_places.duplicate()
		for body: StaticBody3D in p_bodies:
			if body is KitBlock:
				points.append(body.global_position)
		if not points.is_empty():
			var around: AABB = AABB(points[0], Vector3.ZERO)
			for point: Vector3 in points:
				around = around.expand(point)
			bounds = bounds.intersection(around.grow(AROUND_M))
			p_mesh.filter_baking_aabb = bounds
	# What is larger is looked at more coarsely.
	var cell: float = maxf(CELL_M, sqrt(bounds.size.x * bounds.size.z / MAX_CELLS))
	p_mesh.cell_size = cell
	p_mesh.agent_radius = maxf(RADIUS_M, cell)


func _join() -> void:
	var parents: PackedInt32Array = PackedInt32Array(range(polygons.size()))
	var by_edge: Dictionary[Vector2i, int] = {}
	for index: int in polygons.size():
		var corners: PackedInt32Array = polygons[index]
		for number: int in corners.size():
			var next: int = corners[(number + 1) % corners.size()]
			var edge: Vector2i = Vector2i(mini(corners[number], next), maxi(corners[number], next))
			if by_edge.has(edge):
				parents[_top(parents, by_edge[edge])] = _top(parents, index)
			else:
				by_edge[edge] = index
	for index: int in polygons.size():
		var island: int = _top(parents, index)
		islands.append(island)
		areas[island] = areas.get(island, 0.0) + _area(index)


static func _top(p_parents: PackedInt32Array, p_index: int) -> int:
	var index: int = p_index
	while p_parents[index] != index:
		p_parents[index] = p_parents[p_parents[index]]
		index = p_parents[index]
	return index


func _area(p_polygon: int) -> float:
	var corners: PackedInt32Array = polygons[p_polygon]
	var from: Vector3 = vertices[corners[0]]
	var sum: float = 0.0
	for number: int in range(1, corners.size() - 1):
		var one: Vector3 = vertices[corners[number]] - from
		sum += one.cross(vertices[corners[number + 1]] - from).length() / 2.0
	return sum


func _flat(p_polygon: int) -> PackedVector2Array:
	var points: PackedVector2Array = []
	for corner: int in polygons[p_polygon]:
		points.append(Vector2(vertices[corner].x, vertices[corner].z))
	return points


func _heights(p_polygon: int) -> Vector2:
	var range_m: Vector2 = Vector2(INF, -INF)
	for corner: int in polygons[p_polygon]:
		range_m.x = minf(range_m.x, vertices[corner].y)
		range_m.y = maxf(range_m.y, vertices[corner].y)
	return range_m


## Distance from above, m; INF where the polygon is at another height.
func _distance(p_polygon: int, p_at: Vector3, p_height: float) -> float:
	var heights: Vector2 = _heights(p_polygon)
	if p_at.y < heights.x - p_height or p_at.y > heights.y + p_height:
		return INF
	var points: PackedVector2Array = _flat(p_polygon)
	var at: Vector2 = Vector2(p_at.x, p_at.z)
	if Geometry2D.is_point_in_polygon(at, points):
		return 0.0
	var least: float = INF
	for number: int in points.size():
		var next: Vector2 = points[(number + 1) % points.size()]
		var nearest: Vector2 = Geometry2D.get_closest_point_to_segment(at, points[number], next)
		least = minf(least, nearest.distance_to(at))
	return least
