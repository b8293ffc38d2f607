extends RefCounted
## What sensors say whose heading, mounting and faults are known, for tests of [SensorFit] and
## [WearerModel].


## A sensor on a mount that nothing is known of yet.
static func on(p_mount: int) -> SensorFit:
	var fit: SensorFit = SensorFit.new()
	fit.mount = p_mount
	return fit


## Adds a pose that was held, the limb being off by a rotation vector in its own axes, degrees.
static func hold(
	r_fit: SensorFit,
	p_pose: ResetPose.Kind,
	p_off_deg: Vector3,
	p_heading: float = 0.0,
	p_mounting: Quaternion = Quaternion.IDENTITY
) -> SensorFit.Hold:
	var held: SensorFit.Hold = SensorFit.Hold.new()
	held.pose = p_pose
	var limb: Quaternion = ResetPose.rotation(p_pose, r_fit.mount)
	limb *= Rotations.from_vector(p_off_deg * (PI / 180.0))
	held.said = Rotations.yaw(p_heading) * limb * p_mounting
	r_fit.holds.append(held)
	return held


## Adds a movement about an axis of the body, askew by a rotation vector, degrees.
static func turn(
	r_fit: SensorFit, p_wanted: Vector3, p_askew_deg: Vector3, p_heading: float = 0.0
) -> SensorFit.Turn:
	var turned: SensorFit.Turn = SensorFit.Turn.new()
	turned.wanted = p_wanted
	var askew: Quaternion = Rotations.from_vector(p_askew_deg * (PI / 180.0))
	turned.axis = Rotations.yaw(p_heading) * (askew * p_wanted)
	turned.angle = 1.0
	r_fit.turns.append(turned)
	return turned
