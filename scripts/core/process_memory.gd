class_name ProcessMemory
extends RefCounted
## How much memory this process takes.


## Memory that is in use, bytes, as the system counts it: the engine's own count is 0 in release
## builds, and lacks what extensions take. 0 where the system does not tell.
static func resident_bytes() -> int:
	var file: FileAccess = FileAccess.open("/proc/self/status", FileAccess.READ)
	# Its length is 0, as the system writes it while it is read.
	while file != null and not file.eof_reached():
		var line: String = file.get_line()
		if line.begins_with("VmRSS:"):
			return line.trim_prefix("VmRSS:").strip_edges().get_slice(" ", 0).to_int() * 1024
	return OS.get_static_memory_usage()
