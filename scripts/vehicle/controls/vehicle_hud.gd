class_name VehicleHud
extends CanvasLayer
## Shows a crew what it needs besides the view: instruments, the sight's reticle with the range, the
## slit of a periscope, and the keys of the seat.

## Farthest range that the sight measures, m, and how often, s.
const MAX_RANGE_M: float = 3000.0
const _RANGE_PERIOD_S: float = 0.2

@export var _frame: ViewFrame
@export var _instruments: InstrumentPanel
@export var _keys: Label

var _controls: SeatControls = null
var _range_s: float = 0.0


func _ready() -> void:
	visible = false


func _process(p_delta: float) -> void:
	if not visible or not is_instance_valid(_controls.vehicle):
		return
	_instruments.show_state(_controls.vehicle.state, _controls.reader.gear)
	var view: SeatView = _controls.view
	_frame.show_view(view)
	_range_s += p_delta
	if view != null and view.kind == SeatView.Kind.SIGHT and _range_s > _RANGE_PERIOD_S:
		_range_s = 0.0
		_frame.show_range(measure_range(view))


## Shows what a seat's user needs, from now on.
func follow(p_controls: SeatControls) -> void:
	_controls = p_controls
	_controls.seat_changed.connect(_on_seat_changed)


## How far it is to what a view looks at, m; 0 where nothing is near enough.
static func measure_range(p_view: SeatView) -> float:
	var vehicle: Vehicle = Vehicle.find_above(p_view)
	var from: Vector3 = p_view.global_position
	var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		from, from - p_view.global_basis.z * MAX_RANGE_M, PhysicsLayers.ALL, [vehicle.get_rid()]
	)
	var hit: Dictionary = p_view.get_world_3d().direct_space_state.intersect_ray(ray)
	return 0.0 if hit.is_empty() else from.distance_to(hit["position"])


## The gun that a crew loads, if the seat fires one; else null.
static func find_gun(p_controls: SeatControls) -> VehicleGun:
	if not is_instance_valid(p_controls.vehicle) or p_controls.seat == null:
		return null
	for node: Node in p_controls.vehicle.find_children("*", "Node3D", true, false):
		var gun: VehicleGun = node as VehicleGun
		if gun != null and gun.seat == p_controls.seat and not gun.is_automatic:
			return gun
	return null


## The keys of a seat, for the line at the bottom.
static func describe_keys(p_controls: SeatControls) -> String:
	var parts: PackedStringArray = []
	if p_controls.has_command(&"drive"):
		parts.append("%s%s drive" % [_key(&"drive_forward"), _key(&"drive_back")])
		parts.append("%s%s steer" % [_key(&"steer_left"), _key(&"steer_right")])
		parts.append("%s brake" % _key(&"drive_brake"))
		parts.append("%s gear" % _key(&"drive_gear"))
		parts.append("%s engine" % _key(&"drive_engine"))
		parts.append("%s lamps" % _key(&"drive_lamps"))
	if p_controls.has_command(&"aim"):
		parts.append("Drag aim")
		parts.append("%s magnify" % _key(&"next_magnification"))
	if p_controls.has_command(&"fire"):
		parts.append("%s fire" % _key(&"fire"))
		parts.append("%s machine gun" % _key(&"fire_coax"))
		parts.append("%s ammunition" % _key(&"next_ammunition"))
	if p_controls.has_command(&"open_hatch") or p_controls.has_command(&"open_loader_hatch"):
		parts.append("%s hatch" % _key(&"toggle_hatch"))
	parts.append("%s view" % _key(&"change_view"))
	parts.append("%s other seat" % _key(&"next_seat"))
	parts.append("%s leave" % _key(&"interact"))
	return "   ".join(parts)


func _on_seat_changed(p_seat: Seat) -> void:
	visible = p_seat != null
	_frame.show_view(_controls.view)
	_instruments.gun = find_gun(_controls)
	if p_seat != null:
		_keys.text = describe_keys(_controls)


static func _key(p_action: StringName) -> String:
	return InputKeys.name_of(p_action)
