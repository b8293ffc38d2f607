class_name SceneView
extends RefCounted
## One look at a [ClientScene]: a camera that follows one of the people, from around, from behind or
## out of the eyes, or looks from a camera of the level. The window has one; an instructor's station
## may have more, each in a viewport of its own: see [method ClientScene.add_view].

## Distance within which bodies are reported to the camera, m.
const _CAMERA_NEAR_M: float = 4.0

## The camera.
var camera: OrbitCamera = null
## Whether the user looks out of the own eyes: in a headset, or on walls that follow the own head.
var sees_by_own_eyes: bool = false
## Whether the head from whose eyes the camera looks is hidden, for all views: only the window's
## view hides it.
var hides_head: bool = false
## Out of whose eyes the camera looks, or -1.
var eyes: int = -1

# Where the own eyes look, where the user turns them by hand: heading and up, rad; NAN: by the body.
var _look: Vector2 = Vector2(NAN, 0.0)
# The people who are shown, as the scene has them.
var _actors: Dictionary[int, ActorView] = {}
var _followed: FollowedPerson = FollowedPerson.new()
var _is_aimed: bool = false


## Takes the people who are shown: the scene's own dictionary.
func _init(p_camera: OrbitCamera, p_actors: Dictionary[int, ActorView]) -> void:
	camera = p_camera
	_actors = p_actors


## Lets the camera follow the person of this client, who has one from now on. Where the user has set
## no camera it stays behind the person.
func follow_own(p_actor: int, p_stays_behind: bool) -> void:
	if _followed.own < 0 and p_actor >= 0 and p_stays_behind:
		camera.view = OrbitCamera.View.BEHIND
		camera.azimuth = 0.0
		_is_aimed = false
	_followed.own = p_actor


## The person of this client, or -1.
func own() -> int:
	return _followed.own


## Whom the camera follows, or -1.
func followed() -> int:
	return _followed.find(_actors)


## Lets the camera follow one of the people.
func follow(p_actor: int) -> void:
	camera.fixed = null
	_followed.chosen = p_actor


## Lets the camera follow the next person.
func follow_next() -> void:
	camera.fixed = null
	_followed.choose_next(_actors)


## Lets the camera follow who is seen at a point of its viewport, if anybody is.
func follow_at(p_point: Vector2) -> void:
	var from: Vector3 = camera.project_ray_origin(p_point)
	if _followed.choose_at(_actors, from, camera.project_ray_normal(p_point)):
		camera.fixed = null


## Looks from where a camera is, such as that of a seat; null: back to the followed person.
func look_through(p_camera: Camera3D) -> void:
	camera.fixed = p_camera


## Goes to the next of some views of the level, and after the last one back to the followed person.
## Returns where it looks from now, for people.
func look_through_next(p_views: Array[ObserverCamera]) -> String:
	var next: int = p_views.find(camera.fixed) + 1
	camera.fixed = p_views[next] if next < p_views.size() else null
	if camera.fixed != null:
		return p_views[next].get_title()
	return "This level has no views of its own" if p_views.is_empty() else "Back to people"


## Says where the user turns the own eyes by hand: the angle about +Y, rad, 0 towards +Z, and up,
## rad. NAN: they look where the body's head does.
func look(p_heading: float, p_up: float) -> void:
	_look = Vector2(p_heading, p_up)


## Looks at the followed person from elsewhere: around, from behind, out of the eyes.
func change_view() -> void:
	if camera.fixed != null:
		camera.fixed = null
		return
	camera.change_view()


## A person is no longer shown. Call it before the person's node is freed.
func forget(p_actor: int) -> void:
	if p_actor == eyes:
		eyes = -1


## Follows the people, who are where the frame shows them. Returns from whose own eyes it looks, and
## whose name need not be shown therefore, or -1.
func aim() -> int:
	var actor: int = followed()
	camera.has_head = actor >= 0
	_keep_camera_out()
	var is_own: bool = sees_by_own_eyes and _followed.own >= 0
	if is_own:
		camera.view = OrbitCamera.View.EYES
		actor = _followed.own
	var looks_out: bool = camera.view == OrbitCamera.View.EYES and camera.fixed == null
	camera.is_steady = actor != _followed.own
	# Whatever the window's camera shows, such as the view of a seat.
	_look_out_of(actor if looks_out or is_own else -1)
	if actor >= 0:
		camera.target = _actors[actor].hips()
		camera.head = _actors[actor].head()
		camera.heading = _actors[actor].heading()
		if actor == _followed.own and not is_nan(_look.x):
			_look_by_hand()
		if not _is_aimed:
			camera.snap()
			_is_aimed = true
	return actor if looks_out else -1


## A mouse turns the eyes at once, and the view from behind with them.
func _look_by_hand() -> void:
	var turn: Quaternion = Rotations.yaw(_look.x) * Quaternion(Vector3.RIGHT, -_look.y)
	camera.head = Transform3D(Basis(turn), camera.head.origin)
	camera.heading = _look.x
	if camera.view == OrbitCamera.View.BEHIND:
		camera.elevation = clampf(0.2 - _look.y, deg_to_rad(-60.0), deg_to_rad(80.0))


## Tells the camera where bodies near it are.
func _keep_camera_out() -> void:
	var ends: PackedVector3Array = []
	var radii: PackedFloat32Array = []
	var eye: Vector3 = camera.global_position
	for view: ActorView in _actors.values():
		if (
			view.node.visible
			and view.hips().distance_squared_to(eye) < _CAMERA_NEAR_M * _CAMERA_NEAR_M
		):
			view.write_skeleton()
			view.hull.append_to(ends, radii)
	camera.capsule_ends = ends
	camera.capsule_radii = radii


## Hides the head from whose eyes the camera looks, and shows the one before again; -1: nobody.
func _look_out_of(p_actor: int) -> void:
	if p_actor == eyes:
		return
	if hides_head and _actors.has(eyes):
		_actors[eyes].set_first_person(false)
	eyes = p_actor
	if hides_head and _actors.has(eyes):
		_actors[eyes].set_first_person(true)
