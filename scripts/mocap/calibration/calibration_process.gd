class_name CalibrationProcess
extends RefCounted
## Runs a calibration step by step: instructions for the screen, and the measurement.
##
## Times and frames are passed in. The present calibration stays in use until the caller accepts
## [member result].

## A step began, or everything ended.
signal phase_changed(p_phase: Phase)
## There is a [member result].
signal finished

## The present stage.
enum Phase {
	## Nothing.
	IDLE,
	## Time to get ready.
	COUNTDOWN,
	## A pose is held.
	HOLD,
	## A movement is made.
	MOVE,
	## There is a result that has not been accepted or refused yet.
	DONE,
}

## Span over which movement is shown live, s.
const LIVE_S: float = 0.5

## The present stage.
var phase: Phase = Phase.IDLE
## The kind that runs or ran.
var kind: CalibrationGuide.Kind = CalibrationGuide.Kind.T_POSE
## How it is done; may be changed before [method start].
var options: CalibrationOptions = CalibrationOptions.new()
## Seconds that are left of this step.
var seconds_left: float = 0.0
## The result, or null.
var result: CalibrationResult = null
## How far each sensor moved in the last [constant LIVE_S], degrees, by sensor.
var live_deg: PackedFloat32Array = PackedFloat32Array()

var _solver: CalibrationSolver = null
var _steps: Array[CalibrationGuide.Step] = []
var _step: int = -1
var _ends_s: float = 0.0
var _recent: Array[SensorFrame] = []


## Begins, at a time in s of any clock. [param p_mounts] has a mount for each sensor, -1 for none.
## Returns why it cannot, or an empty text.
func start(
	p_kind: CalibrationGuide.Kind,
	p_sensors: Array[SensorInfo],
	p_mounts: PackedInt32Array,
	p_old: Calibration,
	p_now_s: float
) -> String:
	if p_sensors.is_empty() or p_sensors.size() != p_mounts.size():
		return "there are no sensors to calibrate"
	if _worn(p_mounts).is_empty():
		return "no sensor has a mount on the body"
	kind = p_kind
	result = null
	_solver = CalibrationSolver.new()
	_solver.sensors = p_sensors
	_solver.mounts = p_mounts
	_solver.options = options
	_solver.old = p_old
	_steps = CalibrationGuide.steps(p_kind, options.pose, _worn(p_mounts))
	if options.ready_s > CalibrationGuide.COUNTDOWN_S and not _steps[0].is_countdown:
		_steps.push_front(CalibrationGuide.countdown(_steps[0].pose))
	if _steps[0].is_countdown:
		_steps[0].duration_s = options.ready_s
	_step = -1
	_ends_s = p_now_s
	_next_step()
	seconds_left = _ends_s - p_now_s
	return ""


## Stops without a result.
func cancel() -> void:
	result = null
	_set_phase(Phase.IDLE)


## Whether steps are still to come.
func is_running() -> bool:
	return phase == Phase.COUNTDOWN or phase == Phase.HOLD or phase == Phase.MOVE


## The present instruction to the wearer.
func instruction() -> String:
	if is_running():
		return _steps[_step].text()
	return ""


## The present step, or null.
func current_step() -> CalibrationGuide.Step:
	return _steps[_step] if is_running() else null


## How much of the present step has passed, 0 to 1.
func step_part() -> float:
	if not is_running():
		return 1.0
	return clampf(1.0 - seconds_left / maxf(_steps[_step].duration_s, 1e-3), 0.0, 1.0)


## Progress, 0 to 1.
func progress() -> float:
	if not is_running():
		return 1.0 if phase == Phase.DONE else 0.0
	var left: float = seconds_left
	for later: int in range(_step + 1, _steps.size()):
		left += _steps[later].duration_s
	var whole: float = 0.0
	for step: CalibrationGuide.Step in _steps:
		whole += step.duration_s
	return clampf(1.0 - left / whole, 0.0, 1.0)


## Takes a frame that was measured in the step that runs.
func add_frame(p_frame: SensorFrame) -> void:
	_watch(p_frame)
	if not is_running() or _step < 0:
		return
	var step: CalibrationGuide.Step = _steps[_step]
	if phase == Phase.HOLD:
		_solver.holds[-1].add(p_frame)
	elif phase == Phase.MOVE:
		_solver.axes[step.movement].add(p_frame)


## Goes on to a time, s of the clock that [method start] had.
func advance(p_now_s: float) -> void:
	while is_running() and p_now_s >= _ends_s:
		if _step + 1 < _steps.size():
			_next_step()
		else:
			_finish()
	seconds_left = maxf(_ends_s - p_now_s, 0.0) if is_running() else 0.0


## Forgets the result: it was accepted or refused.
func close() -> void:
	if phase == Phase.DONE:
		result = null
		_set_phase(Phase.IDLE)


func _next_step() -> void:
	_step += 1
	var step: CalibrationGuide.Step = _steps[_step]
	_ends_s += step.duration_s
	if step.is_countdown:
		_set_phase(Phase.COUNTDOWN)
	elif step.movement != GuideMovements.Movement.NONE:
		_solver.axes[step.movement] = MotionAxis.new()
		_set_phase(Phase.MOVE)
	else:
		_solver.holds.append(PoseHold.new(step.pose))
		_set_phase(Phase.HOLD)


func _finish() -> void:
	if kind == CalibrationGuide.Kind.FIT_CHECK:
		result = FitCheck.judge(_solver.sensors, _solver.mounts, _solver.axes)
	else:
		result = _solver.solve(kind, Time.get_unix_time_from_system())
	_set_phase(Phase.DONE)
	finished.emit()


func _set_phase(p_phase: Phase) -> void:
	phase = p_phase
	phase_changed.emit(p_phase)


static func _worn(p_mounts: PackedInt32Array) -> PackedInt32Array:
	var worn: PackedInt32Array = p_mounts.duplicate()
	while worn.has(-1):
		worn.remove_at(worn.find(-1))
	return worn


func _watch(p_frame: SensorFrame) -> void:
	_recent.append(p_frame)
	while p_frame.time_usec - _recent[0].time_usec > LIVE_S * 1e6 or _recent.size() > 240:
		_recent.pop_front()
	var first: SensorFrame = _recent[0]
	live_deg.resize(p_frame.count())
	for sensor: int in p_frame.count():
		var known: bool = p_frame.present[sensor] != 0 and sensor < first.count()
		if known and first.present[sensor] != 0:
			live_deg[sensor] = Rotations.between_deg(
				first.orientation(sensor), p_frame.orientation(sensor)
			)
