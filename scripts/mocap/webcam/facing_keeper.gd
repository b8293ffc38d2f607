class_name FacingKeeper
extends RefCounted
## Keeps a turned back a back. From one picture a back looks much as a front, and the model takes
## one for the other now and then: it then exchanges left and right, and what is nearer with what is
## further. Nobody turns about within a picture, so of both readings that one is taken by which the
## person has turned least so far (Viterbi's cheapest way), until the model has insisted for long.

## What it costs to doubt the model, rad of turning for each second: where it says front, which it
## often says wrongly, half a turn within a picture is believed after 3 s; where it says back, soon.
const DOUBT_FRONT_PER_S: float = 1.0
const DOUBT_BACK_PER_S: float = 4.0
## By how much cheaper the other reading has to be, rad: from the side both are much the same.
const SURE: float = 0.2
## From this point on each left one's right one is next; those of the face pair otherwise.
const FIRST_PAIR: int = 7
const FACE_PAIRS: Array[Vector2i] = [Vector2i(1, 4), Vector2i(2, 5), Vector2i(3, 6)]

# Of both readings, as the model has it and exchanged: where the person faced, rad, and how much he
# has turned at least if that is so, rad.
var _headings: PackedFloat64Array = []
var _costs: PackedFloat64Array = [0.0, 0.0]
var _usec: int = 0


## Puts right what the model took for the other side, in a frame that has not been smoothed.
func keep(r_frame: LandmarkFrame) -> void:
	var step_s: float = (r_frame.usec - _usec) / 1e6
	_usec = r_frame.usec
	var seen: float = heading(r_frame.places)
	if not is_finite(seen):
		return
	var headings: PackedFloat64Array = [seen, PI - seen]
	if _headings.is_empty() or step_s <= 0.0 or step_s > LandmarkFilter.PAUSE_S:
		_costs = [0.0, DOUBT_FRONT_PER_S]
	else:
		_costs = _costs_after(headings, step_s)
	_headings = headings
	if _costs[1] + SURE < _costs[0]:
		_exchange(r_frame)


## Where shoulders and hips face, rad about the vertical: 0 is to the camera, positive to the left
## of who is seen. [constant NAN] where they lie over one another.
static func heading(p_places: PackedVector3Array) -> float:
	var left: Vector3 = p_places[LandmarkPose.SHOULDER] - p_places[LandmarkPose.SHOULDER + 1]
	left += p_places[LandmarkPose.HIP] - p_places[LandmarkPose.HIP + 1]
	return atan2(-left.z, left.x) if Vector2(left.x, left.z).length() > 1e-3 else NAN


# The cheapest ways (Viterbi's) to both readings of a picture.
func _costs_after(p_headings: PackedFloat64Array, p_step_s: float) -> PackedFloat64Array:
	var costs: PackedFloat64Array = [INF, INF]
	for now: int in 2:
		for before: int in 2:
			var turn: float = absf(wrapf(p_headings[now] - _headings[before], -PI, PI))
			costs[now] = minf(costs[now], _costs[before] + turn)
	var is_front: bool = cos(p_headings[0]) > 0.0
	costs[1] += p_step_s * (DOUBT_FRONT_PER_S if is_front else DOUBT_BACK_PER_S)
	var least: float = minf(costs[0], costs[1])
	return PackedFloat64Array([costs[0] - least, costs[1] - least])


static func _exchange(r_frame: LandmarkFrame) -> void:
	var pairs: Array[Vector2i] = FACE_PAIRS.duplicate()
	for left: int in range(FIRST_PAIR, r_frame.places.size() - 1, 2):
		pairs.append(Vector2i(left, left + 1))
	for pair: Vector2i in pairs:
		_swap(r_frame.places, pair)
		_swap(r_frame.in_picture, pair)
		_swap(r_frame.rays, pair)
		var seen: float = r_frame.seen[pair.x]
		r_frame.seen[pair.x] = r_frame.seen[pair.y]
		r_frame.seen[pair.y] = seen
	for point: int in r_frame.places.size():
		r_frame.places[point].z = -r_frame.places[point].z


static func _swap(r_points: PackedVector3Array, p_pair: Vector2i) -> void:
	if r_points.size() > p_pair.y:
		var point: Vector3 = r_points[p_pair.x]
		r_points[p_pair.x] = r_points[p_pair.y]
		r_points[p_pair.y] = point
