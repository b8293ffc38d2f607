class_name SeatedHips
extends RefCounted
## Computes where in a seat the hips of its occupant should be, from what the wearer does: there is
## no room to walk, and the arms are folded before the hips go down into a hatch.
##
## Positions are in the person's own frame, whose origin is below the middle of the seat, m.

## Time constant with which an occupant who has moved returns to the middle, s.
const RECENTRE_S: float = 2.0
## Greatest step of the hips up or down from one sample to the next, and into the hatch, m.
const MAX_RISE_M: float = 0.1
const MAX_SINK_M: float = 0.025
## Depth of the wanted hips below the rim from which on the wearer ducks, and below which the wearer
## has come up again, m.
const DUCK_DEPTH_M: float = 0.25
const RISE_DEPTH_M: float = 0.15
## Time to fold the arms, s, and the factor on it until the arms have followed.
const FOLD_S: float = 0.4
const FOLD_WAIT_FACTOR: float = 1.7
## Greatest distance of the hips from the middle of the hatch, m: shoulders fill it.
const MAX_HATCH_OFFSET_M: float = 0.02

## Target position of the hips.
var place: Vector3 = Vector3.ZERO
## Whether the arms are folded and the hips may go down into the well.
var is_ducked: bool = false

var _hold: SeatHold = null
## Position of the wearer at which the hips are in the middle of their room.
var _middle: Vector3 = Vector3.ZERO
## Height of the chair's hips, m.
var _chair: float = 0.0
## How far the arms are folded; 1 is all the way.
var _folded: float = 0.0
var _is_seated: bool = false


func _init(p_hold: SeatHold, p_height: float) -> void:
	_hold = p_hold
	place = Vector3(0.0, p_height, 0.0)


## The occupant takes the seat, with the wearer at a position. Returns the height of a sitting
## person's hips above the frame's origin; 0 of a standing one.
func sit(p_root: Vector3) -> float:
	_is_seated = true
	_middle = p_root
	_chair = 0.0 if stands() else place.y
	return _chair


## The occupant is on the way out.
func leave() -> void:
	_is_seated = false


## Whether the occupant stands.
func stands() -> bool:
	return _hold.legs != SeatHold.Legs.SITTING


## How far the arms are folded, 0 to 1.
func folded() -> float:
	return minf(_folded, 1.0)


## Takes the wearer's position. Returns that of the body.
func put(p_root: Vector3) -> Vector3:
	if not _is_seated:
		place = Vector3(0.0, p_root.y, 0.0)
		return place
	var off: Vector3 = p_root - _middle
	var across: Vector2 = Vector2(off.x, off.z)
	var kept: Vector2 = across.limit_length(_room())
	_middle += Vector3(across.x - kept.x, 0.0, across.y - kept.y)
	var height: float = clampf(p_root.y, _lowest(), _hold.highest)
	if not stands():
		var rise: float = clampf(off.y, _hold.lowest, _hold.highest)
		_middle.y += off.y - rise
		height = _chair + rise
	# A wearer whose tracking jumps has not moved; nobody falls into the hatch.
	var sinks: float = MAX_SINK_M if _has_well() and place.y < _hold.rim else MAX_RISE_M
	place = Vector3(kept.x, clampf(height, place.y - sinks, place.y + MAX_RISE_M), kept.y)
	return place


## Advances by a time, s, with the wearer at a position. Returns whether [member is_ducked] has
## changed.
func advance(p_root: Vector3, p_delta_s: float) -> bool:
	var to: Vector3 = p_root - _middle
	to.y = 0.0 if stands() else to.y
	_middle += to.limit_length(1.0) * (1.0 - exp(-p_delta_s / RECENTRE_S))
	if not _has_well():
		return false
	var below: float = _hold.rim - minf(p_root.y, place.y + RISE_DEPTH_M)
	var ducks: bool = below > (RISE_DEPTH_M if _folded > 0.0 else DUCK_DEPTH_M)
	_folded = move_toward(_folded, FOLD_WAIT_FACTOR if ducks else 0.0, p_delta_s / FOLD_S)
	var was_ducked: bool = is_ducked
	is_ducked = _folded >= FOLD_WAIT_FACTOR
	return is_ducked != was_ducked


## The nearest position in the seat's frame that the hips may have.
func nearest(p_at: Vector3) -> Vector3:
	var across: Vector2 = Vector2(p_at.x, p_at.z).limit_length(_hold.room)
	return Vector3(across.x, clampf(p_at.y, _hold.lowest, _hold.highest), across.y)


func _has_well() -> bool:
	return _hold.hatch_radius > 0.0


func _lowest() -> float:
	if _has_well() and not is_ducked:
		return maxf(_hold.lowest, minf(_hold.rim - RISE_DEPTH_M, place.y))
	return _hold.lowest


## Greatest distance of the hips from the middle, m.
func _room() -> float:
	if not _has_well():
		return _hold.room
	var below: float = smoothstep(0.0, DUCK_DEPTH_M, _hold.rim - place.y)
	return lerpf(_hold.room, minf(_hold.room, MAX_HATCH_OFFSET_M), maxf(below, folded()))
