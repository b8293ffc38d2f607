class_name HmdMenu
extends Node3D
## A menu in front of the wearer, at arm's length, which a ray from a hand points at and presses.
##
## It shows any [Control], on a layer of the runtime's own where it has one (sharper than anything
## in the picture, and steady at low rates), else on a board in the scene. Put it below the view's
## origin.

## It was opened or closed.
signal opened(p_is_open: bool)

## Size of the board, m, and of its picture, px: at 0.8 m a pixel is 0.06 degrees, so that letters
## of 26 px are seen as those of a book are.
const SIZE_M: Vector2 = Vector2(1.0, 0.75)
const SIZE_PX: Vector2i = Vector2i(1200, 900)
## How far in front of the eyes it opens, and how far below them, m.
const _AHEAD_M: float = 0.8
const _BELOW_M: float = 0.1
## How far a trigger is in when it presses, and when it releases.
const _PRESSED: float = 0.6
const _RELEASED: float = 0.4

var _picture: SubViewport = SubViewport.new()
var _layer: OpenXRCompositionLayerQuad = null
var _board: MeshInstance3D = MeshInstance3D.new()
var _ray: MeshInstance3D = MeshInstance3D.new()
var _hand: int = 1
var _at: Vector2 = Vector2.ZERO
var _is_down: bool = false
var _was_on: bool = false


func _init() -> void:
	_picture.size = SIZE_PX
	_picture.transparent_bg = true
	_picture.render_target_update_mode = SubViewport.UPDATE_DISABLED
	_picture.disable_3d = true
	add_child(_picture)
	var quad: QuadMesh = QuadMesh.new()
	quad.size = SIZE_M
	_board.mesh = quad
	add_child(_board)
	var line: BoxMesh = BoxMesh.new()
	line.size = Vector3(0.004, 0.004, 1.0)
	_ray.mesh = line
	var bright: StandardMaterial3D = StandardMaterial3D.new()
	bright.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	bright.albedo_color = Color(0.4, 0.8, 1.0)
	_ray.material_override = bright
	_ray.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	_ray.top_level = true
	add_child(_ray)
	visible = false


func _ready() -> void:
	var paper: StandardMaterial3D = StandardMaterial3D.new()
	paper.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	paper.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	paper.albedo_texture = _picture.get_texture()
	_board.material_override = paper
	_board.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF


## Shows a control, which fills the board. It stays whose it was: [method close] gives it up.
func open(p_control: Control, p_head: Transform3D) -> void:
	close()
	_picture.add_child(p_control)
	p_control.set_anchors_and_offsets_preset(Control.PRESET_FULL_RECT)
	face(p_head)
	visible = true
	_picture.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	if _layer != null:
		_layer.transform = transform
		_layer.visible = true
	opened.emit(true)


## Hides it and takes the control out of it.
func close() -> void:
	_release()
	_picture.render_target_update_mode = SubViewport.UPDATE_DISABLED
	for child: Node in _picture.get_children():
		_picture.remove_child(child)
	if _layer != null:
		_layer.visible = false
	if visible:
		visible = false
		opened.emit(false)


## Whether it is shown.
func is_open() -> bool:
	return visible


## Uses a layer of the runtime's where it has such; the board then only takes the rays. Returns
## whether it does. Takes the origin of the tracking space, this node's parent.
func use_layer(p_origin: XROrigin3D) -> bool:
	_layer = OpenXRCompositionLayerQuad.new()
	_layer.quad_size = SIZE_M
	_layer.alpha_blend = true
	_layer.sort_order = 1
	_layer.visible = false
	# The engine takes it only directly below the origin.
	p_origin.add_child(_layer)
	if not _layer.is_natively_supported():
		_layer.queue_free()
		_layer = null
		return false
	_layer.layer_viewport = _picture
	_board.visible = false
	return true


## Comes before the eyes, upright. Takes the head in the space of this node's parent.
func face(p_head: Transform3D) -> void:
	var turn: Basis = Basis(Vector3.UP, Recentring.heading_of(p_head.basis))
	transform = Transform3D(turn, p_head.origin - turn.z * _AHEAD_M + Vector3.DOWN * _BELOW_M)


## A frame: where both hands point in the world (-Z ahead) and how far their triggers are in, 0 to
## 1.
func point(p_hands: Array[Transform3D], p_triggers: PackedFloat32Array) -> void:
	if not visible:
		_ray.visible = false
		return
	for hand: int in p_hands.size():
		# Whichever pulls its trigger is the one that points.
		if not _is_down and p_triggers[hand] > _PRESSED:
			_hand = hand
	_hand = mini(_hand, p_hands.size() - 1)
	var hit: Vector2 = hit_by(p_hands[_hand])
	var is_on: bool = hit.is_finite()
	_show_ray(p_hands[_hand], is_on)
	if is_on:
		_move(hit * Vector2(SIZE_PX))
	elif _was_on:
		_release()
	_was_on = is_on
	if is_on and not _is_down and p_triggers[_hand] > _PRESSED:
		_press(true)
	elif _is_down and p_triggers[_hand] < _RELEASED:
		_press(false)


## Where a hand's ray hits the board: 0 to 1 from its upper left corner; infinite where it does not.
func hit_by(p_hand: Transform3D) -> Vector2:
	var inside: Transform3D = global_transform.affine_inverse() * p_hand
	var ahead: Vector3 = -inside.basis.z
	# From behind, or along it.
	if not inside.is_finite() or ahead.z > -1e-6 or inside.origin.z <= 0.0:
		return Vector2.INF
	var at: Vector3 = inside.origin - ahead * inside.origin.z / ahead.z
	var share: Vector2 = Vector2(0.5 + at.x / SIZE_M.x, 0.5 - at.y / SIZE_M.y)
	return share if Rect2(Vector2.ZERO, Vector2.ONE).has_point(share) else Vector2.INF


func _show_ray(p_hand: Transform3D, p_is_on: bool) -> void:
	_ray.visible = p_is_on
	if not p_is_on:
		return
	var length: float = p_hand.origin.distance_to(_to_world(_at / Vector2(SIZE_PX)))
	_ray.global_transform = Transform3D(
		p_hand.basis.orthonormalized().scaled_local(Vector3(1.0, 1.0, length)),
		p_hand.origin - p_hand.basis.orthonormalized().z * length * 0.5
	)


func _to_world(p_share: Vector2) -> Vector3:
	var at: Vector2 = (p_share - Vector2(0.5, 0.5)) * SIZE_M
	return global_transform * Vector3(at.x, -at.y, 0.0)


func _move(p_at: Vector2) -> void:
	var event: InputEventMouseMotion = InputEventMouseMotion.new()
	event.position = p_at
	event.global_position = p_at
	event.relative = p_at - _at
	event.button_mask = MOUSE_BUTTON_MASK_LEFT if _is_down else 0 as MouseButtonMask
	_at = p_at
	_picture.push_input(event, true)


func _press(p_is_down: bool) -> void:
	_is_down = p_is_down
	var event: InputEventMouseButton = InputEventMouseButton.new()
	event.position = _at
	event.global_position = _at
	event.button_index = MOUSE_BUTTON_LEFT
	event.button_mask = MOUSE_BUTTON_MASK_LEFT if p_is_down else 0 as MouseButtonMask
	event.pressed = p_is_down
	_picture.push_input(event, true)


## A press that leaves the board is none: it ends outside of everything.
func _release() -> void:
	if not _is_down:
		return
	_move(Vector2(-1.0, -1.0))
	_press(false)
