class_name ClientPlatform
extends Node
## Moves the motion platform of --platform as the seat moves that this client's session sits in.

## How often a seat is looked for, s.
const _PERIOD_S: float = 0.2

var _output: PlatformOutput = PlatformOutput.new()
var _seat: Seat = null
var _waited_s: float = 0.0
var _error: String = ""


func _ready() -> void:
	add_child(_output)


func _process(p_delta: float) -> void:
	_waited_s += p_delta
	if _waited_s < _PERIOD_S:
		return
	_waited_s = 0.0
	if _output.get_sender().get_error() != _error:
		_error = _output.get_sender().get_error()
		Log.error("client", _error)
	if not is_instance_valid(_seat) or not _seat.is_mine():
		_seat = _find_seat()
		_output.seat = _seat


## Begins to send as the options say. Returns what is wrong, or an empty text.
func open(p_options: Options) -> String:
	_output.platform = MotionPlatform.preset(p_options.text("platform-kind"))
	_output.rate = p_options.number("platform-rate")
	return _output.start(PlatformAddress.parse(p_options.text("platform")))


## What is sent.
func get_output() -> PlatformOutput:
	return _output


func _find_seat() -> Seat:
	for node: Node in get_tree().get_nodes_in_group(Interactable.GROUP):
		var seat: Seat = node as Seat
		if seat != null and seat.is_mine():
			return seat
	return null
