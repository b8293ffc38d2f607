extends SceneTree
## Films a recording for the start screen's backdrop: the camera glides to and fro, and nothing is
## written over the picture. film_backdrop.sh runs it; the engine's movie writer takes the frames.

const _CLIENT: PackedScene = preload("res://scenes/client/client.tscn")
## How far the camera glides about where the options put it: about the vertical and the horizon,
## rad, and nearer and further, m.
const _GLIDE: Vector3 = Vector3(0.12, 0.03, 2.0)
const _PERIOD_S: float = 16.0

var _client: Client = _CLIENT.instantiate()
var _camera: OrbitCamera = null
var _rest: Vector3 = Vector3.ZERO
var _time_s: float = 0.0


func _initialize() -> void:
	var options: Options = ProgramOptions.parse(OS.get_cmdline_user_args(), ProgramRoles.REPLAY)
	assert(options.error == "", options.error)
	var parts: PackedStringArray = ProgramParts.of_client(ProgramRoles.REPLAY)
	_client.configure(ProgramRoles.REPLAY, options, parts)
	_client.left.connect(quit)
	root.add_child(_client)


func _process(p_delta: float) -> bool:
	for layer: Node in _client.find_children("*", "CanvasLayer", true, false):
		(layer as CanvasLayer).visible = false
	for label: Node in _client.find_children("*", "Label3D", true, false):
		(label as Label3D).visible = false
	if _camera == null:
		_camera = root.get_camera_3d() as OrbitCamera
		if _camera != null:
			_rest = Vector3(_camera.azimuth, _camera.elevation, _camera.distance)
		return false
	_time_s += p_delta
	var turn: float = TAU * _time_s / _PERIOD_S
	_camera.azimuth = _rest.x + _GLIDE.x * sin(turn)
	_camera.elevation = _rest.y + _GLIDE.y * sin(2.0 * turn)
	_camera.distance = _rest.z - _GLIDE.z * cos(turn)
	return false
