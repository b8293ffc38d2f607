@tool
extends RefCounted
## Starts a session on a level: a server, a trainee who walks by keys, and an observer.


## Starts it. Returns what is told to people.
static func start(p_scene: String) -> String:
	var name: String = p_scene.get_file().get_basename()
	if LevelStore.path_of(name) != p_scene:
		return "Only a level that lies in scenes/world/NAME/NAME.tscn can be tried."
	var port: int = _find_port()
	var trainee: int = _run(_window(1), ["--role=trainee", "--port=%d" % port])
	var server: PackedStringArray = ["--role=server", "--port=%d" % port, "--world=" + name]
	server.append("--end-with=%d" % trainee)
	var is_started: bool = trainee > 0 and _run(["--headless"], server) > 0
	if not is_started or _run(_window(0), ["--role=observer", "--port=%d" % port]) < 0:
		return "The session could not be started."
	return "Two windows open: trainee and observer. The server ends with the trainee's window."


## Half a screen for one of two windows beside one another: what is small is also there sooner.
static func _window(p_index: int) -> PackedStringArray:
	var screen: Rect2i = DisplayServer.screen_get_usable_rect()
	var size: Vector2i = Vector2i(screen.size.x / 2, screen.size.x * 9 / 32)
	var at: Vector2i = screen.position + Vector2i(p_index * size.x, (screen.size.y - size.y) / 2)
	return ["--resolution", "%dx%d" % [size.x, size.y], "--position", "%d,%d" % [at.x, at.y]]


static func _run(p_engine: PackedStringArray, p_own: PackedStringArray) -> int:
	var all: PackedStringArray = p_engine.duplicate()
	all.append_array(["--no-header", "--path", ProjectSettings.globalize_path("res://"), "--"])
	all.append_array(p_own)
	return OS.create_process(OS.get_executable_path(), all)


## A UDP port that nobody uses.
static func _find_port() -> int:
	var socket: PacketPeerUDP = PacketPeerUDP.new()
	var error: Error = socket.bind(0, "127.0.0.1")
	var port: int = socket.get_local_port() if error == OK else 7777
	socket.close()
	return port
