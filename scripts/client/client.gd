class_name Client
extends Node
## A client: a trainee who sends motion, an observer who watches, or the replay of a recording.
##
## It never simulates: everything that moves is put where its [StateStream] says, by way of a
## [WorldReplica]; only a trainee's own body is shown as the trainee moves it.

## Frames that must have been shown before a picture is taken, and how long that is waited for, s.
const _PICTURE_FRAMES: int = 8
const _PICTURE_PATIENCE_S: float = 60.0

@export var _scene: ClientScene
@export var _hud: Hud
@export var _mocap: MocapSetup
@export var _interaction: Interaction
@export var _controls: WindowControls
@export var _seat: ClientSeat
@export var _sound: ClientSound
@export var _display: ClientDisplay

var _role: String = ""
var _options: Options = null
var _stream: StateStream = null
var _recorder: StateRecorder = null
var _stats_sent_s: float = 0.0
var _report: ReportFile = null
var _desk: InstructorDesk = null
var _wearer: WearerReports = null
var _shared: SharedClient = null
var _arrival: LevelArrival = null
var _effects: EffectUpdates = null
var _begin_s: float = 0.0
var _exit_code: int = 0
var _stats: ClientStats = ClientStats.new()
var _stop: StopSignal = StopSignal.new()
var _pacer: FramePacer = null
var _fade: PhysicsFade = PhysicsFade.new()
var _clock: FrameClock = null


## Takes over the options. Call it before the node enters the tree.
func configure(p_role: String, p_options: Options) -> void:
	_role = p_role
	_options = p_options


func _ready() -> void:
	ClientPhysics.begin()
	get_tree().auto_accept_quit = false
	if DisplayServer.get_name() == "headless":
		Engine.max_fps = _options.number("fps")
		# Else Godot makes 145 frames a second at most where nothing is drawn.
		OS.low_processor_usage_mode_sleep_usec = 1
	else:
		RenderingServer.frame_post_draw.connect(_on_frame_drawn)
	_pacer = FramePacer.new(Engine.max_fps if FramePacer.is_free() else 0)
	_report = ReportFile.new(_options.file("report"), _options.seconds("report-every"))
	_stop.watch()
	_hud.show_probe(_stats.probe)
	_controls.set_up(_role, _options)
	_scene.avatars.keep(_options.text("avatar"))
	_display.leaving.connect(_on_leaving)
	_controls.leave_wanted.connect(_leave)
	_display.leave_wanted.connect(_leave)
	_display.open(_options)
	_clock = FrameClock.of_window()
	var fault: String = _apply_options()
	if fault != "":
		_quit(StateStream.EXIT_OPTIONS, fault)
		return
	fault = _open_files()
	if fault == "":
		fault = _stream.open()
	_begin_s = _stream.now_s()
	if fault != "":
		_quit(StateStream.EXIT_FAILED, fault)


func _process(p_delta: float) -> void:
	if _exit_code != 0:
		return
	_display.await_frame()
	_display.read_devices(_seat)
	if _mocap.people != null:
		_mocap.advance(_stream.now_s())
		_wearer.advance(_stream.now_s())
		_hud.show_guide(_mocap.guide(_stream.now_s()))
	if _desk != null:
		_desk.advance(_stream.now_s())
	_stream.advance(p_delta)
	if _arrival != null:
		_arrival.advance(p_delta, _take)
	_acknowledge()
	_seat.set_menu_open(_controls.is_menu_open())
	_scene.fade_physics(_fade, _stream.now_s() - _begin_s)
	_update_scene()
	_show_status()
	_check_duration()


func _physics_process(_delta: float) -> void:
	ClientPhysics.advance()


func _notification(p_what: int) -> void:
	if p_what == NOTIFICATION_WM_CLOSE_REQUEST:
		_leave()


func _exit_tree() -> void:
	_mocap.close()
	if _arrival != null:
		_arrival.close()
	if _desk != null:
		_desk.close()
	if _report != null:
		_report.write(_make_report())
	if _recorder != null:
		_recorder.close()
	_stats.probe.close()
	if _stream != null:
		_stream.close()


## Puts the parts together as the options ask. Returns what is wrong, or an empty text.
func _apply_options() -> String:
	var fault: String = _scene.apply(_options.text("views"), _options.text("camera"))
	fault = _fade.set_from_text(_options.text("physics-at")) if fault == "" else fault
	_scene.replica.wants_marks = _options.file("latency-csv") != ""
	_scene.replica.set_smoothing(_options.text("smoothing"))
	var made: ClientStreams = ClientStreams.make(_role, _options)
	fault = made.error if fault == "" else fault
	_stream = made.stream
	_connect_stream()
	_sound.open(_scene, _options, _controls.settings(), _controls.sound_menu())
	if fault == "" and _role != ClientStreams.REPLAY:
		var has_body: bool = Roles.can(Roles.find(_role), Roles.Capability.SEND_MOTION)
		fault = _seat.open(_scene, _hud, _options, has_body)
		_controls.wheel_wanted.connect(_seat.show_wheel_panel)
	if fault == "" and Roles.can(Roles.find(_role), Roles.Capability.SEND_MOTION):
		_mocap.headset = _display.headset
		fault = _mocap.open(_options, made.live.link)
		made.live.joined.connect(_mocap.people.begin)
		_wearer = WearerReports.new(made.live.link, _mocap)
		made.live.link.calibration_asked.connect(
			func(index: int, kind: int, number: int) -> void:
				_wearer.calibrate(index, kind, number, _stream.now_s())
		)
	if fault == "" and Roles.can(Roles.find(_role), Roles.Capability.MODERATE):
		var things: ThingOrders = ThingOrders.new(_scene.replica, _scene.entities)
		_desk = InstructorDesk.new(made.live.link, _options.text("orders"), things)
		_desk.quit_wanted.connect(_leave.bind(0))
		fault = _desk.error
	if fault == "" and made.live != null:
		made.live.link.told.connect(_on_told)
		_controls.ask_about_keys(made.live, _options)
		_shared = SharedClient.new(made.live.link, Roles.find(_role) as Roles.Role)
		_scene.get_level().shared = _shared.api
		if _options.is_on("prediction"):
			_seat.predict(made.live, _scene.replica)
		made.live.connecting.connect(_shared.reconnect)
		_await_levels(made.live.link)
		_effects = EffectUpdates.new(made.live.link)
	return fault


## Levels of a server are loaded over several frames, and got from it where they are not here.
func _await_levels(p_link: ClientLink) -> void:
	var store: ReceivedLevels = ReceivedLevels.new()
	store.room = _options.number("level-store") << 20
	_scene.get_level().store = store
	_arrival = LevelArrival.new(_scene, store, p_link.send_reliably)
	_arrival.hold_shared = p_link.hold_shared
	_arrival.progressed.connect(_hud.show_message)
	p_link.handle(
		Protocol.Message.LEVEL_DATA,
		MessageHandlers.Path.RELIABLE,
		func(bytes: PackedByteArray, _arrival_usec: int) -> bool: return _arrival.take_data(bytes)
	)


func _connect_stream() -> void:
	_stream.received.connect(_on_received)
	_stream.restarted.connect(_on_restarted)
	_stream.status_changed.connect(_hud.show_message)
	_stream.ended.connect(_on_ended)
	_scene.entities.use(_stream)
	_scene.level_noted.connect(_hud.show_note.bind(&"level"))
	_scene.happening_told.connect(_hud.show_news)
	# What has been recorded takes no commands.
	if _role == ClientStreams.REPLAY:
		_interaction.process_mode = Node.PROCESS_MODE_DISABLED
	_interaction.prompt_changed.connect(_hud.show_prompt)
	if _display.is_worn():
		_interaction.aim = _display.headset.aim
	_interaction.use_by_name(_options.text("use"))
	_scene.level_missing.connect(
		func(why: String) -> void: _on_ended(StateStream.EXIT_REFUSED, why)
	)
	_scene.replica.marked.connect(_on_marked)
	_scene.replica.table.spawned.connect(_on_spawned)


func _open_files() -> String:
	if _options.file("record") != "":
		_recorder = StateRecorder.new()
		var fault: String = _recorder.open(_display.fresh_file(_options.file("record")))
		if fault != "":
			return fault
	if _options.file("latency-csv") != "":
		return _stats.probe.write_to(_display.fresh_file(_options.file("latency-csv")))
	return ""


## The program is about to start again, with a headset: everything that is open ends in order.
func _on_leaving() -> void:
	if _report != null and _stream != null:
		_report.write(_make_report())
	if _recorder != null:
		_recorder.close()
	_stats.probe.close()
	_mocap.close()
	if _shared != null:
		_shared.api.close()
	if _stream != null:
		_stream.close()


func _acknowledge() -> void:
	var bytes: PackedByteArray = _scene.replica.acknowledgement(
		Time.get_ticks_usec(), _scene.viewpoint()
	)
	if not bytes.is_empty() and _mocap.people != null:
		_mocap.people.send_ack(bytes)
	elif not bytes.is_empty():
		_stream.send_fast(bytes)
	if _scene.replica.is_ready() and _stream.now_s() - _stats_sent_s > StatsMessage.PERIOD_S:
		_stats_sent_s = _stream.now_s()
		_stream.send_fast(_stats.packet())


func _update_scene() -> void:
	var own: Dictionary[int, PackedFloat32Array] = {}
	var begin: int = Time.get_ticks_usec()
	_stats.times.begin(begin)
	var now: int = _clock.begin(begin, _display.due_usec())
	var people: ClientPeople = _mocap.people
	if people != null and _scene.replica.is_ready():
		own = people.evaluate(now, _scene.replica)
	if _options.text("feedback") == "server":
		own.clear()
	elif people != null and own.has(people.first_actor):
		_stats.own_shown(people.shown_moment_usec(now))
	_seat.apply_prediction()
	_scene.sees_by_own_eyes = _display.is_own_view()
	_sound.hear_at(_display.head())
	_scene.update(_stream.frame_s(now), own, _display.agreement(now))
	_display.place_wearer(people, own, get_process_delta_time())
	var headless: bool = DisplayServer.get_name() == "headless"
	if FramePacer.is_free() and not _display.is_worn():
		Engine.max_fps = _pacer.limit_for(_scene.replica.shown_tick(), _scene.replica.tick_rate())
	_stats.frame(_scene.replica, _stream.server_usec(begin), headless)
	_stats.times.placed(Time.get_ticks_usec())
	_display.placed()


func _on_received(p_bytes: PackedByteArray, p_time_s: float) -> void:
	if _recorder != null:
		_recorder.add(p_bytes)
	if _arrival == null or not _arrival.keeps(p_bytes):
		_take(p_bytes, p_time_s)


func _take(p_bytes: PackedByteArray, p_time_s: float = 0.0) -> void:
	_scene.replica.take(p_bytes, p_time_s)
	_stats.snapshots = _scene.replica.datagrams


func _on_marked(p_mark: LatencyMark) -> void:
	if not _stream.knows_server_clock():
		return
	p_mark.arrival_usec = _stream.server_usec(p_mark.arrival_usec)
	_stats.probe.arrived(p_mark)
	if _mocap.people != null:
		_mocap.people.note_trip(p_mark)


func _on_spawned(p_row: EntityRow) -> void:
	if _mocap.people != null and p_row.is_person() and p_row.owner == _stream.session():
		_mocap.people.embody(_scene)
		_scene.follow_own(_mocap.people.first_actor, _options.text("camera") == "")


func _on_restarted() -> void:
	_hud.show_note("", &"told")
	_scene.clear()
	if _arrival != null:
		_arrival.restart()
	_stats.probe.restart()
	if _recorder != null:
		_recorder.begin()


func _on_ended(p_exit_code: int, p_why: String) -> void:
	if p_exit_code == StateStream.EXIT_DONE:
		_leave(0)
	else:
		_quit(p_exit_code, p_why)


func _on_told(p_text: String) -> void:
	Log.warning("client", p_text)
	_hud.show_note(p_text, &"told")
	_display.tell(p_text)
	_sound.click_radio()


func _on_frame_drawn() -> void:
	var now: int = Time.get_ticks_usec()
	_clock.drawn(now)
	_stats.times.drawn(now)
	if _stream != null:
		_stats.drawn(_stream.server_usec(now))


func _show_status() -> void:
	if Engine.get_process_frames() % 10 == 0:
		var text: String = _stats.describe(_role, _stream.traffic, _stream.security())
		_hud.show_status(text, _scene.describe_views() + "   " + _controls.hint())
		if _mocap.people != null:
			_hud.show_tether(_scene.describe_tether(_mocap.people.first_actor))
		if _role != ClientStreams.REPLAY:
			_hud.show_screen(ScreenDelay.describe() + "; " + _stats.times.describe())
	if _report.is_due():
		_report.write(_make_report())


func _make_report() -> Dictionary:
	var people: Array[Dictionary] = []
	if _mocap.people != null:
		people = _mocap.people.stats()
	var traffic: TrafficMeter = _stream.traffic if _stream != null else TrafficMeter.new()
	var report: Dictionary = _stats.report(_role, traffic, people)
	if _arrival != null:
		report["level"] = _arrival.report()
	if _effects != null:
		report["effects"] = _effects.report()
	report["driving"] = _seat.report()
	report["sound"] = _sound.report()
	report["display"] = _display.report()
	return report


func _check_duration() -> void:
	var takes_picture: bool = _options.file("screenshot") != ""
	if _stop.is_raised():
		if takes_picture:
			_take_picture(_options.file("screenshot"))
		_leave(0)
		return
	var duration: float = _options.seconds("duration")
	# A film is made slower than it plays: a recording has a clock of its own.
	var elapsed: float = _stream.now_s() - _begin_s
	if duration == 0.0 or elapsed < duration:
		return
	if takes_picture:
		# A busy machine may not have drawn anything by then.
		if _stats.shown_frames < _PICTURE_FRAMES and elapsed < duration + _PICTURE_PATIENCE_S:
			return
		_take_picture(_options.file("screenshot"))
	_leave(0)


func _take_picture(p_path: String) -> void:
	_controls.draw_for_picture(_options.text("quality"))
	var image: Image = get_viewport().get_texture().get_image()
	var error: Error = image.save_png(p_path) if image != null else ERR_UNAVAILABLE
	if error != OK:
		Log.error("client", "no picture could be saved to %s: %s" % [p_path, error_string(error)])


## Ends with a code; in a window the message stays until it is closed.
func _quit(p_code: int, p_why: String) -> void:
	_exit_code = p_code
	Log.error("client", p_why)
	_hud.show_message(p_why.left(1).to_upper() + p_why.substr(1) + ".")
	var is_read: bool = p_code == StateStream.EXIT_REFUSED or p_code == StateStream.EXIT_OPTIONS
	if not is_read or DisplayServer.get_name() == "headless" or _options.seconds("duration") > 0.0:
		_leave(p_code)


## Ends the program with a code, as soon as no thread reads a level and nothing is heard.
func _leave(p_code: int = _exit_code) -> void:
	if _shared != null:
		_shared.api.close()
	set_process(false)
	_display.stay_away()
	if _arrival != null:
		await _arrival.end_reading(get_tree())
	await MixerRelease.release(self)
	get_tree().quit(p_code)
