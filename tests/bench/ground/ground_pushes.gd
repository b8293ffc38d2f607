class_name GroundPushes
extends RefCounted
## Pushes at the chest of somebody who stands: whether he gives way, steps, falls, and stands again.

## What is to happen at an impulse, N s: the chest moves by at least so much, cm; so many steps at
## least, 0 for no goal; whether the person is to fall or not to; upright again within so long, s.
const _GOALS: Dictionary[float, Array] = {
	40.0: [5.0, 0, false, 1.5],
	80.0: [15.0, 1, false, 1.5],
	160.0: [15.0, 0, true, 4.0],
}
## Pushed at this time, s, and watched for so long.
const _BEGIN_S: float = 1.5
const _WATCH_S: float = 6.0

var _report: BenchReport = null
var _far: float = 0.0
var _upright_s: float = INF
var _falls: int = 0
var _phase: int = 0


func _init(p_report: BenchReport) -> void:
	_report = p_report


## Pushes somebody who stands in [param p_run].
func push(p_run: GroundRun, p_impulse: float, p_direction: Vector3) -> void:
	_far = 0.0
	_upright_s = INF
	_falls = 0
	_phase = 0
	await p_run.world.run(_BEGIN_S, p_run.note)
	var chest: int = p_run.person.find(&"Chest")
	var start: Vector3 = p_run.person.bodies()[chest].origin
	var body: RID = p_run.person.ragdoll.get_bodies()[chest]
	PhysicsServer3D.body_apply_central_impulse(body, p_direction * p_impulse)
	await p_run.world.run(_WATCH_S, _watch.bind(p_run, chest, start, p_direction))
	_tell("%d N s towards %s" % [p_impulse, p_direction], p_run, _GOALS[p_impulse])


func _watch(p_run: GroundRun, p_chest: int, p_start: Vector3, p_direction: Vector3) -> bool:
	p_run.note()
	var moved: float = (p_run.person.bodies()[p_chest].origin - p_start).dot(p_direction)
	_far = maxf(_far, moved)
	var balance: Dictionary = p_run.person.ragdoll.motor.get_balance()
	var phase: int = balance.get("phase", 0)
	_falls += 1 if phase == RagdollMotor.BALANCE_FALLING and phase != _phase else 0
	_phase = phase
	var low: float = p_run.wanted_heights[-1] - p_run.heights[-1]
	if p_run.errors[-1] > 3.0 or low > 0.05:
		_upright_s = INF
	elif is_inf(_upright_s):
		_upright_s = p_run.world.time_s - _BEGIN_S
	return false


func _tell(p_case: String, p_run: GroundRun, p_goals: Array) -> void:
	_report.at_least(p_case, "chest moves", 100.0 * _far, "cm", p_goals[0])
	_report.at_least(p_case, "steps", p_run.steps, "", p_goals[1], p_goals[1] > 0)
	if p_goals[2]:
		_report.at_least(p_case, "falls", _falls, "", 1.0)
	else:
		_report.at_most(p_case, "falls", _falls, "", 0.0)
	_report.at_most(p_case, "upright again after", _upright_s, "s", p_goals[3])
