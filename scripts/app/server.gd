class_name Server
extends Node
## The dedicated server: simulates the world, drives each trainee's ragdoll, tells everybody.
##
## A tick: take in what has arrived, set the motors, let Jolt step; right after the step the new
## state goes out, in the same frame.

## What --root can be: inertial finds travel from the feet, as a suit without positions needs it.
const _ROOTS: Dictionary[String, RagdollMotor.RootMode] = {
	"soft": RagdollMotor.ROOT_SOFT,
	"held": RagdollMotor.ROOT_HELD,
	"inertial": RagdollMotor.ROOT_INERTIAL,
	"contacts": RagdollMotor.ROOT_CONTACTS,
	"lowest_foot": RagdollMotor.ROOT_LOWEST_FOOT,
	"pendulum": RagdollMotor.ROOT_PENDULUM,
	"self_righting": RagdollMotor.ROOT_SELF_RIGHTING,
}
## Exit code for wrong options.
const _EXIT_OPTIONS: int = 2
## Seconds between two lines of figures in the log.
const _STATUS_S: float = 10.0

@export var _world: Node3D
@export var _actors: ServerActors

var _options: Options = null
var _link: ServerLink = ServerLink.new()
var _report: ReportFile = null
var _registry: BodyRegistry = BodyRegistry.new()
var _tick: int = 0
var _sent_tick: int = 0
var _began_usec: int = 0
var _settled_usec: int = 0
var _settled_tick: int = 0
var _status_usec: int = 0
var _work: Statistics = Statistics.new()
var _ticks_at_status: int = 0


## Takes over the options. Call it before the node enters the tree.
func configure(_p_role: String, p_options: Options) -> void:
	_options = p_options


func _ready() -> void:
	_report = ReportFile.new(_options.file("report"))
	var port: int = _options.number("port")
	var root: String = _options.text("root")
	if not _ROOTS.has(root):
		var known: String = ", ".join(_ROOTS.keys())
		_give_up(_EXIT_OPTIONS, "--root is one of %s, found '%s'" % [known, root])
		return
	_actors.root_mode = _ROOTS[root]
	if not _open_link(port):
		return
	_registry.add_world(_world)
	_actors.changed.connect(_announce)
	_link.client_joined.connect(_on_joined)
	_link.client_returned.connect(_on_returned)
	_link.client_left.connect(_actors.remove)
	_link.pose_received.connect(_on_pose)
	_began_usec = Time.get_ticks_usec()
	_status_usec = _began_usec
	Log.info("server", "listening on UDP port %d, %d ticks/s" % [port, _rate()])


func _open_link(p_port: int) -> bool:
	var rules: ServerRules = ServerRules.new()
	rules.max_clients = _options.number("max-clients")
	rules.max_per_address = _options.number("max-per-address")
	rules.password = _options.text("password")
	rules.instructor_password = _options.text("instructor-password")
	rules.waiting_room = _options.number("waiting-room") != 0
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
	SessionControl.serve(self, _link)
	return true


func _give_up(p_code: int, p_why: String) -> void:
	Log.error("server", p_why)
	get_tree().quit(p_code)
	set_physics_process(false)
	set_process(false)


func _physics_process(p_delta: float) -> void:
	var begin: int = Time.get_ticks_usec()
	_link.publish_tick(_tick + 1, begin, _rate())
	_link.poll()
	_actors.drive(begin / 1e6, p_delta)
	_tick += 1
	_work.add((Time.get_ticks_usec() - begin) / 1e6)


func _process(_p_delta: float) -> void:
	if _sent_tick != _tick:
		_sent_tick = _tick
		_after_step()
	var now: int = Time.get_ticks_usec()
	if _settled_usec == 0 and now - _began_usec > 1000000:
		_settled_usec = now
		_settled_tick = _tick
		_status_usec = now
		_ticks_at_status = _tick
	if _report.is_due():
		_report.write(_figures())
	if now - _status_usec > int(_STATUS_S * 1e6):
		_log_status(now)
	var duration: float = _options.seconds("duration")
	if duration > 0.0 and now - _began_usec > int(duration * 1e6):
		get_tree().quit(0)


func _exit_tree() -> void:
	if _report != null:
		_report.write(_figures())
	_link.close()


func _after_step() -> void:
	_actors.measure()
	var snapshot: Snapshot = Snapshot.new()
	snapshot.tick = _tick
	snapshot.tick_rate = _rate()
	_registry.read(snapshot)
	_actors.mark(snapshot)
	_link.send_snapshot(snapshot)


func _on_joined(p_session: int, p_hello: Dictionary) -> void:
	if p_hello["role"] == Protocol.Role.TRAINEE:
		_actors.add(p_session, p_hello["name"], p_hello["hip_height"])
	else:
		_announce()


func _on_returned(_p_session: int) -> void:
	_announce()


func _on_pose(p_session: int, p_sample: PoseSample, p_arrival_usec: int) -> void:
	_actors.push_sample(p_session, p_sample, p_arrival_usec / 1e6)


func _announce() -> void:
	_link.send_world(_registry.describe(_actors.list()))


func _rate() -> int:
	return Engine.physics_ticks_per_second


func _log_status(p_now_usec: int) -> void:
	var seconds: float = (p_now_usec - _status_usec) / 1e6
	var rate: float = (_tick - _ticks_at_status) / seconds
	_status_usec = p_now_usec
	_ticks_at_status = _tick
	var parts: Array = [rate, _link.client_count(), _actors.list().size()]
	Log.info("server", "%.1f ticks/s, %d clients, %d people" % parts)


## Ticks per second since the first second, in which a loaded machine catches up with its start.
func _measured_rate() -> float:
	if _settled_usec == 0:
		return 0.0
	var seconds: float = (Time.get_ticks_usec() - _settled_usec) / 1e6
	return (_tick - _settled_tick) / maxf(seconds, 0.001)


func _figures() -> Dictionary:
	var seconds: float = maxf((Time.get_ticks_usec() - _began_usec) / 1e6, 0.001)
	return {
		"role": "server",
		"seconds": seconds,
		"ticks": _tick,
		"ticks_per_second": _measured_rate(),
		"script_ms_p50": _work.percentile(0.5) * 1000.0,
		"script_ms_p99": _work.percentile(0.99) * 1000.0,
		"clients": _link.client_count(),
		"sent_bytes_per_second": _link.traffic.sent_per_second(),
		"received_bytes_per_second": _link.traffic.received_per_second(),
		"transport": _link.figures(),
		"people": _actors.figures(),
	}
