@tool
extends RefCounted
## The lines by which the editor shows what is not seen in the game.

## Corners of a round zone.
const CORNERS: int = 24
## Length of an arrow's edges, m.
const ARROW_M: float = 0.4


## Pairs of points, in the node's frame; none for what is seen anyway.
static func of(p_node: Node3D) -> PackedVector3Array:
	if p_node is TriggerZone:
		return _zone(p_node)
	if p_node is WaypointPath:
		return _path(p_node)
	return []


static func _zone(p_zone: TriggerZone) -> PackedVector3Array:
	var lines: PackedVector3Array = []
	var box: AABB = p_zone.get_box()
	var corners: PackedVector2Array = [
		Vector2(-0.5, -0.5), Vector2(0.5, -0.5), Vector2(0.5, 0.5), Vector2(-0.5, 0.5)
	]
	if p_zone.form == TriggerZone.Form.CYLINDER:
		corners.clear()
		for index: int in CORNERS:
			corners.append(Vector2.from_angle(TAU * index / CORNERS) / 2.0)
	for index: int in corners.size():
		var ends: PackedVector3Array = []
		for corner: Vector2 in [corners[index], corners[(index + 1) % corners.size()]]:
			ends.append(Vector3(corner.x * box.size.x, 0.0, corner.y * box.size.z))
		var up: Vector3 = Vector3.UP * box.size.y
		lines.append_array([ends[0], ends[1], ends[0] + up, ends[1] + up])
		if index % (corners.size() / 4) == 0:
			lines.append_array([ends[0], ends[0] + up])
	return lines


static func _path(p_path: WaypointPath) -> PackedVector3Array:
	var lines: PackedVector3Array = []
	var corners: PackedVector3Array = p_path.get_corners()
	for index: int in corners.size() - 1:
		var way: Vector3 = (corners[index + 1] - corners[index]).normalized()
		var side: Vector3 = way.cross(Vector3.UP).normalized() * ARROW_M / 2.0
		var middle: Vector3 = corners[index].lerp(corners[index + 1], 0.6)
		lines.append_array([corners[index], corners[index + 1]])
		lines.append_array([middle, middle - way * ARROW_M + side])
		lines.append_array([middle, middle - way * ARROW_M - side])
	return lines
