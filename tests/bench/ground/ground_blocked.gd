class_name GroundBlocked
extends RefCounted
## People whose motion goes on behind what they cannot pass: a wall, a corner, a table, a door that
## closes. How deep limbs get into it, whether any gets through, and whether the body is back with
## the motion when that has come back.
##
## The wearer plays a clip and is moved on besides, until the hips are [constant _BEYOND_M] behind;
## there they stay, then they come back.

## Goals, mm and m.
const _DEEPEST: float = 30.0
const _BACK: float = 0.15
const _BEYOND_M: float = 3.0
## Between everything that the first second needs and what is in the way, m.
const _ROOM_M: float = 0.3
const _BEGIN_S: float = 1.0
const _SPEED: float = 1.5
const _STAY_S: float = 2.0
const _SETTLE_S: float = 2.5
const _CLIP_S: float = 10.0

var _world: ContactWorld = null
var _person: ContactPerson = null
var _obstacles: GroundObstacles = null
var _direction: Vector3 = Vector3.BACK
var _distance: float = 0.0
var _clip_s: float = 0.0
var _performer: ContactPerformer = null
var _deepest: float = 0.0
var _tunnelled: int = 0
var _must_come_back: bool = false


## Runs one clip against one of [constant GroundObstacles.KINDS]. [param p_side] is the direction of
## somebody who goes nowhere, in quarter turns.
func run(
	p_world: ContactWorld,
	p_person: ContactPerson,
	p_performer: ContactPerformer,
	p_kind: String,
	p_side: int
) -> void:
	_world = p_world
	_person = p_person
	_clip_s = minf(p_performer.duration(), _CLIP_S)
	_performer = p_performer
	# Whoever gets under a table, or falls, or is carried by the feet alone, need not.
	var mode: RagdollMotor.RootMode = p_person.ragdoll.root_mode
	var follows: bool = mode == RagdollMotor.ROOT_SOFT or mode == RagdollMotor.ROOT_HELD
	_must_come_back = follows and p_kind != "table"
	_direction = _find_direction(p_side)
	_distance = _ROOM_M + _find_room(sqrt(0.5) if p_kind == "corner" else 0.0)
	var at: Vector3 = _there(0.0)
	var turn: Basis = Basis(_direction.cross(Vector3.UP) * -1.0, Vector3.UP, _direction)
	var frame: Transform3D = Transform3D(turn, Vector3(at.x, 0.0, at.z))
	p_world.add_block(Vector3(60.0, 1.0, 60.0), Transform3D(Basis(), Vector3.DOWN * 0.5))
	_obstacles = GroundObstacles.new(p_world, p_kind, frame, _distance, at.y)
	p_world.add_person(p_person, _pose, _place)
	await p_world.run(_come_back_s() + _SETTLE_S, _note)


## Adds what came of it to a report.
func tell(p_report: BenchReport, p_case: String) -> void:
	p_report.at_most(p_case, "deepest limb", 1000.0 * maxf(_deepest, 0.0), "mm", _DEEPEST)
	p_report.at_most(p_case, "limbs that got through", _tunnelled, "", 0.0)
	var bodies: Array[Transform3D] = _person.bodies()
	var wanted: Array[Transform3D] = _person.targets_at(_world.time_s)
	var off: Vector3 = _person.joint(0, bodies) - _person.joint(0, wanted)
	var distance: float = Vector2(off.x, off.z).length()
	p_report.at_most(p_case, "off when it has come back", distance, "m", _BACK, _must_come_back)


func _note() -> bool:
	var bodies: Array[Transform3D] = _person.bodies()
	_deepest = maxf(_deepest, _obstacles.depth(_person, bodies))
	if _world.time_s > _BEGIN_S:
		_tunnelled = maxi(_tunnelled, _obstacles.tunnelled(_person, bodies))
	_obstacles.advance(_person.joint(0, bodies), _world.delta_s)
	return false


func _pose(p_time_s: float) -> PoseSample:
	return _performer.source.pose_at(minf(p_time_s, _clip_s))


## Where the clip itself has the hips at a time, s.
func _there(p_time_s: float) -> Vector3:
	return _performer.hips_at(minf(p_time_s, _clip_s), _person)


## Where the motion has the hips at a time, s.
func _place(p_time_s: float) -> Vector3:
	var here: Vector3 = _there(p_time_s)
	var start: Vector3 = _there(0.0)
	var clip: float = (here - start).dot(_direction)
	var most: float = _distance + _BEYOND_M
	var forth: float = maxf(p_time_s - _BEGIN_S, 0.0) * _SPEED
	var back: float = maxf(p_time_s - _turn_s(), 0.0) * _SPEED
	var moved: float = minf(forth, most)
	if back > 0.0:
		# Also what the clip itself has gone.
		moved = maxf(most - back, minf(most, -clip))
	return here + _direction * moved


func _turn_s() -> float:
	return maxf(_BEGIN_S + (_distance + _BEYOND_M) / _SPEED, _clip_s) + _STAY_S


func _come_back_s() -> float:
	var way: Vector3 = _there(_clip_s) - _there(0.0)
	return _turn_s() + (_distance + _BEYOND_M + maxf(way.dot(_direction), 0.0)) / _SPEED


## Where the clip goes; a quarter turn of its front where it goes nowhere.
func _find_direction(p_side: int) -> Vector3:
	var start: Vector3 = _there(0.0)
	var furthest: Vector3 = Vector3.ZERO
	for i: int in 50:
		var off: Vector3 = _there(_clip_s * i / 50.0) - start
		off.y = 0.0
		furthest = off if off.length() > furthest.length() else furthest
	if furthest.length() > 1.0:
		return furthest.normalized()
	return Basis(Vector3.UP, PI / 2.0 * p_side) * Vector3.BACK


## How far the body reaches in its first second from where it begins, m: in the direction, or in
## those to both sides of it by an angle of this sine.
func _find_room(p_sine: float) -> float:
	var start: Vector3 = _there(0.0)
	var room: float = 0.0
	var across: Vector3 = _direction.cross(Vector3.UP) * p_sine
	var ahead: Vector3 = _direction * sqrt(1.0 - p_sine * p_sine)
	for i: int in 21:
		var time: float = _BEGIN_S * i / 20.0
		var bodies: Array[Transform3D] = _person.targets(_pose(time), _there(time))
		for limb: int in _person.count:
			for side: float in [-1.0, 1.0]:
				var normal: Vector3 = ahead + across * side
				var reach: float = _person.reach(limb, bodies[limb], normal)
				room = maxf(room, reach - start.dot(normal))
	return room
