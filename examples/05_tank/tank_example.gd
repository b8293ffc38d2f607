extends Node3D
## A tank on a field, to be driven without a server: take a seat with E, then Q changes seats.

@onready var _controls: SeatControls = $Controls
@onready var _camera: OrbitCamera = $Camera
@onready var _hud: VehicleHud = $Hud


func _ready() -> void:
	_controls.view_changed.connect(func(view: SeatView) -> void: _camera.fixed = view)
	_hud.follow(_controls)
