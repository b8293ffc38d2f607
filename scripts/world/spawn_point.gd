@tool
@icon("res://scenes/world/icons/spawn_point.svg")
class_name SpawnPoint
extends Marker3D
## Where people start in a [Level]: on the ground, facing the point's +Z.
##
## People take the points in turn, 2.5 m apart at least. If all are taken, further people stand in
## ranks around them, facing as they do, where there is floor and nothing in the way. A point may be
## for people of one role only, by their avatar: two sides start apart.

## Who starts here: people who have this avatar, such as [code]raider[/code]; empty: everybody who
## has no points of the own.
@export_placeholder("everybody") var avatar: String = "":
	set(p_value):
		avatar = p_value
		update_configuration_warnings()


## Where people stand, m, and which way they face: upright and not scaled, whatever the node is.
func get_start() -> Transform3D:
	var facing: float = Rotations.facing_of(global_basis.get_rotation_quaternion())
	return Transform3D(Basis(Vector3.UP, facing), global_position)


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	var up: Vector3 = global_basis.y if is_inside_tree() else basis.y
	if not up.normalized().is_equal_approx(Vector3.UP):
		warnings.append("People start upright: turn the point about the Y axis only.")
	if avatar != "" and not AvatarStore.NAMES.has(avatar):
		var text: String = "There is no avatar '%s', so nobody starts here: choose one of %s."
		warnings.append(text % [avatar, ", ".join(AvatarStore.NAMES)])
	return warnings
