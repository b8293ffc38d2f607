class_name PersonSeat
extends RefCounted
## A person in a [Seat]: the way in, the frame that moves with the seat, the hold of the hips, and
## the way out.
##
## Positions are in the frame of the seat's body, m.

enum Phase {
	## On the way in.
	COMING,
	## In the seat.
	SITTING,
	## On the way out.
	LEAVING,
	## Outside.
	GONE,
}

## Longest time of a way in or out, s, and speed of the feet along it, m/s.
const MAX_CLIMB_S: float = 2.0
const CLIMB_SPEED: float = 2.5
## Time after the end of the way after which a person who has not arrived is put there, s.
const MAX_DELAY_S: float = 1.0
## Distance at which the hips count as arrived, m.
const ARRIVED_M: float = 0.08
## Distance from the seat beyond which a person does not climb but is put there at once, m.
const MAX_CLIMB_M: float = 12.0
## Greatest force on a climbing person, N: it stands for the person's own feet and hands, and the
## vehicle does not feel it.
const MAX_CLIMB_FORCE: float = 6000.0
## Factor on a seat's forces while the hips are outside of their room.
const RETURN_FACTOR: float = 5.0
## Distance outside of their room that the hips may have until then, m.
const SLACK_M: float = 0.03
## Time constant with which the hips follow the motion's, s.
const SMOOTH_S: float = 0.03
## Time in which legs and arms come into the seat's pose, s: at once they kick a light vehicle.
const SIT_DOWN_S: float = 0.5
## Turn of the seat in a step from which on it counts as teleported, rad.
const _TELEPORT_RAD: float = 0.2

## What the phase is.
var phase: Phase = Phase.COMING
## The seat; may have been freed.
var seat: SeatGeometry = null
## How it holds; null: not at all.
var hold: SeatHold = null

var _body: PhysicsBody3D = null
var _person: DrivenBody = null
var _joint: SeatJoint = null
var _neighbours: Array[RID] = []
## Transform of the person's own frame in that of the seat.
var _offset: Transform3D = Transform3D.IDENTITY
var _seat_before: Transform3D = Transform3D.IDENTITY
## Positions of the feet on the path; the seat's own points follow.
var _way: PackedVector3Array = []
var _from: Transform3D = Transform3D.IDENTITY
var _time_s: float = 0.0
var _duration_s: float = 0.0
## When the person has come to sit; who comes out of another seat sits already.
var _sat_s: float = -SIT_DOWN_S
var _target: Vector3 = Vector3.ZERO
## The person's own frame at the end of the last step, and the hips in it, smoothed.
var _frame: Transform3D = Transform3D.IDENTITY
var _hips: Vector3 = Vector3.ZERO
var _place: SeatedHips = null
var _lengths: Vector3 = Vector3.ZERO
var _room: HatchRoom = null
var _before: Dictionary[StringName, float] = {}


## A person takes a seat of a body. [param p_is_inside]: out of another seat of it.
func _init(
	p_person: DrivenBody, p_seat: SeatGeometry, p_body: PhysicsBody3D, p_is_inside: bool
) -> void:
	_person = p_person
	seat = p_seat
	hold = p_seat.hold()
	_body = p_body
	_seat_before = p_seat.frame_in_body()
	if hold == null:
		var root: Vector3 = _root()
		var below: Vector3 = Vector3(root.x, p_person.origin.y, root.z)
		_offset = Transform3D(Basis.IDENTITY, -below)
		phase = Phase.SITTING
		return
	_lengths = SeatedPose.lengths_of(p_person.ragdoll.profile)
	_room = HatchRoom.new(p_person.ragdoll.profile)
	_begin()
	_place = SeatedHips.new(hold, _root().y)
	_hips = _place.place
	_target = _hips_place()
	_from = _body_transform().affine_inverse() * p_person.ragdoll.motor.get_frame()
	_from.basis = _from.basis.orthonormalized()
	var feet: Vector3 = _target - _seat_before.basis.y * _hips.y
	_from.origin = feet
	_frame = _from
	# The motion goes on in another frame: nothing of the one before may remain.
	p_person.ragdoll.motor.clear_motion()
	var is_far: bool = _target.distance_to(_seat_before.origin) > MAX_CLIMB_M
	var way: PackedVector3Array = p_seat.way_in(feet)
	if is_far or way.is_empty():
		_sit()
		_frame = _seat_before * _offset
		_target = _frame * _hips
		return
	_way.append(feet)
	if not p_is_inside:
		_way.append_array(way)
	_duration_s = _duration_of(_path())
	_meet([])


## Begins the way out. Returns false where there is none: the person is then out at once.
func leave(p_is_free: Callable) -> bool:
	if hold == null or phase == Phase.GONE or not is_instance_valid(seat):
		return false
	if phase == Phase.LEAVING:
		return true
	var way: PackedVector3Array = seat.way_out(p_is_free)
	if way.is_empty():
		return false
	phase = Phase.LEAVING
	_place.leave()
	_end_hold()
	_enclose(false)
	_meet([])
	_from = _frame
	_way = PackedVector3Array([_frame.origin])
	_way.append_array(way)
	_time_s = 0.0
	_duration_s = _duration_of(_way)
	return true


## The person's own frame in that of the body at the end of the next step, of a length, s.
func advance(p_delta_s: float) -> Transform3D:
	var now: Transform3D = _seat_before
	if is_instance_valid(seat):
		now = seat.frame_in_body()
	var next: Transform3D = now * (_seat_before.affine_inverse() * now)
	var turn: Basis = _seat_before.basis.inverse() * now.basis
	if turn.get_rotation_quaternion().get_angle() > _TELEPORT_RAD:
		next = now
	_seat_before = now
	_time_s += p_delta_s
	_frame = (next * _offset).orthonormalized() if phase == Phase.SITTING else _climb(next)
	return _frame


## Pulls the hips for the next step, after [method advance].
func pull(p_delta_s: float) -> void:
	if hold == null:
		return
	var from: Vector3 = _target
	# Samples come unevenly.
	_hips = _hips.lerp(_place.place, 1.0 - exp(-p_delta_s / SMOOTH_S))
	_target = _frame * _hips
	if phase == Phase.COMING and _time_s >= _duration_s:
		_arrive()
	elif phase == Phase.LEAVING and _time_s >= _duration_s:
		phase = Phase.GONE
	if _joint == null:
		return
	if _place.advance(_root(), p_delta_s):
		_meet([] if _place.is_ducked else _limbs_that_meet())
	var at: Vector3 = hips_in_seat()
	# The origin of a chair is where the hips are, and so is that of the hips' room.
	var more: float = RETURN_FACTOR if _place.nearest(at).distance_to(at) > SLACK_M else 1.0
	var up: float = hold.support_force * more
	_joint.pull(from, _target, hold.side_force * more, up, hold.down_force * more, p_delta_s)


## Takes the wearer's position in the person's own frame, m; returns that of the body.
func place_of(p_root: Vector3) -> Vector3:
	if hold == null or phase == Phase.GONE:
		return p_root
	return _place.put(p_root - Vector3.UP * _person.origin.y)


## A sample as it drives the body in this seat.
func fit(p_sample: PoseSample) -> PoseSample:
	if hold == null or phase != Phase.SITTING:
		return p_sample
	var fitted: PoseSample = SeatedPose.fit(p_sample, hold, _place.place.y, _lengths)
	if hold.hatch_radius > 0.0:
		_room.fit(fitted, _place.place, hold, _place.folded())
	var share: float = smoothstep(0.0, SIT_DOWN_S, _time_s - _sat_s)
	if share < 1.0:
		for limb: int in Limbs.COUNT:
			var free: Quaternion = p_sample.orientation(limb)
			fitted.set_orientation(limb, free.slerp(fitted.orientation(limb), share))
	return fitted


## Where the hips are in the seat's frame, m.
func hips_in_seat() -> Vector3:
	return _seat_before.affine_inverse() * _hips_place()


## Ends it: call it before person or body are freed.
func release() -> void:
	phase = Phase.GONE
	if _before.is_empty():
		return
	_end_hold()
	if is_instance_valid(_body) and _body.tree_exiting.is_connected(release):
		_body.tree_exiting.disconnect(release)
	if _person.ragdoll != null and _person.ragdoll.motor != null:
		_meet(range(_person.ragdoll.get_bodies().size()))
		_enclose(false)
		_person.ragdoll.motor.root_mode = int(_before[&"root_mode"]) as RagdollMotor.RootMode
		_person.ragdoll.motor.root_force = _before[&"root_force"]
	_before.clear()


## On the way the motion's own hold of the hips moves the body.
func _begin() -> void:
	var motor: RagdollMotor = _person.ragdoll.motor
	_before = {&"root_mode": float(motor.root_mode), &"root_force": motor.root_force}
	motor.root_mode = RagdollMotor.ROOT_SOFT
	motor.root_force = MAX_CLIMB_FORCE
	_body.tree_exiting.connect(release)
	_neighbours = seat.neighbours()


## In the seat a joint to the vehicle holds the hips, not one to the world; that keeps them upright.
func _begin_hold() -> void:
	_person.ragdoll.motor.root_force = 0.0
	_joint = SeatJoint.new(_body.get_rid(), _person.ragdoll)


func _end_hold() -> void:
	if _joint != null:
		_joint.release()
	_joint = null
	if _person.ragdoll != null and _person.ragdoll.motor != null:
		_person.ragdoll.motor.root_force = MAX_CLIMB_FORCE


## The way is done: the hold begins where the hips are near enough.
func _arrive() -> void:
	_sat_s = _time_s
	if _hips_place().distance_to(_target) < ARRIVED_M:
		_sit()
	elif _time_s > _duration_s + MAX_DELAY_S:
		_sit()
		# Something holds the body back: the next sample puts it there.
		_person.ragdoll.motor.clear_motion()


func _sit() -> void:
	phase = Phase.SITTING
	_offset = Transform3D(_facing(), Vector3.DOWN * _place.sit(_root()))
	_meet(_limbs_that_meet())
	_enclose(hold.is_enclosed)
	_begin_hold()


## The person's frame on the way, before the seat's one at the end of the step.
func _climb(p_seat: Transform3D) -> Transform3D:
	var path: PackedVector3Array = _path()
	var share: float = clampf(_time_s / maxf(_duration_s, 0.01), 0.0, 1.0)
	share = smoothstep(0.0, 1.0, share)
	var feet: Vector3 = _along(path, share * _length(path))
	var to: Basis = p_seat.basis * _facing()
	var turn: Basis = _from.basis.orthonormalized().slerp(to, share)
	if phase == Phase.LEAVING:
		turn = _from.basis.orthonormalized()
	return Transform3D(turn, feet)


## The points of the feet, with those that move with the seat.
func _path() -> PackedVector3Array:
	var path: PackedVector3Array = _way.duplicate()
	if phase == Phase.COMING and is_instance_valid(seat):
		if _way.size() > 1:
			path.append(seat.mouth())
		var down: float = 0.0 if _place.stands() else _place.place.y
		path.append(_seat_before.origin - _seat_before.basis.y * down)
	return path


## Turns the wearer so that the person looks ahead in the seat, whichever direction the wearer
## faces.
func _facing() -> Basis:
	if _person.newest == null:
		return Basis.IDENTITY
	var facing: Quaternion = SeatedPose.facing_of(_person.newest.orientation(Limbs.HIPS))
	return Basis(facing.inverse())


## Position of the motion's hips in the person's own frame, m, above the wearer's floor.
func _root() -> Vector3:
	var start: Vector3 = Vector3(_person.origin.x, 0.0, _person.origin.z)
	if _person.newest == null:
		return start + Vector3.UP * _person.ragdoll.get_hip_height()
	return _person.newest.root * _person.scale + start


## Where the hips are.
func _hips_place() -> Vector3:
	var hips: Transform3D = PhysicsServer3D.body_get_state(
		_person.ragdoll.get_bodies()[0], PhysicsServer3D.BODY_STATE_TRANSFORM
	)
	var joint: Vector3 = hips * SeatJoint.joint_of(_person.ragdoll.profile.limbs[0])
	return _body_transform().affine_inverse() * joint


func _body_transform() -> Transform3D:
	return PhysicsServer3D.body_get_direct_state(_body.get_rid()).transform


func _limbs_that_meet() -> Array[int]:
	var limbs: Array[int] = []
	if not hold.meets_vehicle:
		return limbs
	var order: PackedInt32Array = _person.ragdoll.get_limb_order()
	for limb: int in range(Limbs.SPINE, Limbs.LEFT_UPPER_LEG):
		if order[limb] >= 0:
			limbs.append(order[limb])
	return limbs


## Has only these limbs collide with the body and its neighbours.
func _meet(p_limbs: Array) -> void:
	var others: Array[RID] = _neighbours.duplicate()
	if is_instance_valid(_body):
		others.append(_body.get_rid())
	var bodies: Array[RID] = _person.ragdoll.get_bodies()
	for limb: int in bodies.size():
		for other: RID in others:
			# The engine keeps an exception as often as it was added.
			PhysicsServer3D.body_remove_collision_exception(bodies[limb], other)
			if not p_limbs.has(limb):
				PhysicsServer3D.body_add_collision_exception(bodies[limb], other)


## A person inside collides with nothing.
func _enclose(p_is_inside: bool) -> void:
	for body: RID in _person.ragdoll.get_bodies():
		PhysicsServer3D.body_set_collision_layer(body, 0 if p_is_inside else PhysicsLayers.PEOPLE)
		PhysicsServer3D.body_set_collision_mask(body, 0 if p_is_inside else PhysicsLayers.ALL)


func _duration_of(p_path: PackedVector3Array) -> float:
	return clampf(_length(p_path) / CLIMB_SPEED, 0.3, MAX_CLIMB_S)


static func _length(p_path: PackedVector3Array) -> float:
	var length: float = 0.0
	for point: int in range(1, p_path.size()):
		length += p_path[point].distance_to(p_path[point - 1])
	return length


static func _along(p_path: PackedVector3Array, p_way: float) -> Vector3:
	var left: float = p_way
	for point: int in range(1, p_path.size()):
		var step: float = p_path[point].distance_to(p_path[point - 1])
		if left <= step:
			return p_path[point - 1].lerp(p_path[point], left / maxf(step, 1e-6))
		left -= step
	return p_path[p_path.size() - 1]
