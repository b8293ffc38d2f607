class_name Client
extends Node
## A client: a trainee who sends motion, an observer who watches, or the replay of a recording. It
## conducts its parts (see [ClientPart]) and knows none of them.
##
## It never simulates: everything that moves is put where its [StateStream] says, by way of a
## [WorldReplica]; only a trainee's own body is shown as the trainee moves it. When it has left, it
## can be freed and another one begun in the same process.

## The session is over and nothing of it runs: the exit code of the program.
signal left(p_exit_code: int)

@export var _scene: ClientScene
@export var _hud: Hud

## Whether whoever began the session shows why it has ended: then nothing is left standing in the
## window.
var returns: bool = false
## Why the session could not begin or go on; empty where it did.
var fault: String = ""
## Whether the user wants the whole program to end: the window was closed, or the system asks.
var ends_program: bool = false

var _context: ClientContext = ClientContext.new()
var _list: PartList = PartList.new()
var _parts: Array[ClientPart] = []
var _report: ReportFile = null
var _stop: StopSignal = StopSignal.new()
var _exit_code: int = 0
var _is_open: bool = false
var _is_leaving: bool = false


## Takes over the role, the options, and the paths of the parts, in their order. Call it before the
## node enters the tree.
func configure(p_role: String, p_options: Options, p_parts: PackedStringArray) -> void:
	_context.role = p_role
	_context.options = p_options
	_list.make(p_parts, self)
	_parts.assign(_list.parts)


## Ends the session, as what it needs has ended; the reason is for people.
func give_up(p_why: String) -> void:
	_fail(StateStream.EXIT_REFUSED, p_why)


func _ready() -> void:
	ClientPhysics.begin()
	get_tree().auto_accept_quit = false
	_context.scene = _scene
	_context.hud = _hud
	_context.failed.connect(_fail)
	_context.leave_wanted.connect(_leave)
	_context.restart_near.connect(_close)
	var options: Options = _context.options
	_report = ReportFile.new(options.file("report"), options.seconds("report-every"))
	_stop.watch()
	_is_open = true
	var fault: String = _list.open(func(part: ClientPart) -> String: return part.open(_context))
	if fault != "":
		_fail(StateStream.EXIT_OPTIONS, fault)
		return
	fault = _list.begin()
	if fault != "":
		_fail(_list.fault_code, fault)
		return
	_context.begin_s = _context.now_s()


func _process(p_delta: float) -> void:
	if _stop.is_raised():
		ends_program = true
		_leave()
	if _exit_code != 0 or _is_leaving:
		return
	for part: ClientPart in _parts:
		part.begin_frame()
	_context.stream.advance(p_delta)
	for part: ClientPart in _parts:
		part.advance(p_delta)
	for part: ClientPart in _parts:
		part.end_frame(p_delta)
	if _report.is_due():
		_report.write(_list.report())
	if _is_over():
		_leave()


func _physics_process(_delta: float) -> void:
	ClientPhysics.advance()


func _notification(p_what: int) -> void:
	if p_what == NOTIFICATION_WM_CLOSE_REQUEST:
		ends_program = true
		_leave()


func _exit_tree() -> void:
	_close()


## Whether the session has lasted as long as the options ask.
func _is_over() -> bool:
	var duration: float = _context.options.seconds("duration")
	# A film is made slower than it plays: a recording has a clock of its own.
	if duration == 0.0 or _context.now_s() - _context.begin_s < duration:
		return false
	return _parts.all(func(part: ClientPart) -> bool: return part.is_ready_to_end())


## Ends with a code; in a window of its own the message stays until that is closed.
func _fail(p_code: int, p_why: String) -> void:
	if p_code == StateStream.EXIT_DONE:
		_leave()
		return
	_exit_code = p_code
	fault = p_why
	Log.error("client", p_why)
	_hud.show_message(p_why.left(1).to_upper() + p_why.substr(1) + ".")
	var is_read: bool = p_code == StateStream.EXIT_REFUSED or p_code == StateStream.EXIT_OPTIONS
	var has_end: bool = _context.options.seconds("duration") > 0.0
	if not is_read or returns or ClientContext.is_headless() or has_end:
		_leave(p_code)
		return
	# Nothing moves any more: the picture is drawn again where it changes only.
	OS.low_processor_usage_mode = true


## Ends the session with a code, as soon as nothing of its parts runs.
func _leave(p_code: int = _exit_code) -> void:
	if _is_leaving:
		return
	_is_leaving = true
	set_process(false)
	await _list.finish()
	left.emit(p_code)


func _close() -> void:
	if not _is_open:
		return
	_is_open = false
	if _context.stream != null:
		_report.write(_list.report())
	_list.close()
	ClientPhysics.end()
	get_tree().auto_accept_quit = true
