class_name WalkerControls
extends Node
## What a user's hands wish who walks: keys and mouse, a gamepad, or the sticks of a headset.
##
## While the mouse is caught it turns the eyes; a click into the window catches it, Esc lets it go.
## Without it the arrow keys and the right stick turn them. A headset says itself where they look.

## Speeds, m/s: walking by keys, the full stick, running; faster, and the body would fall.
const WALK: float = 1.6
const JOG: float = 2.4
const RUN: float = 3.2
## Turn for each pixel of the mouse, rad, and of the keys and the full stick, rad/s.
const MOUSE: float = 0.0025
const TURN_RATE: float = 2.6
## Deflection of a stick below which it rests, a share of its travel.
const _REST: float = 0.15
# What pads press.
const _ACTIONS: Array[StringName] = [
	&"walk_left",
	&"walk_right",
	&"walk_back",
	&"walk_forward",
	&"walk_run",
	&"walk_jump",
	&"walk_crouch",
	&"look_left",
	&"look_right",
	&"look_up",
	&"look_down",
]
## How far up and down the eyes look, rad.
const MAX_LOOK: float = 1.4

## A list that walks instead of hands; null: none.
var list: WalkScript = null
## Whether keys and sticks are used by something else now, such as a menu or a seat.
var hands_off: bool = false
## Where the eyes look: the angle about +Y, rad, 0 towards +Z, and up, rad.
var heading: float = 0.0
var look: float = 0.0
## Whether eyes are a headset's, which sets [member heading] and [member look]: nothing here turns
## them.
var is_worn: bool = false
## The stick in the left hand of a headset's wearer: x right, y ahead, up to 1.
var stick: Vector2 = Vector2.ZERO
## Where ahead is for sticks and keys, from where the eyes look: rad about +Y.
var aside: float = 0.0
## How fast the wearer of a headset goes in the own room, along +X and +Z of the world, m/s.
var own_steps: Vector2 = Vector2.ZERO
## What a headset's wearer wishes besides.
var is_jumping: bool = false
var is_crouching: bool = false

var _is_prone: bool = false
# The stick of the gamepad that was moved last: x right, y back.
var _pad: Vector2 = Vector2.ZERO


func _ready() -> void:
	Input.joy_connection_changed.connect(_on_pad_changed)


func _input(p_event: InputEvent) -> void:
	var motion: InputEventJoypadMotion = p_event as InputEventJoypadMotion
	if motion != null and motion.axis in [JOY_AXIS_LEFT_X, JOY_AXIS_LEFT_Y]:
		_pad[motion.axis] = motion.axis_value


func _unhandled_input(p_event: InputEvent) -> void:
	var motion: InputEventMouseMotion = p_event as InputEventMouseMotion
	if motion != null and Input.mouse_mode == Input.MOUSE_MODE_CAPTURED and not hands_off:
		if not is_worn:
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
	if not hands_off and not is_worn:
		_turn(p_delta_s)
	input.heading = heading
	input.look = look
	if hands_off:
		return input
	var speed: float = WALK if _pad.length() < _REST else JOG
	var way: Vector2 = _way()
	if stick.length() > _REST:
		way = stick.normalized() * inverse_lerp(_REST, 1.0, minf(stick.length(), 1.0))
		speed = JOG
	if Input.is_action_pressed(&"walk_run"):
		speed = RUN
	input.wish = WalkerInput.to_world(way.y * speed, way.x * speed, heading + aside) + own_steps
	input.jumps = is_jumping or Input.is_action_pressed(&"walk_jump")
	if input.jumps:
		_is_prone = false
	if _is_prone:
		input.stance = WalkerMover.PRONE
	elif is_crouching or Input.is_action_pressed(&"walk_crouch"):
		input.stance = WalkerMover.CROUCH
	return input


## Whether a stick or keys say where to go.
func goes() -> bool:
	return not hands_off and (_way() != Vector2.ZERO or stick.length() > _REST)


## What keys or the stick of a gamepad say: x right, y ahead, up to 1.
func _way() -> Vector2:
	if _pad.length() >= _REST:
		return Input.get_vector(&"walk_left", &"walk_right", &"walk_back", &"walk_forward")
	# Each with its own dead zone: a stick that rests does not turn the way of keys.
	var right: float = Input.get_axis(&"walk_left", &"walk_right")
	return Vector2(right, Input.get_axis(&"walk_back", &"walk_forward")).limit_length()


func _turn(p_delta_s: float) -> void:
	var turn: Vector2 = Input.get_vector(&"look_left", &"look_right", &"look_down", &"look_up")
	heading = wrapf(heading - turn.x * TURN_RATE * p_delta_s, -PI, PI)
	look = clampf(look + turn.y * TURN_RATE * p_delta_s, -MAX_LOOK, MAX_LOOK)


## Nobody lets go of a stick that is gone: the engine keeps its actions as they were.
func _on_pad_changed(_device: int, p_is_there: bool) -> void:
	if p_is_there:
		return
	_pad = Vector2.ZERO
	for action: StringName in _ACTIONS:
		Input.action_release(action)
