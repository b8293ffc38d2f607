class_name Client
extends Node
## A client: a trainee who sends motion, an observer who watches, or the replay of a recording.
##
## It never simulates: everything that moves is put where the server says, by way of a
## [WorldReplica]; only a trainee's own body is shown as the trainee moves it.

## Seconds between two attempts to reach a server.
const _RETRY_S: float = 2.0
## Seconds until the first one after a connection that stood.
const _SOON_S: float = 0.3
## Frames per second without a window: enough to send every sample in time.
const _HEADLESS_FPS: int = 240
const _EXIT_FAILED: int = 1
const _EXIT_OPTIONS: int = 2
const _EXIT_REFUSED: int = 3
const _EXIT_NO_SERVER: int = 4

@export var _scene: ClientScene
@export var _hud: Hud
@export var _mocap: MocapSetup

var _role: String = ""
var _options: Options = null
var _link: ClientLink = ClientLink.new()
var _player: SnapshotPlayer = null
var _recorder: SnapshotRecorder = null
var _told_s: float = 0.0
var _was_joined: bool = false
var _report: ReportFile = null
var _request: JoinRequest = JoinRequest.new()
var _orders: InstructorOrders = null
var _clock_s: float = 0.0
var _retry_at_s: float = 0.0
var _alone_since_s: float = 0.0
var _exit_code: int = 0
var _stats: ClientStats = ClientStats.new()
var _stop: StopSignal = StopSignal.new()
var _pacer: FramePacer = null


## Takes over the options. Call it before the node enters the tree.
func configure(p_role: String, p_options: Options) -> void:
	_role = p_role
	_options = p_options


func _ready() -> void:
	PhysicsServer3D.set_active(false)
	if DisplayServer.get_name() == "headless":
		var frames: int = _options.number("fps")
		Engine.max_fps = frames if frames > 0 else _HEADLESS_FPS
	_pacer = FramePacer.new(Engine.max_fps if FramePacer.is_free() else 0)
	_report = ReportFile.new(_options.file("report"))
	var fault: String = _scene.apply(_options.text("views"), _options.text("camera"))
	_apply_choices()
	if fault == "" and _role == "trainee":
		fault = _mocap.open(_options, _link)
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
	_hud.show_probe(_stats.probe)
	if _options.file("latency-csv") != "":
		fault = _stats.probe.write_to(_options.file("latency-csv"))
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
		if _mocap.people != null:
			_mocap.advance(_clock_s)
			_hud.show_guide(_mocap.guide(_clock_s))
		_link.poll()
		_acknowledge()
		_keep_trying()
	_show_world()
	_show_status()
	_check_duration()


func _exit_tree() -> void:
	_mocap.close()
	if _report != null:
		_report.write(_make_report())
	if _recorder != null:
		_recorder.close()
	_stats.probe.close()
	_link.close()


func _apply_choices() -> void:
	_scene.replica.wants_marks = _options.file("latency-csv") != ""
	_scene.replica.set_smoothing(SmoothingMethods.find(_options.text("smoothing")))
	_stop.watch()


func _open_player() -> String:
	_player = SnapshotPlayer.new()
	_player.snapshot_received.connect(_take_snapshot)
	_player.restarted.connect(_scene.clear)
	_player.world_received.connect(_on_world)
	_player.finished.connect(func() -> void: get_tree().quit(0))
	return _player.open(_options.file("file"))


func _open_link() -> String:
	_request.role = Protocol.Role[_role.to_upper()]
	_request.name = _options.text("name") if _options.text("name") != "" else _role
	_request.rate = _options.number("snapshot-rate")
	_request.version = _options.number("protocol")
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
	_link.calibration_asked.connect(_on_calibration_asked)
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
	_link.open(where[0], where[1], _request, _options.text("password"))
	if _request.role == Protocol.Role.INSTRUCTOR:
		_orders.attach(SessionControl.follow(self, _link))


func _keep_trying() -> void:
	var now: float = Time.get_ticks_usec() / 1e6
	if not _link.is_joined() and now > _retry_at_s:
		_connect()
	var patience: float = _options.seconds("connect-timeout")
	if not _link.is_joined() and patience > 0.0 and now - _alone_since_s > patience:
		var where: Array = [_options.text("host"), _options.number("port"), patience]
		_quit(_EXIT_NO_SERVER, "no server at %s:%d for %.0f s" % where)


func _acknowledge() -> void:
	var bytes: PackedByteArray = _scene.replica.acknowledgement(
		Time.get_ticks_usec(), _scene.viewpoint()
	)
	if not bytes.is_empty():
		_link.send_fast(bytes)
	if _link.is_joined() and _clock_s - _told_s > StatsMessage.PERIOD_S:
		_told_s = _clock_s
		_link.send_fast(_stats.packet())


func _show_world() -> void:
	var own: Dictionary[int, PackedFloat32Array] = {}
	var now: int = Time.get_ticks_usec()
	var people: ClientPeople = _mocap.people
	if people != null and _link.is_joined():
		own = people.show(now, _scene.replica)
	if _options.text("feedback") == "server":
		own.clear()
	elif people != null and own.has(people.first_actor):
		_stats.own_shown(people.shown_moment_usec(now))
	_scene.update(_clock_s, own)
	var headless: bool = DisplayServer.get_name() == "headless"
	_stats.smoothing_delay_s = _scene.replica.delay()
	if FramePacer.is_free():
		Engine.max_fps = _pacer.limit_for(_scene.replica.shown_tick(), _scene.replica.tick_rate())
	_stats.frame(_scene.replica.shown_tick(), _server_usec(), headless)


func _on_joined() -> void:
	Log.info("client", "joined %s:%d" % [_options.text("host"), _options.number("port")])
	_hud.show_message("")
	_was_joined = true
	# What the server tells builds upon what it has told in this connection.
	_scene.clear()
	if _recorder != null:
		_recorder.begin()
	if _mocap.people != null:
		_mocap.people.begin()


func _on_lost(p_why: String) -> void:
	Log.limited("client", p_why, "%s; trying again" % p_why)
	_hud.show_message("%s.\nTrying again ..." % p_why.capitalize())
	var now: float = Time.get_ticks_usec() / 1e6
	# The first try after a good time comes soon.
	_retry_at_s = now + (_SOON_S if _was_joined else _RETRY_S)
	if _was_joined:
		_alone_since_s = now
	_was_joined = false
	_scene.clear()
	_stats.probe.restart()


func _on_refused(p_why: String) -> void:
	_quit(_EXIT_REFUSED, "the server refused us: %s" % p_why)


func _on_waiting(p_place: int) -> void:
	_hud.show_message("Waiting for an instructor, place %d ..." % p_place)
	Log.limited("client", "waiting", "waiting for an instructor, place %d" % p_place)
	_alone_since_s = Time.get_ticks_usec() / 1e6


func _on_datagram(p_bytes: PackedByteArray, p_arrival_usec: int) -> void:
	_take_snapshot(p_bytes, p_arrival_usec / 1e6)
	var mark: LatencyMark = _scene.replica.take_mark()
	if mark != null and _link.clock.is_known():
		mark.arrival_usec = _link.clock.server_usec(p_arrival_usec)
		_stats.probe.arrived(mark)
		if _mocap.people != null:
			_mocap.people.note_trip(mark)
	if _recorder != null:
		_recorder.add(p_bytes)


func _take_snapshot(p_bytes: PackedByteArray, p_arrival_s: float) -> void:
	if _scene.replica.take(p_bytes, p_arrival_s):
		_stats.snapshots += 1


func _on_world(p_world: WorldDescription, p_bytes: PackedByteArray) -> void:
	_scene.describe(p_world)
	if _mocap.people != null:
		_mocap.people.embody(p_world, _scene)
	if _recorder != null:
		_recorder.add(p_bytes)


func _on_calibration_asked(p_index: int, p_kind: int) -> void:
	if _mocap.people != null:
		_mocap.calibrate(p_index, p_kind, _clock_s)


func _on_frame_drawn() -> void:
	_stats.drawn(_server_usec())


## The server's clock, µs, as far as it is known.
func _server_usec() -> int:
	var now: int = Time.get_ticks_usec()
	return _link.clock.server_usec(now) if _link.clock.is_known() else now


func _show_status() -> void:
	if Engine.get_process_frames() % 10 == 0:
		_hud.show_status(_stats.describe(_role, _link.traffic), _scene.describe_views())
	if _report.is_due():
		_report.write(_make_report())


func _make_report() -> Dictionary:
	var people: Array[Dictionary] = []
	if _mocap.people != null:
		people = _mocap.people.stats()
	return _stats.report(_role, _link.traffic, people)


func _check_duration() -> void:
	if _stop.is_raised():
		get_tree().quit(0)
		return
	var duration: float = _options.seconds("duration")
	# A film is made slower than it plays: a replay has a clock of its own.
	var elapsed: float = _clock_s if _role == "replay" else _stats.seconds()
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
	var is_read: bool = p_code == _EXIT_REFUSED or p_code == _EXIT_OPTIONS
	var stays: bool = is_read and DisplayServer.get_name() != "headless"
	if stays and _options.seconds("duration") == 0.0:
		get_tree().auto_accept_quit = false
		get_window().close_requested.connect(get_tree().quit.bind(p_code))
	else:
		get_tree().quit(p_code)
