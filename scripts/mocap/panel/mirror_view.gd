class_name MirrorView
extends TextureRect
## A small lit room with a mirror: what hangs in [member stage] is seen as in it, the right hand on
## the right. The picture is made anew some times a second, and only while it is seen.
##
## Drag with the mouse, or left and right with the keyboard on it, to look from another side; the
## wheel brings it nearer.

## From where the person is seen.
enum Direction {
	## As in a mirror on the wall in front.
	FRONT,
	## As in a mirror at the side.
	SIDE,
	## As in two mirrors, of which the second one is behind: the right hand stays on the right.
	BACK,
}

## How often the picture is made, per second.
const RATE: float = 30.0
## The most lines that the picture has: more are not worth their cost.
const MAX_LINES: float = 1080.0
## How much the camera sees up and down, degrees.
const FOV_DEG: float = 36.0
## Half the edge of the room, and its height, m.
const ROOM_M: float = 2.2
const HEIGHT_M: float = 2.8

const _DISTANCES_M: Vector2 = Vector2(1.2, 4.8)
const _DISTANCE_M: float = 3.9
const _ELEVATION: float = 0.06
const _HIGHEST: float = 0.6
## Turn of one press of a key, rad, and of one pixel of the mouse.
const _STEP: float = PI / 12.0
const _PER_PIXEL: float = 0.008
## Time in which the room goes along with who walks, s.
const _FOLLOW_S: float = 0.4
## How far from the middle of the room somebody may be seen, m.
const _LEASH_M: float = 0.35

# Boards of the floor on an edge.
const _BOARDS: int = 8
const _WALL: Color = Color(0.42, 0.45, 0.49)
const _FLOOR: Color = Color(0.46, 0.41, 0.35)
const _JOINT: Color = Color(0.34, 0.3, 0.25)

## What is shown hangs here, in a world of its own. Front is +Z, the floor is where [method follow]
## says.
var stage: Node3D = Node3D.new()
## From where it is looked at.
var direction: Direction = Direction.FRONT

var _viewport: SubViewport = SubViewport.new()
var _room: Node3D = Node3D.new()
var _camera: Camera3D = Camera3D.new()
var _shade: MeshInstance3D = null
# How far the camera has been turned from where the person faced, rad, and how high, rad.
var _azimuth: float = 0.0
var _elevation: float = _ELEVATION
var _distance: float = _DISTANCE_M
# Where the person faces, and faced when the side was chosen; NAN: not known yet.
var _heading: float = 0.0
var _faced: float = NAN
var _tall: float = BodySize.USUAL_HEIGHT
var _due_s: float = 0.0


func _init() -> void:
	expand_mode = TextureRect.EXPAND_IGNORE_SIZE
	stretch_mode = TextureRect.STRETCH_SCALE
	focus_mode = Control.FOCUS_ALL
	mouse_default_cursor_shape = Control.CURSOR_DRAG
	flip_h = true
	_viewport.own_world_3d = true
	_viewport.handle_input_locally = false
	_viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	add_child(_viewport)
	_viewport.add_child(stage)
	_viewport.add_child(_room)
	_camera.fov = FOV_DEG
	_viewport.add_child(_camera)
	_furnish()
	texture = _viewport.get_texture()
	resized.connect(_fit)
	focus_entered.connect(queue_redraw)
	focus_exited.connect(queue_redraw)


func _ready() -> void:
	# Nothing moves by itself here.
	PhysicsServer3D.space_set_active(_viewport.find_world_3d().space, false)
	_fit()


func _process(p_delta: float) -> void:
	if not is_visible_in_tree():
		return
	_due_s -= p_delta
	if _due_s <= 0.0:
		_due_s = maxf(_due_s + 1.0 / RATE, 0.0)
		_place_camera()
		# As good as the window's own picture, in the tier of quality that the user has chosen.
		_viewport.msaa_3d = get_viewport().msaa_3d
		_viewport.scaling_3d_scale = get_viewport().scaling_3d_scale
		_viewport.mesh_lod_threshold = get_viewport().mesh_lod_threshold
		_viewport.render_target_update_mode = SubViewport.UPDATE_ONCE


func _draw() -> void:
	if has_focus():
		draw_rect(Rect2(Vector2.ZERO, size).grow(-1.0), UiStyle.ACCENT, false, 2.0)


func _gui_input(p_event: InputEvent) -> void:
	var dragged: InputEventMouseMotion = p_event as InputEventMouseMotion
	var button: InputEventMouseButton = p_event as InputEventMouseButton
	if dragged != null and dragged.button_mask & MOUSE_BUTTON_MASK_LEFT != 0:
		turn(dragged.relative.x * _PER_PIXEL, dragged.relative.y * _PER_PIXEL)
	elif button != null and button.pressed and button.button_index == MOUSE_BUTTON_WHEEL_UP:
		approach(0.9)
	elif button != null and button.pressed and button.button_index == MOUSE_BUTTON_WHEEL_DOWN:
		approach(1.0 / 0.9)
	elif p_event.is_action_pressed(&"ui_left", true):
		turn(-_STEP)
	elif p_event.is_action_pressed(&"ui_right", true):
		turn(_STEP)
	else:
		return
	accept_event()


## Looks from a side of where the person faces now.
func show_from(p_from: Direction) -> void:
	direction = p_from
	flip_h = p_from != Direction.BACK
	_azimuth = [0.0, PI / 2.0, PI][p_from]
	_elevation = _ELEVATION
	_faced = _heading


## Turns what is seen: to the right in the picture, and the camera upwards, rad.
func turn(p_right: float, p_higher: float = 0.0) -> void:
	_azimuth = wrapf(_azimuth + (p_right if flip_h else -p_right), -PI, PI)
	_elevation = clampf(_elevation + p_higher, -0.02, _HIGHEST)


## Changes the distance by a factor.
func approach(p_factor: float) -> void:
	_distance = clampf(_distance * p_factor, _DISTANCES_M.x, _DISTANCES_M.y)


## Somebody else is shown from now on, of a height, m: the mirror turns to where that one faces.
func begin(p_height: float) -> void:
	_tall = p_height
	_faced = NAN


## Lets the room go along with who moves: where the hips are, above which floor (Y), m, and the
## angle about the vertical to which they face, 0 towards +Z; the frame's length, s.
func follow(p_hips: Vector3, p_floor: float, p_heading: float, p_delta: float) -> void:
	_heading = p_heading
	var place: Vector3 = Vector3(p_hips.x, p_floor, p_hips.z)
	if is_nan(_faced):
		_faced = p_heading
		_room.position = place
	var before: Vector3 = Vector3(_room.position.x, p_floor, _room.position.z)
	var now: Vector3 = before.lerp(place, 1.0 - exp(-p_delta / _FOLLOW_S))
	_room.position = place - (place - now).limit_length(_LEASH_M)
	_room.rotation.y = _faced
	_shade.global_position = place + Vector3(0.0, 0.004, 0.0)


## Where a point of [member stage] is in the picture, px from its upper left corner.
func seen_at(p_point: Vector3) -> Vector2:
	_place_camera()
	var at: Vector2 = _camera.unproject_position(p_point) / Vector2(_viewport.size) * size
	return Vector2(size.x - at.x, at.y) if flip_h else at


func _fit() -> void:
	# As many pixels as the screen has there.
	var unit: float = (
		get_viewport().get_screen_transform().get_scale().x if is_inside_tree() else 1.0
	)
	var lines: float = clampf(size.y * unit, 16.0, MAX_LINES)
	var wide: float = clampf(lines * size.x / maxf(size.y, 1.0), 16.0, MAX_LINES * 2.0)
	_viewport.size = Vector2i(roundi(wide), roundi(lines))


func _place_camera() -> void:
	var middle: Vector3 = _room.position + Vector3(0.0, 0.53 * _tall, 0.0)
	var faced: float = 0.0 if is_nan(_faced) else _faced
	var away: Vector3 = Vector3.BACK.rotated(Vector3.RIGHT, -_elevation)
	# Taller people are seen from further away, and where the picture is narrow, too.
	var narrow: float = maxf(1.0, 0.8 * size.y / maxf(size.x, 1.0))
	var far: float = _distance * _tall / BodySize.USUAL_HEIGHT * narrow
	_camera.position = middle + away.rotated(Vector3.UP, faced + _azimuth) * far
	_camera.basis = Basis.looking_at(middle - _camera.position)


func _furnish() -> void:
	_room.add_child(_board(Vector3.UP, Vector2(ROOM_M, ROOM_M) * 2.0, Vector3.ZERO, _floor_look()))
	var wall: StandardMaterial3D = _wall_look()
	var high: Vector3 = Vector3(0.0, HEIGHT_M / 2.0, 0.0)
	# Seen from inside only: the camera stands outside.
	for inward: Vector3 in [Vector3.BACK, Vector3.FORWARD, Vector3.LEFT, Vector3.RIGHT]:
		var extent: Vector2 = Vector2(ROOM_M * 2.0, HEIGHT_M)
		_room.add_child(_board(inward, extent, high - inward * ROOM_M, wall))
	# One lamp, for the person alone: three that lit the room too took 0.3 s a picture where a
	# processor draws.
	var lamp: OmniLight3D = OmniLight3D.new()
	lamp.position = Vector3(-1.0, 2.6, 1.9)
	lamp.omni_range = 5.5
	lamp.light_color = Color(1.0, 0.95, 0.88)
	# People's shader takes lamps without shadows by this: see light.gdshaderinc.
	lamp.light_specular = 0.0
	_room.add_child(lamp)
	_shade = _make_shade()
	_room.add_child(_shade)
	var surroundings: WorldEnvironment = WorldEnvironment.new()
	surroundings.environment = Environment.new()
	surroundings.environment.background_mode = Environment.BG_COLOR
	surroundings.environment.background_color = UiStyle.SURFACE
	_viewport.add_child(surroundings)


static func _board(
	p_normal: Vector3, p_size: Vector2, p_at: Vector3, p_look: Material
) -> MeshInstance3D:
	var mesh: QuadMesh = QuadMesh.new()
	mesh.size = p_size
	mesh.material = p_look
	var board: MeshInstance3D = MeshInstance3D.new()
	board.mesh = mesh
	board.position = p_at
	# A quad faces +Z.
	var up: Vector3 = Vector3.FORWARD if p_normal == Vector3.UP else Vector3.UP
	board.basis = Basis.looking_at(p_normal, up, true)
	return board


## Its light is painted: no lamp has to be worked out for it.
static func _look(p_picture: Texture2D) -> StandardMaterial3D:
	var look: StandardMaterial3D = StandardMaterial3D.new()
	look.albedo_texture = p_picture
	look.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	return look


## Brightest near the ceiling, where the lamp is.
static func _wall_look() -> StandardMaterial3D:
	var fade: Gradient = Gradient.new()
	fade.set_color(0, _WALL.lightened(0.25))
	fade.set_color(1, _WALL.darkened(0.25))
	var picture: GradientTexture2D = GradientTexture2D.new()
	picture.gradient = fade
	picture.fill_from = Vector2(0.5, 0.0)
	picture.fill_to = Vector2(0.5, 1.0)
	return _look(picture)


## Boards with joints, so that one sees where the feet are; bright in the middle.
static func _floor_look() -> StandardMaterial3D:
	var picture: Image = Image.create(_BOARDS * 64, _BOARDS * 64, false, Image.FORMAT_RGB8)
	picture.fill(_JOINT)
	for at: int in _BOARDS * _BOARDS:
		var place: Vector2i = Vector2i(at % _BOARDS, at / _BOARDS)
		var off: float = (Vector2(place) + Vector2(0.5, 0.5)).distance_to(
			Vector2(_BOARDS, _BOARDS) / 2.0
		)
		var board: Rect2i = Rect2i(place * 64 + Vector2i(1, 1), Vector2i(62, 62))
		picture.fill_rect(board, _FLOOR.darkened(0.6 * off / _BOARDS))
	picture.generate_mipmaps()
	return _look(ImageTexture.create_from_image(picture))


## What stands somewhere darkens the floor below: cheaper than shadows of lamps.
static func _make_shade() -> MeshInstance3D:
	var fade: Gradient = Gradient.new()
	fade.set_color(0, Color(0.0, 0.0, 0.0, 0.55))
	fade.set_color(1, Color(0.0, 0.0, 0.0, 0.0))
	var spot: GradientTexture2D = GradientTexture2D.new()
	spot.gradient = fade
	spot.fill = GradientTexture2D.FILL_RADIAL
	spot.fill_from = Vector2(0.5, 0.5)
	spot.fill_to = Vector2(1.0, 0.5)
	var look: StandardMaterial3D = _look(spot)
	look.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	return _board(Vector3.UP, Vector2(1.0, 1.0), Vector3.ZERO, look)
