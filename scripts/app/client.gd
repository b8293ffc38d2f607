class_name Client
extends Node
## A client: a trainee who sends motion, an observer who watches, or the replay of a recording.
##
## It never simulates: everything that moves is put where the server says, by way of a
## [SnapshotBuffer].

## Seconds between two attempts to reach a server.
const _RETRY_S: float = 2.0
## Frames per second without a window: enough to send every sample in time.
const _HEADLESS_FPS: int = 240
## Samples that a frame may send.
const _MOST_SAMPLES: int = 16
const _EXIT_FAILED: int = 1
const _EXIT_OPTIONS: int = 2
const _EXIT_REFUSED: int = 3
const _EXIT_NO_SERVER: int = 4

@export var _scene: ClientScene
@export var _hud: Hud

var _role: String = ""
var _options: Options = null
var _link: ClientLink = ClientLink.new()
var _player: SnapshotPlayer = null
var _recorder: SnapshotRecorder = null
var _source: MotionSource = null
var _report: ReportFile = null
var _greeting: Greeting = Greeting.new()
var _orders: InstructorOrders = null
var _clock_s: float = 0.0
var _next_sample_usec: int = 0
var _retry_at_s: float = 0.0
var _alone_since_s: float = 0.0
var _exit_code: int = 0
var _figures: ClientFigures = ClientFigures.new()


## Takes over the options. Call it before the node enters the tree.
func configure(p_role: String, p_options: Options) -> void:
	_role = p_role
	_options = p_options


func _ready() -> void:
	PhysicsServer3D.set_active(false)
	if DisplayServer.get_name() == "headless":
		Engine.max_fps = _HEADLESS_FPS
	_report = ReportFile.new(_options.file("report"))
	var fault: String = _scene.apply(_options.text("views"), _options.text("camera"))
	if fault == "" and _role == "trainee":
		fault = _open_source()
	if fault != "":
		_quit(_EXIT_OPTIONS, fault)
		return
	if _options.file("record") != "":
		_recorder = SnapshotRecorder.new()
		fault = _recorder.open(_options.file("record"))
	if fault == "":
		fault = _open_player() if _role == "replay" else _open_link()
	if fault != "":
		_quit(_EXIT_FAILED, fault)
		return
	if DisplayServer.get_name() != "headless":
		RenderingServer.frame_post_draw.connect(_on_frame_drawn)


func _process(p_delta: float) -> void:
	if _exit_code != 0:
		return
	_clock_s = _clock_s + p_delta if _role == "replay" else Time.get_ticks_usec() / 1e6
	if _role == "replay":
		_player.advance(_clock_s)
	else:
		_link.poll()
		_send_samples()
		_keep_trying()
	_scene.update(_clock_s)
	_figures.frame(_scene, DisplayServer.get_name() == "headless")
	_show_status()
	_check_duration()


func _exit_tree() -> void:
	if _report != null:
		_report.write(_make_report())
	if _recorder != null:
		_recorder.close()
	_link.close()


func _open_source() -> String:
	var source: BvhSource = BvhSource.new()
	var path: String = _options.file("bvh")
	if path == "":
		return "a trainee needs a motion source: --bvh=FILE"
	source.open(path, _options.text("unit"), _options.text("up"))
	if source.error == "":
		_source = source
		Log.info("mocap", source.describe())
	return source.error


func _open_player() -> String:
	_player = SnapshotPlayer.new()
	_player.snapshot_received.connect(_on_snapshot)
	_player.world_received.connect(_on_world)
	_player.finished.connect(func() -> void: get_tree().quit(0))
	return _player.open(_options.file("file"))


func _open_link() -> String:
	_greeting.role = Protocol.Role[_role.to_upper()]
	_greeting.name = _options.text("name") if _options.text("name") != "" else _role
	_greeting.rate = _options.number("snapshot-rate")
	_greeting.version = _options.number("protocol")
	if _source != null:
		_greeting.hip_height = _source.get_hip_height()
	_orders = InstructorOrders.new(_options.text("orders"))
	if _orders.error != "":
		return _orders.error
	var fault: String = _set_up_encryption()
	if fault != "":
		return fault
	_link.joined.connect(_on_joined)
	_link.lost.connect(_on_lost)
	_link.refused.connect(_on_refused)
	_link.waiting.connect(_on_waiting)
	_link.snapshot_received.connect(_on_datagram)
	_link.world_received.connect(_on_world)
	_alone_since_s = Time.get_ticks_usec() / 1e6
	_connect()
	return ""


func _set_up_encryption() -> String:
	var certificate: String = _options.file("dtls-certificate")
	var options: TransportSecurity = TransportSecurity.client(
		_options.number("dtls") != 0, certificate
	)
	_link.tls = options.tls
	Log.info("net", options.describe())
	return options.error


func _connect() -> void:
	var where: Array = [_options.text("host"), _options.number("port")]
	_hud.show_message("Joining %s:%d ..." % where)
	_retry_at_s = INF
	_link.open(where[0], where[1], _greeting, _options.text("password"))
	if _greeting.role == Protocol.Role.INSTRUCTOR:
		_orders.attach(SessionControl.follow(self, _link))


func _keep_trying() -> void:
	var now: float = Time.get_ticks_usec() / 1e6
	if not _link.is_joined() and now > _retry_at_s:
		_connect()
	var patience: float = _options.seconds("connect-timeout")
	if not _link.is_joined() and patience > 0.0 and now - _alone_since_s > patience:
		var where: Array = [_options.text("host"), _options.number("port"), patience]
		_quit(_EXIT_NO_SERVER, "no server at %s:%d for %.0f s" % where)


func _send_samples() -> void:
	var now: int = int(Time.get_unix_time_from_system() * 1e6)
	if _source == null or not _link.is_joined():
		return
	var period: int = 1000000 / _options.number("rate")
	# A slow display may not thin out the motion: what was due since the last frame goes together.
	_next_sample_usec = maxi(_next_sample_usec, now - period * _MOST_SAMPLES)
	while _next_sample_usec <= now:
		var sample: PoseSample = _source.sample(_next_sample_usec)
		if sample != null:
			_link.send_pose(PosePacket.encode(sample))
		_next_sample_usec += period


func _on_joined() -> void:
	Log.info("client", "joined %s:%d" % [_options.text("host"), _options.number("port")])
	_hud.show_message("")


func _on_lost(p_why: String) -> void:
	Log.limited("client", p_why, "%s; trying again" % p_why)
	_hud.show_message("%s.\nTrying again ..." % p_why.capitalize())
	var now: float = Time.get_ticks_usec() / 1e6
	if _retry_at_s != INF or _scene.has_world():
		_alone_since_s = now
	_scene.clear()
	_retry_at_s = now + _RETRY_S


func _on_refused(p_why: String) -> void:
	_quit(_EXIT_REFUSED, "the server refused us: %s" % p_why)


func _on_waiting(p_place: int) -> void:
	_hud.show_message("Waiting for an instructor, place %d ..." % p_place)
	Log.limited("client", "waiting", "waiting for an instructor, place %d" % p_place)
	_alone_since_s = Time.get_ticks_usec() / 1e6


func _on_datagram(p_bytes: PackedByteArray, _p_arrival_usec: int) -> void:
	var snapshot: Snapshot = SnapshotPacket.decode(p_bytes)
	if snapshot != null:
		_on_snapshot(snapshot, p_bytes)
	else:
		Log.limited("net", "snapshot", "the server sent %d bytes of no use" % p_bytes.size())


func _on_snapshot(p_snapshot: Snapshot, p_bytes: PackedByteArray) -> void:
	_figures.snapshots += 1
	_scene.push(p_snapshot, _clock_s)
	if _recorder != null:
		_recorder.add(p_bytes)


func _on_world(p_world: WorldDescription, p_bytes: PackedByteArray) -> void:
	_scene.describe(p_world)
	if _recorder != null:
		_recorder.add(p_bytes)


func _on_frame_drawn() -> void:
	_figures.drawn()


func _show_status() -> void:
	if Engine.get_process_frames() % 10 == 0:
		_hud.show_status(_figures.describe(_role, _link.traffic), _scene.describe_views())
	if _report.is_due():
		_report.write(_make_report())


func _make_report() -> Dictionary:
	return _figures.report(_role, _link.traffic)


func _check_duration() -> void:
	var duration: float = _options.seconds("duration")
	# A film is made slower than it plays: a replay has a clock of its own.
	var elapsed: float = _clock_s if _role == "replay" else _figures.seconds()
	if duration > 0.0 and elapsed > duration:
		if _options.file("screenshot") != "":
			_take_picture(_options.file("screenshot"))
		get_tree().quit(0)


func _take_picture(p_path: String) -> void:
	var image: Image = get_viewport().get_texture().get_image()
	var error: Error = image.save_png(p_path) if image != null else ERR_UNAVAILABLE
	if error != OK:
		Log.error("client", "no picture could be saved to %s: %s" % [p_path, error_string(error)])


## Ends with a code; in a window the message stays until it is closed.
func _quit(p_code: int, p_why: String) -> void:
	_exit_code = p_code
	Log.error("client", p_why)
	_hud.show_message(p_why.left(1).to_upper() + p_why.substr(1) + ".")
	var stays: bool = p_code == _EXIT_REFUSED and DisplayServer.get_name() != "headless"
	if stays and _options.seconds("duration") == 0.0:
		get_tree().auto_accept_quit = false
		get_window().close_requested.connect(get_tree().quit.bind(p_code))
	else:
		get_tree().quit(p_code)
