class_name ClientCues
extends Node
## What this client's user feels of the vehicle in which the session sits: the motion platform of
## --platform, rumble, the forces of a wheel.

## How often a seat is looked for, s.
const _PERIOD_S: float = 0.2

var _platform: PlatformOutput = PlatformOutput.new()
var _forces: ForceFeedback = ForceFeedback.new()
var _seat: Seat = null
var _waited_s: float = 0.0
var _error: String = ""


func _ready() -> void:
	add_child(_platform)
	add_child(_forces)


func _process(p_delta: float) -> void:
	_waited_s += p_delta
	if _waited_s < _PERIOD_S:
		return
	_waited_s = 0.0
	var error: String = _platform.get_sender().get_error()
	if error != _error:
		_error = error
		Log.error("client", error)
	if not is_instance_valid(_seat) or not _seat.is_mine():
		_take(_find_seat())


## Begins as the options say. Returns what is wrong, or an empty text.
func open(p_options: Options) -> String:
	var has_window: bool = DisplayServer.get_name() != "headless"
	_forces.process_mode = (
		Node.PROCESS_MODE_ALWAYS
		if p_options.is_on("force-feedback") and has_window
		else Node.PROCESS_MODE_DISABLED
	)
	if p_options.text("platform") == "":
		return ""
	_platform.platform = MotionPlatform.preset(p_options.text("platform-kind"))
	_platform.rate = p_options.number("platform-rate")
	return _platform.start(PlatformAddress.parse(p_options.text("platform")))


## Rumble and wheel, for jolts that no motion shows.
func get_forces() -> ForceFeedback:
	return _forces


## Adds the motion platform's present pose, as commanded, to the headset's frame.
func tell_platform(p_frame: PlatformFrame) -> void:
	var sender: PlatformSender = _platform.get_sender()
	# Without a seat the platform goes back to its middle; it still moves on the way there.
	if _platform.platform != null:
		p_frame.push_cue(Time.get_ticks_usec(), sender.get_position(), sender.get_attitude())


func _take(p_seat: Seat) -> void:
	_seat = p_seat
	_platform.seat = p_seat
	_forces.seat = p_seat
	var vehicle: Vehicle = Vehicle.find_above(p_seat)
	_forces.state = vehicle.state if vehicle != null else null


func _find_seat() -> Seat:
	for node: Node in get_tree().get_nodes_in_group(Interactable.GROUP):
		var seat: Seat = node as Seat
		if seat != null and seat.is_mine():
			return seat
	return null
