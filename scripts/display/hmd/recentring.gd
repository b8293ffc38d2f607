class_name Recentring
extends RefCounted
## Where the wearer's tracking space lies in the room: recentred, seated, turned by steps.
##
## Only heading and position ever change: up stays up.

## Where eyes of a standing person are, m above the ground.
const STANDING_EYES_M: float = 1.65

## Whether the wearer sits in a chair and sees the world from a standing person's height.
var is_seated: bool = false

## From the tracking space to the room.
var _offset: Transform3D = Transform3D.IDENTITY


## From the tracking space to the room.
func transform() -> Transform3D:
	return _offset


## Nothing is recentred any more.
func clear() -> void:
	_offset = Transform3D.IDENTITY


## The head's position and heading become the room's own origin and -Z. Takes the head in the
## tracking space. Standing, the height stays what the runtime measures from its floor; seated, the
## eyes come to the height of a standing person's.
func recentre(p_head: Transform3D) -> void:
	if not _is_sound(p_head):
		return
	var turn: Basis = Basis(Vector3.UP, -heading_of(p_head.basis))
	var position: Vector3 = -(turn * p_head.origin)
	position.y = STANDING_EYES_M - p_head.origin.y if is_seated else 0.0
	_offset = Transform3D(turn, position)


## Turns the wearer on the spot. Takes an angle about +Y (rad, left is positive) and the head in
## the tracking space.
func turn(p_angle: float, p_head: Transform3D) -> void:
	if not _is_sound(p_head) or not is_finite(p_angle):
		return
	var pivot: Vector3 = _offset * p_head.origin
	var about: Transform3D = Transform3D(Basis(Vector3.UP, p_angle), Vector3.ZERO)
	_offset = (
		Transform3D(Basis.IDENTITY, pivot) * about * Transform3D(Basis.IDENTITY, -pivot) * _offset
	)
	_offset = _offset.orthonormalized()


## The heading of a rotation: rad about +Y, 0 along -Z. Of somebody who looks straight up or down it
## is where the top of the head points, or its opposite.
static func heading_of(p_basis: Basis) -> float:
	var ahead: Vector3 = -p_basis.z
	if absf(ahead.y) > 0.98:
		ahead = -signf(ahead.y) * p_basis.y
	return atan2(-ahead.x, -ahead.z)


## Where somebody with this rotation looks as bodies and walkers have it: rad about +Y, 0 along +Z.
static func facing_of(p_basis: Basis) -> float:
	return wrapf(heading_of(p_basis) + PI, -PI, PI)


static func _is_sound(p_transform: Transform3D) -> bool:
	return p_transform.is_finite()
