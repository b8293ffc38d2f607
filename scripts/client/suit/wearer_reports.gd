class_name WearerReports
extends RefCounted
## Reports this client's suit to the server, and the outcome of the calibrations that instructors
## order: see [WearerMessage].

## Seconds between two reports about the suit.
const PERIOD_S: float = 1.0

var _link: ClientLink = null
var _mocap: MocapSetup = null
var _reported: String = ""
var _due_s: float = 0.0
var _now_s: float = 0.0


func _init(p_link: ClientLink, p_mocap: MocapSetup) -> void:
	_link = p_link
	_mocap = p_mocap
	_link.joined.connect(_on_joined)
	_link.calibration_asked.connect(_calibrate)


## Reports the suit if its state has changed; call it in every frame with the time, s.
func advance(p_now_s: float) -> void:
	_now_s = p_now_s
	if p_now_s < _due_s or not _link.is_joined():
		return
	_due_s = p_now_s + PERIOD_S
	var text: String = ByteReader.clean(_mocap.inputs.describe()).left(WearerMessage.MAX_TEXT)
	if text != _reported:
		_reported = text
		_link.send_reliably(WearerMessage.encode(0, true, text))


## Calibrates one of the people, as an instructor asks, and reports the outcome.
func _calibrate(p_index: int, p_kind: int, p_number: int) -> void:
	_mocap.calibrate(
		p_index,
		p_kind,
		_now_s,
		func(accepted: bool, text: String) -> void:
			_link.send_reliably(WearerMessage.encode(p_number, accepted, text))
	)


func _on_joined() -> void:
	_reported = ""
