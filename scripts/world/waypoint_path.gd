@tool
@icon("res://scenes/world/icons/waypoint_path.svg")
class_name WaypointPath
extends Node3D
## Points in a level, in their order: a patrol's path, a vehicle's route, where a camera goes.
##
## The editor shows it as a line: pull a point to move it, pull the small dot between two to add
## one. In the game nothing is seen of it.

## Most points.
const MAX_POINTS: int = 256

## The points, in the node's own frame, on the ground.
@export_custom(PROPERTY_HINT_NONE, "suffix:m")
var points: PackedVector3Array = [Vector3.ZERO, Vector3(0.0, 0.0, 4.0)]:
	set(p_value):
		points = p_value
		update_gizmos()
		update_configuration_warnings()
## Whether the last point leads to the first one.
@export var is_closed: bool = false:
	set(p_value):
		is_closed = p_value
		update_gizmos()


func _get_configuration_warnings() -> PackedStringArray:
	if points.size() < 2:
		return ["A path needs two points at least: add some to 'Points' in the inspector."]
	if points.size() > MAX_POINTS:
		return ["It has %d points, %d are the most." % [points.size(), MAX_POINTS]]
	return []


## The points in the world, m.
func get_places() -> PackedVector3Array:
	return global_transform * points


## Length of the path, m.
func get_length() -> float:
	var length: float = 0.0
	var corners: PackedVector3Array = get_corners()
	for index: int in maxi(corners.size() - 1, 0):
		length += corners[index].distance_to(corners[index + 1])
	return length


## The points in the node's frame; the first one again at the end of a closed path, m.
func get_corners() -> PackedVector3Array:
	var corners: PackedVector3Array = points.duplicate()
	if is_closed and points.size() > 2:
		corners.append(points[0])
	return corners


## The position in the world, m, at a distance along the path; +Z points along it. An open path ends
## at its ends, a closed one begins again.
func sample(p_distance: float) -> Transform3D:
	var corners: PackedVector3Array = get_corners()
	if corners.size() < 2 or get_length() == 0.0:
		return global_transform.translated_local(points[0] if not points.is_empty() else Vector3())
	var rest: float = maxf(p_distance, 0.0)
	if is_closed:
		rest = fposmod(p_distance, get_length())
	for index: int in corners.size() - 1:
		var step: float = corners[index].distance_to(corners[index + 1])
		if step > 0.0 and (rest <= step or index == corners.size() - 2):
			var at: Vector3 = corners[index].lerp(corners[index + 1], minf(rest / step, 1.0))
			return global_transform * Transform3D(_facing(corners, index), at)
		rest -= step
	return global_transform * Transform3D(Basis.IDENTITY, corners[-1])


static func _facing(p_corners: PackedVector3Array, p_from: int) -> Basis:
	var way: Vector3 = p_corners[p_from + 1] - p_corners[p_from]
	return Basis(Vector3.UP, atan2(way.x, way.z))
