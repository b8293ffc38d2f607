class_name SensorFit
extends RefCounted
## The heading and the mounting of one sensor that explain best what it said in the poses that were
## held and in the movements that were made.
##
## With s = H r M ([Calibration]) a pose that was held says s = H P F M: P is the pose as it was
## asked for, F how far the limb was off. A movement turns the limb about a level axis x of the
## body, so in the sensor's frame about H (x + (k g + o) x x): o is how far the movement was askew,
## g the limb's F seen from the body, and k tells whether the movement went about an axis of the
## limb (1, a hinge) or of the body (0). Heading and mounting are those with the least F and o,
## weighted by the inverse of their variances, which [WearerModel] learns: Gauss-Newton on the
## rotations (maximum a posteriori, all errors taken as normal).

## Iterations: errors are small angles, so a few do.
const _ROUNDS: int = 3
## Standard deviation of a heading of which nothing is known, rad.
const _ANY_RAD: float = 30.0

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


## Finds both, the heading being free.
func solve(p_model: WearerModel) -> void:
	for _round: int in _ROUNDS:
		var found: PackedFloat64Array = _step(p_model, NAN)
		heading_variance = found[15]
		coupling = Vector3(found[3], found[7], found[11]) / found[15]
	if heading_variance > _ANY_RAD:
		# The weak guess that keeps the equations solvable is all that there is.
		heading_variance = INF


## Finds the mounting for a heading.
func solve_for(p_model: WearerModel, p_heading: float) -> void:
	mounting = Rotations.from_vector(-coupling * angle_difference(heading, p_heading)) * mounting
	heading = p_heading
	mounting_covariance.resize(9)
	for _round: int in _ROUNDS:
		var found: PackedFloat64Array = _step(p_model, heading)
		heading = p_heading
		for row: int in 3:
			for column: int in 3:
				mounting_covariance[row * 3 + column] = found[row * 4 + column]


## One step of Gauss and Newton. The unknowns are the mounting's turn, in the limb's axes, and the
## heading's. Returns their covariance.
func _step(p_model: WearerModel, p_heading: float) -> PackedFloat64Array:
	var equations: NormalEquations = NormalEquations.new(4)
	for held: Hold in holds:
		_add_hold(equations, held, p_model)
	var start: Hold = hold(ResetPose.Kind.N)
	for turn: Turn in turns:
		_add_turn(equations, turn, start, p_model)
	var known: bool = not is_nan(p_heading)
	equations.add([0.0, 0.0, 0.0, 1.0], 0.0, 1e-10 if known else _ANY_RAD * _ANY_RAD)
	var covariance: PackedFloat64Array = equations.covariance()
	var by: PackedFloat64Array = equations.solution(covariance)
	mounting = (Rotations.from_vector(-Vector3(by[0], by[1], by[2])) * mounting).normalized()
	heading += by[3]
	return covariance


func _add_hold(r_equations: NormalEquations, p_hold: Hold, p_model: WearerModel) -> void:
	var off: Vector3 = fault(p_hold)
	var up: Vector3 = ResetPose.rotation(p_hold.pose, mount).inverse() * Vector3.UP
	var variance: Vector3 = p_model.pose_variance(self, p_hold)
	for part: int in 3:
		var row: PackedFloat64Array = [0.0, 0.0, 0.0, -up[part]]
		row[part] = 1.0
		r_equations.add(row, -off[part], variance[part])


func _add_turn(
	r_equations: NormalEquations, p_turn: Turn, p_start: Hold, p_model: WearerModel
) -> void:
	var off: Vector2 = deviation(p_turn)
	var variance: float = p_model.axis_variance(p_turn)
	var hinge: float = p_model.hinge if p_start != null else 0.0
	var side: Vector3 = p_turn.wanted.cross(Vector3.UP)
	var around: Vector3 = Vector3.ZERO
	var across: Vector3 = Vector3.ZERO
	var start: Vector3 = Vector3.ZERO
	if p_start != null:
		var asked: Quaternion = ResetPose.rotation(p_start.pose, mount)
		start = fault(p_start)
		around = asked.inverse() * Vector3.UP * hinge
		across = asked.inverse() * side * hinge
		variance += p_model.hinge_variance * start.length_squared() / 3.0
	r_equations.add(
		[around.x, around.y, around.z, 1.0 - hinge], off.x - around.dot(start), variance
	)
	r_equations.add([across.x, across.y, across.z, 0.0], off.y - across.dot(start), variance)
