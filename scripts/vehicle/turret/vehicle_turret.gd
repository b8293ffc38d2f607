@tool
@icon("res://scenes/vehicle/icons/vehicle.svg")
class_name VehicleTurret
extends Node3D
## The turret of a [Vehicle] with its gun: turns as the gunner asks, within limits, rates and
## accelerations, and holds the aim in the world while the hull moves below.
##
## It stands where the turret turns, below the vehicle's body. It turns itself about +Y, the
## [member gun] about +X, and takes the [member shapes] along. Where the body is frozen (on clients)
## it shows what the vehicle's state says.

## Least angle by which shapes follow, rad: each time the engine builds the body anew.
const _SHAPE_STEP: float = 0.02

## What is raised and lowered: its origin is where the gun turns, its -Z where it points.
@export var gun: Node3D = null:
	set(p_value):
		gun = p_value
		update_configuration_warnings()
## Shapes of the body that turn with the turret.
@export var shapes: Array[CollisionShape3D] = []

@export_group("Drives")
## How fast the turret turns at most.
@export_range(0.01, 5.0, 0.01, "radians_as_degrees", "suffix:°/s") var yaw_rate: float = 0.7
## How fast its rate changes at most, rad/s^2.
@export_range(0.01, 50.0, 0.01, "suffix:rad/s²") var yaw_acceleration: float = 2.0
## How far it turns to either side; 0: all the way round.
@export_range(0.0, 180.0, 0.1, "radians_as_degrees") var yaw_limit: float = 0.0
## How fast the gun is raised at most.
@export_range(0.01, 5.0, 0.01, "radians_as_degrees", "suffix:°/s") var pitch_rate: float = 0.7
## How fast that rate changes at most, rad/s^2.
@export_range(0.01, 50.0, 0.01, "suffix:rad/s²") var pitch_acceleration: float = 6.0
## Lowest elevation of the gun.
@export_range(-90.0, 0.0, 0.1, "radians_as_degrees") var pitch_min: float = deg_to_rad(-9.0)
## Highest elevation of the gun.
@export_range(0.0, 90.0, 0.1, "radians_as_degrees") var pitch_max: float = deg_to_rad(20.0)
## Whether the aim is held in the world from the start.
@export var starts_stabilised: bool = true

## What the gunner asks for: shares of the greatest rates, -1 to 1; x to the left, y up.
var aim: Vector2 = Vector2.ZERO:
	set(p_value):
		# What is not a number counts as nothing.
		aim = p_value.clampf(-1.0, 1.0) if p_value.is_finite() else Vector2.ZERO

var _drive: TurretDrive = TurretDrive.new()
var _vehicle: Vehicle = null
var _rests: Array[Transform3D] = []
var _rest: Transform3D = Transform3D.IDENTITY
var _shown_yaw: float = 0.0


func _ready() -> void:
	if Engine.is_editor_hint():
		return
	_rest = transform
	for shape: CollisionShape3D in shapes:
		_rests.append(shape.transform)
	_vehicle = Vehicle.find_above(self)
	if not _configure():
		Log.error("vehicle", "%s keeps ahead: its rates or limits make no sense" % get_path())


func _process(_delta: float) -> void:
	if not Engine.is_editor_hint() and _vehicle != null and _vehicle.freeze:
		_show(_vehicle.state.turret_yaw, _vehicle.state.gun_pitch)


func _physics_process(p_delta: float) -> void:
	if Engine.is_editor_hint() or _vehicle == null or _vehicle.freeze:
		return
	_drive.step(
		_vehicle.global_transform.orthonormalized(),
		_vehicle.angular_velocity,
		aim.x,
		aim.y,
		p_delta
	)
	_vehicle.state.turret_yaw = _drive.get_yaw()
	_vehicle.state.gun_pitch = _drive.get_pitch()
	_vehicle.state.stabilised = _drive.is_stabilised()
	_show(_drive.get_yaw(), _drive.get_pitch())


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	if gun == null:
		warnings.append("It needs the node that is raised and lowered: choose one for 'Gun'.")
	if Vehicle.find_above(self) == null:
		warnings.append("It turns on a Vehicle: put it below one.")
	if not (pitch_min < pitch_max):
		warnings.append("'Pitch Min' must be below 'Pitch Max'.")
	return warnings


## Has the aim held in the world, or turret and gun keep their angles to the hull.
func set_stabilised(p_is_stabilised: bool) -> void:
	_drive.set_stabilised(p_is_stabilised)


## Whether the aim is held in the world.
func is_stabilised() -> bool:
	return _drive.is_stabilised()


## Puts turret and gun at angles (rad), at rest.
func place(p_yaw: float, p_pitch: float) -> void:
	_drive.place(p_yaw, p_pitch)
	_show(_drive.get_yaw(), _drive.get_pitch())


## Where the stabilised gun is to point in the world, a unit vector.
func get_aim_direction() -> Vector3:
	return _drive.get_aim()


func _configure() -> bool:
	_drive.set_stabilised(starts_stabilised)
	return _drive.configure(
		Vector2(yaw_rate, pitch_rate),
		Vector2(yaw_acceleration, pitch_acceleration),
		yaw_limit,
		pitch_min,
		pitch_max
	)


func _show(p_yaw: float, p_pitch: float) -> void:
	rotation.y = p_yaw
	if gun != null:
		gun.rotation.x = p_pitch
	if absf(angle_difference(_shown_yaw, p_yaw)) < _SHAPE_STEP:
		return
	_shown_yaw = p_yaw
	var turn: Transform3D = _rest * Transform3D(Basis(Vector3.UP, p_yaw)) * _rest.affine_inverse()
	for index: int in shapes.size():
		shapes[index].transform = turn * _rests[index]
