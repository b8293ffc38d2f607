class_name LivePoses
extends RefCounted
## Poses of a live source, to be asked for at any moment.
##
## A source measures in its own time, samples are taken in the server's: asked for the newest pose
## only, the server would sometimes get a fresh one and sometimes an old one, and would have to
## extrapolate. So it is asked for the pose of a moment a little more than one period back, which
## lies between two that were measured. For one thread.

## Delay beyond one period, s: the usual jitter of the path from the source.
const MARGIN_S: float = 0.002
## Time for which a late source is extrapolated, s; then there is no pose until it comes again.
const MAX_AHEAD_S: float = 0.05
## Least distance of the two poses from which it is extrapolated, s, besides half a period: two that
## came at once after a hold-up, their times close together, would make any motion a hundred times
## faster.
const MIN_SPAN_S: float = 0.008
## Poses that are kept.
const MAX_POSES: int = 16
## The period of a source of which only one pose is known, s.
const _USUAL_PERIOD_S: float = 0.01
const _MAX_PERIOD_S: float = 0.1

## Delay beyond one period with which poses are asked for, s: more where the path from the source is
## worse than usual.
var margin_s: float = MARGIN_S

var _poses: Array[PoseSample] = []
# Of the newest pose, as its source knows it; 0 where it does not.
var _period_s: float = 0.0
var _returned_usec: int = 0


## Takes a pose that was measured at its [member PoseSample.time_usec]. A source in which several
## devices take turns says with [param p_period_s] how long the slowest of them takes.
func push(p_pose: PoseSample, p_period_s: float = 0.0) -> void:
	_period_s = p_period_s
	if not _poses.is_empty() and p_pose.time_usec <= _poses[_poses.size() - 1].time_usec:
		_poses.clear()  # A clock that was set, or another recording.
	_poses.append(p_pose)
	if _poses.size() > MAX_POSES:
		_poses.pop_front()


## Forgets all.
func clear() -> void:
	_poses.clear()


## Time between two poses, s.
func period_s() -> float:
	if _period_s > 0.0:
		return minf(_period_s, _MAX_PERIOD_S)
	if _poses.size() < 2:
		return _USUAL_PERIOD_S
	var span: float = (_poses[_poses.size() - 1].time_usec - _poses[0].time_usec) / 1e6
	return minf(span / (_poses.size() - 1), _MAX_PERIOD_S)


## Which of poses or frames in the order of their time_usec, one a period, s, is the newest that is
## old enough to extrapolate from it through the last one; the last one itself if none is.
static func base_of(p_timed: Array, p_period_s: float) -> int:
	var last: int = p_timed.size() - 1
	var least_usec: float = maxf(MIN_SPAN_S, p_period_s / 2.0) * 1e6
	for at: int in range(last - 1, -1, -1):
		if p_timed[last].time_usec - p_timed[at].time_usec >= least_usec:
			return at
	return last


## The pose for a moment, µs of Unix time; its own time says of when it is. Null if there is none,
## or none newer than the last one returned.
func at(p_time_usec: int) -> PoseSample:
	if _poses.is_empty():
		return null
	var wanted: int = p_time_usec - roundi((period_s() + margin_s) * 1e6)
	var newest: PoseSample = _poses[_poses.size() - 1]
	if _poses.size() < 2:
		wanted = newest.time_usec
	var base: PoseSample = newest
	var limit_usec: int = newest.time_usec + roundi(MAX_AHEAD_S * 1e6)
	if wanted > newest.time_usec:
		base = _poses[base_of(_poses, period_s())]
		wanted = mini(wanted, limit_usec) if base != newest else newest.time_usec
	if wanted <= _returned_usec and _returned_usec <= limit_usec:
		return null
	_returned_usec = wanted
	if _poses.size() < 2 or wanted <= _poses[0].time_usec:
		return _between(_poses[0], _poses[0], 0.0)
	if wanted > newest.time_usec:
		return _at(wanted, base, newest)
	var later: int = 1
	while _poses[later].time_usec < wanted:
		later += 1
	return _at(wanted, _poses[later - 1], _poses[later])


static func _at(p_time_usec: int, p_from: PoseSample, p_to: PoseSample) -> PoseSample:
	var span: float = p_to.time_usec - p_from.time_usec
	return _between(p_from, p_to, (p_time_usec - p_from.time_usec) / span)


static func _between(p_from: PoseSample, p_to: PoseSample, p_part: float) -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	pose.time_usec = p_from.time_usec + roundi((p_to.time_usec - p_from.time_usec) * p_part)
	for limb: int in Limbs.COUNT:
		pose.set_orientation(
			limb, p_from.orientation(limb).slerp(p_to.orientation(limb), p_part).normalized()
		)
	pose.root = p_from.root.lerp(p_to.root, p_part)
	pose.details = p_to.details
	if p_to.details != null and p_from.details != null:
		pose.details = _details_between(p_from.details, p_to.details, p_part)
	return pose


static func _details_between(
	p_from: MotionDetails, p_to: MotionDetails, p_part: float
) -> MotionDetails:
	var details: MotionDetails = MotionDetails.new()
	details.counter = p_to.counter
	details.positions = p_to.positions
	details.contacts = p_to.contacts
	details.joints = p_to.joints
	details.measured = p_to.measured
	details.rates = p_to.rates.duplicate()
	for limb: int in mini(details.rates.size(), p_from.rates.size()):
		details.rates[limb] = p_from.rates[limb].lerp(p_to.rates[limb], p_part)
	return details
