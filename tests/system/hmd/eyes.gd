extends Node3D
## Moves a headset by Monado's remote driver and compares both eyes' pictures of a small target with
## what geometry says of the pose that was commanded. Prints one line of JSON.

const _TARGET: Vector3 = Vector3(0.06, 1.55, -0.9)
## Half the distance of the eyes of Monado's headset, m.
const _HALF_IPD: float = 0.0315
const _SETTLE_FRAMES: int = 6

var _poses: Array[Transform3D] = [
	Transform3D(Basis.IDENTITY, Vector3(0.0, 1.6, 0.0)),
	Transform3D(Basis(Vector3.UP, 0.2), Vector3(0.1, 1.62, 0.05)),
	Transform3D(Basis(Vector3.RIGHT, 0.15), Vector3(-0.08, 1.5, 0.02)),
	Transform3D(Basis(Vector3.BACK, 0.3), Vector3(0.02, 1.58, -0.1)),
	Transform3D(Basis(Vector3(1.0, 2.0, 0.5).normalized(), -0.22), Vector3(0.15, 1.65, 0.1)),
]
var _display: HmdDisplay = HmdDisplay.new()
var _reader: EyeReader = null
var _remote: StreamPeerTCP = StreamPeerTCP.new()
var _frames: int = 0
var _next: int = 0
var _sent_frame: int = -1
var _since: int = 0
var _error_px: float = 0.0
var _lag: int = 0
var _withheld_px: float = 0.0


func _ready() -> void:
	var camera: Camera3D = Camera3D.new()
	add_child(camera)
	_display.camera = camera
	_display.set_mirror(HmdDisplay.Mirror.NONE)
	_display.keeper = FullQuality.new()
	add_child(_display)
	var fault: String = _display.open()
	if fault != "":
		print("JSON ", JSON.stringify({"fault": fault}))
		get_tree().quit(1)
		return
	var world: WorldEnvironment = WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = Color.BLACK
	world.compositor = Compositor.new()
	_reader = EyeReader.new()
	world.compositor.compositor_effects = [_reader]
	add_child(world)
	var target: MeshInstance3D = MeshInstance3D.new()
	var ball: SphereMesh = SphereMesh.new()
	ball.radius = 0.01
	ball.height = 0.02
	target.mesh = ball
	target.position = _TARGET
	var white: StandardMaterial3D = StandardMaterial3D.new()
	white.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	target.material_override = white
	add_child(target)
	_remote.connect_to_host("127.0.0.1", int(OS.get_environment("REMOTE_PORT")))


func _process(_delta: float) -> void:
	_remote.poll()
	_display.place_room(Transform3D.IDENTITY)
	_frames += 1
	if _reader == null or _remote.get_status() != StreamPeerTCP.STATUS_CONNECTED or _frames < 20:
		return
	if _sent_frame < 0:
		# What the last pose shows against the next one, which is withheld, must be wrong.
		if _next > 0:
			_withheld_px = maxf(_withheld_px, _compare(_poses[_next]))
		_send(_poses[_next])
		_sent_frame = _frames
		_since = 0
	elif _since == 0:
		if _display.head_in_world().origin.distance_to(_poses[_next].origin) < 1e-4:
			_lag = maxi(_lag, _frames - _sent_frame)
			_since = 1
	else:
		_since += 1
		if _since >= _SETTLE_FRAMES:
			_error_px = maxf(_error_px, _compare(_poses[_next]))
			_next += 1
			_sent_frame = -1
			if _next == _poses.size():
				_end()


func _end() -> void:
	var report: Dictionary = {
		"poses": _poses.size(),
		"error_px": _error_px,
		"lag_frames": _lag,
		"withheld_px": _withheld_px,
		"size": [_reader.size.x, _reader.size.y],
	}
	print("JSON ", JSON.stringify(report))
	get_tree().quit(0)


## The greatest distance of the target, in both pictures, from where it is seen from a pose; px.
func _compare(p_head: Transform3D) -> float:
	var openxr: XRInterface = XRServer.find_interface("OpenXR")
	var worst: float = 0.0
	var size: Vector2 = _reader.size
	for view: int in 2:
		var eye: Transform3D = p_head.translated_local(
			Vector3(_HALF_IPD if view == 1 else -_HALF_IPD, 0.0, 0.0)
		)
		var at: Vector3 = eye.affine_inverse() * _TARGET
		var lens: Projection = openxr.get_projection_for_view(view, size.x / size.y, 0.05, 100.0)
		var clip: Vector4 = lens * Vector4(at.x, at.y, at.z, 1.0)
		var seen: Vector2 = Vector2(1.0 + clip.x / clip.w, 1.0 - clip.y / clip.w) * 0.5 * size
		var off: float = seen.distance_to(_reader.found[view])
		worst = maxf(worst, off if is_finite(off) else 1000.0)
	return worst


## Struct r_remote_data, see tools/toolchain/monado.py; without controllers.
func _send(p_head: Transform3D) -> void:
	var packet: PackedByteArray = "mndrmt3".to_ascii_buffer()
	packet.resize(376)
	var turn: Quaternion = p_head.basis.get_rotation_quaternion()
	var at: Vector3 = p_head.origin
	var values: PackedFloat32Array = [turn.x, turn.y, turn.z, turn.w, at.x, at.y, at.z]
	for i: int in values.size():
		packet.encode_float(104 + 4 * i, values[i])
	# Rotations of what is not there are rotations as well.
	for offset: int in [36, 84, 148, 268]:
		packet.encode_float(offset, 1.0)
	_remote.put_data(packet)


## Compared is where things are seen: a busy machine must not make the pictures smaller meanwhile.
class FullQuality:
	extends RateKeeper

	func add(
		_frame_s: float, _period_s: float, _card_s: float = 0.0, _is_held_up: bool = false
	) -> void:
		pass
