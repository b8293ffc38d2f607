class_name ShellFlow
extends Node
## The start screen and the sessions that a user begins from it, one after the other in the same
## window: when a session is over, the start screen is there again, and says why where the user did
## not want that.

## The program is to end, with an exit code.
signal left(p_exit_code: int)

const _CLIENT: PackedScene = preload("res://scenes/client/client.tscn")

var _options: Options = null
var _shell: AppShell = null
var _client: Client = null
## What was started beside for the session that runs; each can be stopped.
var _beside: Array[RefCounted] = []
var _choice: SessionChoice = null


## Takes over the options. Call it before the node enters the tree.
func configure(p_options: Options) -> void:
	_options = p_options


func _ready() -> void:
	get_tree().auto_accept_quit = false
	_open_shell()


func _process(_delta: float) -> void:
	# Another program may have taken its port meanwhile: the client would go on there.
	for program: RefCounted in _beside:
		var server: HostedServer = program as HostedServer
		if _client != null and server != null and not server.is_running():
			_beside.erase(program)
			_client.give_up(tr("The server has ended: %s") % server.fault())
			return


func _exit_tree() -> void:
	_stop_beside()


func _open_shell(p_screen: ShellScreen = null) -> void:
	_shell = AppShell.new()
	_shell.configure(_options)
	_shell.session_wanted.connect(_begin)
	_shell.host_wanted.connect(_host)
	_shell.demonstration_wanted.connect(_demonstrate)
	_shell.left.connect(_leave)
	add_child(_shell)
	if p_screen != null:
		_shell.show_screen(p_screen)


func _host(p_server: HostedServer, p_choice: SessionChoice) -> void:
	var fault: String = p_server.start()
	if fault != "":
		_shell.show_screen(RefusalScreen.new(p_choice, fault))
		return
	_beside.append(p_server)
	p_choice.port = p_server.port
	_begin(p_choice)


func _demonstrate() -> void:
	var demonstration: Demonstration = Demonstration.new()
	demonstration.wanted_port = _options.number("port")
	var fault: String = demonstration.start()
	if fault != "":
		_shell.show_screen(RefusalScreen.new(demonstration.choice(), fault))
		return
	_beside.append(demonstration)
	_begin(demonstration.choice())


func _begin(p_choice: SessionChoice) -> void:
	var options: Options = ProgramOptions.parse(p_choice.arguments(), p_choice.role)
	if options.error != "":
		_shell.show_screen(RefusalScreen.new(p_choice, options.error))
		return
	_choice = p_choice
	await MixerRelease.release(_shell)
	_shell.queue_free()
	_shell = null
	_client = _CLIENT.instantiate()
	_client.returns = true
	_client.configure(p_choice.role, options, ProgramParts.of_client(p_choice.role))
	_client.left.connect(_on_left)
	add_child(_client)


func _on_left(p_exit_code: int) -> void:
	var client: Client = _client
	await MixerRelease.release(client)
	_stop_beside()
	if client.ends_program:
		left.emit(p_exit_code)
		return
	var screen: ShellScreen = null
	if client.fault != "":
		screen = RefusalScreen.new(_choice, client.fault)
	remove_child(client)
	client.queue_free()
	_client = null
	get_tree().auto_accept_quit = false
	_open_shell(screen)
	Log.info("app", "back at the start screen")


func _leave(p_exit_code: int) -> void:
	left.emit(p_exit_code)


func _stop_beside() -> void:
	for program: RefCounted in _beside:
		program.call("stop")
	_beside.clear()
