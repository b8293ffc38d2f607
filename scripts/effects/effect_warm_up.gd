class_name EffectWarmUp
extends SubViewport
## Draws every effect in a small picture that nobody sees, while a client loads. Otherwise compiling
## a shader (up to 0.1 s each) would freeze the picture at the first shot.
##
## It must be in the world where effects are shown: with other air and other lights the engine
## compiles other variants. So it draws them far below that world, without a lamp and beside one.

## All effects have been drawn.
signal finished

## Frames for which each is drawn: the first makes its particles, the second draws them.
const FRAMES: int = 2
## Files that are drawn at once.
const AT_ONCE: int = 2
## No powers of two, as windows have none: drivers that draw with the processor compile others for
## those.
const _SIZE: Vector2i = Vector2i(44, 28)
## Depth at which they are drawn, m: no level reaches so deep.
const _PLACE: Vector3 = Vector3(0.0, -2000.0, 0.0)
## Kinds of light: none, and a lamp, such as the flash of a gun.
const _ROUNDS: int = 2
const _FAINT_RANGE_M: float = 60.0

var _waiting: Array[EffectLayer] = []
var _shown: Array[ParticleEffect] = []
var _left: int = 0
var _round: int = 0
var _lamp: OmniLight3D = null
## The same beside the user's eye, too faint to be seen: the first flash of a gun lights the level,
## whose surfaces are compiled anew for it.
var _faint_lamp: OmniLight3D = null


func _ready() -> void:
	size = _SIZE
	# What is compiled depends on these too.
	var window: Window = get_window()
	if window != null:
		msaa_3d = window.msaa_3d
		use_hdr_2d = window.use_hdr_2d
	render_target_update_mode = SubViewport.UPDATE_ALWAYS
	var camera: Camera3D = Camera3D.new()
	camera.position = _PLACE + Vector3(0.0, 0.5, 3.0)
	add_child(camera)
	_lamp = OmniLight3D.new()
	_lamp.position = _PLACE + Vector3(0.0, 0.5, 2.0)
	_lamp.visible = false
	add_child(_lamp)
	_faint_lamp = OmniLight3D.new()
	_faint_lamp.light_energy = 0.001
	_faint_lamp.omni_range = _FAINT_RANGE_M
	_faint_lamp.visible = false
	add_child(_faint_lamp)
	if DisplayServer.get_name() != "headless":
		_begin_round()


func _process(_p_delta: float) -> void:
	if _left > 0:
		_left -= 1
		return
	for shown: ParticleEffect in _shown:
		shown.queue_free()
	_shown.clear()
	if _waiting.is_empty() and _round < _ROUNDS - 1 and DisplayServer.get_name() != "headless":
		_round += 1
		_begin_round()
	if _waiting.is_empty():
		finished.emit()
		queue_free()
		return
	for _index: int in mini(AT_ONCE, _waiting.size()):
		_show(_waiting.pop_back())
	_left = FRAMES


## All files at first; then one of each shader that draws some.
func _begin_round() -> void:
	_lamp.visible = _round > 0
	var camera: Camera3D = get_parent().get_viewport().get_camera_3d()
	if _round > 0 and camera != null:
		_faint_lamp.global_position = camera.global_position
		_faint_lamp.visible = true
	var library: EffectLibrary = EffectLibrary.shared()
	var drawn: Dictionary[Shader, bool] = {}
	for name: String in library.files():
		var layer: EffectLayer = library.find(name)
		if _round == 0 or not drawn.has(layer.material.shader):
			_waiting.append(layer)
		drawn[layer.material.shader] = true


func _show(p_layer: EffectLayer) -> void:
	var shown: ParticleEffect = ParticleEffect.new()
	shown.show_layer(p_layer)
	shown.visibility_range_end = 0.0
	shown.amount = mini(shown.amount, 8)
	shown.position = _PLACE
	add_child(shown)
	shown.restart()
	_shown.append(shown)
