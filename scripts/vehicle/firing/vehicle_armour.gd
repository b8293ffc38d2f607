@tool
@icon("res://scenes/combat/icons/armour.svg")
class_name VehicleArmour
extends Armour
## The armour of a [Vehicle]: thickness of each side, and the damage when something pierces it.
##
## Only the server decides. A vehicle that is knocked out has no engine, no brakes and no gun, until
## a session sends [constant REPAIR].

## The vehicle has another [enum VehicleState.Damage] now: on the server.
signal damaged(p_damage: VehicleState.Damage)

## Command that makes it whole again.
const REPAIR: StringName = &"repair"
## Ratio of penetration to what was needed from which on a hit knocks out at once.
const OVERMATCH: float = 1.3
## Share of the needed penetration from which on a shell that does not pierce still damages.
const SHAKEN: float = 0.7
## Least cosine of the angle of impact that is used: the effective thickness is thickness / cosine,
## and grows no further at flatter angles.
const _FLATTEST: float = 0.25

## The vehicle.
@export var vehicle: Vehicle = null:
	set(p_value):
		vehicle = p_value
		update_configuration_warnings()
## Its entity.
@export var entity: Entity = null:
	set(p_value):
		entity = p_value
		update_configuration_warnings()
## Its turret, if it has one.
@export var turret: VehicleTurret = null

@export_group("Steel")
## Thickness of the hull's front, mm of rolled steel.
@export_range(0.0, 2000.0, 1.0, "suffix:mm") var front: float = 10.0
## Thickness of the sides, mm.
@export_range(0.0, 2000.0, 1.0, "suffix:mm") var side: float = 10.0
## Thickness of the rear, mm.
@export_range(0.0, 2000.0, 1.0, "suffix:mm") var rear: float = 10.0
## Thickness of roof and floor, mm.
@export_range(0.0, 2000.0, 1.0, "suffix:mm") var top: float = 10.0
## Height above the ground from which on armour belongs to the turret and turns with it, m; 0:
## nothing does.
@export_range(0.0, 5.0, 0.05, "suffix:m") var turret_height: float = 0.0

@export_group("Bullets")
## Energy of bullets that have pierced at which it is damaged (x) and knocked out (y), kJ.
@export_custom(PROPERTY_HINT_NONE, "suffix:kJ") var toughness: Vector2 = Vector2(30.0, 90.0)

var _bullet_energy: float = 0.0


func _ready() -> void:
	if not Engine.is_editor_hint() and entity != null:
		entity.commanded.connect(_on_commanded)


func _physics_process(_delta: float) -> void:
	if not Engine.is_editor_hint() and entity != null and entity.is_authority():
		_keep_dead()


func _get_configuration_warnings() -> PackedStringArray:
	if vehicle == null:
		return ["It protects a Vehicle: choose one in the inspector."]
	if entity == null:
		return ["It needs the Entity of the vehicle: choose one in the inspector."]
	return []


## See [method Armour.take_hit]. It changes the vehicle's damage.
func take_hit(
	p_ammunition: Ammunition, p_velocity: Vector3, p_place: Vector3, p_normal: Vector3
) -> float:
	if not (p_velocity.is_finite() and p_place.is_finite() and p_normal.is_finite()):
		return 0.0
	var speed: float = p_velocity.length()
	var steel: float = steel_at(p_place, p_normal)
	var slant: float = clampf(-p_velocity.normalized().dot(p_normal), _FLATTEST, 1.0)
	var share: float = p_ammunition.penetration_at(speed) * slant / maxf(steel, 0.1)
	if p_ammunition.kind == Ammunition.Kind.BULLET:
		if share >= 1.0:
			_take_bullet(p_ammunition.mass * speed * speed / 2000.0)
	elif share >= OVERMATCH:
		_set_damage(VehicleState.Damage.KNOCKED_OUT)
	elif share >= 1.0:
		_worsen()
	elif share >= SHAKEN and vehicle.state.damage == VehicleState.Damage.WHOLE:
		_set_damage(VehicleState.Damage.DAMAGED)
	return share


func take_fragments(p_ammunition: Ammunition, p_direction: Vector3, p_place: Vector3) -> void:
	if p_ammunition.fragment_penetration >= steel_at(p_place, -p_direction):
		_worsen()


## Thickness of steel at a point of the outside (m) with its normal, both in the world; mm.
func steel_at(p_place: Vector3, p_normal: Vector3) -> float:
	var normal: Vector3 = vehicle.global_basis.inverse() * p_normal
	if turret_height > 0.0 and vehicle.to_local(p_place).y > turret_height:
		normal = normal.rotated(Vector3.UP, -vehicle.state.turret_yaw)
	var across: Vector3 = normal.abs()
	if across.y > across.x and across.y > across.z and across.y > 0.75:
		return top
	if across.x > across.z:
		return side
	return front if normal.z < 0.0 else rear


## Makes it whole: on the server.
func repair() -> void:
	_bullet_energy = 0.0
	if vehicle.state.damage == VehicleState.Damage.WHOLE:
		return
	var was_dead: bool = vehicle.state.damage == VehicleState.Damage.KNOCKED_OUT
	_set_damage(VehicleState.Damage.WHOLE)
	vehicle.input.clear()
	if was_dead:
		vehicle.set_engine_on(vehicle.starts_running)
		if turret != null:
			turret.set_stabilised(turret.starts_stabilised)


func _take_bullet(p_energy: float) -> void:
	_bullet_energy += p_energy
	if _bullet_energy >= toughness.y:
		_set_damage(VehicleState.Damage.KNOCKED_OUT)
	elif _bullet_energy >= toughness.x and vehicle.state.damage == VehicleState.Damage.WHOLE:
		_set_damage(VehicleState.Damage.DAMAGED)


func _worsen() -> void:
	var is_whole: bool = vehicle.state.damage == VehicleState.Damage.WHOLE
	_set_damage(VehicleState.Damage.DAMAGED if is_whole else VehicleState.Damage.KNOCKED_OUT)


func _set_damage(p_damage: VehicleState.Damage) -> void:
	if vehicle.state.damage != p_damage:
		vehicle.state.damage = p_damage
		_keep_dead()
		damaged.emit(p_damage)


## Whatever its crew asks for, a vehicle that is knocked out does nothing.
func _keep_dead() -> void:
	if vehicle.state.damage != VehicleState.Damage.KNOCKED_OUT:
		return
	if vehicle.state.engine_on:
		vehicle.set_engine_on(false)
	vehicle.input.clear()
	vehicle.input.brake = 1.0
	if turret != null:
		turret.aim = Vector2.ZERO
		if turret.is_stabilised():
			turret.set_stabilised(false)


func _on_commanded(_session: int, p_command: StringName, _values: PackedFloat32Array) -> void:
	if p_command == REPAIR:
		repair()
	else:
		_keep_dead()
