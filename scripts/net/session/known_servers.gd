class_name KnownServers
extends RefCounted
## The servers that this user's clients have joined and the key of each, in a file: a line for each
## server with its address, its public key and the day on which that was remembered.
##
## Clients that run at the same time change it one after the other, each with what it has then.
## Lines that make no sense are named and left as they are. A server whose line is damaged, and any
## server where the file can't be read, counts as known by a key that it can't have: the user is
## asked.

## Where it is.
const DEFAULT_PATH: String = "user://known_servers"
## Servers that are remembered; further ones are not.
const MAX_SERVERS: int = 1000
## Larger files are not read, bytes.
const MAX_BYTES: int = 1 << 18

const _DAMAGED_BYTES: int = 32
const _HEAD: String = "# Servers that were joined: address, public key, since when."
## Longest name of a host that the domain name system has, and a port.
const _MAX_ADDRESS: int = 260
## Longest time for which others may hold the lock while they change the file, ms.
const _PATIENCE_MS: int = 2000
const _LOOK_MS: int = 5
## Maximum of damaged lines that are named; the others are counted.
const _MAX_NAMED: int = 8

## Full path of the file.
var path: String = ""
## Why it could not be read or written the last time, or an empty text.
var error: String = ""
## Lines of it that make no sense, as "FILE:LINE: ...", as of the last reading.
var faults: PackedStringArray = []

var _lines: PackedStringArray = []
var _keys: Dictionary[String, PackedByteArray] = {}
var _line_of: Dictionary[String, int] = {}


func _init(p_path: String = DEFAULT_PATH) -> void:
	path = ProjectSettings.globalize_path(p_path)


## How an address stands in the file: as the user typed it, but for what makes no difference.
static func address(p_host: String, p_port: int) -> String:
	var host: String = p_host.strip_edges().to_lower()
	host = host.trim_prefix("[").trim_suffix("]").trim_suffix(".")
	return ("[%s]:%d" if host.contains(":") else "%s:%d") % [host, p_port]


## The key of a server, or nothing if it is not known; zeros where it can't be read.
func find(p_address: String) -> PackedByteArray:
	_read()
	return _keys.get(p_address, PackedByteArray() if error == "" else _damaged())


## Remembers a server's key. Another key that stands there already stays, unless it may be replaced.
## Returns the key that holds then, whether or not it could be written.
func keep(p_address: String, p_key: PackedByteArray, p_may_replace: bool) -> PackedByteArray:
	if find(p_address) == p_key:
		return p_key
	var lock: PrivateFile = _lock()
	if lock == null:
		return p_key
	# Somebody may have changed it since.
	_read()
	if _keys.has(p_address) and (_keys[p_address] == p_key or not p_may_replace):
		return _keys[p_address]
	if error == "":
		_put(p_address, p_key)
	return p_key


func _read() -> void:
	error = ""
	faults.clear()
	_lines.clear()
	_keys.clear()
	_line_of.clear()
	if not FileAccess.file_exists(path):
		return
	var file: FileAccess = FileAccess.open(path, FileAccess.READ)
	if file == null:
		error = "%s cannot be read: %s" % [path, error_string(FileAccess.get_open_error())]
		return
	if file.get_length() > MAX_BYTES:
		error = "%s is larger than %d bytes" % [path, MAX_BYTES]
		return
	var bytes: PackedByteArray = file.get_buffer(MAX_BYTES)
	if bytes.has(0):
		error = "%s is no text of ours" % path
		return
	_lines = bytes.get_string_from_utf8().split("\n")
	if _lines[-1] == "":
		_lines.remove_at(_lines.size() - 1)
	for i: int in _lines.size():
		_read_line(i)


func _read_line(p_index: int) -> void:
	var line: String = _lines[p_index].strip_edges()
	if line == "" or line.begins_with("#"):
		return
	var parts: PackedStringArray = line.split(" ", false)
	var key: PackedByteArray = PackedByteArray()
	if parts.size() == 3:
		key = KeyFingerprint.from_text(parts[1])
	if key.is_empty():
		_refuse(p_index, "expected an address, a key and a day")
		if not _keys.has(parts[0]):
			_keys[parts[0]] = _damaged()
			_line_of[parts[0]] = p_index
	elif _line_of.has(parts[0]):
		var before: int = _line_of[parts[0]] + 1
		_refuse(p_index, "the same address stands in line %d, which holds" % before)
	else:
		_keys[parts[0]] = key
		_line_of[parts[0]] = p_index


static func _damaged() -> PackedByteArray:
	var zeros: PackedByteArray = []
	zeros.resize(_DAMAGED_BYTES)
	return zeros


func _refuse(p_index: int, p_what: String) -> void:
	if faults.size() < _MAX_NAMED:
		faults.append("%s:%d: %s" % [path, p_index + 1, p_what])


func _put(p_address: String, p_key: PackedByteArray) -> void:
	var today: String = Time.get_date_string_from_system()
	var line: String = " ".join([p_address, KeyFingerprint.to_text(p_key), today])
	if _line_of.has(p_address):
		_lines[_line_of[p_address]] = line
	elif p_address.length() > _MAX_ADDRESS or p_address.contains(" "):
		error = "an address like this is not kept in %s" % path
		return
	elif _keys.size() >= MAX_SERVERS:
		error = "%s has %d servers, which is the most: take some out" % [path, MAX_SERVERS]
		return
	else:
		if _lines.is_empty():
			_lines.append(_HEAD)
		_lines.append(line)
	_write()


## Others find the old file or the new one, never half of it.
func _write() -> void:
	var bytes: PackedByteArray = ("\n".join(_lines) + "\n").to_utf8_buffer()
	if bytes.size() > MAX_BYTES:
		error = "%s would be larger than %d bytes: take some lines out" % [path, MAX_BYTES]
		return
	var fresh: String = path + ".new"
	var file: FileAccess = FileAccess.open(fresh, FileAccess.WRITE)
	var done: Error = OK if file != null else FileAccess.get_open_error()
	if file != null:
		# Only the user may know which servers were joined.
		FileAccess.set_unix_permissions(
			fresh, FileAccess.UNIX_READ_OWNER | FileAccess.UNIX_WRITE_OWNER
		)
		file.store_buffer(bytes)
		file.flush()
		done = file.get_error()
		file.close()
	if done == OK:
		done = DirAccess.rename_absolute(fresh, path)
	if done != OK:
		error = "%s cannot be written: %s" % [path, error_string(done)]


## A lock that only one client has at a time; null where it cannot be had.
func _lock() -> PrivateFile:
	var opened: Error = DirAccess.make_dir_recursive_absolute(path.get_base_dir())
	var lock: PrivateFile = PrivateFile.new()
	var until: int = Time.get_ticks_msec() + _PATIENCE_MS
	opened = lock.open(path + ".lock") if opened == OK else opened
	while opened == ERR_BUSY and Time.get_ticks_msec() < until:
		OS.delay_msec(_LOOK_MS)
		opened = lock.open(path + ".lock")
	if opened == OK:
		return lock
	error = "%s.lock cannot be had: %s" % [path, error_string(opened)]
	return null
