class_name OrbitCamera
extends Camera3D
## A camera that circles around what it watches. Drag with the mouse to turn, wheel to come closer,
## arrow keys likewise; it follows its target softly. It can also stay behind a person, or look out
## of the person's eyes.

## Where the camera is relative to the person.
enum View {
	## From any side; the side stays when the person turns.
	AROUND,
	## From behind; it turns with the person.
	BEHIND,
	## Out of the eyes.
	EYES,
}

## Distance from obstacles, m.
const _CLEARANCE_M: float = 0.15
## Near plane when the camera looks out of somebody's eyes, m: the eyes are near the visor.
const _NEAR_M: float = 0.05
const _NEAR_EYES_M: float = 0.03
## Least distance from the head, m: nearer, the camera would be in the face.
const _MIN_DISTANCE_M: float = 0.5
## Distance at which it looks at the head, and at which it looks at the target, m.
const _FACE_M: float = 1.2
const _BODY_M: float = 3.0
## Step in which it searches for a distance outside of bodies, m, and number of steps.
const _STEP_M: float = 0.05
const _STEPS: int = 40
## From the head's joint to the middle of the head, in the head's frame, m.
const _FACE: Vector3 = Vector3(0.0, 0.1, 0.0)
## From the head's joint to between the eyes, in the head's frame, m. The own head is not drawn.
const EYES: Vector3 = Vector3(0.0, 0.085, 0.125)

## Where it looks from: angle about the vertical, 0 from +Z.
@export_range(-180.0, 180.0, 0.1, "radians_as_degrees") var azimuth: float = deg_to_rad(35.0)
## Where it looks from: angle above the horizon.
@export_range(-89.0, 89.0, 0.1, "radians_as_degrees") var elevation: float = deg_to_rad(12.0)
## Distance to the target.
@export_range(0.5, 50.0, 0.1, "suffix:m") var distance: float = 4.0
## How quickly it follows: in a second it covers the share 1 - e^-value of its distance.
@export_range(0.1, 50.0, 0.1) var follow_speed: float = 6.0
## Whether arrow keys turn it.
@export var takes_keys: bool = true
## Whether it is smoothed when it looks out of somebody's eyes: for spectators. Wearers see the
## unfiltered view.
@export var is_steady: bool = false
## Obstacles: the camera comes closer where one would be between it and its target.
@export_flags_3d_physics var obstacles: int = 0

## What it watches, in the world, m.
var target: Vector3 = Vector3(0.0, 1.0, 0.0)
## From where it looks.
var view: View = View.AROUND
## The head of whom it watches, in the world, its front towards +Z.
var head: Transform3D = Transform3D.IDENTITY
## Whether it watches a person, who has a [member head].
var has_head: bool = false
## Capsules that it does not enter: two ends in the world for each, m, and a radius, m.
var capsule_ends: PackedVector3Array = []
var capsule_radii: PackedFloat32Array = []
## Where the person faces: angle about the vertical, 0 towards +Z.
var heading: float = 0.0

## A view of the level that it shows instead, or null.
var fixed: Camera3D = null:
	set(p_value):
		if fixed == null and p_value != null:
			_own_fov = fov
		fixed = p_value
		if fixed == null:
			fov = _own_fov
			snap()

var _own_fov: float = fov
var _steady: SteadyEye = SteadyEye.new()
var _centre: Vector3 = Vector3(0.0, 1.0, 0.0)
var _heading: float = 0.0


func _init() -> void:
	# After everything that it watches or looks through has been moved.
	process_priority = 10


func _process(p_delta: float) -> void:
	var turn: Vector2 = Vector2.ZERO
	if takes_keys:
		turn.x = Input.get_axis(&"camera_left", &"camera_right")
		turn.y = Input.get_axis(&"camera_down", &"camera_up")
	azimuth += turn.x * p_delta
	elevation = clampf(elevation + turn.y * p_delta, deg_to_rad(-80.0), deg_to_rad(85.0))
	var share: float = 1.0 - exp(-follow_speed * p_delta)
	_centre = _centre.lerp(_find_centre(), share)
	_heading = lerp_angle(_heading, heading, share)
	if is_instance_valid(fixed) and fixed.is_inside_tree():
		near = _NEAR_M
		fov = fixed.fov
		global_transform = fixed.global_transform.orthonormalized()
		return
	if view == View.EYES and has_head:
		_look_out(p_delta)
		return
	near = _NEAR_M
	var around: float = azimuth + (_heading + PI if view == View.BEHIND else 0.0)
	var direction: Vector3 = Vector3.BACK.rotated(Vector3.RIGHT, -elevation)
	direction = direction.rotated(Vector3.UP, around)
	position = _centre + direction * _clear_of_bodies(direction)
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
			distance = maxf(distance * 0.9, _MIN_DISTANCE_M)
		elif button == MOUSE_BUTTON_WHEEL_DOWN:
			distance = minf(distance * 1.1, 50.0)


## The next of the views.
func change_view() -> void:
	view = ((view + 1) % View.size()) as View
	if view == View.BEHIND:
		azimuth = 0.0
	snap()


## Jumps to the target at once.
func snap() -> void:
	_steady.restart()
	_centre = _find_centre()
	_heading = heading


## Sets azimuth, elevation (degrees) and distance (m) from a text such as "35,12,4", or one of the
## views: "around", "behind", "eyes". Returns why it cannot, or an empty text.
func set_from_text(p_text: String) -> String:
	if View.has(p_text.to_upper()) and p_text == p_text.to_lower():
		view = View[p_text.to_upper()]
		snap()
		return ""
	var parts: PackedStringArray = p_text.split(",")
	var numbers: bool = parts.size() == 3
	for part: String in parts:
		numbers = numbers and part.is_valid_float() and is_finite(part.to_float())
	if not numbers:
		var form: String = "a camera is azimuth,elevation,distance, or around, behind or eyes"
		return "%s, found '%s'" % [form, p_text]
	azimuth = deg_to_rad(parts[0].to_float())
	elevation = deg_to_rad(clampf(parts[1].to_float(), -80.0, 85.0))
	distance = clampf(parts[2].to_float(), _MIN_DISTANCE_M, 50.0)
	return ""


## What is in the middle: from near, the head.
func _find_centre() -> Vector3:
	if not has_head:
		return target
	return (head * _FACE).lerp(target, smoothstep(_FACE_M, _BODY_M, distance))


func _look_out(p_delta: float) -> void:
	near = _NEAR_EYES_M
	var turn: Basis = head.basis.orthonormalized()
	# A camera looks along -Z, a face along +Z.
	var eyes: Transform3D = Transform3D(turn * Basis(Vector3.UP, PI), head.origin + turn * EYES)
	global_transform = _steady.advance(eyes, p_delta) if is_steady else eyes


## How far it can be from its target in a direction before what it does not pass, m; up to a
## distance.
func _free_distance(p_direction: Vector3, p_up_to: float) -> float:
	if obstacles == 0:
		return p_up_to
	var end: Vector3 = _centre + p_direction * p_up_to
	var ray: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.create(
		_centre, end, obstacles
	)
	var hit: Dictionary = get_world_3d().direct_space_state.intersect_ray(ray)
	if hit.is_empty():
		return p_up_to
	return maxf(_centre.distance_to(hit["position"]) - _CLEARANCE_M, _CLEARANCE_M)


## The distance in a direction that is nearest to the wanted one, before walls and outside of all
## bodies, m; the wanted one where there is none.
func _clear_of_bodies(p_direction: Vector3) -> float:
	var free: float = _free_distance(p_direction, distance + _STEPS * _STEP_M)
	var wanted: float = minf(distance, free)
	for step: int in _STEPS:
		for each: float in [wanted - step * _STEP_M, wanted + step * _STEP_M]:
			var is_allowed: bool = each >= minf(_MIN_DISTANCE_M, wanted) and each <= free
			if is_allowed and not _is_in_body(_centre + p_direction * each):
				return each
	return wanted


func _is_in_body(p_point: Vector3) -> bool:
	for capsule: int in capsule_radii.size():
		var reach: float = capsule_radii[capsule] + _NEAR_M
		var nearest: Vector3 = Geometry3D.get_closest_point_to_segment(
			p_point, capsule_ends[2 * capsule], capsule_ends[2 * capsule + 1]
		)
		if nearest.distance_squared_to(p_point) < reach * reach:
			return true
	return false
