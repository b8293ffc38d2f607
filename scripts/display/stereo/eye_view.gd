class_name EyeView
extends SubViewport
## What one eye sees of the world of a window, drawn as that window draws.

## What an eye's picture takes over from the window, and its camera from the viewer's.
const _DRAWING: Array[StringName] = [
	&"msaa_3d",
	&"screen_space_aa",
	&"use_taa",
	&"use_debanding",
	&"use_occlusion_culling",
	&"mesh_lod_threshold",
	&"debug_draw",
	&"scaling_3d_mode",
	&"scaling_3d_scale",
	&"texture_mipmap_bias",
	&"anisotropic_filtering_level",
	&"fsr_sharpness",
	&"positional_shadow_atlas_size",
	&"positional_shadow_atlas_16_bits",
]
const _SEEING: Array[StringName] = [
	&"cull_mask", &"environment", &"attributes", &"compositor", &"far"
]

## The eye.
var camera: Camera3D = Camera3D.new()


func _init() -> void:
	render_target_update_mode = SubViewport.UPDATE_ALWAYS
	render_target_clear_mode = SubViewport.CLEAR_MODE_ALWAYS
	audio_listener_enable_2d = false
	gui_disable_input = true
	handle_input_locally = false
	add_child(camera)
	camera.current = true


## Draws the world of a viewer's camera as the camera's window does.
func follow(p_viewer: Camera3D) -> void:
	var window: Viewport = p_viewer.get_viewport()
	# Set only what has changed: most of these make buffers anew.
	if world_3d != window.find_world_3d():
		world_3d = window.find_world_3d()
	_take_over(self, window, _DRAWING)
	_take_over(camera, p_viewer, _SEEING)


## Resizes the picture, pixels.
func resize(p_size: Vector2i) -> void:
	var wanted: Vector2i = p_size.max(Vector2i(2, 2))
	if size != wanted:
		size = wanted


## Puts the eye to the right of the viewer by so much, m (negative: to the left), so that both eyes'
## pictures are one at a distance, m: an off-axis frustum, not a turned eye.
func look_beside(p_viewer: Camera3D, p_right_m: float, p_convergence_m: float) -> void:
	var from: Transform3D = p_viewer.get_camera_transform()
	camera.global_transform = from.translated_local(Vector3(p_right_m, 0.0, 0.0))
	camera.keep_aspect = p_viewer.keep_aspect
	var shift: Vector2 = Vector2(-p_right_m / p_convergence_m, 0.0)
	var extent: float = 2.0 * tan(deg_to_rad(p_viewer.fov) * 0.5)
	if p_viewer.projection == Camera3D.PROJECTION_FRUSTUM:
		extent = p_viewer.size / p_viewer.near
		shift += p_viewer.frustum_offset / p_viewer.near
	var near: float = p_viewer.near
	camera.set_frustum(extent * near, shift * near, near, p_viewer.far)


static func _take_over(p_to: Object, p_from: Object, p_names: Array[StringName]) -> void:
	for name: StringName in p_names:
		var value: Variant = p_from.get(name)
		if p_to.get(name) != value:
			p_to.set(name, value)
