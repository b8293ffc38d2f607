@tool
@icon("res://scenes/world/icons/camera_screen.svg")
class_name CameraScreen
extends KitBlock
## A big screen with the picture of a [FilmCamera], live: what a wearer does is seen on it while he
## does it. Its origin is the middle of the screen, which is seen from +Z.
##
## The picture costs a second rendering of the level, so it is small, taken only every few frames
## and only while the screen is on somebody's display. Screens are on a layer of their own that the
## camera does not see. A dedicated server shows nothing.

## Layer of screens: no camera of a screen sees them.
const LAYER: int = 1 << 19
const _SHADER: String = "res://assets/shaders/camera_screen.gdshader"
const _FRAME_M: float = 0.12
const _DEEP_M: float = 0.14
## Most pictures in a second.
const _MAX_RATE: float = 30.0
const _SHADOWS: int = 512

## Whose picture it shows; where none is chosen, that of the first of the level.
@export var camera: FilmCamera = null:
	set(p_value):
		camera = p_value
		update_configuration_warnings()
## Width and height.
@export_custom(PROPERTY_HINT_NONE, "suffix:m") var size: Vector2 = Vector2(6.4, 3.6):
	set(p_value):
		size = p_value.clamp(Vector2(0.2, 0.2), Vector2(40.0, 40.0))
		queue_rebuild()
## Lines of the picture; its width follows from the size.
@export_range(60, 1080, 10, "suffix:px") var lines: int = 200:
	set(p_value):
		lines = clampi(p_value, 60, 1080)
		queue_rebuild()
## A picture every so many frames.
@export_range(1, 20) var every: int = 3:
	set(p_value):
		every = clampi(p_value, 1, 20)
## How bright the screen is.
@export_range(0.0, 4.0, 0.05) var brightness: float = 1.15:
	set(p_value):
		brightness = clampf(p_value, 0.0, 4.0)
		queue_rebuild()

# How many times fewer lines and pictures there are in the lowest tier of quality.
var _thrift: int = 1
var _viewport: SubViewport = null
var _eye: Camera3D = null
var _watch: VisibleOnScreenNotifier3D = null
var _frames: int = 0
var _waited: float = 0.0


static func kit_entry() -> KitEntry:
	var entry: KitEntry = KitEntry.of_block(
		CameraScreen,
		4,
		{"camera": PropertyRule.node(["FilmCamera"]), "size": PropertyRule.vector2(0.2, 40.0)}
	)
	entry.offered("Camera screen", "video wall", {}, 3.0)
	return entry


func _init() -> void:
	super()
	add_to_group(Quality.FOLLOWERS)


func _get_configuration_warnings() -> PackedStringArray:
	var warnings: PackedStringArray = super()
	if is_inside_tree() and _has_scene() and find_camera() == null:
		warnings.append("It stays dark: add a FilmCamera and choose it for 'Camera'.")
	if lines * lines * size.x / size.y > 1_000_000.0:
		warnings.append("Its picture has over a million pixels: choose fewer 'Lines'.")
	return warnings


func _process(p_delta: float) -> void:
	_waited += p_delta
	_frames += 1
	if not _watch.is_on_screen():
		return
	if _frames < every * _thrift or _waited < 1.0 / _MAX_RATE:
		return
	take_picture()


func contact_key() -> StringName:
	return &"metal"


func build(p_mesh: BlockMesh, _p_part: StringName) -> void:
	var half: Vector2 = size / 2.0
	var rim: Vector2 = half + Vector2.ONE * _FRAME_M
	var paint: int = Steelwork.PAINT
	var black: int = SurfaceTints.Tint.BLACK
	p_mesh.box(
		Vector3(-rim.x, -rim.y, -_DEEP_M), Vector3(rim.x, rim.y, -0.02), paint, black, 0, true
	)
	for side: float in [-1.0, 1.0]:
		var x: float = side * (half.x + _FRAME_M / 2.0)
		var y: float = side * (half.y + _FRAME_M / 2.0)
		var wide: float = _FRAME_M / 2.0
		p_mesh.box(Vector3(x - wide, -rim.y, -0.02), Vector3(x + wide, rim.y, 0.02), paint, black)
		p_mesh.box(Vector3(-rim.x, y - wide, -0.02), Vector3(rim.x, y + wide, 0.02), paint, black)


func rebuild() -> void:
	super()
	_viewport = null
	var is_shown: bool = is_inside_tree() and DisplayServer.get_name() != "headless"
	set_process(is_shown and not Engine.is_editor_hint())
	if not is_shown:
		return
	_viewport = SubViewport.new()
	_viewport.size = get_resolution()
	_viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	_viewport.positional_shadow_atlas_size = _SHADOWS
	_viewport.positional_shadow_atlas_16_bits = false
	_viewport.gui_disable_input = true
	add_child(_viewport, false, Node.INTERNAL_MODE_BACK)
	_eye = Camera3D.new()
	_eye.add_to_group(KitBlock.EYES_GROUP)
	_eye.cull_mask = 0xfffff & ~LAYER
	_viewport.add_child(_eye)
	_watch = VisibleOnScreenNotifier3D.new()
	_watch.aabb = AABB(Vector3(-size.x, -size.y, -0.1) / 2.0, Vector3(size.x, size.y, 0.1))
	_watch.layers = LAYER
	add_child(_watch, false, Node.INTERNAL_MODE_BACK)
	add_child(_make_screen(), false, Node.INTERNAL_MODE_BACK)
	_be_due()
	follow_quality()


## Width and height of the picture.
func get_resolution() -> Vector2i:
	var high: int = lines / _thrift
	return Vector2i(maxi(8, roundi(high * size.x / size.y)), high)


## Spends less in the lowest tier of quality: see [Quality].
func follow_quality() -> void:
	var thrift: int = 2 if Quality.tier.name == Quality.NAMES[0] else 1
	if thrift == _thrift or _viewport == null:
		return
	_thrift = thrift
	_viewport.size = get_resolution()
	_viewport.positional_shadow_atlas_size = _SHADOWS if Quality.tier.shadow_pixels > 0 else 0
	# Another size has taken the picture away.
	take_picture()


## The picture as it was taken last; null on a server.
func get_picture() -> ViewportTexture:
	return _viewport.get_texture() if _viewport != null else null


## The camera whose picture it shows, or null.
func find_camera() -> FilmCamera:
	if camera != null or not is_inside_tree():
		return camera
	return get_tree().get_first_node_in_group(FilmCamera.GROUP) as FilmCamera


## Takes a picture with the next frame.
func take_picture() -> void:
	var film: FilmCamera = find_camera()
	if _viewport == null or film == null:
		return
	var hips: PackedVector3Array = []
	for node: Node in get_tree().get_nodes_in_group(Ragdoll.PEOPLE):
		var person: Ragdoll = node as Ragdoll
		if person != null and person.visible:
			hips.append(person.get_bone_transform(&"Hips").origin)
	film.advance(_waited, hips)
	_eye.global_transform = film.get_view()
	_eye.fov = film.get_fov()
	_viewport.render_target_update_mode = SubViewport.UPDATE_ONCE
	_frames = 0
	_waited = 0.0


## Lets it take a picture with the next frame that shows it.
func _be_due() -> void:
	_frames = every * _thrift
	_waited = maxf(_waited, 1.0 / _MAX_RATE)


## Whether it is in a level, and not in the hand of somebody who places it.
func _has_scene() -> bool:
	return _is_in_level() or owner != null


func _make_screen() -> MeshInstance3D:
	var quad: QuadMesh = QuadMesh.new()
	quad.size = size
	var material: ShaderMaterial = ShaderMaterial.new()
	material.shader = load(_SHADER)
	material.set_shader_parameter(&"picture", _viewport.get_texture())
	material.set_shader_parameter(&"pixels", Vector2(get_resolution()))
	material.set_shader_parameter(&"brightness", brightness)
	var shown: MeshInstance3D = MeshInstance3D.new()
	shown.mesh = quad
	shown.material_override = material
	shown.layers = LAYER
	shown.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	return shown
