class_name DriveScript
extends RefCounted
## Drives by a list instead of by hand: for clients without a user, and for tests.

## Why the list is invalid, or an empty text.
var error: String = ""

## Of each part: throttle, steering, brake, and for how long, s.
var _parts: Array[PackedFloat32Array] = []
var _elapsed_s: float = 0.0


## Reads a list such as [code]1:0:0:5,0:0.5:0:3,0:0:1:2[/code]: of each part throttle (-1 to 1),
## steering (-1 right to 1 left), brake (0 to 1) and for how long (s). The last part lasts.
static func parse(p_text: String) -> DriveScript:
	var made: DriveScript = DriveScript.new()
	for part: String in p_text.split(",", false):
		var numbers: PackedFloat32Array = []
		for word: String in part.strip_edges().split(":"):
			numbers.append(word.to_float() if word.is_valid_float() else NAN)
		var is_sound: bool = numbers.size() == 4 and is_finite(numbers[3]) and numbers[3] > 0.0
		for index: int in mini(numbers.size(), 3):
			# A comparison that NaN fails, too.
			is_sound = is_sound and numbers[index] >= -1.0 and numbers[index] <= 1.0
		if not is_sound:
			made.error = (
				"--drive is THROTTLE:STEERING:BRAKE:SECONDS, and more of them; found '%s'" % part
			)
			return made
		made._parts.append(numbers)
	if made._parts.is_empty():
		made.error = "--drive is THROTTLE:STEERING:BRAKE:SECONDS, and more of them; found nothing"
	return made


## Goes on by a time, s.
func advance(p_delta: float) -> void:
	_elapsed_s += p_delta


## Begins again.
func restart() -> void:
	_elapsed_s = 0.0


## Reads what is due now into an input.
func read(p_input: VehicleInput) -> void:
	var left: float = _elapsed_s
	var now: PackedFloat32Array = _parts[-1]
	for part: PackedFloat32Array in _parts:
		if left < part[3]:
			now = part
			break
		left -= part[3]
	p_input.throttle = now[0]
	p_input.steer = now[1]
	p_input.brake = now[2]
	p_input.handbrake = 0.0
