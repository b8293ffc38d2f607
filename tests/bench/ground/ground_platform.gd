class_name GroundPlatform
extends RefCounted
## Somebody on a platform that moves sideways at 2 m/s, turns at 30 deg/s, or goes up and down at up
## to 1 m/s: how far the body comes from where the motion has it on the platform.

const KINDS: Array[String] = ["sideways", "turning", "lift"]
## The platform begins to move at this time, s, and reaches its speed within a second.
const _BEGIN_S: float = 2.0
const _STAND_S: float = 30.0
const _GOAL_CM: float = 2.0
const Walker: GDScript = preload("../gait/walker.gd")

## Who stands on it.
var person: ContactPerson = null

var _world: ContactWorld = null
var _kind: String = ""
var _platform: AnimatableBody3D = AnimatableBody3D.new()
## From where the motion has the hips to where they are, on the platform, before it moves, m.
var _begin: Vector3 = Vector3.ZERO
var _drift: float = 0.0
var _last: float = 0.0
var _is_walk: bool = false


func _init(p_world: ContactWorld, p_person: ContactPerson, p_kind: String) -> void:
	_world = p_world
	person = p_person
	_kind = p_kind
	_platform.sync_to_physics = false
	_platform.position.y = -0.25
	_platform.collision_layer = PhysicsLayers.STATIC
	_platform.add_child(BenchBodies.box(Vector3(20.0, 0.5, 40.0)))
	p_world.add_child(_platform)


## Stands for 30 s, so far from the platform's middle, m.
func stand(p_away: float) -> void:
	var pose: PoseSample = ContactPoses.standing(person)
	var hips: Vector3 = person.standing_hips() + Vector3(0.0, 0.0, p_away)
	_world.add_standing(person, pose, hips)
	await _run(_BEGIN_S + _STAND_S)


## Walks along it.
func walk(p_walker: Walker) -> void:
	_is_walk = true
	_world.add_person(
		person, p_walker.pose_at, func(t: float) -> Vector3: return p_walker.pose_at(t).root
	)
	await _run(p_walker.duration)


## Adds what came of it to a report: of walks, where they end.
func tell(p_report: BenchReport, p_case: String) -> void:
	var drift: float = 100.0 * (_last if _is_walk else _drift)
	p_report.at_most(p_case, "off at its end" if _is_walk else "drift", drift, "cm", _GOAL_CM)
	_world.queue_free()


func _run(p_seconds: float) -> void:
	await _world.run(_BEGIN_S, _note)
	_begin = _offset()
	await _world.run(p_seconds - _BEGIN_S, _note)


func _note() -> bool:
	_last = (_offset() - _begin).length()
	_drift = maxf(_drift, _last) if _world.time_s > _BEGIN_S else 0.0
	# Last, as the step that follows takes it there.
	_move(_world.time_s - _BEGIN_S, _world.delta_s)
	return false


func _offset() -> Vector3:
	var wanted: Vector3 = person.place.call(_world.time_s)
	var at: Transform3D = Transform3D(_platform.basis, _platform.position + Vector3.UP * 0.25)
	return at.affine_inverse() * person.joint(0, person.bodies()) - wanted


func _move(p_time_s: float, p_delta_s: float) -> void:
	var eased: float = clampf(p_time_s, 0.0, 1.0)
	match _kind:
		"sideways":
			_platform.position.x += 2.0 * eased * p_delta_s
		"turning":
			_platform.rotation.y += deg_to_rad(30.0) * eased * p_delta_s
		"lift":
			_platform.position.y += sin(maxf(p_time_s, 0.0)) * p_delta_s
