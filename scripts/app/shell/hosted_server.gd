class_name HostedServer
extends RefCounted
## A dedicated server that the user's own program starts beside itself, as a process of its own.
##
## It ends with this program, or when [method stop] is called, unless it is to stay.

const _LOG: String = "user://logs/hosted-server.log"
## A server's log line of a fault, as [Log] writes it.
const _FAULT: String = " ERROR "

## UDP port that is tried first; where it is taken the system chooses one.
var wanted_port: int = Protocol.DEFAULT_PORT
## World of the server, see [LevelStore].
var world: String = LevelStore.DEFAULT
## Password of the session. Empty: it asks for none.
var password: String = ""
## Whether others on the network can join; otherwise this machine alone.
var is_on_network: bool = true
## Whether it goes on when the user leaves the session and when the program ends.
var stays: bool = false
## Further options of the server, each as [code]--name=value[/code].
var more: PackedStringArray = []
## Its UDP port, once it has been started.
var port: int = 0

var _process: ChildProcess = ChildProcess.new()


## A UDP port that nobody uses: the wanted one, if it is free.
static func find_port(p_wanted: int, p_address: String = "*") -> int:
	var socket: PacketPeerUDP = PacketPeerUDP.new()
	var error: Error = socket.bind(p_wanted, p_address)
	if error != OK:
		error = socket.bind(0, p_address)
	var found: int = socket.get_local_port() if error == OK else p_wanted
	socket.close()
	return found


## Addresses of this machine that others on its network can type, IPv4 before IPv6.
static func addresses() -> PackedStringArray:
	var short: PackedStringArray = []
	var long: PackedStringArray = []
	for address: String in IP.get_local_addresses():
		var is_own: bool = address.begins_with("127.") or address == "::1"
		if is_own or address.begins_with("fe80") or address.begins_with("0:0:0:0:0:0:0:1"):
			continue
		if ":" in address:
			long.append(address)
		else:
			short.append(address)
	return short + long


## Starts it. Returns what is wrong, or an empty text.
func start() -> String:
	var address: String = "*" if is_on_network else "127.0.0.1"
	port = find_port(wanted_port, address)
	var command: PackedStringArray = ProgramPaths.server()
	command.append_array(["--", "--role=server", "--port=%d" % port, "--world=" + world])
	command.append("--bind=" + address)
	command.append("--log-file=" + log_path())
	if not stays:
		command.append("--end-with=%d" % OS.get_process_id())
	command.append_array(more)
	DirAccess.make_dir_recursive_absolute(log_path().get_base_dir())
	DirAccess.remove_absolute(log_path())
	if not _process.start(command, {"DISMOUNT_PASSWORD": password}):
		return tr("The server could not be started: %s") % command[0]
	Log.info("app", "server %d beside this program, on UDP port %d" % [_process.id(), port])
	return ""


## Whether it runs.
func is_running() -> bool:
	return _process.is_running()


## Ends it as its operator would, so that it closes recordings, unless it is to stay.
func stop() -> void:
	if not stays:
		_process.stop()


## The fault that its log ends with; empty if there is none.
func fault() -> String:
	var found: String = ""
	for line: String in FileAccess.get_file_as_string(log_path()).split("\n"):
		if _FAULT in line:
			found = line.get_slice(_FAULT, 1).strip_edges()
	return found


## The file that it writes its log to.
static func log_path() -> String:
	return ProjectSettings.globalize_path(_LOG)
