class_name Server
extends Node
## The dedicated server: simulates the world, drives each trainee's ragdoll, sends everybody the
## state.
##
## A tick: process what has arrived, set the motors, let Jolt step; right after the step the new
## state is sent, in the same frame.

## Maximum ticks per second: a snapshot has the rate in a byte.
const _MAX_TICKS: int = 240
## Exit code for wrong options.
const _EXIT_OPTIONS: int = 2
## Below this speed of the world a frame's last tick is sent only.
const _MIN_SPEED: float = 0.8
## Seconds between two lines of stats in the log.
const _STATUS_S: float = 10.0
## Frames between two looks whether the process of --end-with is there.
const _WATCH_FRAMES: int = 30

@export var _level: ServerLevel
@export var _people: ServerPeople

var _options: Options = null
var _link: ServerLink = ServerLink.new()
var _sending: Replication = null
var _entities: ServerEntities = null
var _impacts: ServerImpacts = null
var _report: ReportFile = null
var _stats: ServerStats = null
var _status: StatusEndpoint = StatusEndpoint.new()
var _reload: ServerReload = null
var _stop: StopSignal = StopSignal.new()
var _pacer: TickPacer = TickPacer.new()
var _control: SessionControl = null
var _conditions: ServerConditions = null
var _shared: SharedServer = null
var _offers: LevelOffers = null
var _effects: ServerEffects = null
var _level_orders: LevelOrders = null
var _tick: int = 0
var _sent_tick: int = 0
var _network_usec: int = 0
var _names: Dictionary[int, String] = {}
var _lists: PeopleLists = PeopleLists.new()


## Takes over the options. Call it before the node enters the tree.
func configure(_p_role: String, p_options: Options) -> void:
	_options = p_options


## What it has counted so far.
func stats() -> ServerStats:
	return _stats


func _ready() -> void:
	_report = ReportFile.new(_options.file("report"), _options.seconds("report-every"))
	if _rate() > _MAX_TICKS:
		_give_up(_EXIT_OPTIONS, "%d ticks/s are set, %d is the most" % [_rate(), _MAX_TICKS])
		return
	_people.root_mode = RootModes.BY_NAME[_options.text("root")]
	_stats = ServerStats.new(_rate())
	if _open_link(_options.number("port")):
		_open_world()


## Sets the parts up; the level comes last, as all others listen to its signals.
func _open_world() -> void:
	var bits: float = _bandwidth()
	var error: float = _options.degrees("pose-error")
	_shared = SharedServer.new(_link)
	_level.shared = _shared.api
	_people.setup(_level.table, _options.number("max-people"))
	_sending = Replication.new(_link, _level, _people, _rate(), bits, error)
	_entities = ServerEntities.new(_link, _level.table, _people, _sending.encoder)
	_impacts = ServerImpacts.new(_level, _people)
	_offers = LevelOffers.new(_link, _level)
	_offers.bits_per_second = _options.number("level-bandwidth") * 1000.0
	_effects = ServerEffects.new(_link, _options.file("effects"))
	_level_orders = LevelOrders.new(_level, _link.rates)
	_entities.command_refused.connect(
		func(session: int, what: String) -> void: _control.tell_instructors(session, what)
	)
	_level.entity_added.connect(_on_entity_added)
	_level.leaving.connect(_people.leave)
	_level.leaving.connect(_entities.forget_waiting)
	_level.changed.connect(_on_level_changed)
	_people.person_added.connect(_on_person_added)
	_link.client_joined.connect(_on_joined)
	_link.client_returned.connect(_on_returned)
	_link.client_lost.connect(_sending.remove_client)
	_link.client_left.connect(_on_left)
	_link.people_declared.connect(_on_people)
	_link.pose_received.connect(_on_pose)
	var fault: String = _sending.record_to(_options.file("record"))
	_level.share = LevelShare.new(_options.file("levels"))
	fault = _level.share.find_fault() if fault == "" else fault
	fault = _effects.find_fault() if fault == "" else fault
	_conditions = ServerConditions.new(_level, _options.text("time"), _options.text("weather"))
	fault = _conditions.error if fault == "" else fault
	fault = _level.load_level(_options.text("world")) if fault == "" else fault
	if fault != "":
		_give_up(_EXIT_OPTIONS, fault)
		return
	_people.changes.prepare()
	_stop.watch()
	_stop.watch_reload()
	_open_status(_options.number("port"))
	var parts: Array = [_options.number("port"), _rate(), _level.level_name]
	Log.info("server", "listening on UDP port %d, %d ticks/s, world '%s'" % parts)


func _open_link(p_port: int) -> bool:
	var rules: ServerRules = ServerRules.new()
	ServerReload.apply(_options, rules)
	rules.bans = BanList.open(_options.file("ban-file"))
	rules.seals = _options.is_on("sealing")
	if rules.bans.error != "":
		_give_up(_EXIT_OPTIONS, rules.bans.error)
		return false
	if rules.seals:
		var key: ServerKeyFile = ServerKeyFile.open(_options.file("server-key"))
		if key.error != "":
			_give_up(_EXIT_OPTIONS, key.error)
			return false
		rules.server_key = key.key_seed
	if _link.listen(p_port, rules) != OK:
		_give_up(1, "UDP port %d is in use: choose another with --port" % p_port)
		return false
	Log.info("net", rules.sealing().describe())
	if rules.seals:
		Log.info("net", "the server's key is %s" % rules.fingerprint())
	_reload = ServerReload.new(_options, rules)
	_control = SessionControl.new(_link)
	_control.level_requested.connect(_change_level)
	_control.fields_requested.connect(_change_fields)
	_control.describer = _describe_client
	return true


## Options that may change while it runs.
func _take_options(p_options: Options) -> void:
	_options = p_options
	_people.changes.max_people = p_options.number("max-people")
	_offers.bits_per_second = p_options.number("level-bandwidth") * 1000.0
	_sending.set_bandwidth(_bandwidth())
	_link.renew_passwords()


## Of each client, bit/s.
func _bandwidth() -> float:
	return _options.number("bandwidth") * 1000.0


func _open_status(p_port: int) -> void:
	var port: int = _options.number("status-port")
	if port == 0:
		port = p_port
	if _status.open(port) != OK:
		Log.warning("server", "TCP port %d is in use: there is no status (--status-port)" % port)
		return
	Log.info("server", "status at http://127.0.0.1:%d/" % port)


func _give_up(p_code: int, p_why: String) -> void:
	Log.error("server", p_why)
	_leave(p_code)


func _physics_process(p_delta: float) -> void:
	var begin: int = Time.get_ticks_usec()
	if _sent_tick != _tick and _stats.watch.speed > _MIN_SPEED:
		# A late frame has several ticks: who sees the world gets each of them.
		_send_tick()
	_stats.begin_work()
	_network_usec -= ThreadClock.get_usec()
	_link.publish_tick(_tick + 1, begin, _rate())
	_link.poll()
	_control.advance()
	_network_usec += ThreadClock.get_usec()
	_tick += 1
	_people.tick = _tick
	_take_lists(begin / 1e6)
	_level_orders.advance(begin / 1e6)
	_level.advance(_tick)
	_offers.advance(p_delta)
	_effects.advance(p_delta)
	_sending.advance_survey()
	if not _level.is_between:
		_people.advance()
		_entities.advance(_tick, _rate())
		_people.drive(begin / 1e6, p_delta)
	_stats.ticks = _tick
	_stats.script_time.add((Time.get_ticks_usec() - begin) / 1e6)
	if _stats.begin_tick(begin):
		_report_speed()


func _process(_p_delta: float) -> void:
	_pacer.pace(_rate())
	if _sent_tick != _tick:
		_send_tick()
	elif TickPacer.is_idle(_rate()):
		_people.changes.restock()
	_stats.frame(Time.get_ticks_usec())
	_status.poll(_make_report)
	if _report.is_due():
		_report.write(_make_report())
	if _stats.since_status() > _STATUS_S:
		Log.info("server", _stats.describe(_link.session_ids().size(), _people.list().size()))
	if _stop.take_reload():
		_take_options(_reload.reload())
	var duration: float = _options.seconds("duration")
	if _stop.is_raised():
		Log.info("server", "stopped by a signal: ending all sessions")
		_leave(0)
	elif duration > 0.0 and _stats.seconds() > duration:
		_leave(0)
	elif Engine.get_process_frames() % _WATCH_FRAMES == 0 and not _has_companion():
		Log.info("server", "the process that it was to end with has ended")
		_leave(0)


func _exit_tree() -> void:
	if _report != null and _stats != null:
		_report.write(_make_report())
	_status.close()
	if _offers != null:
		_offers.close()
		_effects.close()
	if _sending != null:
		_sending.close()
	# The bodies are out of the tree already: nobody needs to know who leaves now.
	if _link.client_left.is_connected(_on_left):
		_link.client_left.disconnect(_on_left)
	_link.close()


## Whether the process of --end-with runs still.
func _has_companion() -> bool:
	var number: int = _options.number("end-with")
	if number == 0:
		return true
	var file: FileAccess = FileAccess.open("/proc/%d/stat" % number, FileAccess.READ)
	# One that has ended stays in the list until who started it asks, as the editor does not.
	return file != null and not file.get_line().get_slice(") ", 1).begins_with("Z")


## Sends the state after a tick's step.
func _send_tick() -> void:
	var now: int = Time.get_ticks_usec()
	_sent_tick = _tick
	var begin: int = ThreadClock.get_usec()
	if not _level.is_between:
		_people.measure()
		begin = ThreadClock.get_usec()
		var messages: Array[PackedByteArray] = _entities.take_messages()
		messages.append(_impacts.take_message(_tick, 1.0 / _rate()))
		_sending.send(_tick, now, messages)
	_stats.networked(_network_usec + ThreadClock.get_usec() - begin)
	_network_usec = 0
	_stats.send_time.add((Time.get_ticks_usec() - now) / 1e6)
	_stats.end_work()


func _report_speed() -> void:
	if not _stats.watch.is_slow:
		Log.info("server", "the world runs at full speed again")
		return
	var parts: Array = [
		100.0 * _stats.watch.speed, _people.list().size(), _link.session_ids().size()
	]
	var text: String = "the world runs at %.0f %% of its speed (%d people, %d clients): "
	Log.warning("server", text % parts + "the machine is too slow for it")


func _change_level(p_name: String, p_reply: Callable) -> void:
	_level_orders.ask(p_name, p_reply, Time.get_ticks_usec() / 1e6)


func _change_fields(p_values: Dictionary[StringName, float], p_answer: Callable) -> void:
	p_answer.call(_conditions.change(p_values))


func _describe_client(p_row: RosterRow) -> void:
	var stats: Dictionary = _sending.stats_of(p_row.session)
	p_row.round_trip_ms = stats.get("round_trip_ms", -1.0)
	p_row.delay_ms = stats.get("display_latency_ms_p50", -1.0)
	_people.describe(p_row)


func _on_level_changed() -> void:
	_link.rules.level_name = _level.reference
	_link.rules.level_fingerprint = _level.fingerprint
	_conditions.apply()
	var points: Array[Transform3D] = []
	var avatars: PackedStringArray = []
	for point: SpawnPoint in _level.level.get_spawn_points():
		points.append(point.get_start())
		avatars.append(point.avatar)
	_people.default_avatar = _level.level.default_avatar
	_people.enter(points, avatars)
	_survey_soon()


func _survey_soon() -> void:
	# Bodies are in the physics space after a step.
	await get_tree().physics_frame
	_sending.survey()


func _on_entity_added(p_row: EntityRow, p_node: Entity, p_body: PhysicsBody3D) -> void:
	if p_body != null:
		_entities.note_body(p_row, p_body)
	if p_node != null:
		_entities.bind(p_row, p_node)


func _on_person_added(p_person: ServerPerson) -> void:
	if p_person.entity != null:
		_entities.bind(_level.table.find(p_person.id), p_person.entity)


func _on_joined(p_session: int, p_hello: Dictionary) -> void:
	_entities.add_session(p_session)
	_sending.add_client(p_session, p_hello["rate"])
	_names[p_session] = p_hello["name"]


func _on_returned(p_session: int) -> void:
	_entities.add_session(p_session)
	_sending.add_client(p_session, _link.session(p_session).rate)


func _on_left(p_session: int) -> void:
	_entities.remove_session(p_session)
	_sending.remove_client(p_session)
	_names.erase(p_session)
	_lists.forget(p_session)
	_people.remove(p_session)


func _on_people(p_session: int, p_people: Array[PersonCard]) -> void:
	_lists.take(p_session, p_people)


## Applies what sessions have said of their people, as far as it counts yet.
func _take_lists(p_now_s: float) -> void:
	var due: Dictionary[int, Array] = _lists.take_due(p_now_s)
	for session: int in due:
		var cards: Array[PersonCard] = []
		cards.assign(due[session])
		if _people.set_people(session, cards, _names.get(session, "")) > 0:
			var text: String = "the server has room for %d people: not all of yours have a body"
			text = text % _people.changes.max_people
			_link.send_reliably([session], NoticeMessage.tell(text))


func _on_pose(p_session: int, p_sample: PoseSample, p_arrival_usec: int) -> void:
	p_sample.arrival_usec = p_arrival_usec
	# What the motors do with it is no work of the network.
	_network_usec += ThreadClock.get_usec()
	_people.push_sample(p_session, p_sample, p_arrival_usec / 1e6)
	_network_usec -= ThreadClock.get_usec()


func _rate() -> int:
	return Engine.physics_ticks_per_second


func _make_report() -> Dictionary:
	var report: Dictionary = _stats.report(_link, _sending, _people)
	report["status_requests"] = _status.counts
	report["level"] = _level.report()
	report["level"].merge(_offers.report())
	report["effects"] = _effects.report()
	return report


## Ends the program with a code, as soon as no thread reads a level.
func _leave(p_code: int) -> void:
	if _shared != null:
		_shared.api.close()
	set_physics_process(false)
	set_process(false)
	await _level.loader.end_reading(get_tree())
	get_tree().quit(p_code)
