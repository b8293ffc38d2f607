class_name GroundBall
extends RefCounted
## A ball that flies against the chest of somebody who stands: how far the trunk gives way, and when
## it is back.

const _MASS: float = 5.0
const _SPEED: float = 10.0
const _RADIUS: float = 0.11
const _DISTANCE: float = 0.8
const _SETTLE_S: float = 1.5
const _WATCH_S: float = 3.0
## The trunk is back when it is off by less than this, deg.
const _BACK_DEG: float = 2.0

var _report: BenchReport = null
var _hit_s: float = -1.0
var _back_s: float = -1.0
var _worst_deg: float = 0.0


func _init(p_report: BenchReport) -> void:
	_report = p_report


## Throws a ball that flies towards [param p_direction] at the person of [param p_run].
func throw(p_run: GroundRun, p_direction: Vector3) -> void:
	_hit_s = -1.0
	_back_s = -1.0
	_worst_deg = 0.0
	await p_run.world.run(_SETTLE_S, p_run.note)
	var chest: int = p_run.person.find(&"Chest")
	var from: Vector3 = p_run.person.bodies()[chest].origin - p_direction * _DISTANCE
	var ball: RigidBody3D = p_run.world.add_ball(_RADIUS, from, _MASS)
	ball.gravity_scale = 0.0
	ball.linear_velocity = p_direction * _SPEED
	await p_run.world.run(_WATCH_S, _watch.bind(p_run, ball, chest))
	var case: String = "ball of 5 kg towards %s" % p_direction
	_report.at_least(case, "trunk turns", _worst_deg, "deg", 8.0)
	_report.at_most(case, "trunk turns at most", _worst_deg, "deg", 20.0)
	var back_s: float = _back_s - _hit_s
	_report.at_most(case, "trunk is back", back_s, "s", 0.6)


func _watch(p_run: GroundRun, p_ball: RigidBody3D, p_chest: int) -> bool:
	p_run.note()
	var now_s: float = p_run.world.time_s
	if _hit_s < 0.0 and p_ball.linear_velocity.length() < 0.9 * _SPEED:
		_hit_s = now_s
		p_ball.gravity_scale = 1.0
	var shown: Basis = p_run.person.bodies()[p_chest].basis
	var wanted: Basis = p_run.person.targets_at(now_s)[p_chest].basis
	var error: float = ContactPerson.angle_deg(shown, wanted)
	_worst_deg = maxf(_worst_deg, error)
	if _hit_s >= 0.0 and error > _BACK_DEG:
		_back_s = now_s
	return false
