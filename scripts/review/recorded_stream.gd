class_name RecordedStream
extends StateStream
## Plays a recording of a [StateRecorder] as if its messages arrived from a server.

## Largest message that a recording may hold, bytes.
const MAX_BYTES: int = 1 << 24

## Path of the recording.
var path: String = ""

var _file: FileAccess = null
var _next: PackedByteArray = PackedByteArray()
var _next_usec: int = 0
var _clock_s: float = 0.0


## A stream that plays a file.
static func of_file(p_path: String) -> RecordedStream:
	var stream: RecordedStream = RecordedStream.new()
	stream.path = p_path
	return stream


func open() -> String:
	_file = FileAccess.open(path, FileAccess.READ)
	if _file == null:
		return "cannot read %s: %s" % [path, error_string(FileAccess.get_open_error())]
	var magic: String = _file.get_buffer(8).get_string_from_ascii()
	if magic != StateRecorder.MAGIC:
		var found: String = ByteReader.clean(magic)
		return "%s: expected a recording (%s), found '%s'" % [path, StateRecorder.MAGIC, found]
	_read_next()
	if _next.is_empty():
		return "%s: the recording is empty" % path
	return ""


func advance(p_delta_s: float) -> void:
	_clock_s += p_delta_s
	while not _next.is_empty() and _next_usec <= int(_clock_s * 1e6):
		var bytes: PackedByteArray = _next
		var time_s: float = _next_usec / 1e6
		_read_next()
		if bytes.size() == 1 and bytes[0] == StateRecorder.BEGIN:
			restarted.emit()
		else:
			received.emit(bytes, time_s)
		if _next.is_empty():
			ended.emit(EXIT_DONE, "")


func now_s() -> float:
	return _clock_s


func frame_s(_frame_usec: int) -> float:
	# A film is made slower than it plays: frames are as far apart as the engine says.
	return _clock_s


func server_usec(p_local_usec: int) -> int:
	return p_local_usec


func knows_server_clock() -> bool:
	return false


func session() -> int:
	return 0


func send_fast(_bytes: PackedByteArray) -> void:
	# There is no server to take it.
	pass


func close() -> void:
	_file = null
	_next = PackedByteArray()


func _read_next() -> void:
	_next = PackedByteArray()
	# A record that was cut off by a kill is the end.
	if _file.get_length() - _file.get_position() < 12:
		return
	var size: int = _file.get_32()
	_next_usec = _file.get_64()
	if size == 0 or size > MAX_BYTES or _file.get_length() - _file.get_position() < size:
		if size == 0 or size > MAX_BYTES:
			Log.warning("review", "%s: a broken record ends the playback" % path)
		return
	_next = _file.get_buffer(size)
