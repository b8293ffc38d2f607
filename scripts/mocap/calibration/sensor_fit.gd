class_name SensorFit
extends RefCounted
## What one sensor said in the poses that were held and in the movements that were made, and the
## heading and the mounting that explain it best: [FitSolver] finds them.
##
## With s = H r M ([Calibration]) a pose that was held says s = H P F M: P is the pose as it was
## asked for, F how far the limb was off. A movement turns the limb about a level axis x of the
## body, so in the sensor's frame about H (x + (k g + o) x x): o is how far the movement was askew,
## g the limb's F seen from the body, and k tells whether the movement went about an axis of the
## limb (1, a hinge) or of the body (0). Heading and mounting are those with the least F and o,
## weighted by the inverse of their variances, which [WearerModel] learns: Gauss-Newton on the
## rotations (maximum a posteriori, all errors taken as normal).

## The arms must come down by this to show which way somebody faces, rad.
const _MIN_ARMS: float = 0.3
## Turns that together are less show nothing, rad.
const _MIN_TURNS: float = 0.15

## Number of the sensor in the frames.
var sensor: int = -1
## Its mount of [BodyMounts].
var mount: int = -1
## The heading H, rad about the vertical.
var heading: float = 0.0
## The mounting M.
var mounting: Quaternion = Quaternion.IDENTITY
## Variance of the heading as poses and movements alone tell it, rad².
var heading_variance: float = INF
## Covariance of the mounting, in the limb's axes, when the heading is known: 3 times 3, rad².
var mounting_covariance: PackedFloat64Array = PackedFloat64Array()
## By how much the mounting turns with the heading that is taken, in the limb's axes.
var coupling: Vector3 = Vector3.ZERO
## Poses that were held.
var holds: Array[Hold] = []
## Movements that turned it.
var turns: Array[Turn] = []


## A pose that was held.
class Hold:
	var pose: ResetPose.Kind = ResetPose.Kind.T
	## What the sensor said, by and large.
	var said: Quaternion = Quaternion.IDENTITY
	## By how much it moved meanwhile, rad.
	var movement: float = 0.0


## A movement that turned the sensor.
class Turn:
	## The axis in the sensor's global frame, of length 1.
	var axis: Vector3 = Vector3.ZERO
	## The axis that was asked for, for somebody who faces +Z.
	var wanted: Vector3 = Vector3.ZERO
	## How far it turned, rad.
	var angle: float = 0.0
	## How much the axis changed meanwhile, rad (standard deviation).
	var scatter: float = 0.0


## The first hold of a pose, or null.
func hold(p_pose: ResetPose.Kind) -> Hold:
	for held: Hold in holds:
		if held.pose == p_pose:
			return held
	return null


## How often a pose was held.
func count(p_pose: ResetPose.Kind) -> int:
	var number: int = 0
	for held: Hold in holds:
		number += 1 if held.pose == p_pose else 0
	return number


## How far the limb was off in the holds of a pose in the mean: see [method fault].
func mean_fault(p_pose: ResetPose.Kind) -> Vector3:
	var sum: Vector3 = Vector3.ZERO
	for held: Hold in holds:
		sum += fault(held) if held.pose == p_pose else Vector3.ZERO
	return sum / maxi(count(p_pose), 1)


## Sets the mounting from one hold alone.
func start_from(p_hold: Hold) -> void:
	var asked: Quaternion = ResetPose.rotation(p_hold.pose, mount)
	mounting = ((Rotations.yaw(heading) * asked).inverse() * p_hold.said).normalized()


## How far the limb was off in a pose, with the present heading and mounting: a rotation vector in
## the limb's axes, rad.
func fault(p_hold: Hold) -> Vector3:
	var asked: Quaternion = ResetPose.rotation(p_hold.pose, mount)
	var limb: Quaternion = Rotations.yaw(-heading) * p_hold.said * mounting.inverse()
	return Rotations.vector((asked.inverse() * limb).normalized())


## How far the axis of a movement was off, with the present heading, rad: about the vertical (x),
## and upwards (y).
func deviation(p_turn: Turn) -> Vector2:
	var axis: Vector3 = Rotations.yaw(-heading) * p_turn.axis
	var level: float = Vector2(axis.x, axis.z).length()
	var angle: float = atan2(axis.x, axis.z) - atan2(p_turn.wanted.x, p_turn.wanted.z)
	return Vector2(wrapf(angle, -PI, PI), atan2(axis.y, level))


## A first estimate of the heading, from the movements and from the arms' movement from T to N, rad;
## NAN if there were none.
func estimate_heading() -> float:
	var sum: Vector2 = Vector2.ZERO
	for turn: Turn in turns:
		var level: Vector2 = Vector2(turn.axis.x, turn.axis.z)
		var found: float = atan2(level.x, level.y) - atan2(turn.wanted.x, turn.wanted.z)
		sum += Vector2.from_angle(found) * turn.angle * level.length()
	var from: Hold = hold(ResetPose.Kind.T)
	var to: Hold = hold(ResetPose.Kind.N)
	if ResetPose.hangs(mount) and from != null and to != null:
		var turned: Vector3 = Rotations.vector((to.said * from.said.inverse()).normalized())
		var wanted: Vector3 = GuideMovements.axis(GuideMovements.Movement.ARMS, mount)
		if Vector2(turned.x, turned.z).length() > _MIN_ARMS:
			var found: float = atan2(turned.x, turned.z) - atan2(wanted.x, wanted.z)
			sum += Vector2.from_angle(found) * turned.length()
	return sum.angle() if sum.length() > _MIN_TURNS else NAN
