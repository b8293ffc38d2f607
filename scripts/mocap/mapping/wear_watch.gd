class_name WearWatch
extends RefCounted
## Notices from anybody's motion that sensors are exchanged or have slipped, because joints go
## where no joint goes; and names them.
##
## It judges the last [constant WINDOW_S] seconds, a little in every frame. What bends no joint
## wrongly it cannot see: exchanges of whole arms or legs, of a hand with its forearm, of a foot
## with its shank, or within the trunk. A fit check finds those ([FitCheck]).

## Something was noticed, or is over.
signal changed

## Span that is judged, s.
const WINDOW_S: float = 20.0
## Poses a second that are kept.
const RATE_HZ: float = 5.0
## Nothing is said before so many poses.
const LEAST_POSES: int = 40
## By so much an exchange must lessen what all joints together are beyond their ranges, in the
## mean, rad.
const SWAP_RAD: float = 0.2
## And it must leave less than this part, and less than this angle, rad.
const EXPLAINS: float = 0.5
const LEAVES_RAD: float = 0.5
## Exchanges that are about as good as the best, rad: the one within an arm or leg is it then.
const ABOUT_RAD: float = 0.05
## A joint that is beyond its range by so much in the mean is bad, rad.
const SLIP_RAD: float = 0.35
## Exchanges that bend joints wrongly.
const PAIRS: Array[Vector2i] = [
	Vector2i(4, 5),
	Vector2i(8, 9),
	Vector2i(11, 12),
	Vector2i(14, 15),
	Vector2i(4, 8),
	Vector2i(5, 9),
	Vector2i(6, 10),
	Vector2i(11, 14),
	Vector2i(12, 15),
	Vector2i(13, 16),
]

## Pairs of places whose sensors look exchanged.
var swaps: Array[Vector2i] = []
## Places whose sensor seems to have slipped or to sit upside down.
var slipped: PackedInt32Array = PackedInt32Array()

var _poses: Array[Array] = []
var _last_usec: int = -1
var _next: int = 0
var _excess_now: float = 0.0
## What each exchange would leave, rad; infinite where it is not possible.
var _excess_then: PackedFloat32Array = PackedFloat32Array()
# The pose in which the sensors were calibrated.
var _reset: ResetPose.Kind = ResetPose.Kind.T


## Forgets what was seen.
func clear() -> void:
	_poses.clear()
	_next = 0
	_last_usec = -1
	if not swaps.is_empty() or not slipped.is_empty():
		swaps = []
		slipped = PackedInt32Array()
		changed.emit()


## What was noticed, a sentence each.
func messages() -> PackedStringArray:
	var found: PackedStringArray = []
	for swap: Vector2i in swaps:
		found.append(FitCheck.describe(swap))
	for place: int in slipped:
		var title: String = BodyPlaces.title(place)
		found.append("%s sensor seems loose or upside down: fasten it, calibrate again" % title)
	return found


## Takes a frame of sensors that are calibrated.
func add(p_frame: SensorFrame, p_table: SuitTable) -> void:
	if not p_table.is_calibrated:
		return
	if absf(p_frame.time_usec - _last_usec) < 1e6 / RATE_HZ:
		if _poses.size() >= LEAST_POSES:
			_judge_a_little()
		return
	_last_usec = p_frame.time_usec
	_reset = p_table.reset_pose
	var pose: Array = []
	pose.resize(BodyPlaces.COUNT)
	for sensor: int in mini(p_frame.count(), p_table.places.size()):
		var place: int = p_table.places[sensor]
		if place >= 0 and p_frame.present[sensor] != 0:
			pose[place] = p_table.rotation(sensor, p_frame.orientation(sensor))
	_poses.append(pose)
	if _poses.size() > WINDOW_S * RATE_HZ:
		_poses.pop_front()


func _judge_a_little() -> void:
	if _next == 0:
		_excess_now = _total(Vector2i.ZERO)
		_excess_then.resize(PAIRS.size())
	elif _next <= PAIRS.size():
		_excess_then[_next - 1] = _total(PAIRS[_next - 1])
	else:
		_conclude()
	_next = (_next + 1) % (PAIRS.size() + 2)


## How far all joints are beyond their ranges if two places are exchanged, in the mean, rad;
## infinite if a place is not worn.
func _total(p_pair: Vector2i) -> float:
	var sum: float = 0.0
	var judged: int = 0
	for at: int in range(0, _poses.size(), maxi(_poses.size() / 40, 1)):
		var pose: Array = _poses[at]
		if p_pair != Vector2i.ZERO:
			if pose[p_pair.x] == null or pose[p_pair.y] == null:
				continue
			pose = pose.duplicate()
			var first: Quaternion = pose[p_pair.x]
			pose[p_pair.x] = _moved(pose[p_pair.y], p_pair.y, p_pair.x)
			pose[p_pair.y] = _moved(first, p_pair.x, p_pair.y)
		judged += 1
		for place: int in BodyPlaces.COUNT:
			var above: Variant = pose[BodyPlaces.PARENTS[place]] if place > 0 else null
			if pose[place] != null and above != null:
				sum += JointRange.excess(place, above, pose[place])
	return sum / judged if judged > 0 else INF


## What a sensor would have said of another place, had it been calibrated for that.
func _moved(p_rotation: Quaternion, p_from: int, p_to: int) -> Quaternion:
	if _reset == ResetPose.Kind.T:
		return p_rotation
	var from: Quaternion = ResetPose.rotation(_reset, p_from)
	return p_rotation * from.inverse() * ResetPose.rotation(_reset, p_to)


func _conclude() -> void:
	var best: float = _excess_now
	for left: float in _excess_then:
		best = minf(best, left)
	var found: Array[Vector2i] = []
	if _excess_now - best > SWAP_RAD and best < minf(_excess_now * EXPLAINS, LEAVES_RAD):
		for at: int in PAIRS.size():
			# The first ones are those within an arm or a leg.
			if found.is_empty() and _excess_then[at] < best + ABOUT_RAD:
				found.append(PAIRS[at])
	var loose: PackedInt32Array = []
	if found.is_empty():
		loose = _find_slipped()
	if found != swaps or loose != slipped:
		swaps = found
		slipped = loose
		changed.emit()


## The fewest places that explain all bad joints: those whose every joint is bad, first those with
## most joints.
func _find_slipped() -> PackedInt32Array:
	var bad: PackedInt32Array = []
	var good: PackedInt32Array = []
	for place: int in BodyPlaces.COUNT:
		var mean: float = _mean_excess(place)
		if mean > SLIP_RAD:
			bad.append(place)
		elif mean >= 0.0:
			good.append(place)
	var found: PackedInt32Array = []
	while not bad.is_empty():
		var best: int = -1
		var most: int = 0
		for place: int in BodyPlaces.COUNT:
			var count: int = _joints_of(place, bad).size()
			if count >= most and count > 0 and _joints_of(place, good).is_empty():
				best = place
				most = count
		if best < 0:
			break
		found.append(best)
		for joint: int in _joints_of(best, bad):
			bad.remove_at(bad.find(joint))
	found.sort()
	return found


## Those of some joints (by the place below) that touch a place.
static func _joints_of(p_place: int, p_joints: PackedInt32Array) -> PackedInt32Array:
	var found: PackedInt32Array = []
	for joint: int in p_joints:
		if joint == p_place or BodyPlaces.PARENTS[joint] == p_place:
			found.append(joint)
	return found


## Mean excess of the joint above a place, rad; -1 if it is not known.
func _mean_excess(p_place: int) -> float:
	if p_place == BodyPlaces.PELVIS or not JointRange.knows(p_place):
		return -1.0
	var above: int = BodyPlaces.PARENTS[p_place]
	var sum: float = 0.0
	var count: int = 0
	for pose: Array in _poses:
		if pose[p_place] != null and pose[above] != null:
			sum += JointRange.excess(p_place, pose[above], pose[p_place])
			count += 1
	return sum / count if count > 0 else -1.0
