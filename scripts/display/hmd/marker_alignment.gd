class_name MarkerAlignment
extends RefCounted
## Aligns the wearer's room with the world by a marker on the real wall: where the runtime sees the
## marker, and where the level has it, give the room's heading and position.
##
## Only heading and position are taken: what is up both know better than a camera that looks at a
## sheet of paper.

## A marker that is seen further off its mean than this is not taken, m and rad.
const _FAR_M: float = 0.05
const _FAR_RAD: float = 0.05
## Observations that are averaged.
const _COUNT: int = 30

## Which marker is meant: what it says (a QR code's text) or its number; empty: any.
var marker: String = ""
## Where the level has it: +Z out of the wall, +Y up the wall; position in m.
var in_world: Transform3D = Transform3D.IDENTITY

var _positions: PackedVector3Array = []
var _headings: Array[Vector2] = []


## A sight of the marker, in the tracking space: +Z out of the paper, as the runtime gives it.
## Returns whether it was taken.
func observe(p_seen: Transform3D) -> bool:
	if not p_seen.is_finite():
		return false
	var out: Vector3 = p_seen.basis.z
	# On a floor or ceiling the way out of it says nothing about heading.
	if absf(out.normalized().y) > 0.7:
		out = p_seen.basis.y
	var heading: Vector2 = Vector2(out.x, out.z).normalized()
	if heading == Vector2.ZERO:
		return false
	_positions.append(p_seen.origin)
	_headings.append(heading)
	if _positions.size() > _COUNT:
		_positions.remove_at(0)
		_headings.remove_at(0)
	return true


## Whether enough has been seen, and all of it alike.
func is_certain() -> bool:
	if _positions.size() < _COUNT:
		return false
	var position: Vector3 = _mean_position()
	var heading: Vector2 = _mean_heading()
	for i: int in _positions.size():
		if _positions[i].distance_to(position) > _FAR_M:
			return false
		if absf(heading.angle_to(_headings[i])) > _FAR_RAD:
			return false
	return true


## From the tracking space to the world; the identity before anything was seen.
func room() -> Transform3D:
	if _positions.is_empty():
		return Transform3D.IDENTITY
	var out: Vector3 = in_world.basis.z
	if absf(out.normalized().y) > 0.7:
		out = in_world.basis.y
	var wanted: Vector2 = Vector2(out.x, out.z)
	# Angles from +X to +Z are those about -Y.
	var turn: Basis = Basis(Vector3.UP, -_mean_heading().angle_to(wanted))
	return Transform3D(turn, in_world.origin - turn * _mean_position())


## Forgets what was seen.
func clear() -> void:
	_positions.clear()
	_headings.clear()


## A frame: looks for the marker among what the runtime tracks. Returns whether it was seen.
func look() -> bool:
	var trackers: Dictionary = XRServer.get_trackers(XRServer.TRACKER_ANCHOR)
	for name: StringName in trackers:
		var seen: OpenXRMarkerTracker = trackers[name] as OpenXRMarkerTracker
		if seen == null or not _is_meant(seen):
			continue
		var pose: XRPose = seen.get_pose(&"default")
		if pose != null and pose.has_tracking_data:
			return observe(pose.transform)
	return false


func _is_meant(p_seen: OpenXRMarkerTracker) -> bool:
	var said: String = str(p_seen.marker_data) if p_seen.marker_data != null else ""
	return marker == "" or marker == said or marker == str(p_seen.marker_id)


func _mean_position() -> Vector3:
	var sum: Vector3 = Vector3.ZERO
	for position: Vector3 in _positions:
		sum += position
	return sum / _positions.size()


func _mean_heading() -> Vector2:
	var sum: Vector2 = Vector2.ZERO
	for heading: Vector2 in _headings:
		sum += heading
	return sum.normalized()
