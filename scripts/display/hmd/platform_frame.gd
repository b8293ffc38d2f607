class_name PlatformFrame
extends RefCounted
## Takes the motion of a platform out of a headset's pose, so that the cabin on it stands still.
##
## A headset is tracked in the room; its wearer sits on a platform that moves with the vehicle. Seen
## from the platform only the head's own motion remains: [code]inverse(platform) * headset[/code].
## The platform's pose is the one that was commanded to it (the cue, see docs/motion-platform.md) or
## that a tracker on it shows, at the moment for which the headset's was predicted, less the
## platform's delay. Frame: the tracking space, turned so that the platform's neutral pose is
## [member neutral]; metres.

## Poses that are kept: 2 s at 250 Hz.
const KEPT: int = 512
## A platform's delay is no longer than this, s.
const MAX_DELAY_S: float = 1.0

## Where the platform's neutral point is in the tracking space, and how it faces (-Z ahead).
var neutral: Transform3D = Transform3D.IDENTITY
## From a command to the platform's motion, s; 0 for poses that were measured.
var delay_s: float = 0.0:
	set(p_value):
		if is_finite(p_value):
			delay_s = clampf(p_value, 0.0, MAX_DELAY_S)

var _times: PackedInt64Array = PackedInt64Array()
var _poses: Array[Transform3D] = []


## The pose of a platform from a cue: position from neutral, m (to the right, up, back), and
## attitude, rad (pitch, yaw, roll): first yaw, then pitch, then roll.
static func of_cue(p_position: Vector3, p_attitude: Vector3) -> Transform3D:
	return Transform3D(Basis.from_euler(p_attitude, EULER_ORDER_YXZ), p_position)


## Takes the platform's pose from neutral at a time, µs of any one clock. What is no pose is left
## out.
func push(p_time_usec: int, p_pose: Transform3D) -> void:
	if not p_pose.is_finite() or absf(p_pose.basis.determinant() - 1.0) > 0.01:
		return
	if not _times.is_empty() and p_time_usec <= _times[-1]:
		_times.clear()
		_poses.clear()
	if _times.size() >= 2 * KEPT:
		_times = _times.slice(KEPT)
		_poses = _poses.slice(KEPT)
	_times.append(p_time_usec)
	_poses.append(p_pose)


## Takes a cue at a time, µs: see [method of_cue].
func push_cue(p_time_usec: int, p_position: Vector3, p_attitude: Vector3) -> void:
	push(p_time_usec, of_cue(p_position, p_attitude))


## Forgets all poses: the platform is in neutral.
func clear() -> void:
	_times.clear()
	_poses.clear()


## The platform's pose from neutral at a time, µs of that clock: between the poses around the moment
## a delay before; the last one where there is none later.
func pose_at(p_time_usec: int) -> Transform3D:
	if _times.is_empty():
		return Transform3D.IDENTITY
	var wanted: int = p_time_usec - roundi(delay_s * 1e6)
	var after: int = _times.bsearch(wanted)
	if after <= 0:
		return _poses[0]
	if after >= _times.size():
		return _poses[-1]
	var span: float = _times[after] - _times[after - 1]
	return _poses[after - 1].interpolate_with(_poses[after], (wanted - _times[after - 1]) / span)


## A pose of the tracking space (the headset, a controller) as it is on the platform, at a time, µs.
func without_platform(p_pose: Transform3D, p_time_usec: int) -> Transform3D:
	var moved: Transform3D = neutral * pose_at(p_time_usec) * neutral.affine_inverse()
	return moved.affine_inverse() * p_pose
