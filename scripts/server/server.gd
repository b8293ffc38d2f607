class_name Server
extends Node
## The dedicated server: simulates the world, drives each trainee's ragdoll, sends everybody the
## state.
##
## A tick: process what has arrived, set the motors, let Jolt step; right after the step the new
## state is sent, in the same frame.

## What --root can be: inertial finds travel from the feet, as a suit without positions needs it.
const ROOTS: Dictionary[String, RagdollMotor.RootMode] = {
	"soft": RagdollMotor.ROOT_SOFT,
	"held": RagdollMotor.ROOT_HELD,
	"inertial": RagdollMotor.ROOT_INERTIAL,
	"contacts": RagdollMotor.ROOT_CONTACTS,
	"lowest_foot": RagdollMotor.ROOT_LOWEST_FOOT,
	"pendulum": RagdollMotor.ROOT_PENDULUM,
	"self_righting": RagdollMotor.ROOT_SELF_RIGHTING,
}
## Maximum ticks per second: a snapshot has the rate in a byte.
const _MAX_TICKS: int = 240
## Exit code for wrong options.
const _EXIT_OPTIONS: int = 2
## Seconds between two lines of stats in the log.
const _STATUS_S: float = 10.0

@export var _level: ServerLevel
@export var _people: ServerPeople

var _options: Options = null
var _link: ServerLink = ServerLink.new()
var _sending: Replication = null
var _entities: ServerEntities = null
var _report: ReportFile = null
var _stats: ServerStats = null
var _status: StatusEndpoint = StatusEndpoint.new()
var _stop: StopSignal = StopSignal.new()
var _pacer: TickPacer = TickPacer.new()
var _control: SessionControl = null
var _tick: int = 0
var _sent_tick: int = 0
var _network_usec: int = 0
var _names: Dictionary[int, String] = {}


## Takes over the options. Call it before the node enters the tree.
func configure(_p_role: String, p_options: Options) -> void:
	_options = p_options


func _ready() -> void:
	_report = ReportFile.new(_options.file("report"))
	if _rate() > _MAX_TICKS:
		_give_up(_EXIT_OPTIONS, "%d ticks/s are set, %d is the most" % [_rate(), _MAX_TICKS])
		return
	_people.root_mode = ROOTS[_options.text("root")]
	_stats = ServerStats.new(_rate())
	if _open_link(_options.number("port")):
		_open_world()


## Sets the parts up; the level comes last, as all others listen to its signals.
func _open_world() -> void:
	var bits: float = _options.number("bandwidth") * 1000.0
	var error: float = _options.degrees("pose-error")
	_people.setup(_level.table)
	_sending = Replication.new(_link, _level, _people, _rate(), bits, error)
	_entities = ServerEntities.new(_link, _level.table, _people, _sending.encoder)
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
	fault = _level.load_level(_options.text("world")) if fault == "" else fault
	if fault != "":
		_give_up(_EXIT_OPTIONS, fault)
		return
	_stop.watch()
	_open_status(_options.number("port"))
	var parts: Array = [_options.number("port"), _rate(), _level.level_name]
	Log.info("server", "listening on UDP port %d, %d ticks/s, world '%s'" % parts)


func _open_link(p_port: int) -> bool:
	var rules: ServerRules = ServerRules.new()
	rules.max_clients = _options.number("max-clients")
	rules.max_per_address = _options.number("max-per-address")
	rules.password = _options.text("password")
	rules.instructor_password = _options.text("instructor-password")
	rules.waiting_room = _options.is_on("waiting-room")
	rules.bans = BanList.open(_options.file("ban-file"))
	var security: TransportSecurity = TransportSecurity.server(
		_options.file("dtls-certificate"), _options.file("dtls-key")
	)
	rules.tls = security.tls
	var fault: String = rules.bans.error if rules.bans.error != "" else security.error
	if fault != "":
		_give_up(_EXIT_OPTIONS, fault)
		return false
	if _link.listen(p_port, rules) != OK:
		_give_up(1, "UDP port %d is in use: choose another with --port" % p_port)
		return false
	Log.info("net", security.describe())
	var control: SessionControl = SessionControl.serve(self, _link)
	control.level_requested.connect(_change_level)
	_control = control
	return true


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
	get_tree().quit(p_code)
	set_physics_process(false)
	set_process(false)


func _physics_process(p_delta: float) -> void:
	var begin: int = Time.get_ticks_usec()
	_network_usec -= ThreadClock.get_usec()
	_link.publish_tick(_tick + 1, begin, _rate())
	_link.poll()
	_network_usec += ThreadClock.get_usec()
	_tick += 1
	_people.tick = _tick
	_entities.advance(_tick, _rate())
	_people.drive(begin / 1e6, p_delta)
	_stats.ticks = _tick
	_stats.script_time.add((Time.get_ticks_usec() - begin) / 1e6)
	if _stats.watch.ticked(begin / 1e6):
		_report_speed()


func _process(_p_delta: float) -> void:
	_pacer.pace(_rate())
	if _sent_tick != _tick:
		_sent_tick = _tick
		_after_step()
	_stats.frame(Time.get_ticks_usec())
	_status.poll(_make_report)
	if _report.is_due():
		_report.write(_make_report())
	if _stats.since_status() > _STATUS_S:
		Log.info("server", _stats.describe(_link.session_ids().size(), _people.list().size()))
	var duration: float = _options.seconds("duration")
	if _stop.is_raised():
		Log.info("server", "stopped by a signal: ending all sessions")
		get_tree().quit(0)
	elif duration > 0.0 and _stats.seconds() > duration:
		get_tree().quit(0)


func _exit_tree() -> void:
	if _report != null and _stats != null:
		_report.write(_make_report())
	_status.close()
	if _sending != null:
		_sending.close()
	# The bodies are out of the tree already: nobody needs to know who leaves now.
	if _link.client_left.is_connected(_on_left):
		_link.client_left.disconnect(_on_left)
	_link.close()


func _after_step() -> void:
	var now: int = Time.get_ticks_usec()
	_people.measure()
	var begin: int = ThreadClock.get_usec()
	_sending.send(_tick, now, _entities.take_messages())
	_stats.networked(_network_usec + ThreadClock.get_usec() - begin)
	_network_usec = 0
	_stats.send_time.add((Time.get_ticks_usec() - now) / 1e6)


func _report_speed() -> void:
	if not _stats.watch.is_slow:
		Log.info("server", "the world runs at full speed again")
		return
	var parts: Array = [
		100.0 * _stats.watch.speed, _people.list().size(), _link.session_ids().size()
	]
	var text: String = "the world runs at %.0f %% of its speed (%d people, %d clients): "
	Log.warning("server", text % parts + "the machine is too slow for it")


## Loads another level while the session runs. Returns why it cannot, or an empty text.
func _change_level(p_name: String, p_answer: Callable) -> void:
	p_answer.call(_level.load_level(p_name, _tick))


func _on_level_changed() -> void:
	_link.rules.level_name = _level.level_name
	_link.rules.level_fingerprint = _level.fingerprint
	var points: Array[Vector3] = []
	for point: SpawnPoint in _level.level.get_spawn_points():
		points.append(point.global_position)
	_people.enter(points)
	_survey_soon()


func _survey_soon() -> void:
	# Bodies are in the physics space after a step.
	await get_tree().physics_frame
	_sending.survey()


func _on_entity_added(p_row: EntityRow, p_node: Entity, _body: PhysicsBody3D) -> void:
	if p_node != null:
		_entities.bind(p_row, p_node)


func _on_person_added(p_person: ServerPeople.Person) -> void:
	var node: Entity = Entity.find_in(p_person.ragdoll)
	if node != null:
		_entities.bind(_level.table.find(p_person.id), node)


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
	_people.remove(p_session)


func _on_people(p_session: int, p_people: Array[PersonCard]) -> void:
	_people.set_people(p_session, p_people, _names.get(p_session, ""))


func _on_pose(p_session: int, p_sample: PoseSample, p_arrival_usec: int) -> void:
	p_sample.arrival_usec = p_arrival_usec
	# What the motors do with it is no work of the network.
	_network_usec += ThreadClock.get_usec()
	_people.push_sample(p_session, p_sample, p_arrival_usec / 1e6)
	_network_usec -= ThreadClock.get_usec()


func _rate() -> int:
	return Engine.physics_ticks_per_second


func _make_report() -> Dictionary:
	return _stats.report(_link, _sending, _people.stats())
