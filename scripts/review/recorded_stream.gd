class_name RecordedStream
extends StateStream
## Plays a recording of a [StateRecorder] as if its messages arrived from a server.

## Largest message that a recording may hold, bytes.
const MAX_BYTES: int = 1 << 24
## Changes of the world (beginnings, levels, each KiB of tables) that are played in a frame; the
## rest waits for the next one. A forged recording could have everything made thousands of times at
## once.
const MAX_CHANGES: int = 8
## The same of the first frame, if the playback begins in the middle: the frame is to show what was
## there by then.
const MAX_FIRST_CHANGES: int = 64

## Path of the recording.
var path: String = ""
## The longest step of a frame, s: with a limit the recording does not run on unseen during a frame
## that takes long, as while a world loads.
var max_step_s: float = INF
## Where in the recording the playback begins, s: what was before is taken in at once.
var from_s: float = 0.0

var _file: FileAccess = null
var _next: PackedByteArray = PackedByteArray()
var _next_usec: int = 0
var _clock_s: float = 0.0
var _limit: int = MAX_CHANGES


## A stream that plays a file.
static func of_file(p_path: String, p_from_s: float = 0.0) -> RecordedStream:
	var stream: RecordedStream = RecordedStream.new()
	stream.path = p_path
	stream.from_s = p_from_s
	return stream


func open() -> String:
	if path == "":
		return "which recording? --file=FILE"
	_file = FileAccess.open(path, FileAccess.READ)
	if _file == null:
		return "cannot read %s: %s" % [path, error_string(FileAccess.get_open_error())]
	if _file.get_length() == 0:
		return "%s: the recording is empty" % path
	var magic: String = _file.get_buffer(8).get_string_from_ascii()
	if magic != StateRecorder.MAGIC:
		var found: String = ByteReader.clean(magic)
		return "%s: expected a recording (%s), found '%s'" % [path, StateRecorder.MAGIC, found]
	_read_next()
	if _next.is_empty():
		return "%s: the recording is empty" % path
	_clock_s = from_s
	_limit = MAX_FIRST_CHANGES if from_s > 0.0 else MAX_CHANGES
	return ""


func advance(p_delta_s: float) -> void:
	_clock_s += minf(p_delta_s, max_step_s)
	var changes: int = 0
	var limit: int = _limit
	_limit = MAX_CHANGES
	var is_first: bool = true
	while not _next.is_empty() and _next_usec <= int(_clock_s * 1e6):
		var bytes: PackedByteArray = _next
		changes += _weight(bytes)
		if changes > limit and not is_first:
			return
		is_first = false
		var time_s: float = _next_usec / 1e6
		_read_next()
		if bytes.size() == 1 and bytes[0] == StateRecorder.BEGIN:
			restarted.emit()
		else:
			received.emit(bytes, time_s)
		if _next.is_empty():
			ended.emit(EXIT_DONE, "")


## Plays all that is left at once, frame by frame, however long it is.
func play_all() -> void:
	var before_s: float = max_step_s
	max_step_s = INF
	while not _next.is_empty():
		advance(1e6)
	max_step_s = before_s


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


func describe() -> String:
	return path.get_file()


func security() -> String:
	return ""


func send_fast(_bytes: PackedByteArray) -> void:
	# There is no server to take it.
	pass


func close() -> void:
	_file = null
	_next = PackedByteArray()


## How many changes of the world a message counts for: a level is as many as fit into a frame.
static func _weight(p_bytes: PackedByteArray) -> int:
	match p_bytes[0]:
		Protocol.Message.LEVEL:
			return MAX_CHANGES
		Protocol.Message.TABLE:
			return 1 + (p_bytes.size() >> 10)
		StateRecorder.BEGIN:
			return 1
	return 0


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
