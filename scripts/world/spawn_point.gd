@tool
@icon("res://scenes/world/icons/spawn_point.svg")
class_name SpawnPoint
extends Marker3D
## Where people start in a [Level]: on the ground, facing this node's +Z.
##
## People take the points in turn. If all are taken, further people stand beside them.


func _get_configuration_warnings() -> PackedStringArray:
	var up: Vector3 = global_basis.y if is_inside_tree() else basis.y
	if not up.normalized().is_equal_approx(Vector3.UP):
		return ["People start upright: turn the point about the Y axis only."]
	return []
