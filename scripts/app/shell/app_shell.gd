class_name AppShell
extends Control
## The program before a session: the start screen over a living world, and the screens that it
## leads to. It begins nothing itself: [ShellFlow] does what its signals say, and shows it again
## when the session is over.

## The user wants to begin a session.
signal session_wanted(p_choice: SessionChoice)
## The user wants to begin a session on a server of the user's own, which is to be started.
signal host_wanted(p_server: HostedServer, p_choice: SessionChoice)
## The user wants to see the demonstration.
signal demonstration_wanted
## The program is to end, with an exit code.
signal left(p_exit_code: int)

## The screens by name, each a [ShellScreen].
const SCREENS: Dictionary[StringName, String] = {
	&"join": "res://scripts/app/shell/join_screen.gd",
	&"watch": "res://scripts/app/shell/join_screen.gd",
	&"instruct": "res://scripts/app/shell/join_screen.gd",
	&"host": "res://scripts/app/shell/host_screen.gd",
	&"review": "res://scripts/app/shell/review_screen.gd",
}

## As what a user takes part, by the screen that leads there.
const _ROLES: Dictionary[StringName, String] = {
	&"join": "trainee", &"watch": "observer", &"instruct": "instructor"
}
## Frames a second where a processor draws: the film has no more to show.
const _SOFTWARE_FPS: int = 30

## Whether servers are looked for on this machine's networks, besides on this machine.
var looks_on_networks: bool = true

var _start: StartScreen = StartScreen.new(SCREENS.keys())
var _screen: ShellScreen = null
## The control that had the keyboard when a screen was opened.
var _returns_to: Control = null
var _stop: StopSignal = StopSignal.new()
var _end_usec: int = 0
var _port: int = Protocol.DEFAULT_PORT


func _init() -> void:
	set_anchors_preset(Control.PRESET_FULL_RECT)
	add_child(FilmBackdrop.new())
	add_child(_start)
	_start.screen_wanted.connect(open)
	_start.command_wanted.connect(_run_command)
	_start.demonstration_wanted.connect(demonstration_wanted.emit)
	_start.leave_wanted.connect(left.emit.bind(0))


## Takes over the options. Call it before the node enters the tree.
func configure(p_options: Options) -> void:
	var duration_s: float = p_options.seconds("duration")
	_port = p_options.number("port")
	looks_on_networks = p_options.is_on("discovery")
	if duration_s > 0.0:
		_end_usec = Time.get_ticks_usec() + int(duration_s * 1e6)


func _ready() -> void:
	_stop.watch()
	if Quality.draws_by_processor():
		Engine.max_fps = _SOFTWARE_FPS
	WindowFrame.follow(self)
	get_window().title = "Dismount"
	if _screen == null:
		_start.focus_first()
	Log.info("app", "the start screen is open")


func _exit_tree() -> void:
	Engine.max_fps = 0


func _process(_delta: float) -> void:
	var is_over: bool = _end_usec > 0 and Time.get_ticks_usec() > _end_usec
	if _stop.is_raised() or is_over:
		left.emit(0)
		set_process(false)


func _notification(p_what: int) -> void:
	if p_what == NOTIFICATION_WM_CLOSE_REQUEST:
		left.emit(0)
		set_process(false)


## Opens a screen by its name in [constant SCREENS].
func open(p_name: StringName) -> void:
	if _ROLES.has(p_name):
		_open_join().choose_role(_ROLES[p_name])
	else:
		show_screen((load(SCREENS[p_name]) as GDScript).new())


## Shows a screen in place of the start screen, until its user closes it.
func show_screen(p_screen: ShellScreen) -> void:
	if _screen == null and is_inside_tree():
		_returns_to = get_viewport().gui_get_focus_owner()
	_free_screen()
	_screen = p_screen
	_screen.closed.connect(_close)
	_screen.begin_wanted.connect(session_wanted.emit)
	_screen.screen_wanted.connect(open)
	if _screen is HostScreen:
		(_screen as HostScreen).wanted_port = _port
		(_screen as HostScreen).host_wanted.connect(host_wanted.emit)
	elif _screen is RefusalScreen:
		(_screen as RefusalScreen).retry_wanted.connect(_retry)
	_start.hide()
	add_child(_screen)
	_screen.focus_first()


## Leads to the screen from which a session can be joined, filled in as it was.
func _retry(p_choice: SessionChoice) -> void:
	_open_join().take(p_choice)
	_screen.focus_first()


func _open_join() -> JoinScreen:
	var finder: ServerFinder = ServerFinder.new()
	if looks_on_networks:
		finder = ServerFinder.of_all_networks()
	else:
		finder.hosts = ServerFinder.HERE
	var screen: JoinScreen = JoinScreen.new(finder)
	show_screen(screen)
	return screen


func _close() -> void:
	_free_screen()
	_start.show()
	if _returns_to != null and is_instance_valid(_returns_to):
		_returns_to.grab_focus()
	else:
		_start.focus_first()


func _free_screen() -> void:
	if _screen != null:
		remove_child(_screen)
		_screen.queue_free()
		_screen = null


## Starts a command of [code]./run[/code] beside this program.
func _run_command(p_command: String) -> void:
	if OS.create_process(ProgramPaths.run(), [p_command]) < 0:
		Log.warning("app", "cannot start %s %s" % [ProgramPaths.run(), p_command])
