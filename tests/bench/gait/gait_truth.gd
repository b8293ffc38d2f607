extends RefCounted
## What is true of a clip: where the points of a body that touch the ground are in it, and when the
## person flies.
##
## A person flies while the centre of mass falls freely, what was lowest does not stay where it was,
## and what is lowest is higher than where it left the ground or comes back to it: whoever only
## crouches quickly leaves the feet on the floor, and a foot that rolls stays on it. That tells
## flights of a few centimetres from floors, boxes and beams that nobody sees.

## The centre of mass falls freely when it is accelerated downward by more than this, m/s^2.
const _FALLS: float = 0.6 * 9.81
## For at least so long, s.
const _SHORTEST_S: float = 0.06
## The lowest point moves by more than this (m) while it lasts.
const _MOVES: float = 0.012
## And is so much higher (m) than so long (s) before and after: a flight of 0.13 s rises by 2 cm.
const _RISES: float = 0.02
const _BESIDE_S: float = 0.1
## Who is so high (m) over the file's floor for so long (s) without flying stands on something.
const _HIGH: float = 0.12
const _STANDS_S: float = 0.5
## Over how long the acceleration is measured to either side, s.
const _SPAN_S: float = 1.0 / 30.0

## Feet that stand slide by so much (m/s) and by so many times the way of the hips on a treadmill.
## Feet of people who walk on the ground slide 0.3 to 1.0 times as much as the hips go, those of
## treadmill clips, and of a suit that does not know its feet, 1.5 to 14 times.
const _SLIDES_M_S: float = 0.4
const _SLIDES_BY_WAY: float = 1.5

## Contact points by tick, in the order of limbs and their points, m.
var points: Array[PackedVector3Array] = []
## Whether the person flies, by tick.
var flies: Array[bool] = []
## Whether the person stands on something that no body has under it.
var climbs: bool = false
## Whether the feet slide all the time while the hips stay, as on a treadmill: then the hips of the
## file are not where the person would get to on the ground.
var is_treadmill: bool = false
## The centre of mass by tick, m.
var centres: PackedVector3Array = []
## The limb of each point, and its place in the limb's frame, m.
var limbs: PackedInt32Array = []
var locals: PackedVector3Array = []

var _profile: RagdollProfile = null


func _init(p_profile: RagdollProfile) -> void:
	_profile = p_profile
	for i: int in p_profile.limbs.size():
		var limb: RagdollLimb = p_profile.limbs[i]
		for point: Vector3 in limb.contact_points:
			limbs.append(i)
			locals.append(limb.rest_orientation.inverse() * (point - limb.anchor))


## Takes the whole of a clip.
func read(p_source: BvhSource, p_ticks: int, p_delta: float) -> void:
	for tick: int in p_ticks:
		_add(p_source.pose_at(tick * p_delta))
	flies.resize(p_ticks)
	flies.fill(false)
	var span: int = maxi(roundi(_SPAN_S / p_delta), 1)
	var begin: int = -1
	for tick: int in p_ticks + 1:
		var falls: bool = tick < p_ticks and _falls_at(tick, span, p_delta)
		if falls and begin < 0:
			begin = tick
		elif not falls and begin >= 0:
			var is_long: bool = (tick - begin) * p_delta > _SHORTEST_S
			var beside: int = roundi(_BESIDE_S / p_delta)
			if is_long and _range(begin, tick) > _MOVES and _rises(begin, tick, beside):
				for i: int in range(begin, tick):
					flies[i] = true
			begin = -1
	var high: int = 0
	for tick: int in p_ticks:
		high = high + 1 if not flies[tick] and _lowest(points[tick]) > _HIGH else 0
		climbs = climbs or high * p_delta > _STANDS_S
	_find_treadmill(p_delta)


## Feet that stand are where the body is lowest.
func _find_treadmill(p_delta: float) -> void:
	var slide: float = 0.0
	var way: float = 0.0
	for tick: int in range(1, points.size()):
		if flies[tick]:
			continue
		var lowest: float = _lowest(points[tick])
		var least: float = INF
		for i: int in points[tick].size():
			if height_of(i, points[tick]) < lowest + 0.03:
				least = minf(least, _level(points[tick][i] - points[tick - 1][i]))
		slide += least
		way += _level(centres[tick] - centres[tick - 1])
	var enough: float = _SLIDES_M_S * p_delta * points.size()
	is_treadmill = slide > enough and slide > _SLIDES_BY_WAY * way


static func _level(p_way: Vector3) -> float:
	return Vector2(p_way.x, p_way.z).length()


func _add(p_pose: PoseSample) -> void:
	var joints: PackedVector3Array = []
	var mass: float = 0.0
	var moment: Vector3 = Vector3.ZERO
	for i: int in _profile.limbs.size():
		var limb: RagdollLimb = _profile.limbs[i]
		joints.append(_joint_of(i, joints, p_pose))
		var centre: Vector3 = limb.rest_orientation.inverse() * (limb.position - limb.anchor)
		mass += limb.mass_fraction
		moment += limb.mass_fraction * (joints[i] + _turn_of(i, p_pose) * centre)
	centres.append(moment / mass)
	var places: PackedVector3Array = []
	for i: int in limbs.size():
		places.append(joints[limbs[i]] + _turn_of(limbs[i], p_pose) * locals[i])
	points.append(places)


func _turn_of(p_limb: int, p_pose: PoseSample) -> Quaternion:
	var limb: RagdollLimb = _profile.limbs[p_limb]
	return p_pose.orientation(Limbs.find(limb.bone)) * limb.reset_orientation


func _joint_of(p_limb: int, p_joints: PackedVector3Array, p_pose: PoseSample) -> Vector3:
	var parent: int = _profile.get_parent_index(p_limb)
	if parent < 0:
		return p_pose.root
	var above: RagdollLimb = _profile.limbs[parent]
	var arm: Vector3 = _profile.limbs[p_limb].anchor - above.anchor
	return p_joints[parent] + _turn_of(parent, p_pose) * (above.rest_orientation.inverse() * arm)


func _falls_at(p_tick: int, p_span: int, p_delta: float) -> bool:
	if p_tick < p_span or p_tick + p_span >= centres.size():
		return false
	var bend: Vector3 = centres[p_tick - p_span] + centres[p_tick + p_span] - 2.0 * centres[p_tick]
	return bend.y / pow(p_span * p_delta, 2.0) < -_FALLS


## Whether the lowest point in the middle of a time is higher than so many ticks beside it.
func _rises(p_from: int, p_to: int, p_beside: int) -> bool:
	var before: float = _lowest(points[maxi(p_from - p_beside, 0)])
	var after: float = _lowest(points[mini(p_to + p_beside, points.size() - 1)])
	var middle: float = _lowest(points[floori((p_from + p_to) / 2.0)])
	return middle > minf(before, after) + _RISES


## How far the points move that are lowest in the middle of a time: the least of them, m.
func _range(p_from: int, p_to: int) -> float:
	var middle: PackedVector3Array = points[floori((p_from + p_to) / 2.0)]
	var lowest: float = _lowest(middle)
	var least: float = INF
	for i: int in middle.size():
		if height_of(i, middle) > lowest + 0.03:
			continue
		var box: AABB = AABB(middle[i], Vector3.ZERO)
		for tick: int in range(p_from, p_to):
			box = box.expand(points[tick][i])
		least = minf(least, box.size.length())
	return least


func _lowest(p_places: PackedVector3Array) -> float:
	var lowest: float = INF
	for i: int in p_places.size():
		lowest = minf(lowest, height_of(i, p_places))
	return lowest


## Height of the flesh at a point, m.
func height_of(p_point: int, p_places: PackedVector3Array) -> float:
	return p_places[p_point].y - _profile.limbs[limbs[p_point]].contact_radius
