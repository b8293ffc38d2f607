class_name SnapshotPlayer
extends RefCounted
## Plays a recording of a [SnapshotRecorder] as if the packets arrived from a server.

## A snapshot's datagram, as it came so many s after the start.
signal snapshot_received(p_bytes: PackedByteArray, p_time_s: float)
## A connection begins: what was told before is void.
signal restarted
## Which bodies there are now.
signal world_received(p_world: WorldDescription, p_bytes: PackedByteArray)
## The recording is over.
signal finished

## Largest packet that a recording may hold, bytes.
const LARGEST: int = 1 << 24

var _file: FileAccess = null
var _path: String = ""
var _next: PackedByteArray = PackedByteArray()
var _next_usec: int = 0


## Opens a recording; returns why it cannot, or an empty text.
func open(p_path: String) -> String:
	_path = p_path
	_file = FileAccess.open(p_path, FileAccess.READ)
	if _file == null:
		return "cannot read %s: %s" % [p_path, error_string(FileAccess.get_open_error())]
	var magic: String = _file.get_buffer(8).get_string_from_ascii()
	if magic != SnapshotRecorder.MAGIC:
		var found: String = ByteReader.clean(magic)
		return "%s: expected a recording (%s), found '%s'" % [p_path, SnapshotRecorder.MAGIC, found]
	_read_next()
	if _next.is_empty():
		return "%s: the recording is empty" % p_path
	return ""


## Hands out everything up to a time since the start, s.
func advance(p_time_s: float) -> void:
	while not _next.is_empty() and _next_usec <= int(p_time_s * 1e6):
		_emit(_next)
		_read_next()
		if _next.is_empty():
			finished.emit()


func _emit(p_bytes: PackedByteArray) -> void:
	if p_bytes.size() == 1 and p_bytes[0] == SnapshotRecorder.BEGIN:
		restarted.emit()
	elif p_bytes[0] == Protocol.Message.WORLD:
		var world: WorldDescription = WorldDescription.decode(p_bytes)
		if world != null:
			world_received.emit(world, p_bytes)
	else:
		snapshot_received.emit(p_bytes, _next_usec / 1e6)


func _read_next() -> void:
	_next = PackedByteArray()
	# A record that was cut off by a kill is the end.
	if _file.get_length() - _file.get_position() < 12:
		return
	var size: int = _file.get_32()
	_next_usec = _file.get_64()
	if size == 0 or size > LARGEST or _file.get_length() - _file.get_position() < size:
		if size == 0 or size > LARGEST:
			Log.warning("review", "%s: a broken record ends the playback" % _path)
		return
	_next = _file.get_buffer(size)
