extends CalibrationSolver
## Calibrates somebody of whom it is told how far poses, movements and norths usually are off, and
## in which way, but not how far they are this time: as good as a calibration and its forecast can
## be, with errors taken as normal.

var _pose_rad: float = 0.0
var _askew_rad: float = 0.0
var _norths_deg: float = 0.0
var _is_anew: bool = false
var _is_hinged: bool = false


## One in the place of another, for a person.gd.
static func of(p_other: CalibrationSolver, p_person: Object) -> CalibrationSolver:
	var script: GDScript = load("res://tests/bench/calibration/knowing_solver.gd")
	var found: CalibrationSolver = script.new()
	found.holds = p_other.holds
	found.axes = p_other.axes
	found.sensors = p_other.sensors
	found.mounts = p_other.mounts
	found.options = p_other.options
	found.old = p_other.old
	# An angle that is even to either side about any axis: its deviation about each of three.
	found._pose_rad = deg_to_rad(p_person.poses_deg) / 3.0
	found._askew_rad = deg_to_rad(p_person.askew_deg)
	found._norths_deg = p_person.norths_deg / (1.0 if p_person.is_normal else sqrt(3.0))
	found._is_anew = p_person.is_anew
	found._is_hinged = p_person.motion.is_hinged
	return found


func _solve_all() -> void:
	var off: float = _pose_rad * _pose_rad
	var is_again: bool = _is_anew and holds.size() > 2
	_model.arms = WearerModel.FLOOR if is_again else off
	_model.rest = _model.arms
	_model.arms_again = off if is_again else 0.0
	_model.rest_again = _model.arms_again
	_model.askew = _askew_rad * _askew_rad
	_model.hinge = 1.0 if _is_hinged else 0.0
	_model.hinge_variance = 0.0
	super()


func _learn() -> void:
	pass


## The known spread, between the two of the finder's that are nearest.
func _usual_spreads() -> PackedFloat64Array:
	if options.align != CalibrationOptions.Align.AUTO:
		return super()
	var found: PackedFloat64Array = PackedFloat64Array()
	found.resize(NorthFinder.SPREADS_DEG.size())
	var at: int = NorthFinder.SPREADS_DEG.bsearch(_norths_deg, false) - 1
	var below: float = NorthFinder.SPREADS_DEG[at]
	var above: float = NorthFinder.SPREADS_DEG[at + 1]
	var part: float = (_norths_deg - below) / (above - below) if is_finite(above) else 0.0
	found[at] = 1.0 - part
	found[at + 1] = part
	return found
