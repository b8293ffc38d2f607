extends TestCase
## What is taken of a sensor from holds and movements.

const FOREARM: int = BodyMounts.LEFT_FOREARM

var _time_usec: int = 1700000000000000


func test_what_was_held_and_how_still() -> void:
	var holds: Array[PoseHold] = [
		_hold(ResetPose.Kind.T, [0.0, 0.0]), _hold(ResetPose.Kind.N, [20.0, 22.0, 24.0])
	]
	var fit: SensorFit = FitReader.read(0, FOREARM, holds, {})
	equal(fit.sensor, 0)
	equal(fit.mount, FOREARM)
	equal(fit.holds.size(), 2)
	equal(fit.turns.size(), 0)
	equal(fit.holds[1].pose, ResetPose.Kind.N)
	almost_equal(rad_to_deg(Rotations.angle(fit.holds[1].said)), 22.0, 0.1)
	almost_equal(rad_to_deg(fit.holds[0].movement), 0.0, 0.01)
	almost_equal(rad_to_deg(fit.holds[1].movement), 4.0, 0.5)
	equal(FitReader.first_hold(holds, ResetPose.Kind.N), holds[1])
	is_null(FitReader.first_hold(holds.slice(0, 1), ResetPose.Kind.N))


func test_a_sensor_that_was_mostly_silent_was_not_held() -> void:
	var held: PoseHold = PoseHold.new(ResetPose.Kind.T)
	for number: int in 40:
		held.add(_frame(0.0, number % 4 == 0))
	equal(FitReader.read(0, FOREARM, [held], {}).holds.size(), 0)


func test_movements_that_turn_the_mount_show_their_axis() -> void:
	var holds: Array[PoseHold] = [_hold(ResetPose.Kind.N, [0.0])]
	var axes: Dictionary[GuideMovements.Movement, MotionAxis] = {
		GuideMovements.Movement.REACH: _move(-80.0),
		GuideMovements.Movement.SQUAT: _move(-60.0),
	}
	var fit: SensorFit = FitReader.read(0, FOREARM, holds, axes)
	equal(fit.turns.size(), 1, "a squat says nothing of arms")
	almost_equal(fit.turns[0].axis, Vector3.LEFT, 1e-3)
	almost_equal(fit.turns[0].wanted, Vector3.LEFT, 1e-3)
	almost_equal(rad_to_deg(fit.turns[0].angle), 80.0, 1.0)
	almost_equal(fit.turns[0].scatter, 0.0, 1e-2)
	# The way to another pose is none: both its ends are held.
	axes = {GuideMovements.Movement.ARMS: _move(-80.0)}
	equal(FitReader.read(0, FOREARM, holds, axes).turns.size(), 0)


func test_a_movement_that_was_hardly_made_shows_nothing() -> void:
	var axes: Dictionary[GuideMovements.Movement, MotionAxis] = {
		GuideMovements.Movement.REACH: _move(-5.0)
	}
	var holds: Array[PoseHold] = [_hold(ResetPose.Kind.N, [0.0])]
	equal(FitReader.read(0, FOREARM, holds, axes).turns.size(), 0)


func test_the_pose_before_and_after_movements_counts_too() -> void:
	var holds: Array[PoseHold] = [_hold(ResetPose.Kind.N, [0.0])]
	var axes: Dictionary[GuideMovements.Movement, MotionAxis] = {
		GuideMovements.Movement.REACH: _move(-80.0, 3.0)
	}
	# Held once at 0 degrees, twice at 3.
	var fit: SensorFit = FitReader.read(0, FOREARM, holds, axes)
	almost_equal(rad_to_deg(Rotations.angle(fit.holds[0].said)), 2.0, 0.4)
	# Who had moved already did not stand there: that hardly counts.
	axes[GuideMovements.Movement.REACH] = _move(-80.0)
	axes[GuideMovements.Movement.BOW] = _move(-80.0, 40.0)
	fit = FitReader.read(0, FOREARM, holds, axes)
	is_true(rad_to_deg(Rotations.angle(fit.holds[0].said)) < 2.0)


func _hold(p_pose: ResetPose.Kind, p_degrees: Array) -> PoseHold:
	var held: PoseHold = PoseHold.new(p_pose)
	for degrees: float in p_degrees:
		for _number: int in 40:
			held.add(_frame(degrees, true))
	return held


## About the body's X there and back, from an angle on.
func _move(p_deg: float, p_from_deg: float = 0.0) -> MotionAxis:
	var axis: MotionAxis = MotionAxis.new()
	for number: int in 100:
		var part: float = sin(PI * smoothstep(0.2, 0.8, number / 99.0))
		axis.add(_frame(p_from_deg + p_deg * part, true))
	return axis


## One sensor, turned about X.
func _frame(p_deg: float, p_is_present: bool) -> SensorFrame:
	var frame: SensorFrame = SensorFrame.new()
	frame.resize(1)
	_time_usec += 10000
	frame.time_usec = _time_usec
	if p_is_present:
		frame.set_orientation(0, Quaternion(Vector3.RIGHT, deg_to_rad(p_deg)))
	return frame
