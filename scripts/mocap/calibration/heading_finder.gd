class_name HeadingFinder
extends RefCounted
## Finds which way each sensor's north is from the axes about which it turned.

## A movement must have turned a mount by so much, rad.
const MIN_TURN: float = 0.3
## And it must have been about one horizontal axis: [method MotionAxis.purity].
const MIN_PURITY: float = 0.9

## Headings that differ by more than this are reversed, rad.
const REVERSED_RAD: float = 2.4
## Headings that differ by less agree, rad.
const AGREE_RAD: float = 0.5

## Headings found by movements, rad, by mount.
var measured: Dictionary[int, float] = {}

var _sines: Dictionary[int, Vector2] = {}


## Takes what a movement showed of a mount: the horizontal axis in the sensor's global
## frame and the turn, rad.
func add(p_mount: int, p_wanted: Vector3, p_axis: Vector3, p_turn: float, p_purity: float) -> void:
	if p_turn < MIN_TURN or p_purity < MIN_PURITY or p_wanted == Vector3.ZERO:
		return
	var heading: float = atan2(p_axis.x, p_axis.z) - atan2(p_wanted.x, p_wanted.z)
	var sum: Vector2 = _sines.get(p_mount, Vector2.ZERO)
	sum += Vector2.from_angle(heading) * p_turn
	_sines[p_mount] = sum
	measured[p_mount] = sum.angle()


## Takes back what was found of a mount.
func forget(p_mount: int) -> void:
	measured.erase(p_mount)
	_sines.erase(p_mount)


## The heading of somebody's front: arms where there are, left and right alike, else all.
func common() -> float:
	var arms: Vector2 = Vector2.ZERO
	for side: int in [-1, 1]:
		var sum: Vector2 = Vector2.ZERO
		for mount: int in measured:
			if ResetPose.hangs(mount) and BodyMounts.side(mount) == side:
				sum += Vector2.from_angle(measured[mount])
		arms += sum.normalized()
	if arms.length() > 0.5:
		return arms.angle()
	return middle(measured.values())


## The largest difference of a measured heading from the common one, rad.
func spread() -> float:
	var most: float = 0.0
	var front: float = common()
	for mount: int in measured:
		most = maxf(most, absf(angle_difference(front, measured[mount])))
	return most


## Mounts whose axis points the other way round than that of most others, all of which agree: their
## sensors are on the other side, or on the other end of a joint. Empty if that is not clear.
func reversed() -> PackedInt32Array:
	var most: float = middle(measured.values())
	var odd: PackedInt32Array = []
	for mount: int in measured:
		var off: float = absf(angle_difference(most, measured[mount]))
		if off > REVERSED_RAD:
			odd.append(mount)
		elif off > AGREE_RAD:
			return PackedInt32Array()
	odd.sort()
	return odd if odd.size() * 2 < measured.size() else PackedInt32Array()


## A mount's own heading, or that of the nearest one towards the pelvis that has one, or of its
## mirror; [param p_else] if there is none.
func nearest(p_mount: int, p_else: float) -> float:
	var mount: int = p_mount
	while mount >= 0:
		if measured.has(mount):
			return measured[mount]
		mount = BodyMounts.PARENTS[mount]
	return measured.get(BodyMounts.MIRRORS[p_mount], p_else)


## The middle of angles, rad, robust against a few odd ones; 0 if there are none.
static func middle(p_angles: Array) -> float:
	var best: float = 0.0
	var best_sum: float = INF
	for angle: float in p_angles:
		var sum: float = 0.0
		for other: float in p_angles:
			sum += absf(angle_difference(angle, other))
		if sum < best_sum:
			best_sum = sum
			best = angle
	var mean: Vector2 = Vector2.ZERO
	for angle: float in p_angles:
		if absf(angle_difference(angle, best)) < 0.3:
			mean += Vector2.from_angle(angle)
	return mean.angle() if not p_angles.is_empty() else 0.0
