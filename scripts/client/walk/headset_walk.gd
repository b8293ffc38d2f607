class_name HeadsetWalk
extends RefCounted
## Walking with a headset on: the left stick walks, up and down of the right one jump and crouch,
## the head says where to look, and the room of the headset is where the feet are.
##
## The wearer's own frame is the recentred tracking space, see [ClientHeadset]. Who steps aside in
## the own room stays there while a stick is used; while it rests the body comes below the head.

## How far the head may be from above the feet, m; how quickly the body follows beyond that, 1/s.
const SLACK_M: float = 0.15
const FOLLOW: float = 3.0
## The eyes are this far down where the wearer crouches, and where not any more, as shares of their
## height.
const CROUCHED: float = 0.7
const UPRIGHT: float = 0.78
## Deflection at which the right stick jumps or crouches.
const _PUSHED: float = 0.7
const _BACK: float = 0.4
## Where eyes are above the feet, m, by [enum WalkerMover.Stance].
const _EYES_M: PackedFloat32Array = [1.65, 1.05, 0.4]

## Whether ahead is where the left hand points, not where the head looks.
var by_hand: bool = false

var _headset: ClientHeadset = null
# How the wearer's own frame is turned in the world, rad, and what of it is above the feet, m.
var _heading: float = 0.0
var _above: Vector3 = Vector3.ZERO
var _feet: Vector3 = Vector3.INF
# Height of the eyes of who stands upright, m; NAN: as they are next.
var _tall_m: float = NAN
var _is_down: bool = false
# How much lower the eyes are in the world than in the room, m, and the stance that it is for.
var _lower_m: float = 0.0
var _stance: int = WalkerMover.STAND
var _is_pushed: bool = false
var _crouches: bool = false
# The wearer's own steps move the body.
var _follows: bool = false
var _sits: bool = false


## Takes the headset, and whether ahead is where the left hand points.
func _init(p_headset: ClientHeadset, p_by_hand: bool) -> void:
	_headset = p_headset
	by_hand = p_by_hand


## Begins where a walker is: ahead in the room is that heading in the world, rad.
func begin(p_heading: float) -> void:
	_heading = p_heading
	_feet = Vector3.INF
	_headset.cut()


## The wearer has been recentred, who looked by a heading in the world, rad: there ahead is now.
func recentre(p_heading: float) -> void:
	_heading = p_heading
	_above = Vector3.ZERO
	_tall_m = NAN
	_headset.cut()


## A frame: tells the controls what the wearer wishes. Takes legs that carry the wearer's own
## motion, or null.
func read(p_controls: WalkerControls, p_legs: WalkedLegs) -> void:
	p_controls.is_worn = true
	var is_off: bool = p_controls.hands_off or _headset.is_menu_open()
	p_controls.stick = Vector2.ZERO if is_off else _headset.stick(0)
	var pad: Vector2 = Input.get_vector(&"look_left", &"look_right", &"look_down", &"look_up")
	_headset.display.stick = Vector2.ZERO if is_off else pad
	_press(p_controls, Vector2.ZERO if is_off else _headset.stick(1))
	var head: Transform3D = _headset.head()
	var gaze: float = Recentring.facing_of(head.basis)
	p_controls.aside = 0.0
	if by_hand and _headset.has_hand(0):
		p_controls.aside = angle_difference(gaze, Recentring.facing_of(_headset.pointer(0).basis))
	if p_legs != null:
		p_legs.ahead = gaze
		return
	p_controls.heading = wrapf(_heading + gaze, -PI, PI)
	p_controls.look = asin(clampf(-head.basis.z.normalized().y, -1.0, 1.0))
	_step_aside(p_controls, head, is_off)
	_note_height(head.origin.y)
	p_controls.is_crouching = p_controls.is_crouching or _is_down


## Ends it: hands have the controls again.
func end(p_controls: WalkerControls) -> void:
	p_controls.is_worn = false
	p_controls.stick = Vector2.ZERO
	p_controls.aside = 0.0
	p_controls.own_steps = Vector2.ZERO
	p_controls.is_jumping = false
	p_controls.is_crouching = false


## Puts the wearer's room where a walker is shown. Call it once a frame.
func find_room(r_place: WearerTransform, p_prediction: WalkerPrediction) -> void:
	_sits = false
	var mover: WalkerMover = p_prediction.mover
	var feet: Vector3 = p_prediction.shown()
	var turn: Basis = Basis(Vector3.UP, _heading)
	if _follows and _feet.is_finite() and feet.distance_to(_feet) < 1.0:
		var moved: Vector3 = turn.inverse() * (feet - _feet)
		_above += Vector3(moved.x, 0.0, moved.z)
	_feet = feet
	if mover.get_stance() != _stance:
		_stance = mover.get_stance()
		var is_own: bool = _is_down and _stance == WalkerMover.CROUCH
		var stands: bool = is_own or _stance == WalkerMover.STAND
		_lower_m = 0.0 if stands else maxf(_headset.head().origin.y - _EYES_M[_stance], 0.0)
	var lifted: Vector3 = Vector3.DOWN * (_lower_m + mover.get_lift())
	r_place.frame = Transform3D(turn, feet + lifted - turn * _above)
	r_place.velocity = Vector3.ZERO if _follows else mover.get_velocity()


## The same where the body sits in the world: the eyes are where those of its head are, and ahead is
## where it faces by a heading, rad.
func find_seat(r_place: WearerTransform, p_head: Transform3D, p_heading: float) -> void:
	if not _sits:
		_sits = true
		_above = _headset.head().origin
	_feet = Vector3.INF
	_heading = p_heading
	var turn: Basis = Basis(Vector3.UP, p_heading)
	r_place.frame = Transform3D(turn, p_head * OrbitCamera.EYES - turn * _above)


## Up jumps, or stands up again; down crouches, and stands up again.
func _press(r_controls: WalkerControls, p_stick: Vector2) -> void:
	var is_upright: bool = absf(p_stick.y) > absf(p_stick.x)
	r_controls.is_jumping = r_controls.is_jumping and p_stick.y > _BACK
	if _is_pushed:
		_is_pushed = absf(p_stick.y) > _BACK
	elif is_upright and absf(p_stick.y) > _PUSHED:
		_is_pushed = true
		r_controls.is_jumping = p_stick.y > 0.0 and not _crouches
		_crouches = p_stick.y < 0.0 and not _crouches
	r_controls.is_crouching = _crouches


## Lets the body come below a head that is elsewhere.
func _step_aside(r_controls: WalkerControls, p_head: Transform3D, p_is_off: bool) -> void:
	var off: Vector3 = p_head.origin - _above
	off.y = 0.0
	var is_away: bool = off.length() > (0.3 * SLACK_M if _follows else SLACK_M)
	_follows = is_away and not p_is_off and not r_controls.goes()
	var wish: Vector3 = Basis(Vector3.UP, _heading) * off * FOLLOW if _follows else Vector3.ZERO
	r_controls.own_steps = Vector2(wish.x, wish.z).limit_length(WalkerControls.JOG)


func _note_height(p_eyes_m: float) -> void:
	if is_nan(_tall_m):
		_tall_m = p_eyes_m
	if _headset.display.recentring.is_seated:
		_is_down = false
	else:
		_is_down = p_eyes_m < _tall_m * (UPRIGHT if _is_down else CROUCHED)
