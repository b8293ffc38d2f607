class_name LevelDownload
extends RefCounted
## Gets the files of a level from the server, by the hash of its manifest: asks for them piece by
## piece, checks each answer, keeps what has come on the disk so that it can go on after a broken
## connection or a stop, and puts the level together when every file has the right SHA-256.

## How it stands.
enum State {
	## Nothing is downloaded.
	IDLE,
	## The manifest is on its way.
	MANIFEST,
	## A file is on its way.
	FILE,
	## A thread checks a file.
	CHECKING,
	## A thread puts the level together.
	KEEPING,
	## The level is in the store.
	DONE,
	## The level cannot be had: see [member fault].
	FAILED,
}

## Seconds without an answer after which it asks again.
const PATIENCE_S: float = 15.0
## How often it asks again without an answer before it gives up.
const MAX_RETRIES: int = 4

## Pieces that are asked for ahead.
const _AHEAD: int = 3

## How it stands.
var state: State = State.IDLE
## Why the level cannot be had, or an empty text.
var fault: String = ""
## The level's manifest, once it has come.
var manifest: LevelManifest = null
## Bytes of its files that are here.
var here: int = 0
## What was here before, of another connection or another run: bytes.
var resumed: int = 0

var _send: Callable = Callable()
var _store: ReceivedLevels = null
var _reference: LevelReference = null
var _next_number: int = 1
# What was asked for and has not come as a whole, the oldest first.
var _asked: Array[LevelRequestMessage] = []
var _bytes: PackedByteArray = PackedByteArray()
var _index: int = 0
var _file: FileAccess = null
var _file_size: int = 0
var _asked_to: int = 0
var _was_resumed: bool = false
var _waited_s: float = 0.0
var _retries: int = 0
var _thread: Thread = null


## Sends requests by a callable: [code]func(bytes: PackedByteArray) -> void[/code].
func _init(p_send: Callable, p_store: ReceivedLevels) -> void:
	_send = p_send
	_store = p_store


## Begins to get a level, or goes on where an earlier run has stopped.
func begin(p_reference: LevelReference) -> void:
	cancel()
	_reference = p_reference
	fault = ""
	manifest = null
	here = 0
	resumed = 0
	_retries = 0
	_ask_for_manifest()


## Whether something is on its way.
func is_busy() -> bool:
	return state != State.IDLE and state != State.DONE and state != State.FAILED


## Stops. What has come stays on the disk.
func cancel() -> void:
	if _thread != null:
		_thread.wait_to_finish()
		_thread = null
	_file = null
	_asked.clear()
	_bytes = PackedByteArray()
	state = State.IDLE


## Takes an answer. Returns whether it is one that was asked for.
func take(p_bytes: PackedByteArray) -> bool:
	var answer: LevelDataMessage = LevelDataMessage.decode(p_bytes)
	if answer == null or _asked.is_empty() or answer.number != _asked[0].number:
		# It may be the answer to what was asked before the level changed.
		return answer != null
	if answer.outcome == LevelDataMessage.Outcome.REFUSED:
		_fail("the server does not send it: %s" % answer.why)
		return true
	var request: LevelRequestMessage = _asked[0]
	var wanted: int = request.offset + _bytes.size()
	var is_manifest: bool = state == State.MANIFEST
	var size: int = answer.size if is_manifest else _file_size
	if is_manifest and size > LevelManifest.MAX_BYTES:
		_fail("its manifest has %d bytes, %d are the most" % [size, LevelManifest.MAX_BYTES])
		return false
	if answer.offset != wanted or answer.size != size:
		_fail("the server sends something else than was asked for")
		return false
	if _bytes.size() + answer.data.size() > request.length:
		_fail("the server sends more than was asked for")
		return false
	_bytes.append_array(answer.data)
	_waited_s = 0.0
	_retries = 0
	if is_manifest and _bytes.size() == size:
		_take_manifest()
	elif not is_manifest and _bytes.size() == request.length:
		_take_piece()
	return true


## Goes on; the frame has this length, s.
func advance(p_delta_s: float) -> void:
	if state == State.CHECKING or state == State.KEEPING:
		if not _thread.is_alive():
			var outcome: String = _thread.wait_to_finish()
			_thread = null
			if state == State.CHECKING:
				_end_file(outcome)
			else:
				_end_level(outcome)
	elif state == State.MANIFEST or state == State.FILE:
		_waited_s += p_delta_s
		if _waited_s > PATIENCE_S:
			_ask_again()


## Share of the bytes that are here, 0 to 1.
func progress() -> float:
	return float(here) / maxi(manifest.total_size(), 1) if manifest != null else 0.0


## How it stands, for people: "42 %, 3.1 of 7.4 MB".
func describe() -> String:
	if manifest == null:
		return "asking the server"
	var total: float = manifest.total_size() / 1048576.0
	var text: String = "%.0f %%, %.1f of %.1f MB" % [100.0 * progress(), here / 1048576.0, total]
	return text + (", the server is silent" if _retries > 0 else "")


func _ask_for_manifest() -> void:
	state = State.MANIFEST
	_asked.clear()
	_bytes = PackedByteArray()
	_ask(LevelRequestMessage.MANIFEST, 0, LevelManifest.MAX_BYTES)


func _take_manifest() -> void:
	_asked.clear()
	var found: LevelManifest = LevelManifest.decode(_bytes)
	if found.content_hash() != _reference.content_hash:
		_fail("the manifest is not the one that was offered: its SHA-256 differs")
		return
	if found.error == "" and found.name != _reference.name:
		found.error = "it is called '%s'" % found.name
	if found.error == "":
		found.error = _store.make_room(found.total_size(), _reference.content_hash)
	if found.error != "":
		_fail(found.error)
		return
	manifest = found
	_index = 0
	_begin_file()


## Begins the next file, or goes on where an earlier run has stopped.
func _begin_file() -> void:
	_asked.clear()
	_bytes = PackedByteArray()
	var entry: LevelManifest.Entry = manifest.files[_index]
	var path: String = _store.claim_part(entry.sha256)
	var mode: FileAccess.ModeFlags = FileAccess.READ_WRITE
	if not FileAccess.file_exists(path):
		mode = FileAccess.WRITE_READ
	_file = FileAccess.open(path, mode)
	if _file == null:
		_fail("%s cannot be written: %s" % [path, error_string(FileAccess.get_open_error())])
		return
	if _file.get_length() > entry.size:
		_file.resize(0)
	_file_size = entry.size
	_asked_to = _file.get_length()
	_was_resumed = _asked_to > 0
	resumed += _asked_to
	here += _asked_to
	_file.seek_end()
	state = State.FILE
	if _asked_to == entry.size:
		_check_file()
	else:
		_ask_ahead()


func _ask_ahead() -> void:
	while _asked.size() < _AHEAD and _asked_to < _file_size:
		var length: int = mini(LevelRequestMessage.MAX_LENGTH, _file_size - _asked_to)
		_ask(_index + 1, _asked_to, length)
		_asked_to += length


func _ask(p_file: int, p_offset: int, p_length: int) -> void:
	var request: LevelRequestMessage = LevelRequestMessage.new()
	request.number = _next_number
	_next_number = _next_number % 0xFFFF + 1
	request.content_hash = _reference.content_hash.hex_decode()
	request.file = p_file
	request.offset = p_offset
	request.length = p_length
	_asked.append(request)
	_waited_s = 0.0
	_send.call(request.encode())


## A server that is silent is asked again, from what has come on.
func _ask_again() -> void:
	_retries += 1
	if _retries > MAX_RETRIES:
		_fail("the server has stopped to send it")
	elif state == State.MANIFEST:
		_ask_for_manifest()
	else:
		_asked.clear()
		_bytes = PackedByteArray()
		_asked_to = _file.get_length()
		_ask_ahead()


func _take_piece() -> void:
	_asked.pop_front()
	if not _file.store_buffer(_bytes):
		_fail("the disk is full, or %s cannot be written" % _file.get_path())
		return
	_file.flush()
	here += _bytes.size()
	_bytes = PackedByteArray()
	if _file.get_length() == _file_size:
		_check_file()
	else:
		_ask_ahead()


func _check_file() -> void:
	var path: String = _file.get_path()
	_file = null
	state = State.CHECKING
	_thread = Thread.new()
	_thread.start(func() -> String: return FileAccess.get_sha256(path), Thread.PRIORITY_LOW)


func _end_file(p_sha256: String) -> void:
	var entry: LevelManifest.Entry = manifest.files[_index]
	if p_sha256 == entry.sha256:
		_index += 1
		if _index < manifest.files.size():
			_begin_file()
			return
		state = State.KEEPING
		_thread = Thread.new()
		_thread.start(_store.adopt.bind(manifest), Thread.PRIORITY_LOW)
		return
	DirAccess.remove_absolute(_store.claim_part(entry.sha256))
	if not _was_resumed:
		_fail("%s is not what was offered: its SHA-256 differs" % entry.name)
		return
	# What lay there from an earlier run was damaged: once more from the beginning.
	here -= entry.size
	resumed = 0
	_begin_file()


func _end_level(p_fault: String) -> void:
	if p_fault != "":
		_fail(p_fault)
		return
	state = State.DONE


func _fail(p_why: String) -> void:
	cancel()
	fault = p_why
	state = State.FAILED
