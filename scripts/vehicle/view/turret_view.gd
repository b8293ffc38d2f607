class_name TurretView
extends RefCounted
## Turret, gun and hatches of a model, as the vehicle's state has them; the barrel's recoil.

## How far the barrel recoils, m, how soon, s, and how long until it is nearly back, s.
const RECOIL_M: float = 0.30
const _RECOIL_S: float = 0.06
const _RETURN_S: float = 0.5
## How far hatches open, rad.
const HATCH_ANGLE: float = deg_to_rad(105.0)

## Seconds since the last shot.
var since_shot: float = 60.0

var _turret: Node3D = null
var _gun: Node3D = null
var _barrel: Node3D = null
var _barrel_rest: Vector3 = Vector3.ZERO
var _hatches: Array[Node3D] = []


## Finds the nodes in a model; it may have none of them.
func configure(p_model: Node3D) -> void:
	_turret = p_model.find_child("Turret", true, false) as Node3D
	_gun = p_model.find_child("Gun", true, false) as Node3D
	_barrel = p_model.find_child("Barrel", true, false) as Node3D
	if _barrel != null:
		_barrel_rest = _barrel.position
	for name: String in ["HatchCommander", "HatchLoader"]:
		_hatches.append(p_model.find_child(name, true, false) as Node3D)


## Shows a state.
func advance(p_state: VehicleState, p_delta: float) -> void:
	if _turret != null:
		_turret.rotation.y = p_state.turret_yaw
	if _gun != null:
		_gun.rotation.x = p_state.gun_pitch
	_open(_hatches[0], p_state.hatch)
	_open(_hatches[1], p_state.loader_hatch)
	if since_shot < 10.0 and _barrel != null:
		since_shot += p_delta
		_barrel.position = _barrel_rest + Vector3(0.0, 0.0, recoil_at(since_shot))


## The barrel recoils from now on.
func show_shot() -> void:
	since_shot = 0.0


## How far the barrel is back so long after a shot, m.
static func recoil_at(p_seconds: float) -> float:
	if p_seconds < 0.0:
		return 0.0
	if p_seconds < _RECOIL_S:
		return RECOIL_M * sin(p_seconds / _RECOIL_S * PI / 2.0)
	# The recuperator is damped critically.
	var late: float = (p_seconds - _RECOIL_S) / _RETURN_S * 5.8
	return RECOIL_M * (1.0 + late) * exp(-late)


static func _open(p_hatch: Node3D, p_share: float) -> void:
	if p_hatch != null:
		p_hatch.rotation.x = HATCH_ANGLE * smoothstep(0.0, 1.0, p_share)
