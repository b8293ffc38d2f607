extends Node3D
## A turntable with a seat: whoever takes the seat steers it by keys; whoever stands on it is
## carried.

## Fastest turn.
@export_range(0.1, 2.0, 0.05, "suffix:rad/s") var max_speed: float = 0.8
## How quickly the speed follows the one who steers.
@export_range(0.1, 5.0, 0.1, "suffix:rad/s²") var acceleration: float = 0.6

var _wanted: float = 0.0
var _speed: float = 0.0
var _sent: float = 0.0

@onready var _entity: Entity = $Disc/Entity
@onready var _disc: AnimatableBody3D = $Disc
@onready var _seat: Seat = $Disc/Seat


func _ready() -> void:
	_entity.commanded.connect(_on_commanded)
	_seat.occupied.connect(func(_session: int) -> void: _wanted = 0.0)


func _process(_delta: float) -> void:
	if not _entity.is_started() or not _seat.is_mine():
		return
	var axis: float = Input.get_axis(&"steer_right", &"steer_left")
	if axis != _sent:
		_sent = axis
		_entity.send_command(&"steer", [axis])


func _physics_process(p_delta: float) -> void:
	if not _entity.is_authority():
		return
	# The exact value is kept here: the field is rounded to its resolution.
	_speed = move_toward(_speed, _wanted * max_speed, acceleration * p_delta)
	_entity.set_value(&"speed", _speed)
	if _speed != 0.0:
		_disc.rotate_y(_speed * p_delta)


func _on_commanded(_session: int, p_command: StringName, p_values: PackedFloat32Array) -> void:
	if p_command == &"steer":
		_wanted = p_values[0]
