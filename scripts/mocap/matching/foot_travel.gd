class_name FootTravel
extends RefCounted
## Travel of who wears a suit that does not know where it is: feet that stand stay where they are.
##
## Of heels and balls of both feet those near the ground are asked how the hips would move if they
## stood; the one that fits what the hips did last counts, so that a toe that swings low is not
## taken for one that stands. With none that fits, as in the air, the hips go on as they did.

## Points that are so far above the lowest one may stand, m.
const NEAR_M: float = 0.03
## Speed by which a point that stands may change the hips' from one frame to the next, m/s.
const MISFIT: float = 2.5
## Time in which the hips' own speed follows, s.
const FOLLOW_S: float = 0.06

var _segments: BodySegments = null
var _heels: PackedVector3Array = PackedVector3Array()
var _place: Vector3 = Vector3.ZERO
var _velocity: Vector3 = Vector3.ZERO
var _points: PackedVector3Array = PackedVector3Array()


## Takes the wearer's size.
func _init(p_size: BodySize) -> void:
	_segments = BodySegments.new(p_size)
	for foot: int in Limbs.FEET:
		var ankle: Vector3 = _segments.rest_base(foot)
		_heels.append(Vector3(ankle.x, 0.0, ankle.z))


## Begins anew where it is, as after a gap.
func restart() -> void:
	_points.clear()
	_velocity = Vector3.ZERO


## Puts the pose, so many seconds after the last one, where its feet have taken it.
func move(r_pose: PoseSample, p_delta_s: float) -> void:
	var points: PackedVector3Array = _find_points(r_pose)
	if not _points.is_empty():
		_place += _find_velocity(points, p_delta_s) * p_delta_s
	_points = points
	r_pose.root += _place


## Heels and balls, the hips' middle above the origin.
func _find_points(p_pose: PoseSample) -> PackedVector3Array:
	_segments.solve(p_pose)
	var origin: Vector3 = Vector3(p_pose.root.x, 0.0, p_pose.root.z)
	var points: PackedVector3Array = PackedVector3Array()
	for side: int in Limbs.FEET.size():
		var foot: int = Limbs.FEET[side]
		points.append(_segments.attached(foot, _heels[side], p_pose) - origin)
		var ball: Vector3 = _segments.rest_tail(foot)
		ball.y = 0.0
		points.append(_segments.attached(foot, ball, p_pose) - origin)
	return points


func _find_velocity(p_points: PackedVector3Array, p_delta_s: float) -> Vector3:
	var lowest: float = INF
	for point: Vector3 in p_points:
		lowest = minf(lowest, point.y)
	var best: Vector3 = _velocity
	var misfit: float = INF
	for at: int in p_points.size():
		if p_points[at].y > lowest + NEAR_M:
			continue
		var implied: Vector3 = (_points[at] - p_points[at]) / p_delta_s
		implied.y = 0.0
		if implied.distance_to(_velocity) < misfit:
			misfit = implied.distance_to(_velocity)
			best = implied
	if misfit > MISFIT:
		return _velocity
	_velocity = _velocity.lerp(best, 1.0 - exp(-p_delta_s / FOLLOW_S))
	return best
