class_name ChildProcess
extends RefCounted
## A program that this one starts beside itself, and ends as its operator would.

var _id: int = -1


## Starts a command: a path, then arguments. What [param p_environment] names stands in its
## environment only: others on the machine can see arguments, but not that. Returns whether it
## could be started.
func start(p_command: PackedStringArray, p_environment: Dictionary[String, String] = {}) -> bool:
	var before: Dictionary[String, String] = {}
	for variable: String in p_environment:
		before[variable] = OS.get_environment(variable)
		OS.set_environment(variable, p_environment[variable])
	_id = OS.create_process(p_command[0], p_command.slice(1))
	for variable: String in before:
		OS.set_environment(variable, before[variable])
	return _id > 0


## Its number; -1 if it was never started, or has been stopped.
func id() -> int:
	return _id


## Whether it runs.
func is_running() -> bool:
	return _id > 0 and OS.is_process_running(_id)


## Asks it to end: it closes what it writes. Does not wait for it.
func stop() -> void:
	if is_running():
		# OS.kill() would leave it no time.
		OS.execute("/bin/sh", ["-c", "kill -TERM %d" % _id])
	_id = -1
