class_name ClientCalibration
extends RefCounted
## Calibrations without the device panel: at the start, or because an instructor asks for one
## (thesis section 6.1). The wearer is guided by texts on the screen.

## Kinds that options name.
const KINDS: Dictionary[String, CalibrationGuide.Kind] = {
	"t_pose": CalibrationGuide.Kind.T_POSE,
	"n_pose": CalibrationGuide.Kind.N_POSE,
	"t_to_n": CalibrationGuide.Kind.T_TO_N,
	"full": CalibrationGuide.Kind.FULL,
	"quick": CalibrationGuide.Kind.QUICK,
}
## What [method orders] gives for the headings alone, see [method reset_heading].
const HEADING: int = 6
## How long the outcome is shown, s.
const _SHOWN_S: float = 6.0
const _MAX_ADVICE: int = 3

var _source: SuitSource = null
var _store: CalibrationStore = CalibrationStore.new()
# Receives the outcome: func(accepted: bool, text: String), or none.
var _answer: Callable = Callable()
var _outcome: String = ""
var _until_s: float = 0.0
# The time of the last call, s.
var _now_s: float = 0.0


## What instructors may ask for by name: all of [constant KINDS], and [constant HEADING].
static func orders() -> Dictionary[String, int]:
	var found: Dictionary[String, int] = {}
	found.assign(KINDS)
	found["heading"] = HEADING
	return found


## Begins one at a time, s. Returns why it cannot, or an empty text; then the outcome goes to
## [code]func(accepted: bool, text: String)[/code] too.
func start(
	p_source: SuitSource,
	p_kind: CalibrationGuide.Kind,
	p_now_s: float,
	p_answer: Callable = Callable()
) -> String:
	_now_s = p_now_s
	if p_source.process.is_running() or is_running():
		return "another calibration is going on"
	if _source != null:
		forget(_source)  # Somebody ended it at the panel.
	var fault: String = p_source.start_calibration(p_kind, p_now_s)
	if fault == "":
		_source = p_source
		_answer = p_answer
		_source.calibrated.connect(_on_calibrated, CONNECT_ONE_SHOT)
		Log.info("mocap", "calibrating (%s)" % CalibrationGuide.NAMES[p_kind])
	return fault


## Sets the headings of a wearer's sensors anew, at once, while the wearer stands and looks ahead.
## The outcome goes to [code]func(accepted: bool, text: String)[/code] too.
func reset_heading(p_source: SuitSource, p_now_s: float, p_answer: Callable = Callable()) -> void:
	var fault: String = "another calibration is going on"
	if not p_source.process.is_running():
		fault = p_source.reset_heading()
	var outcome: String = "Headings reset" if fault == "" else "Headings not reset: " + fault
	say(outcome, p_now_s)
	Log.info("mocap", outcome)
	if p_answer.is_valid():
		p_answer.call(fault == "", outcome)


## Drops the calibration of a wearer who has gone.
func forget(p_source: SuitSource) -> void:
	if _source == p_source:
		_source.calibrated.disconnect(_on_calibrated)
		_source = null
		_conclude(false, "not calibrated: it was ended at the suit")


## Whether one is in progress.
func is_running() -> bool:
	return _source != null and _source.process.is_running()


## Shows a text on the screen for a while, from a time on, s.
func say(p_text: String, p_now_s: float) -> void:
	_outcome = p_text
	_until_s = p_now_s + _SHOWN_S


## What the wearer is to see at a time, s; mostly nothing.
func text(p_now_s: float) -> String:
	_now_s = p_now_s
	if _source != null and _source.process.is_running():
		var process: CalibrationProcess = _source.process
		return "%s\n%d" % [process.instruction(), ceili(process.seconds_left)]
	return _outcome if p_now_s < _until_s else ""


## The wearer has no hand free to answer: a good result is accepted, with advice on what could be
## better; otherwise the previous calibration stays.
func _on_calibrated(p_result: CalibrationResult) -> void:
	var source: SuitSource = _source
	_source = null
	var advice: String = "; ".join(p_result.advice.slice(0, _MAX_ADVICE))
	var fault: String = p_result.error
	if fault == "" and not p_result.is_acceptable():
		fault = advice if advice != "" else p_result.describe()
	if fault != "":
		source.refuse_calibration()
		say("Not calibrated:\n" + fault.replace("; ", "\n"), _now_s)
		Log.warning("mocap", "not calibrated: " + fault)
		_conclude(false, "not calibrated: " + fault)
		return
	source.accept_calibration()
	say("Calibrated\n" + advice.replace("; ", "\n"), _now_s)
	var outcome: String = p_result.describe() + (": " + advice if advice != "" else "")
	Log.info("mocap", outcome)
	_conclude(true, outcome)
	if not _store.write(source.get_profile()):
		Log.warning("mocap", _store.error)


func _conclude(p_accepted: bool, p_text: String) -> void:
	var answer: Callable = _answer
	_answer = Callable()
	if answer.is_valid():
		answer.call(p_accepted, p_text)
