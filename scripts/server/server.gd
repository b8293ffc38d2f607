class_name Server
extends Node
## The dedicated server: simulates the world, drives each trainee's ragdoll, sends everybody the
## state. It conducts its parts (see [ServerPart]) and knows none of them.
##
## A tick: process what has arrived, set the motors, let Jolt step; right after the step the new
## state is sent, in the same frame.

## The server has ended and nothing of it runs: the exit code of the program.
signal left(p_exit_code: int)

## Exit code for wrong options.
const _EXIT_OPTIONS: int = 2
## Below this speed of the world a frame's last tick is sent only.
const _MIN_SPEED: float = 0.8

@export var _level: ServerLevel
@export var _people: ServerPeople

var _context: ServerContext = ServerContext.new()
var _list: PartList = PartList.new()
var _parts: Array[ServerPart] = []
var _report: ReportFile = null
var _stop: StopSignal = StopSignal.new()
var _pacer: TickPacer = TickPacer.new()
var _sent_tick: int = 0
var _is_open: bool = false


## Takes over the options, and the paths of the parts, in their order. Call it before the node
## enters the tree.
func configure(p_options: Options, p_parts: PackedStringArray) -> void:
	_context.options = p_options
	_list.make(p_parts, self)
	_parts.assign(_list.parts)


## What its parts share.
func context() -> ServerContext:
	return _context


func _ready() -> void:
	var options: Options = _context.options
	_report = ReportFile.new(options.file("report"), options.seconds("report-every"))
	_context.level = _level
	_context.people = _people
	_context.make_report = _make_report
	_context.leave_wanted.connect(_leave)
	_context.stats = ServerStats.new(_context.rate())
	_is_open = true
	var fault: String = _list.open(func(part: ServerPart) -> String: return part.open(_context))
	if fault != "":
		_fail(_EXIT_OPTIONS, fault)
		return
	fault = _list.begin()
	if fault != "":
		_fail(_list.fault_code, fault)
		return
	_stop.watch()
	_stop.watch_reload()
	var about: Array = [options.number("port"), _context.rate(), _level.level_name]
	Log.info("server", "listening on UDP port %d, %d ticks/s, world '%s'" % about)


func _physics_process(p_delta: float) -> void:
	var begin: int = Time.get_ticks_usec()
	var stats: ServerStats = _context.stats
	if _sent_tick != _context.tick and stats.watch.speed > _MIN_SPEED:
		# A late frame has several ticks: who sees the world gets each of them.
		_send_tick()
	stats.begin_work()
	for part: ServerPart in _parts:
		part.receive(begin)
	_context.tick += 1
	for part: ServerPart in _parts:
		part.advance(begin, p_delta)
	stats.ticks = _context.tick
	stats.script_time.add((Time.get_ticks_usec() - begin) / 1e6)
	if stats.begin_tick(begin):
		_context.speed_changed.emit()


func _process(_delta: float) -> void:
	_pacer.pace(_context.rate())
	if _sent_tick != _context.tick:
		_send_tick()
	elif TickPacer.is_idle(_context.rate()):
		for part: ServerPart in _parts:
			part.idle()
	_context.stats.frame(Time.get_ticks_usec())
	for part: ServerPart in _parts:
		part.frame()
	if _report.is_due():
		_report.write(_make_report())
	if _stop.take_reload():
		_context.reload_wanted.emit()
		for part: ServerPart in _parts:
			part.take_options()
	var duration: float = _context.options.seconds("duration")
	if _stop.is_raised():
		Log.info("server", "stopped by a signal: ending all sessions")
		_leave(0)
	elif duration > 0.0 and _context.stats.seconds() > duration:
		_leave(0)


func _exit_tree() -> void:
	if not _is_open:
		return
	_is_open = false
	_report.write(_make_report())
	_list.close()


## Sends the state after a tick's step.
func _send_tick() -> void:
	var now: int = Time.get_ticks_usec()
	_sent_tick = _context.tick
	for part: ServerPart in _parts:
		part.measure()
	var begin: int = ThreadClock.get_usec()
	for part: ServerPart in _parts:
		part.send(now)
	var stats: ServerStats = _context.stats
	stats.networked(_context.network_usec + ThreadClock.get_usec() - begin)
	_context.network_usec = 0
	stats.send_time.add((Time.get_ticks_usec() - now) / 1e6)
	stats.end_work()


func _make_report() -> Dictionary:
	return _context.stats.report().merged(_list.report())


func _fail(p_code: int, p_why: String) -> void:
	Log.error("server", p_why)
	_leave(p_code)


## Ends with a code, as soon as nothing of the parts runs.
func _leave(p_code: int) -> void:
	set_physics_process(false)
	set_process(false)
	await _list.finish()
	left.emit(p_code)
