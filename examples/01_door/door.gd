extends Node3D
## A sliding door with a button: one field (how far it is open), one command (the button), one event
## (it has slammed shut), which a sound would follow.

## Time that the door takes from one end to the other.
@export_range(0.1, 10.0, 0.1, "suffix:s") var duration: float = 1.2
## Width of the way that it opens.
@export_range(0.1, 10.0, 0.1, "suffix:m") var travel: float = 1.4

var _target: float = 0.0
var _opening: float = 0.0

@onready var _entity: Entity = $Entity
@onready var _leaf: AnimatableBody3D = $Leaf
@onready var _closed_x: float = _leaf.position.x


func _ready() -> void:
	_entity.commanded.connect(_on_commanded)
	_entity.field_changed.connect(_on_field_changed)


func _physics_process(p_delta: float) -> void:
	if not _entity.is_authority():
		return
	if _opening == _target:
		return
	# The exact value is kept here: the field is rounded to its resolution.
	_opening = move_toward(_opening, _target, p_delta / duration)
	_entity.set_value(&"opening", _opening)
	if _opening == 0.0:
		_entity.send_event(&"slammed", [travel / duration])


func _on_commanded(_session: int, _command: StringName, _values: PackedFloat32Array) -> void:
	_target = 1.0 - _target


## On the server it moves what collides, on a client what is seen.
func _on_field_changed(_field: StringName, p_value: float) -> void:
	_leaf.position.x = _closed_x + p_value * travel
