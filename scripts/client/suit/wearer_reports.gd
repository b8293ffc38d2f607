class_name WearerReports
extends RefCounted
## Reports this client's suit to the server, and the outcome of the calibrations that instructors
## order: see [WearerMessage].

## Seconds between two reports about the suit.
const PERIOD_S: float = 1.0

var _link: ClientLink = null
var _inputs: MotionInputs = null
var _calibrate: Callable = Callable()
var _reported: String = ""
var _due_s: float = 0.0
var _now_s: float = 0.0


## Reports about motion inputs. [param p_calibrate] calibrates one of the people: see
## [method MocapSetup.calibrate].
func _init(p_link: ClientLink, p_inputs: MotionInputs, p_calibrate: Callable) -> void:
	_link = p_link
	_inputs = p_inputs
	_calibrate = p_calibrate
	_link.joined.connect(_on_joined)
	_link.calibration_asked.connect(_on_calibration_asked)


## Reports the suit if its state has changed; call it in every frame with the time, s.
func advance(p_now_s: float) -> void:
	_now_s = p_now_s
	if p_now_s < _due_s or not _link.is_joined():
		return
	_due_s = p_now_s + PERIOD_S
	var text: String = ByteReader.clean(_inputs.describe()).left(WearerMessage.MAX_TEXT)
	if text != _reported:
		_reported = text
		_link.send_reliably(WearerMessage.encode(0, true, text))


## Calibrates one of the people, as an instructor asks, and reports the outcome.
func _on_calibration_asked(p_index: int, p_kind: int, p_number: int) -> void:
	_calibrate.call(
		p_index,
		p_kind,
		_now_s,
		func(accepted: bool, text: String) -> void:
			_link.send_reliably(WearerMessage.encode(p_number, accepted, text))
	)


func _on_joined() -> void:
	_reported = ""
