class_name WalkScript
extends RefCounted
## Walks by a list instead of by hand: for clients without a user, and for tests.

## How the list is written.
const FORM: String = "AHEAD:RIGHT:TURN:SECONDS[:jump|crouch|prone]"

## Why the list is invalid, or an empty text.
var error: String = ""

## Of each part: velocity ahead and to the right, m/s, turn to the left, rad/s, and for how long, s.
var _parts: Array[PackedFloat32Array] = []
var _moves: PackedStringArray = []
var _elapsed_s: float = 0.0
var _heading: float = 0.0


## Reads a list such as [code]1.5:0:0:3,0:0:90:1:crouch[/code]: of each part the velocity ahead and
## to the right (m/s), the turn to the left (deg/s), for how long (s), and perhaps what else. The
## last part lasts.
static func parse(p_text: String) -> WalkScript:
	var made: WalkScript = WalkScript.new()
	for part: String in p_text.split(",", false):
		var words: PackedStringArray = part.strip_edges().split(":")
		var numbers: PackedFloat32Array = []
		for word: String in words.slice(0, 4):
			numbers.append(word.to_float() if word.is_valid_float() else NAN)
		var move: String = words[4] if words.size() == 5 else ""
		var is_sound: bool = numbers.size() == 4 and words.size() < 6 and numbers[3] > 0.0
		for number: float in numbers:
			is_sound = is_sound and absf(number) < 1e6
		if not is_sound or not move in ["", "jump", "crouch", "prone"]:
			made.error = "--walk is %s, and more of them; found '%s'" % [FORM, part.left(60)]
			return made
		numbers[2] = deg_to_rad(numbers[2])
		made._parts.append(numbers)
		made._moves.append(move)
	if made._parts.is_empty():
		made.error = "--walk is %s, and more of them; found nothing" % FORM
	return made


## Begins to turn from a heading, rad.
func begin(p_heading: float) -> void:
	_heading = p_heading


## Goes on by a time, s, and says what is wished then.
func advance(p_delta_s: float) -> WalkerInput:
	_elapsed_s += p_delta_s
	var left: float = _elapsed_s
	var at: int = 0
	while at < _parts.size() - 1 and left > _parts[at][3]:
		left -= _parts[at][3]
		at += 1
	var now: PackedFloat32Array = _parts[at]
	_heading = wrapf(_heading + now[2] * p_delta_s, -PI, PI)
	var input: WalkerInput = WalkerInput.new()
	input.heading = _heading
	input.wish = WalkerInput.to_world(now[0], now[1], _heading)
	input.jumps = _moves[at] == "jump"
	var stances: Dictionary[String, WalkerMover.Stance] = {
		"crouch": WalkerMover.CROUCH, "prone": WalkerMover.PRONE
	}
	input.stance = stances.get(_moves[at], WalkerMover.STAND)
	return input
