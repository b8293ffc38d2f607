@tool
@icon("res://scenes/vehicle/icons/vehicle.svg")
class_name SeatView
extends Camera3D
## What a user sees who sits in a vehicle without a body: out of the hatch, through a periscope or
## the gunner's sight, or from behind the vehicle.
##
## It looks along its -Z. It never takes over the screen by itself: the client's camera takes its
## position. Make it a child of the node that it turns with.

## What it looks through, and so what is drawn around the picture.
enum Kind {
	## Over the rim of a hatch, or out of a cabin: all round.
	OPEN,
	## A periscope: a wide, low slit.
	PERISCOPE,
	## The gunner's sight: magnified, with a reticle and the range.
	SIGHT,
	## From behind the vehicle.
	CHASE,
}

## Group of all of them.
const GROUP: StringName = &"seat_views"
## After the bodies have been moved, before the client's camera follows it.
const PRIORITY: int = 5
## How quickly the chase view follows: in a second it covers the share 1 - e^-value of its distance.
const _FOLLOW: float = 4.0
## Least distance of the chase view from walls, m.
const _CLEARANCE_M: float = 0.3

## What it looks through.
@export var kind: Kind = Kind.OPEN
## The seat that has it; empty: all seats of the vehicle.
@export var seat: Seat = null
## What people call it; empty: the name of the node.
@export var title: String = ""
## Magnifications that the user can choose, one after the other.
@export var magnifications: PackedFloat32Array = [1.0]
## Angle by which the user can look to either side.
@export_range(0.0, 180.0, 1.0, "radians_as_degrees") var look_yaw: float = 0.0
## Angle by which the user can look up and down.
@export_range(0.0, 89.0, 1.0, "radians_as_degrees") var look_pitch: float = 0.0
## Of a chase view: how far behind and how high it is.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var chase: Vector2 = Vector2(11.0, 4.0)

## Which of the magnifications is used.
var step: int = 0
## Direction in which the user looks besides: x to the left, y up, rad.
var look: Vector2 = Vector2.ZERO

var _rest: Transform3D = Transform3D.IDENTITY
var _base_fov: float = 60.0
var _is_snapping: bool = true


func _init() -> void:
	add_to_group(GROUP)
	process_priority = PRIORITY


func _notification(p_what: int) -> void:
	# Before it enters the tree, where a current camera takes over.
	if p_what == NOTIFICATION_PARENTED and not Engine.is_editor_hint():
		current = false


func _ready() -> void:
	_rest = transform
	_base_fov = fov
	set_process(false)
	if current and not Engine.is_editor_hint():
		# The first camera of a tree is made current.
		clear_current()


func _process(p_delta: float) -> void:
	advance(p_delta)


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = []
	if current:
		warnings.append("Switch 'Current' off: whoever sits there goes to it by a key.")
	if magnifications.is_empty() or magnifications[0] <= 0.0:
		warnings.append("'Magnifications' needs one above 0, such as 1.")
	return warnings


## What people call it.
func get_title() -> String:
	return title if title != "" else String(name).capitalize()


## Begins or ends to be looked through.
func set_active(p_is_active: bool) -> void:
	set_process(p_is_active)
	look = Vector2.ZERO
	step = 0
	_is_snapping = true
	if p_is_active:
		advance(0.0)


## The next of the magnifications.
func change_magnification() -> void:
	step = (step + 1) % magnifications.size()


## How many times nearer things are than with the bare eye.
func magnification() -> float:
	return magnifications[step] if step < magnifications.size() else 1.0


## Looks further to a side (x, to the left) and up (y), rad.
func turn(p_by: Vector2) -> void:
	var limit: Vector2 = Vector2(look_yaw, look_pitch)
	if kind == Kind.CHASE:
		limit = Vector2(PI, 1.2)
	look += p_by
	look.x = wrapf(look.x, -PI, PI) if limit.x >= PI else clampf(look.x, -limit.x, limit.x)
	look.y = clampf(look.y, -limit.y, limit.y)


## Goes on by a time, s.
func advance(p_delta: float) -> void:
	fov = rad_to_deg(2.0 * atan(tan(deg_to_rad(_base_fov) / 2.0) / magnification()))
	if kind == Kind.CHASE:
		_chase(p_delta)
		return
	var turned: Basis = Basis(Vector3.UP, look.x) * Basis(Vector3.RIGHT, look.y)
	transform = Transform3D(_rest.basis * turned, _rest.origin)


func _chase(p_delta: float) -> void:
	var body: Node3D = get_parent_node_3d()
	var back: Vector3 = body.global_basis.z
	back.y = 0.0
	back = back.normalized() if back.length() > 0.1 else Vector3.BACK
	back = back.rotated(Vector3.UP, look.x)
	var centre: Vector3 = body.global_position + Vector3.UP * 0.5 * chase.y
	var way: Vector3 = back * chase.x * cos(look.y) + Vector3.UP * (0.5 * chase.y - 6.0 * look.y)
	var wanted: Vector3 = centre + _free_way(centre, way)
	# Only the side is followed softly: a vehicle that shakes does not leave the picture.
	var share: float = 1.0 if _is_snapping else 1.0 - exp(-_FOLLOW * p_delta)
	_is_snapping = false
	var offset: Vector3 = (global_position - centre).slerp(wanted - centre, share)
	look_at_from_position(centre + offset, centre)


## Distance along a direction that is free of static bodies, m.
func _free_way(p_from: Vector3, p_way: Vector3) -> Vector3:
	var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		p_from, p_from + p_way, PhysicsLayers.STATIC
	)
	var hit: Dictionary = get_world_3d().direct_space_state.intersect_ray(ray)
	if hit.is_empty():
		return p_way
	var length: float = maxf(p_from.distance_to(hit["position"]) - _CLEARANCE_M, 1.0)
	return p_way.normalized() * length
