class_name OrbitCamera
extends Camera3D
## A camera that circles around what it watches. Drag with the mouse to turn, wheel to come closer,
## arrow keys likewise; it follows its target softly.

## Distance that it keeps from what it does not pass, m.
const _CLEARANCE_M: float = 0.15

## Where it looks from: angle about the vertical, 0 from +Z.
@export_range(-180.0, 180.0, 0.1, "radians_as_degrees") var azimuth: float = deg_to_rad(35.0)
## Where it looks from: angle above the horizon.
@export_range(-89.0, 89.0, 0.1, "radians_as_degrees") var elevation: float = deg_to_rad(12.0)
## Distance to the target.
@export_range(0.5, 50.0, 0.1, "suffix:m") var distance: float = 4.0
## How quickly it follows: the share of the way per second is 1 - e^-value.
@export_range(0.1, 50.0, 0.1) var follow_speed: float = 6.0
## Whether arrow keys turn it.
@export var takes_keys: bool = true
## What it does not pass: it comes closer where one of these would stand between it and its target.
@export_flags_3d_physics var obstacles: int = 0

## What it watches, in the world, m.
var target: Vector3 = Vector3(0.0, 1.0, 0.0)

var _centre: Vector3 = Vector3(0.0, 1.0, 0.0)


func _process(p_delta: float) -> void:
	var turn: Vector2 = Vector2.ZERO
	if takes_keys:
		turn.x = Input.get_axis(&"camera_left", &"camera_right")
		turn.y = Input.get_axis(&"camera_down", &"camera_up")
	azimuth += turn.x * p_delta
	elevation = clampf(elevation + turn.y * p_delta, deg_to_rad(-80.0), deg_to_rad(85.0))
	_centre = _centre.lerp(target, 1.0 - exp(-follow_speed * p_delta))
	var direction: Vector3 = Vector3.BACK.rotated(Vector3.RIGHT, -elevation)
	direction = direction.rotated(Vector3.UP, azimuth)
	position = _centre + direction * _free_distance(direction)
	look_at(_centre)


func _unhandled_input(p_event: InputEvent) -> void:
	if p_event is InputEventMouseMotion:
		var motion: InputEventMouseMotion = p_event
		if motion.button_mask & (MOUSE_BUTTON_MASK_LEFT | MOUSE_BUTTON_MASK_RIGHT) != 0:
			azimuth -= motion.relative.x * 0.005
			var higher: float = elevation + motion.relative.y * 0.005
			elevation = clampf(higher, deg_to_rad(-80.0), deg_to_rad(85.0))
	elif p_event is InputEventMouseButton and p_event.is_pressed():
		var button: MouseButton = (p_event as InputEventMouseButton).button_index
		if button == MOUSE_BUTTON_WHEEL_UP:
			distance = maxf(distance * 0.9, 0.5)
		elif button == MOUSE_BUTTON_WHEEL_DOWN:
			distance = minf(distance * 1.1, 50.0)


## How far it can be from its target in a direction, m.
func _free_distance(p_direction: Vector3) -> float:
	if obstacles == 0:
		return distance
	var end: Vector3 = _centre + p_direction * distance
	var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		_centre, end, obstacles
	)
	var hit: Dictionary = get_world_3d().direct_space_state.intersect_ray(ray)
	if hit.is_empty():
		return distance
	return maxf(_centre.distance_to(hit["position"]) - _CLEARANCE_M, _CLEARANCE_M)


## Jumps to the target at once.
func snap() -> void:
	_centre = target


## Sets azimuth, elevation (degrees) and distance (m) from a text such as "35,12,4"; returns why it
## cannot, or an empty text.
func set_from_text(p_text: String) -> String:
	var parts: PackedStringArray = p_text.split(",")
	var numbers: bool = parts.size() == 3
	for part: String in parts:
		numbers = numbers and part.is_valid_float() and is_finite(part.to_float())
	if not numbers:
		return "a camera is azimuth,elevation,distance, found '%s'" % p_text
	azimuth = deg_to_rad(parts[0].to_float())
	elevation = deg_to_rad(clampf(parts[1].to_float(), -80.0, 85.0))
	distance = clampf(parts[2].to_float(), 0.5, 50.0)
	return ""
