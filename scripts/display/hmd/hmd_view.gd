class_name HmdView
extends SubViewport
## What the wearer's two eyes see: a viewport of its own, so that the window outlives the headset.

## What is compiled while a frame waits.
const _COMPILED: Array[RenderingServer.RenderingInfo] = [
	RenderingServer.RENDERING_INFO_PIPELINE_COMPILATIONS_MESH,
	RenderingServer.RENDERING_INFO_PIPELINE_COMPILATIONS_SURFACE,
	RenderingServer.RENDERING_INFO_PIPELINE_COMPILATIONS_DRAW,
]

## The tracking space; its transform is where that space is in the world.
var origin: XROrigin3D = XROrigin3D.new()
## The head.
var head: XRCamera3D = XRCamera3D.new()
## Darkens the edges while the wearer is moved.
var vignette: Vignette = Vignette.new()

var _hands: Array[XRController3D] = []
var _compiled: int = 0


func _init() -> void:
	use_xr = true
	own_world_3d = false
	audio_listener_enable_3d = false
	gui_disable_input = true
	# The size is the runtime's; this is what it has before.
	size = Vector2i(64, 64)
	render_target_update_mode = SubViewport.UPDATE_ALWAYS
	RenderingServer.viewport_set_measure_render_time(get_viewport_rid(), true)
	origin.add_child(head)
	head.near = 0.05
	head.add_child(vignette)
	for tracker: StringName in [&"left_hand", &"right_hand"]:
		var hand: XRController3D = XRController3D.new()
		hand.tracker = tracker
		hand.pose = &"aim"
		_hands.append(hand)
		origin.add_child(hand)
	add_child(origin)


## The left (0) or right (1) hand: where it points.
func hand(p_hand: int) -> XRController3D:
	return _hands[p_hand]


## Where the eyes are in the world, m, and where they look: degrees about +Y, 0 towards +Z.
func describe_eyes() -> Array[float]:
	var at: Vector3 = head.global_position
	return [at.x, at.y, at.z, rad_to_deg(Recentring.facing_of(head.global_basis))]


## How long the card took for both eyes' pictures of the last frame of which that is known, s; 0
## where it does not tell.
func drawing_s() -> float:
	return RenderingServer.viewport_get_measured_render_time_gpu(get_viewport_rid()) / 1000.0


## Whether a frame had to wait for programs of the card to be compiled since this was last asked.
func has_compiled() -> bool:
	var before: int = _compiled
	_compiled = 0
	for info: RenderingServer.RenderingInfo in _COMPILED:
		_compiled += RenderingServer.get_rendering_info(info)
	return _compiled != before


## Draws as a step of [constant RateKeeper.STEPS] says.
func set_quality(p_row: Dictionary) -> void:
	scaling_3d_scale = p_row["scale"]
	msaa_3d = p_row["msaa"]
	positional_shadow_atlas_size = 2048 if p_row["shadows"] else 0
