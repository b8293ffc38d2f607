@tool
@icon("res://scenes/world/icons/spawn_point.svg")
class_name SpawnPoint
extends Marker3D
## Where people start in a [Level]: on the ground, facing the point's +Z.
##
## People take the points in turn, 2.5 m apart at least. If all are taken, further people stand in
## ranks around them, facing as they do, where there is floor and nothing in the way.


## Where people stand, m, and which way they face: upright and not scaled, whatever the node is.
func get_start() -> Transform3D:
	var facing: float = Rotations.facing_of(global_basis.get_rotation_quaternion())
	return Transform3D(Basis(Vector3.UP, facing), global_position)


func _get_configuration_warnings() -> PackedStringArray:
	var up: Vector3 = global_basis.y if is_inside_tree() else basis.y
	if not up.normalized().is_equal_approx(Vector3.UP):
		return ["People start upright: turn the point about the Y axis only."]
	return []
