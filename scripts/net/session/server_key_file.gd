class_name ServerKeyFile
extends RefCounted
## Keeps the seed of a server's key pair, so that clients know the server again after each start.
##
## The file is made at the first start. One that is damaged is never replaced: every client would be
## asked whether it trusts the new key.

## Where it is by default.
const DEFAULT_PATH: String = "user://server.key"

const _HEAD: String = "dismount-server-key 1"
const _MAX_BYTES: int = 4096
## Longest wait for another server that makes the same file, ms.
const _PATIENCE_MS: int = 2000
const _LOOK_MS: int = 5
## Whoever else may read or change it.
const _OTHERS: int = (
	FileAccess.UNIX_READ_OTHER | FileAccess.UNIX_WRITE_OTHER | FileAccess.UNIX_WRITE_GROUP
)

## Seed of the key pair, [constant KeyFingerprint.KEY_SIZE] bytes.
var key_seed: PackedByteArray = PackedByteArray()
## Fingerprint of the public key.
var fingerprint: String = ""
## Full path of the file.
var path: String = ""
## Why there is no key, or an empty text.
var error: String = ""


## Reads the key of a file, which is made if there is none; by default [constant DEFAULT_PATH].
static func open(p_path: String = "") -> ServerKeyFile:
	var made: ServerKeyFile = ServerKeyFile.new()
	made.path = ProjectSettings.globalize_path(p_path if p_path != "" else DEFAULT_PATH)
	made.error = made._make()
	if made.error == "":
		made.error = made._read()
	return made


## The public key of a seed.
static func public_key_of(p_seed: PackedByteArray) -> PackedByteArray:
	var socket: SealedSocket = SealedSocket.new()
	socket.set_server_key(p_seed)
	return socket.get_server_key()


## Makes the file if there is none. Two servers that start at once have one key.
func _make() -> String:
	var folder_error: Error = DirAccess.make_dir_recursive_absolute(path.get_base_dir())
	var made: PrivateFile = PrivateFile.new()
	var fresh: String = path + ".new"
	var until: int = Time.get_ticks_msec() + _PATIENCE_MS
	var opened: Error = ERR_BUSY
	while opened == ERR_BUSY and Time.get_ticks_msec() < until:
		if FileAccess.file_exists(path):
			return ""
		opened = made.open(fresh) if folder_error == OK else folder_error
		if opened == ERR_BUSY:
			OS.delay_msec(_LOOK_MS)
	if opened != OK:
		return _cannot_be("made", opened)
	if FileAccess.file_exists(path):
		# Somebody has made it between the two looks.
		made.remove()
		return ""
	var written: Error = made.write(_text_of(Crypto.new().generate_random_bytes(32)))
	if written == OK:
		written = DirAccess.rename_absolute(fresh, path)
	if written != OK:
		made.remove()
		return _cannot_be("made", written)
	Log.info("server", "made the server's key: %s" % path)
	return ""


func _read() -> String:
	var file: FileAccess = FileAccess.open(path, FileAccess.READ)
	if file == null:
		return _cannot_be("read", FileAccess.get_open_error())
	var bytes: PackedByteArray = file.get_buffer(_MAX_BYTES)
	file.close()
	var lines: PackedStringArray = bytes.get_string_from_ascii().split("\n")
	if lines.size() < 3 or lines[0] != _HEAD:
		return _is_damaged("its first line is not '%s'" % _HEAD)
	key_seed = KeyFingerprint.from_text(lines[1].trim_prefix("seed "))
	if key_seed.is_empty():
		return _is_damaged("its second line has no seed of 32 bytes")
	fingerprint = KeyFingerprint.of(public_key_of(key_seed))
	if lines[2] != "public " + fingerprint:
		return _is_damaged("its seed does not belong to the fingerprint in its third line")
	if FileAccess.get_unix_permissions(path) & _OTHERS != 0:
		var text: String = "others can read or change the server's key %s: chmod 600 it"
		Log.warning("server", text % path)
	return ""


func _text_of(p_seed: PackedByteArray) -> PackedByteArray:
	var public: String = KeyFingerprint.of(public_key_of(p_seed))
	var parts: Array = [_HEAD, KeyFingerprint.to_text(p_seed), public]
	return ("%s\nseed %s\npublic %s\n" % parts).to_ascii_buffer()


func _cannot_be(p_what: String, p_error: Error) -> String:
	var parts: Array = [path, p_what, error_string(p_error)]
	return "the server's key %s cannot be %s: %s (--server-key names another file)" % parts


func _is_damaged(p_how: String) -> String:
	var text: String = (
		"the server's key %s is damaged: %s. Put a copy back; without one remove it: clients"
		+ " without a password are then asked whether they trust the new key"
	)
	return text % [path, p_how]
