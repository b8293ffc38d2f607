class_name EditorSession
extends RefCounted
## What Play in the editor starts: a session on this machine, of a server without a window and of
## the editor's window as a trainee who walks by its keys.


## Whether the editor has started the program, without saying as what.
static func is_wanted(p_arguments: PackedStringArray) -> bool:
	var is_named: bool = OS.get_environment("DISMOUNT_ROLE") != ""
	return EngineDebugger.is_active() and p_arguments.is_empty() and not is_named


## Starts the server, which ends with this program. Returns the arguments of the trainee, or none
## where no server can be started.
static func begin() -> PackedStringArray:
	var port: int = _find_port()
	var project: String = ProjectSettings.globalize_path("res://")
	var server: PackedStringArray = ["--headless", "--no-header", "--path", project, "--"]
	server.append_array(
		["--role=server", "--port=%d" % port, "--end-with=%d" % OS.get_process_id()]
	)
	if OS.create_process(OS.get_executable_path(), server) < 0:
		Log.error("app", "no server could be started beside the editor's window")
		return []
	return ["--role=trainee", "--port=%d" % port]


## A UDP port that nobody uses.
static func _find_port() -> int:
	var socket: PacketPeerUDP = PacketPeerUDP.new()
	var error: Error = socket.bind(0, "127.0.0.1")
	var port: int = socket.get_local_port() if error == OK else Protocol.DEFAULT_PORT
	socket.close()
	return port
