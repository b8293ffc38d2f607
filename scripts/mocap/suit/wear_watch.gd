class_name WearWatch
extends RefCounted
## Notices from any motion that sensors are exchanged or have slipped, because joints turn where no
## joint turns; and names them.
##
## It judges the last [constant WINDOW_S] seconds: where joints go ([JointRange]); and the last
## [constant LEGS_S]: whether knees and ankles are hinges ([LegSpread]). What bends no joint wrongly
## it cannot see: exchanges of whole arms or legs, of a hand with its forearm, or within the trunk.
## A fit check finds those ([FitCheck]).

## Something was noticed, or is over.
signal changed

## Span that is judged, s.
const WINDOW_S: float = 20.0
## Span over which legs are judged, s.
const LEGS_S: float = 60.0
## Number of conclusions in a row, one a second, before something is reported.
const LASTS: int = 8
## Poses a second that are kept.
const RATE_HZ: float = 5.0
## Least number of poses before anything is reported.
const MIN_POSES: int = 40
## Least improvement by an exchange, in the mean of what all joints together are beyond their
## ranges, rad.
const SWAP_RAD: float = 0.2
## Greatest rest after an exchange: a share of what was, and an angle, rad.
const EXPLAINS: float = 0.5
const LEAVES_RAD: float = 0.5
## Difference below which exchanges count as equally good, rad.
const ABOUT_RAD: float = 0.05
## Mean excess over its range that makes a joint bad, rad.
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
# For each pair the mounts above which a joint changes.
const _TOUCHED: Array[Array] = [
	[BodyMounts.LEFT_FOREARM, BodyMounts.LEFT_HAND],
	[BodyMounts.RIGHT_FOREARM, BodyMounts.RIGHT_HAND],
	[BodyMounts.LEFT_THIGH, BodyMounts.LEFT_SHANK, BodyMounts.LEFT_FOOT],
	[BodyMounts.RIGHT_THIGH, BodyMounts.RIGHT_SHANK, BodyMounts.RIGHT_FOOT],
	[BodyMounts.LEFT_FOREARM, BodyMounts.RIGHT_FOREARM],
	[
		BodyMounts.LEFT_FOREARM,
		BodyMounts.LEFT_HAND,
		BodyMounts.RIGHT_FOREARM,
		BodyMounts.RIGHT_HAND
	],
	[BodyMounts.LEFT_HAND, BodyMounts.RIGHT_HAND],
	[BodyMounts.LEFT_THIGH, BodyMounts.LEFT_SHANK, BodyMounts.RIGHT_THIGH, BodyMounts.RIGHT_SHANK],
	[BodyMounts.LEFT_SHANK, BodyMounts.LEFT_FOOT, BodyMounts.RIGHT_SHANK, BodyMounts.RIGHT_FOOT],
	[BodyMounts.LEFT_FOOT, BodyMounts.RIGHT_FOOT],
]

## Pairs of mounts whose sensors look exchanged.
var swaps: Array[Vector2i] = []
## Mounts whose sensor seems to have slipped or to sit upside down.
var slipped: PackedInt32Array = PackedInt32Array()

var _last_usec: int = -1
## Of each pose: what all joints together are beyond their ranges now, then the same for each of
## [constant PAIRS] exchanged (NaN if it is not possible), then for the joint above each mount
## (NaN if it is not known), rad.
var _rows: Array[PackedFloat32Array] = []
var _since: int = 0
# What was noticed last, and how often in a row.
var _found: Array[Vector2i] = []
var _loose: PackedInt32Array = PackedInt32Array()
var _lasts: int = 0
var _legs: LegSpread = LegSpread.new(roundi(LEGS_S * RATE_HZ))
# The pose in which the sensors were calibrated.
var _reset: ResetPose.Kind = ResetPose.Kind.T


## Forgets what was seen.
func clear() -> void:
	_rows.clear()
	_legs.clear()
	_last_usec = -1
	_lasts = 0
	if not swaps.is_empty() or not slipped.is_empty():
		swaps = []
		slipped = PackedInt32Array()
		changed.emit()


## What was noticed, a sentence each.
func messages() -> PackedStringArray:
	var found: PackedStringArray = []
	for swap: Vector2i in swaps:
		found.append(FitCheck.describe(swap))
	for mount: int in slipped:
		var title: String = BodyMounts.title(mount)
		found.append("%s sensor seems loose or upside down: fasten it, calibrate again" % title)
	return found


## Takes a frame of sensors that are calibrated.
func add(p_frame: SensorFrame, p_table: SuitTable) -> void:
	if not p_table.is_calibrated:
		return
	if absf(p_frame.time_usec - _last_usec) < 1e6 / RATE_HZ:
		return
	_last_usec = p_frame.time_usec
	_reset = p_table.reset_pose
	var pose: Array = []
	pose.resize(BodyMounts.COUNT)
	for sensor: int in mini(p_frame.count(), p_table.mounts.size()):
		var mount: int = p_table.mounts[sensor]
		if mount >= 0 and p_frame.present[sensor] != 0:
			pose[mount] = p_table.rotation(sensor, p_frame.orientation(sensor))
	_rows.append(_judge(pose))
	_legs.add(pose)
	if _rows.size() > WINDOW_S * RATE_HZ:
		_rows.pop_front()
	_since += 1
	if _rows.size() >= MIN_POSES and _since >= RATE_HZ:
		_since = 0
		_conclude()


func _judge(p_pose: Array) -> PackedFloat32Array:
	var row: PackedFloat32Array = PackedFloat32Array()
	row.resize(1 + PAIRS.size() + BodyMounts.COUNT)
	row.fill(NAN)
	var joints: int = 1 + PAIRS.size()
	row[0] = 0.0
	for mount: int in range(1, BodyMounts.COUNT):
		if JointRange.knows(mount):
			row[joints + mount] = _excess(p_pose, mount)
			row[0] += 0.0 if is_nan(row[joints + mount]) else row[joints + mount]
	for at: int in PAIRS.size():
		var pair: Vector2i = PAIRS[at]
		if p_pose[pair.x] == null or p_pose[pair.y] == null:
			continue
		var exchanged: Array = p_pose.duplicate()
		exchanged[pair.x] = _moved(p_pose[pair.y], pair.y, pair.x)
		exchanged[pair.y] = _moved(p_pose[pair.x], pair.x, pair.y)
		row[1 + at] = row[0]
		for mount: int in _TOUCHED[at]:
			if not is_nan(row[joints + mount]):
				row[1 + at] += _excess(exchanged, mount) - row[joints + mount]
	return row


## How far the joint above a mount is beyond its range, rad; NaN if an end of it is not known.
static func _excess(p_pose: Array, p_mount: int) -> float:
	var above: Variant = p_pose[BodyMounts.PARENTS[p_mount]]
	if p_pose[p_mount] == null or above == null:
		return NAN
	return JointRange.excess(p_mount, above, p_pose[p_mount])


## The mean of a column of the rows over those that know it; NaN if none does.
func _mean(p_column: int) -> float:
	var sum: float = 0.0
	var count: int = 0
	for row: PackedFloat32Array in _rows:
		if not is_nan(row[p_column]):
			sum += row[p_column]
			count += 1
	return sum / count if count > 0 else NAN


## What a sensor would have said of another mount, had it been calibrated for that.
func _moved(p_rotation: Quaternion, p_from: int, p_to: int) -> Quaternion:
	if _reset == ResetPose.Kind.T:
		return p_rotation
	var from: Quaternion = ResetPose.rotation(_reset, p_from)
	return p_rotation * from.inverse() * ResetPose.rotation(_reset, p_to)


func _conclude() -> void:
	var found: Array[Vector2i] = []
	var pair: Vector2i = _find_swap()
	if pair == Vector2i.ZERO:
		pair = _legs.find_swap()
	if pair != Vector2i.ZERO:
		found.append(pair)
	var loose: PackedInt32Array = []
	if found.is_empty():
		loose = _find_slipped()
	_lasts = _lasts + 1 if found == _found and loose == _loose else 1
	_found = found
	_loose = loose
	var is_over: bool = found.is_empty() and loose.is_empty()
	if (found != swaps or loose != slipped) and (_lasts >= LASTS or is_over):
		swaps = found
		slipped = loose
		changed.emit()


## The exchange that brings joints back into their ranges; zero if there is none.
func _find_swap() -> Vector2i:
	var now: float = _mean(0)
	var best: float = now
	var then: PackedFloat32Array = []
	for at: int in PAIRS.size():
		var left: float = _mean(1 + at)
		then.append(INF if is_nan(left) else left)
		best = minf(best, then[at])
	if now - best < SWAP_RAD or best > minf(now * EXPLAINS, LEAVES_RAD):
		return Vector2i.ZERO
	var found: Vector2i = Vector2i.ZERO
	for at: int in PAIRS.size():
		if then[at] > best + ABOUT_RAD:
			continue
		# The first ones are those within an arm or a leg; but hinges distinguish legs better.
		var legs: float = _legs.total_deg(PAIRS[at])
		if found == Vector2i.ZERO or legs < _legs.total_deg(found) - 1.0:
			found = PAIRS[at]
	return found


## The fewest mounts that explain all bad joints: those whose every joint is bad, first those with
## most joints.
func _find_slipped() -> PackedInt32Array:
	var bad: PackedInt32Array = []
	var good: PackedInt32Array = []
	for mount: int in BodyMounts.COUNT:
		# NaN, where nothing is known, is neither.
		var mean: float = _mean(1 + PAIRS.size() + mount)
		if mean > SLIP_RAD:
			bad.append(mount)
		elif mean <= SLIP_RAD:
			good.append(mount)
	var found: PackedInt32Array = []
	while not bad.is_empty():
		var best: int = -1
		var most: int = 0
		for mount: int in BodyMounts.COUNT:
			var count: int = _joints_of(mount, bad).size()
			if count >= most and count > 0 and _joints_of(mount, good).is_empty():
				best = mount
				most = count
		if best < 0:
			break
		found.append(best)
		for joint: int in _joints_of(best, bad):
			bad.remove_at(bad.find(joint))
	found.sort()
	return found


## Those of some joints (by the mount below) that touch a mount.
static func _joints_of(p_mount: int, p_joints: PackedInt32Array) -> PackedInt32Array:
	var found: PackedInt32Array = []
	for joint: int in p_joints:
		if joint == p_mount or BodyMounts.PARENTS[joint] == p_mount:
			found.append(joint)
	return found
