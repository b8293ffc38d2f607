class_name WalkerControls
extends Node
## What a user's hands wish who walks: keys and mouse, or a gamepad.
##
## While the mouse is caught it turns the eyes; a click into the window catches it, Esc lets it go.
## Without it the arrow keys and the right stick turn them.

## Speeds, m/s: walking by keys, the full stick, running; faster, and the body would fall.
const WALK: float = 1.6
const JOG: float = 2.4
const RUN: float = 3.2
## Turn for each pixel of the mouse, rad, and of the keys and the full stick, rad/s.
const MOUSE: float = 0.0025
const TURN_RATE: float = 2.6
## How far up and down the eyes look, rad.
const MAX_LOOK: float = 1.4

## A list that walks instead of hands; null: none.
var list: WalkScript = null
## Whether keys and sticks are used by something else now, such as a menu or a seat.
var hands_off: bool = false
## Where the eyes look: the angle about +Y, rad, 0 towards +Z, and up, rad.
var heading: float = 0.0
var look: float = 0.0

var _is_prone: bool = false


func _unhandled_input(p_event: InputEvent) -> void:
	var motion: InputEventMouseMotion = p_event as InputEventMouseMotion
	if motion != null and Input.mouse_mode == Input.MOUSE_MODE_CAPTURED and not hands_off:
		heading = wrapf(heading - motion.relative.x * MOUSE, -PI, PI)
		look = clampf(look - motion.relative.y * MOUSE, -MAX_LOOK, MAX_LOOK)
		get_viewport().set_input_as_handled()
	elif p_event.is_action_pressed(&"walk_prone") and not hands_off:
		_is_prone = not _is_prone
		get_viewport().set_input_as_handled()


## What is wished now, after a time, s.
func read(p_delta_s: float) -> WalkerInput:
	if list != null:
		var listed: WalkerInput = list.advance(p_delta_s)
		heading = listed.heading
		return listed
	var input: WalkerInput = WalkerInput.new()
	input.heading = heading
	input.look = look
	if hands_off:
		return input
	var turn: Vector2 = Input.get_vector(&"look_left", &"look_right", &"look_down", &"look_up")
	heading = wrapf(heading - turn.x * TURN_RATE * p_delta_s, -PI, PI)
	look = clampf(look + turn.y * TURN_RATE * p_delta_s, -MAX_LOOK, MAX_LOOK)
	var way: Vector2 = Input.get_vector(&"walk_left", &"walk_right", &"walk_back", &"walk_forward")
	var speed: float = RUN if Input.is_action_pressed(&"walk_run") else WALK
	if speed < JOG and _is_stick():
		speed = JOG
	input.heading = heading
	input.look = look
	input.wish = WalkerInput.to_world(way.y * speed, way.x * speed, heading)
	input.jumps = Input.is_action_pressed(&"walk_jump")
	if input.jumps:
		_is_prone = false
	if _is_prone:
		input.stance = WalkerMover.PRONE
	elif Input.is_action_pressed(&"walk_crouch"):
		input.stance = WalkerMover.CROUCH
	return input


## Whether a stick says where to go: it has a speed of its own.
static func _is_stick() -> bool:
	for pad: int in Input.get_connected_joypads():
		var stick: Vector2 = Vector2(
			Input.get_joy_axis(pad, JOY_AXIS_LEFT_X), Input.get_joy_axis(pad, JOY_AXIS_LEFT_Y)
		)
		if stick.length() > 0.2:
			return true
	return false
