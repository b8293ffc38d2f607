class_name TravelFrame
extends RefCounted
## A mover in the frame of somebody whose body the server moves by samples: where it is in that
## frame, whatever the world does to the frame.
##
## The server holds a body back where something is in its way, and carries it on decks: then the
## person's own frame is elsewhere in the world, and the mover goes there with it.

## How far the frame may be from where it was without the mover being moved, m: less is noise.
const SLACK_M: float = 0.3
## Beyond this the person was put elsewhere, m.
const JUMP_M: float = 2.0
## A body that is lower than its motion by more than this lies, m.
const DOWN_M: float = 0.4

## What is moved.
var mover: WalkerMover = WalkerMover.new()
## The person's own frame in the world.
var frame: Transform3D = Transform3D.IDENTITY
## Body's size by the wearer's: samples are in the wearer's.
var scale: float = 1.0
## How far the mover was moved with the frame, m.
var shift: Vector3 = Vector3.ZERO
## Whether physics has the body, which has fallen.
var is_down: bool = false

var _world: World3D = null
var _bodies: WalkerBodies = null
# Number of the body that carried in the last tick, 0 none, and its transform then.
var _carrier: int = 0
var _carrier_frame: Transform3D = Transform3D.IDENTITY


## Lets it move in a world among its bodies.
func enter(p_world: World3D, p_bodies: WalkerBodies) -> void:
	_world = p_world
	_bodies = p_bodies
	_bodies.add_mover(mover, p_world)


## Ends that.
func leave() -> void:
	if _bodies != null:
		_bodies.remove_mover(mover)
		mover.enter(RID(), null, 0)
	_bodies = null
	_world = null


## Whether there is anything to move in.
func is_entered() -> bool:
	return _bodies != null


## Begins below the hips, which are somewhere in the person's own frame above a floor of that
## height, m; faces there by a heading in the world, rad. Returns false where the body lies.
func begin(p_frame: Transform3D, p_hips: Vector3, p_floor: float, p_heading: float) -> bool:
	frame = p_frame
	shift = Vector3.ZERO
	_carrier = 0
	var hips: Vector3 = to_world(p_hips)
	var ground: Vector3 = to_world(Vector3(p_hips.x, p_floor, p_hips.z))
	var feet: Vector3 = WalkerBodies.find_ground(_world, hips, ground)
	is_down = ground.y < feet.y - DOWN_M
	mover.place(feet, p_heading)
	return not is_down


## Goes along with the frame, which is there now.
func follow(p_frame: Transform3D) -> void:
	_ride()
	var off: Vector3 = p_frame.origin - frame.origin
	var flat: Vector3 = Vector3(off.x, 0.0, off.z)
	is_down = off.y < -DOWN_M
	if off.length() > JUMP_M:
		frame.origin += off
		mover.place(mover.get_position() + off, mover.get_heading())
		shift += off
	elif flat.length() > SLACK_M:
		# As far as the mover can: else it would be elsewhere in the frame, and the body pulled there.
		var moved: Vector3 = mover.push(flat.limit_length(flat.length() - SLACK_M))
		frame.origin += moved
		shift += moved


## Makes a tick; what only hands can climb, which samples do not have, is in the way.
func tick(p_input: WalkerInput, p_delta_s: float) -> void:
	var before: PackedByteArray = mover.get_state()
	p_input.apply(mover, p_delta_s)
	if mover.get_mode() != WalkerMover.WALK:
		mover.set_state(before)


## Where the mover's feet are in the person's own frame, m.
func place() -> Vector3:
	return to_frame(mover.get_position())


## How the person's own frame is turned in the world, rad.
func heading() -> float:
	return Rotations.yaw_of(frame.basis.get_rotation_quaternion())


## From the person's own frame to the world, m.
func to_world(p_place: Vector3) -> Vector3:
	return frame * (p_place * scale)


## From the world to the person's own frame, m.
func to_frame(p_place: Vector3) -> Vector3:
	return (frame.affine_inverse() * p_place) / scale


## The frame moves with what carries, as the mover does by itself.
func _ride() -> void:
	var carrier: int = mover.get_carrier()
	var now: Transform3D = _bodies.transform_of(carrier) if carrier != 0 else Transform3D.IDENTITY
	if carrier != 0 and carrier == _carrier:
		frame = now * _carrier_frame.affine_inverse() * frame
	_carrier = carrier
	_carrier_frame = now
