class_name WalkCheck
extends RefCounted
## Whether people can walk from where they start to all that is meant for them.

## The smallest unreachable area that is reported, m².
const SMALLEST_M2: float = 4.0
## How near a waypoint must be to where people walk, m.
const WAYPOINT_M: float = 0.8
## Greatest difference in height between an unreachable floor and the ground around it for the floor
## to be reported, m.
const GROUND_M: float = 0.6
## How far above its storeys the roof of a house may be, m.
const ROOF_M: float = 1.0

var _findings: LevelFindings = null
var _level: Level = null
var _mesh: WalkMesh = WalkMesh.new()
## The island on which most start.
var _main: int = -1


func _init(p_findings: LevelFindings) -> void:
	_findings = p_findings
	_level = p_findings.level


## Does the work.
func run() -> void:
	var places: PackedVector3Array = []
	for point: SpawnPoint in _level.get_spawn_points():
		places.append(point.global_position)
	if places.is_empty():
		return
	_mesh.build(_level, places)
	_look_at_points()
	if _main < 0:
		return
	_look_at_areas()
	_look_at_waypoints()
	_look_at_floors()


func _look_at_points() -> void:
	var points: Array[SpawnPoint] = _level.get_spawn_points()
	var found: Array[int] = []
	var counts: Dictionary[int, int] = {}
	for point: SpawnPoint in points:
		var polygon: int = _mesh.find_polygon(point.global_position)
		found.append(_mesh.islands[polygon] if polygon >= 0 else -1)
		if polygon >= 0:
			counts[found[-1]] = counts.get(found[-1], 0) + 1
			if _main < 0 or counts[found[-1]] > counts[_main]:
				_main = found[-1]
	for index: int in points.size():
		if found[index] == -1:
			_report(points[index], "nobody can walk away from here: leave 0.9 m of room around it")
		elif found[index] != _main:
			var text: String = "who starts here cannot walk to the other spawn points: open a way "
			_report(points[index], text + "(0.9 m wide, steps of 0.2 m at most), or move it")


func _look_at_areas() -> void:
	for node: Node in _level.find_children("*", "Area3D", true, false):
		var area: Area3D = node as Area3D
		# What belongs to a body moves with it.
		if area.get_parent() is PhysicsBody3D:
			continue
		var zone: TriggerZone = area as TriggerZone
		if zone != null and zone.notices & TriggerZone.Notices.PEOPLE == 0:
			continue
		var box: AABB = _box_of(area)
		if box.size != Vector3.ZERO and not _mesh.comes_into(_main, box.grow(0.1)):
			var what: String = "area" if zone == null else "trigger zone"
			_report(area, "nobody can walk into this %s: move it, or open a way to it" % what)


func _look_at_waypoints() -> void:
	for node: Node in _level.find_children("*", "Node3D", true, false):
		var points: PackedVector3Array = []
		var curve: Path3D = node as Path3D
		if node is WaypointPath:
			points = (node as WaypointPath).get_places()
		elif curve != null and curve.curve != null:
			for index: int in curve.curve.point_count:
				points.append(curve.global_transform * curve.curve.get_point_position(index))
		for index: int in points.size():
			_look_at_waypoint(node as Node3D, index, points[index])


func _look_at_waypoint(p_path: Node3D, p_index: int, p_at: Vector3) -> void:
	var polygon: int = _mesh.find_polygon(p_at, WAYPOINT_M, 1.0)
	if polygon < 0 or _mesh.islands[polygon] != _main:
		var text: String = "nobody can walk to its waypoint %d at (%.1f, %.1f, %.1f): move it"
		_report(p_path, text % [p_index, p_at.x, p_at.y, p_at.z])
		_findings.faults[-1].place = p_at


## Floors that look as if one could get there: those of houses that are entered, and those on the
## ground.
func _look_at_floors() -> void:
	var ground: float = _ground_height()
	# Polygons of an island are neighbours: the first of each tells enough.
	var seen: Dictionary[int, bool] = {}
	for index: int in _mesh.polygons.size():
		var island: int = _mesh.islands[index]
		if island == _main or seen.has(island) or _mesh.areas[island] < SMALLEST_M2:
			continue
		seen[island] = true
		var at: Vector3 = _mesh.middle(index)
		var house: House = _house_at(at)
		var text: String = "nobody can get to %.0f m2 at (%.1f, %.1f, %.1f): "
		text = text % [_mesh.areas[island], at.x, at.y, at.z]
		if house != null and house.entered:
			# Above the roof there is the top of the stairs' hut, which nobody needs.
			if at.y - house.global_position.y > house.storeys * HousePlan.STOREY_M + ROOF_M:
				continue
			_report(house, text + "give it a doorway, or a landing of 1 m at its stairs")
		elif house == null and absf(at.y - ground) < GROUND_M and not _is_solid(at):
			text += "leave a way of 0.9 m, or add a doorway"
			_findings.add_hint(LevelFault.Kind.UNREACHABLE, null, text)
			_findings.faults[-1].place = at


## Whether a position is inside a solid body, which a navigation mesh takes for hollow.
func _is_solid(p_at: Vector3) -> bool:
	var ball: SphereShape3D = SphereShape3D.new()
	ball.radius = 0.2
	var query: PhysicsShapeQueryParameters3D = PhysicsShapeQueryParameters3D.new()
	query.shape = ball
	query.transform.origin = p_at + Vector3.UP
	query.collision_mask = PhysicsLayers.STATIC
	var space: PhysicsDirectSpaceState3D = _level.get_world_3d().direct_space_state
	return not space.intersect_shape(query, 1).is_empty()


## Height of most of what is walked on.
func _ground_height() -> float:
	var by_height: Dictionary[int, int] = {}
	var best: int = 0
	for index: int in _mesh.polygons.size():
		if _mesh.islands[index] == _main:
			var step: int = roundi(_mesh.middle(index).y * 4.0)
			by_height[step] = by_height.get(step, 0) + 1
			if by_height[step] > by_height.get(best, 0):
				best = step
	return best / 4.0


func _house_at(p_at: Vector3) -> House:
	for body: StaticBody3D in _level.get_static_bodies():
		var house: House = body as House
		if house == null:
			continue
		var at: Vector3 = house.global_transform.affine_inverse() * p_at
		if Rect2(0.0, -house.size.y, house.size.x, house.size.y).has_point(Vector2(at.x, at.z)):
			return house
	return null


static func _box_of(p_area: Area3D) -> AABB:
	var box: AABB = AABB()
	for owner: int in p_area.get_shape_owners():
		var place: Transform3D = p_area.global_transform * p_area.shape_owner_get_transform(owner)
		for index: int in p_area.shape_owner_get_shape_count(owner):
			var shape: Shape3D = p_area.shape_owner_get_shape(owner, index)
			var part: AABB = place * shape.get_debug_mesh().get_aabb()
			box = part if box.size == Vector3.ZERO else box.merge(part)
	return box


func _report(p_node: Node3D, p_text: String) -> void:
	_findings.add_fault(LevelFault.Kind.UNREACHABLE, p_node, p_text)
