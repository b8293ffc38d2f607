class_name FitSolver
extends RefCounted
## Finds the heading and the mounting of a sensor that explain a [SensorFit] best, for what a
## [WearerModel] expects of the wearer: Gauss-Newton on the rotations.

## Iterations: errors are small angles, so a few do.
const _ROUNDS: int = 3
## Standard deviation of a heading of which nothing is known, rad.
const _ANY_RAD: float = 30.0


## Finds both, the heading being free.
static func solve(p_fit: SensorFit, p_model: WearerModel) -> void:
	for _round: int in _ROUNDS:
		var found: PackedFloat64Array = _step(p_fit, p_model, NAN)
		p_fit.heading_variance = found[15]
		p_fit.coupling = Vector3(found[3], found[7], found[11]) / found[15]
	if p_fit.heading_variance > _ANY_RAD:
		# The weak guess that keeps the equations solvable is all that there is.
		p_fit.heading_variance = INF


## Finds the mounting for a heading.
static func solve_for(p_fit: SensorFit, p_model: WearerModel, p_heading: float) -> void:
	p_fit.mounting = (
		Rotations.from_vector(-p_fit.coupling * angle_difference(p_fit.heading, p_heading))
		* p_fit.mounting
	)
	p_fit.heading = p_heading
	p_fit.mounting_covariance.resize(9)
	for _round: int in _ROUNDS:
		var found: PackedFloat64Array = _step(p_fit, p_model, p_fit.heading)
		p_fit.heading = p_heading
		for row: int in 3:
			for column: int in 3:
				p_fit.mounting_covariance[row * 3 + column] = found[row * 4 + column]


## One step of Gauss and Newton. The unknowns are the mounting's turn, in the limb's axes, and the
## heading's. Returns their covariance.
static func _step(p_fit: SensorFit, p_model: WearerModel, p_heading: float) -> PackedFloat64Array:
	var equations: NormalEquations = NormalEquations.new(4)
	for held: SensorFit.Hold in p_fit.holds:
		_add_hold(equations, p_fit, held, p_model)
	var start: SensorFit.Hold = p_fit.hold(ResetPose.Kind.N)
	for turn: SensorFit.Turn in p_fit.turns:
		_add_turn(equations, p_fit, turn, start, p_model)
	var known: bool = not is_nan(p_heading)
	equations.add([0.0, 0.0, 0.0, 1.0], 0.0, 1e-10 if known else _ANY_RAD * _ANY_RAD)
	var covariance: PackedFloat64Array = equations.covariance()
	var by: PackedFloat64Array = equations.solution(covariance)
	p_fit.mounting = (
		(Rotations.from_vector(-Vector3(by[0], by[1], by[2])) * p_fit.mounting).normalized()
	)
	p_fit.heading += by[3]
	return covariance


static func _add_hold(
	r_equations: NormalEquations, p_fit: SensorFit, p_hold: SensorFit.Hold, p_model: WearerModel
) -> void:
	var off: Vector3 = p_fit.fault(p_hold)
	var up: Vector3 = ResetPose.rotation(p_hold.pose, p_fit.mount).inverse() * Vector3.UP
	var variance: Vector3 = p_model.pose_variance(p_fit, p_hold)
	for part: int in 3:
		var row: PackedFloat64Array = [0.0, 0.0, 0.0, -up[part]]
		row[part] = 1.0
		r_equations.add(row, -off[part], variance[part])


static func _add_turn(
	r_equations: NormalEquations,
	p_fit: SensorFit,
	p_turn: SensorFit.Turn,
	p_start: SensorFit.Hold,
	p_model: WearerModel
) -> void:
	var off: Vector2 = p_fit.deviation(p_turn)
	var variance: float = p_model.axis_variance(p_turn)
	var hinge: float = p_model.hinge if p_start != null else 0.0
	var side: Vector3 = p_turn.wanted.cross(Vector3.UP)
	var around: Vector3 = Vector3.ZERO
	var across: Vector3 = Vector3.ZERO
	var start: Vector3 = Vector3.ZERO
	if p_start != null:
		var asked: Quaternion = ResetPose.rotation(p_start.pose, p_fit.mount)
		start = p_fit.fault(p_start)
		around = asked.inverse() * Vector3.UP * hinge
		across = asked.inverse() * side * hinge
		variance += p_model.hinge_variance * start.length_squared() / 3.0
	r_equations.add(
		[around.x, around.y, around.z, 1.0 - hinge], off.x - around.dot(start), variance
	)
	r_equations.add([across.x, across.y, across.z, 0.0], off.y - across.dot(start), variance)
