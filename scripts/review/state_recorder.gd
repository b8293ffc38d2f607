class_name StateRecorder
extends RefCounted
## Writes what a client receives, or what a server sends, to a file. A kill loses at most the last
## second.
##
## Format, little-endian: the eight bytes [constant MAGIC], then records of u32 size, u64 time since
## the start (µs) and the packet. See [RecordedStream].

## First bytes of a recording: the name and the version of the format.
const MAGIC: String = "DSMTREC4"
## The only byte of a record that says that a connection begins: what came before is void.
const BEGIN: int = 0xFF
## Number of the recorder in a server's encoder; no session has it.
const CLIENT: int = -1
## Seconds between two flushes to the disk.
const FLUSH_S: float = 1.0

var _file: FileAccess = null
var _begin_usec: int = 0
var _flushed_usec: int = 0


## Begins a recording; returns why it cannot, or an empty text.
func open(p_path: String) -> String:
	_file = FileAccess.open(p_path, FileAccess.WRITE)
	if _file == null:
		return "cannot record to %s: %s" % [p_path, error_string(FileAccess.get_open_error())]
	_file.store_buffer(MAGIC.to_ascii_buffer())
	_file.flush()
	_begin_usec = Time.get_ticks_usec()
	return ""


## Records that a new connection has begun.
func begin() -> void:
	add(PackedByteArray([BEGIN]))


## Adds a packet that has just arrived.
func add(p_bytes: PackedByteArray) -> void:
	if _file == null:
		return
	var now: int = Time.get_ticks_usec()
	_file.store_32(p_bytes.size())
	_file.store_64(now - _begin_usec)
	_file.store_buffer(p_bytes)
	if now - _flushed_usec > int(FLUSH_S * 1e6):
		_flushed_usec = now
		_file.flush()
	if _file.get_error() != OK:
		Log.error("review", "the recording ends here: %s" % error_string(_file.get_error()))
		_file = null


## Ends the recording.
func close() -> void:
	if _file != null:
		_file.close()
		_file = null
