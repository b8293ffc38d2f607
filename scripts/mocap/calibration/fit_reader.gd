class_name FitReader
extends RefCounted
## Takes what one sensor said from the holds and movements of a calibration: a [SensorFit] that is
## not solved yet.

## Of a pose that is taken again and again, what is off by more counts for less, rad.
const AGAIN_RAD: float = 0.07
## Movements that turned a sensor less show nothing, rad.
const MIN_TURN: float = 0.15


## What was measured of a sensor on a mount, from holds in their order and movements.
static func read(
	p_sensor: int,
	p_mount: int,
	p_holds: Array[PoseHold],
	p_axes: Dictionary[GuideMovements.Movement, MotionAxis]
) -> SensorFit:
	var fit: SensorFit = SensorFit.new()
	fit.sensor = p_sensor
	fit.mount = p_mount
	for held: PoseHold in p_holds:
		if held.has(p_sensor):
			var hold: SensorFit.Hold = SensorFit.Hold.new()
			var is_first: bool = held == first_hold(p_holds, held.pose)
			hold.pose = held.pose
			hold.said = _said(p_sensor, held, is_first, p_axes)
			hold.movement = deg_to_rad(held.movement_deg(p_sensor))
			fit.holds.append(hold)
	for movement: GuideMovements.Movement in p_axes:
		var wanted: Vector3 = GuideMovements.axis(movement, p_mount)
		var axis: MotionAxis = p_axes[movement]
		if wanted == Vector3.ZERO or GuideMovements.is_passage(movement):
			continue
		if axis.turn(p_sensor) < MIN_TURN or axis.axis(p_sensor) == Vector3.ZERO:
			continue
		var turn: SensorFit.Turn = SensorFit.Turn.new()
		turn.axis = axis.axis(p_sensor)
		turn.wanted = wanted
		turn.angle = axis.turn(p_sensor)
		turn.scatter = axis.scatter(p_sensor)
		fit.turns.append(turn)
	return fit


## The first hold of a pose, or null.
static func first_hold(p_holds: Array[PoseHold], p_pose: ResetPose.Kind) -> PoseHold:
	for held: PoseHold in p_holds:
		if held.pose == p_pose:
			return held
	return null


## What a sensor said in a hold, and in the same pose before and after the movements that belong to
## it: those before the second hold to the first one.
static func _said(
	p_sensor: int,
	p_hold: PoseHold,
	p_is_first: bool,
	p_axes: Dictionary[GuideMovements.Movement, MotionAxis]
) -> Quaternion:
	var said: Array[Quaternion] = [p_hold.mean(p_sensor)]
	var is_up: bool = p_hold.pose == ResetPose.Kind.T
	for movement: GuideMovements.Movement in p_axes:
		var axis: MotionAxis = p_axes[movement]
		if not axis.was_heard(p_sensor):
			continue
		if movement == GuideMovements.Movement.ARMS and p_is_first:
			said.append(axis.start(p_sensor) if is_up else axis.end(p_sensor))
		elif movement == GuideMovements.Movement.ARMS_UP and not p_is_first:
			said.append(axis.end(p_sensor) if is_up else axis.start(p_sensor))
		elif not GuideMovements.is_passage(movement) and p_is_first and not is_up:
			said.append_array([axis.start(p_sensor), axis.end(p_sensor)])
	return Rotations.mean(said, AGAIN_RAD)
