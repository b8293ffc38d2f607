extends SceneTree
## Records a motion set from a wearer of any suit: [code]./run motion-set record OUT[/code].
##
## [codeblock lang=text]
## godot -s scripts/client/suit/motion_set_record.gd -- OUT --source=KIND [--skip=PHASE,...] ...
## [/codeblock]
## Headless it guides by text alone. Exit code 0; 2 with one line on the error output if the call is
## wrong, a file cannot be written, or nothing was recorded that makes a set.

const USAGE: String = "usage: motion-set record OUT --source=KIND[:ADDRESS] [--skip=PHASE,...]"
## Frames a second where there is no window to wait for.
const _RATE: int = 120

var _session: MotionSetSession = null
var _stop: StopSignal = StopSignal.new()
var _fault: String = ""


func _process(_delta: float) -> bool:
	if _fault != "" or _session == null:
		return true
	if _stop.is_raised():
		_session.stop()
	_session.advance(Time.get_unix_time_from_system() * 1e6)
	if not _session.is_over:
		return false
	_fault = _session.finish()
	if _fault != "":
		printerr("motion-set record: " + _fault)
	quit(0 if _fault == "" else 2)
	return true


func _initialize() -> void:
	_fault = _begin()
	if _fault != "":
		printerr("motion-set record: " + _fault)
		quit(2)


func _begin() -> String:
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	if arguments.is_empty() or arguments[0].begins_with("-"):
		return USAGE
	var rows: Array[OptionRow] = SuitOptions.rows()
	rows.append(OptionRow.text("skip", [], "phases that are left out"))
	var options: Options = Options.parse(rows, arguments.slice(1))
	if options.error != "":
		return options.error
	var skipped: PackedStringArray = options.text("skip").split(",", false)
	for name: String in skipped:
		if not GuidedPhase.names().has(name):
			return "there is no phase '%s', only %s" % [name, ", ".join(GuidedPhase.names())]
	_session = MotionSetSession.new(skipped)
	_session.said.connect(func(text: String) -> void: print(text))
	var fault: String = _session.open(options, Options.full_path(arguments[0]))
	if fault == "":
		_stop.watch()
		_show()
	return fault


func _show() -> void:
	if DisplayServer.get_name() == "headless":
		Engine.max_fps = _RATE
		return
	root.title = "Record a motion set"
	root.close_requested.connect(_session.stop)
	auto_accept_quit = false
	root.add_child(MotionSetView.new(_session))
