class_name Demonstration
extends RefCounted
## A session to look at: a server and a trainee who walks by recorded motion, both beside this
## program, which watches them.

const _MOTION: String = "res://assets/motion/01_01.bvh"
## Where the motion begins, s: the trainee reaches the crates soon after that.
const _FROM_S: float = 2.0
## A trainee whose server has ended ends after this time, s.
const _PATIENCE_S: float = 10.0

## UDP port of the server, where it is free.
var wanted_port: int = Protocol.DEFAULT_PORT
## The server.
var server: HostedServer = HostedServer.new()

var _trainee: ChildProcess = ChildProcess.new()


## Starts both. Returns what is wrong, or an empty text.
func start() -> String:
	server.is_on_network = false
	server.wanted_port = wanted_port
	var fault: String = server.start()
	if fault != "":
		return fault
	var command: PackedStringArray = ProgramPaths.client()
	command.append_array(["--", "--role=trainee", "--host=127.0.0.1", "--port=%d" % server.port])
	command.append_array(["--bvh=" + _MOTION, "--bvh-from=%.1f" % _FROM_S])
	command.append("--connect-timeout=%.0f" % _PATIENCE_S)
	if not _trainee.start(command):
		stop()
		return tr("The trainee could not be started: %s") % command[0]
	return ""


## The session of the user who looks at it.
func choice() -> SessionChoice:
	var result: SessionChoice = SessionChoice.new()
	result.host = "127.0.0.1"
	result.port = server.port
	result.more = ["--camera=60,10,3.5"]
	return result


## Ends both.
func stop() -> void:
	_trainee.stop()
	server.stop()
