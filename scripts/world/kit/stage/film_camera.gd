@tool
@icon("res://scenes/world/icons/film_camera.svg")
class_name FilmCamera
extends Marker3D
## Where a [CameraScreen] looks from: along -Z, or after the person who is nearest to what it looks
## at. It turns and zooms as a camera operator would, and never moves.

## Group of all of them.
const GROUP: StringName = &"film_cameras"
## From the hips up to the middle of the picture of somebody whom it follows, m.
const _ABOVE_HIPS_M: float = 0.06
const _MAX_FOV: float = 75.0
const _MIN_FOV: float = 5.0

## Height of its picture where it follows nobody.
@export_range(5.0, 75.0, 0.5, "suffix:°") var fov: float = 40.0
## How far away it looks at something: the middle of a stage.
@export_range(1.0, 100.0, 0.1, "suffix:m") var focus: float = 10.0
## Whether it follows people.
@export var is_following: bool = true
## Greatest distance from the focus at which people are followed.
@export_range(0.5, 100.0, 0.5, "suffix:m") var radius: float = 6.0
## How high above or below the focus their hips may be.
@export_range(0.2, 20.0, 0.1, "suffix:m") var height: float = 1.6
## Height of what it shows of somebody whom it follows.
@export_range(0.3, 10.0, 0.1, "suffix:m") var frame: float = 2.5
## Time in which it comes near to where it should look.
@export_range(0.05, 5.0, 0.05, "suffix:s") var easing: float = 0.5

# What it looks at, in the world, and the height of its picture there, m.
var _target: Vector3 = Vector3.INF
var _high: float = 0.0


func _init() -> void:
	add_to_group(GROUP)


func _get_configuration_warnings() -> PackedStringArray:
	if is_following and radius > focus:
		return ["People may come behind it: make 'Radius' smaller than 'Focus'."]
	return []


## The point that it looks at where it follows nobody.
func get_focus_point() -> Vector3:
	return global_transform * Vector3(0.0, 0.0, -focus)


## Index of the person to follow, given the positions of all hips in the world: the one nearest to
## the focus; -1 if nobody is near enough.
func choose(p_hips: PackedVector3Array) -> int:
	var middle: Vector3 = get_focus_point()
	var best: int = -1
	var nearest: float = radius
	for index: int in p_hips.size():
		var away: Vector3 = p_hips[index] - middle
		var distance: float = Vector2(away.x, away.z).length()
		if absf(away.y) <= height and distance <= nearest:
			nearest = distance
			best = index
	return best if is_following else -1


## Advances by a time, s: turns and zooms to people, given the positions of their hips.
func advance(p_seconds: float, p_hips: PackedVector3Array) -> void:
	var aim: Vector3 = get_focus_point()
	var high: float = 2.0 * tan(deg_to_rad(fov) / 2.0) * focus
	var one: int = choose(p_hips)
	if one >= 0:
		aim = p_hips[one] + Vector3.UP * _ABOVE_HIPS_M
		high = frame
	if _target == Vector3.INF:
		_target = aim
		_high = high
	var share: float = 1.0 - exp(-p_seconds / maxf(easing, 0.01))
	_target = _target.lerp(aim, share)
	_high = lerpf(_high, high, share)


## Where the picture is taken from.
func get_view() -> Transform3D:
	var from: Vector3 = global_position
	if _target == Vector3.INF or _target.distance_squared_to(from) < 0.01:
		return global_transform.orthonormalized()
	var away: Vector3 = (_target - from).normalized()
	var up: Vector3 = Vector3.UP if absf(away.y) < 0.999 else Vector3.FORWARD
	return Transform3D(Basis.looking_at(away, up), from)


## Height of the picture, degrees.
func get_fov() -> float:
	if _target == Vector3.INF:
		return fov
	var distance: float = maxf(_target.distance_to(global_position), 0.5)
	return clampf(rad_to_deg(2.0 * atan(_high / 2.0 / distance)), _MIN_FOV, _MAX_FOV)
