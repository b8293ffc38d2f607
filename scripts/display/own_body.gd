class_name OwnBody
extends RefCounted
## The wearer's own body as the wearer sees it: at once, and where the server's world stops it.
##
## Puts [PoseSample]s onto the limbs of the body and hands them to [LocalFeedback], together with
## what the server made of them.

## Greatest extrapolation beyond the newest sample, s: half a period of samples keeps the delay even
## where samples and frames are not in step.
const HALF_PERIOD: float = 0.5

var _feedback: LocalFeedback = LocalFeedback.new()
var _skeleton: PersonSkeleton = null
var _scale: float = 1.0
var _period_s: float = 1.0 / 60.0


## Takes the body's skeleton, the ratio of the body's hip height to the wearer's, and how many
## samples come a second.
func setup(p_skeleton: PersonSkeleton, p_scale: float, p_rate: float) -> void:
	_skeleton = p_skeleton
	_scale = p_scale
	_period_s = 1.0 / p_rate
	_feedback.set_skeleton(
		p_skeleton.parents, p_skeleton.joints_in_parent, p_skeleton.joints_in_limb
	)


## Says how far the wearer's own frame is turned about the vertical in the world, rad; with NAN it
## stays as it is.
func turn(p_heading: float) -> void:
	_feedback.set_heading(p_heading)


## Takes a sample of the wearer's motion. Returns whether it was of use.
func add_sample(p_sample: PoseSample) -> bool:
	var root: Vector3 = _skeleton.root_of(p_sample, p_sample.root * _scale)
	return _feedback.push_local(p_sample.time_usec / 1e6, root, p_sample.orientations)


## Takes the server's newest pose of the body (seven floats a limb, see
## [method SnapshotSmoother.newest_person_transforms]) and the moment of the motion that it was made
## of, µs of the wearer's clock. Returns whether it was of use.
func add_truth(p_moment_usec: int, p_transforms: PackedFloat32Array) -> bool:
	return _feedback.push_truth(p_moment_usec / 1e6, p_transforms)


## What is shown at a time of the client's clock (s), when the wearer's clock shows another (µs):
## seven floats a limb; empty before the first sample.
func evaluate(p_now_s: float, p_wearer_usec: int) -> PackedFloat32Array:
	var moment: float = p_wearer_usec / 1e6 - HALF_PERIOD * _period_s
	if not _feedback.evaluate(p_now_s, moment):
		return PackedFloat32Array()
	return _feedback.transforms()


## Where the wearer's own frame lies in the world when the body is shown by these floats (see
## [method evaluate]) and is turned in it by a heading, rad.
func frame_in_world(
	p_sample: PoseSample, p_floats: PackedFloat32Array, p_heading: float
) -> Transform3D:
	var turn: Basis = Basis(Vector3.UP, p_heading)
	var root: Vector3 = _skeleton.root_of(p_sample, p_sample.root * _scale)
	return Transform3D(turn, Vector3(p_floats[0], p_floats[1], p_floats[2]) - turn * root)


## Which of the wearer's moments [method show] shows at a time of the wearer's clock, µs.
func shown_moment_usec(p_wearer_usec: int) -> int:
	var newest: int = roundi(_feedback.newest_moment() * 1e6)
	return mini(
		p_wearer_usec - roundi(HALF_PERIOD * _period_s * 1e6), newest + roundi(_period_s * 1e6)
	)


## How far a limb is shown from where the wearer has it, rad.
func deviation(p_limb: int) -> float:
	return _feedback.deviation(p_limb)


## Forgets all poses.
func clear() -> void:
	_feedback.clear()
