class_name SpawnCheck
extends RefCounted
## Whether people and props start where there is room, and people on the ground.

## The room that a standing person needs, m: a capsule that begins above low steps.
const RADIUS_M: float = 0.3
const HEIGHT_M: float = 1.5
const ABOVE_GROUND_M: float = 0.3
## How far a spawn point may be above or below the ground, m.
const GROUND_M: float = 0.15
## Depth to which the ground is searched below a spawn point, m.
const DEPTH_M: float = 200.0
## Room around the eye of a view, m.
const CAMERA_M: float = 0.1
## Depth by which a prop may be inside a static body, as a share of its size: resting, it sinks in a
## little.
const TOUCH: float = 0.06

var _findings: LevelFindings = null
var _space: PhysicsDirectSpaceState3D = null


func _init(p_findings: LevelFindings) -> void:
	_findings = p_findings
	_space = p_findings.level.get_world_3d().direct_space_state


## Does the work.
func run() -> void:
	var points: Array[SpawnPoint] = _findings.level.get_spawn_points()
	if points.is_empty():
		var text: String = "people start at the origin, wherever that is: add a SpawnPoint below "
		_findings.add_fault(LevelFault.Kind.NO_SPAWN_POINT, null, text + "'Spawns'")
	for point: SpawnPoint in points:
		_look_at_point(point)
	for prop: RigidBody3D in _findings.level.get_props():
		_look_at_prop(prop)
	for camera: ObserverCamera in _findings.level.get_cameras():
		_look_at_camera(camera)


func _look_at_camera(p_camera: ObserverCamera) -> void:
	var ball: SphereShape3D = SphereShape3D.new()
	ball.radius = CAMERA_M
	var wall: Node3D = _find_in(ball, Transform3D(Basis.IDENTITY, p_camera.global_position))
	if wall != null:
		var text: String = "this view is from within '%s': move it to where it sees something"
		_findings.add_fault(LevelFault.Kind.CAMERA_IN_WALL, p_camera, text % wall.name)


func _look_at_point(p_point: SpawnPoint) -> void:
	var at: Vector3 = p_point.global_position
	var capsule: CapsuleShape3D = CapsuleShape3D.new()
	capsule.radius = RADIUS_M
	capsule.height = HEIGHT_M
	var middle: Vector3 = at + Vector3.UP * (ABOVE_GROUND_M + HEIGHT_M / 2.0)
	var wall: Node3D = _find_in(capsule, Transform3D(Basis.IDENTITY, middle))
	if wall != null:
		var text: String = "who starts here stands in '%s': move the point to where there is room"
		_findings.add_fault(LevelFault.Kind.SPAWN_POINT_IN_WALL, p_point, text % wall.name)
		return
	var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		at + Vector3.UP * ABOVE_GROUND_M, at + Vector3.DOWN * DEPTH_M, PhysicsLayers.STATIC
	)
	var hit: Dictionary = _space.intersect_ray(ray)
	if hit.is_empty():
		_findings.add_fault(
			LevelFault.Kind.SPAWN_POINT_IN_AIR,
			p_point,
			"there is no ground below it: move it above a floor, or add a Block as one"
		)
		return
	var gap: float = at.y - (hit["position"] as Vector3).y
	if absf(gap) > GROUND_M:
		var text: String = "it is %.2f m %s the ground: set its height to %.2f m"
		var side: String = "above" if gap > 0.0 else "below"
		var local: float = p_point.position.y - gap
		_findings.add_fault(
			LevelFault.Kind.SPAWN_POINT_IN_AIR, p_point, text % [absf(gap), side, local]
		)


func _look_at_prop(p_prop: RigidBody3D) -> void:
	if p_prop.collision_mask & PhysicsLayers.STATIC == 0:
		# A door hangs in its frame.
		return
	for owner: int in p_prop.get_shape_owners():
		if p_prop.is_shape_owner_disabled(owner):
			continue
		for index: int in p_prop.shape_owner_get_shape_count(owner):
			var shape: Shape3D = p_prop.shape_owner_get_shape(owner, index)
			var place: Transform3D = (
				p_prop.global_transform * p_prop.shape_owner_get_transform(owner)
			)
			var wall: Node3D = _find_in(shape, place.scaled_local(Vector3.ONE * (1.0 - TOUCH)))
			if wall != null:
				var text: String = "it stands in '%s' and will be thrown out: move it"
				_findings.add_fault(LevelFault.Kind.PROP_IN_WALL, p_prop, text % wall.name)
				return


## What stands still and touches a shape, or null.
func _find_in(p_shape: Shape3D, p_place: Transform3D) -> Node3D:
	var query: PhysicsShapeQueryParameters3D = PhysicsShapeQueryParameters3D.new()
	query.shape = p_shape
	query.transform = p_place
	query.collision_mask = PhysicsLayers.STATIC
	for hit: Dictionary in _space.intersect_shape(query, 4):
		if hit["collider"] is StaticBody3D:
			return hit["collider"]
	return null
