class_name EffectWarmUp
extends SubViewport
## Draws every effect once in a small picture that nobody sees, while a client loads: what a shader
## takes to be compiled (up to 0.1 s each) would else freeze the picture at the first shot.

## All effects have been drawn.
signal finished

## How long each is drawn, frames: the first makes its particles, the second draws them.
const FRAMES: int = 3
## Files that are drawn in a frame.
const AT_ONCE: int = 2
const _EDGE: int = 32

var _waiting: Array[EffectLayer] = []
var _shown: Array[ParticleEffect] = []
var _left: int = 0


func _ready() -> void:
	size = Vector2i.ONE * _EDGE
	own_world_3d = true
	# What compiles depends on these too.
	var window: Window = get_window()
	if window != null:
		msaa_3d = window.msaa_3d
		use_hdr_2d = window.use_hdr_2d
	render_target_update_mode = SubViewport.UPDATE_ALWAYS
	var camera: Camera3D = Camera3D.new()
	camera.position = Vector3(0.0, 0.5, 3.0)
	add_child(camera)
	var library: EffectLibrary = EffectLibrary.shared()
	for name: String in library.files():
		_waiting.append(library.find(name))
	if DisplayServer.get_name() == "headless":
		_waiting.clear()


func _process(_p_delta: float) -> void:
	if _left > 0:
		_left -= 1
		return
	for shown: ParticleEffect in _shown:
		shown.queue_free()
	_shown.clear()
	if _waiting.is_empty():
		finished.emit()
		queue_free()
		return
	for _index: int in mini(AT_ONCE, _waiting.size()):
		_show(_waiting.pop_back())
	_left = FRAMES


## Whether there is something left to draw.
func is_busy() -> bool:
	return not (_waiting.is_empty() and _shown.is_empty())


func _show(p_layer: EffectLayer) -> void:
	var shown: ParticleEffect = ParticleEffect.new()
	shown.show_layer(p_layer)
	shown.amount = mini(shown.amount, 8)
	add_child(shown)
	shown.restart()
	_shown.append(shown)
