class_name LevelOffers
extends RefCounted
## Sends clients the files of the present level that they ask for, a little in each tick, so that
## snapshots are not delayed. What is not of the present level is refused.

## Requests of a session that may wait; more are dropped and complained of.
const MAX_WAITING: int = 4
## What all downloads together may take of the network by default, kbit/s.
const DEFAULT_KBITS: int = 20000

## What all downloads together may take of the network, bit/s.
var bits_per_second: float = DEFAULT_KBITS * 1000.0
## Bytes of files that were sent, since the start.
var sent_bytes: int = 0

var _link: ServerLink = null
var _level: ServerLevel = null
var _waiting: Dictionary[int, Array] = {}
# Bytes that the next tick may send: less than none after a large message.
var _room: float = 0.0


## A piece that a session has asked for.
class Piece:
	extends RefCounted
	var request: LevelRequestMessage = null
	var path: String = ""
	var size: int = 0
	var bytes: PackedByteArray = PackedByteArray()
	var sent: int = 0
	var task: int = -1

	## Reads it from the disk or from a share of the network, in a thread: it may take long.
	func read() -> void:
		var file: FileAccess = FileAccess.open(path, FileAccess.READ)
		if file != null:
			file.seek(request.offset)
			bytes = file.get_buffer(request.length)

	## Whether it has been read.
	func is_ready() -> bool:
		if task >= 0 and WorkerThreadPool.is_task_completed(task):
			WorkerThreadPool.wait_for_task_completion(task)
			task = -1
		return task < 0


func _init(p_link: ServerLink, p_level: ServerLevel) -> void:
	_link = p_link
	_level = p_level
	_link.handle(Protocol.Message.LEVEL_REQUEST, MessageHandlers.Path.RELIABLE, _on_request)
	_link.client_left.connect(forget)
	_link.client_lost.connect(forget)


## Sends what a tick of this length (s) has room for, in turn to all who wait.
func advance(p_delta_s: float) -> void:
	var share: float = bits_per_second / 8.0 * p_delta_s
	_room = minf(_room + share, share)
	while _room > 0.0 and not _waiting.is_empty():
		var sent: bool = false
		for session: int in _waiting.keys():
			sent = _send_some(session) or sent
			if _room <= 0.0:
				break
		if not sent:
			return


## Forgets what a session has asked for.
func forget(p_session: int) -> void:
	for piece: Piece in _waiting.get(p_session, []):
		_drop(piece)
	_waiting.erase(p_session)


## Ends: waits for what is being read.
func close() -> void:
	for session: int in _waiting.keys():
		forget(session)


## What it has sent so far, for a report.
func report() -> Dictionary:
	return {"downloads": _waiting.size(), "sent_bytes": sent_bytes}


## Sessions that are being sent something.
func count() -> int:
	return _waiting.size()


## Sends the next part of a session's first piece. Returns whether there was one.
func _send_some(p_session: int) -> bool:
	var piece: Piece = _waiting[p_session][0]
	if not piece.is_ready():
		return false
	if piece.bytes.size() != piece.request.length:
		_refuse(p_session, piece.request, "the server cannot read the file any more")
		_finish(p_session)
		return true
	var data: PackedByteArray = piece.bytes.slice(piece.sent, piece.sent + LevelDataMessage.ROOM)
	var offset: int = piece.request.offset + piece.sent
	_link.send_whole(
		p_session, LevelDataMessage.encode(piece.request.number, offset, piece.size, data)
	)
	piece.sent += data.size()
	sent_bytes += data.size()
	_room -= data.size()
	if piece.sent == piece.bytes.size():
		_finish(p_session)
	return true


func _finish(p_session: int) -> void:
	_waiting[p_session].pop_front()
	if _waiting[p_session].is_empty():
		_waiting.erase(p_session)


func _on_request(p_session: Session, p_bytes: PackedByteArray, _arrival_usec: int) -> String:
	var request: LevelRequestMessage = LevelRequestMessage.decode(p_bytes)
	if request == null:
		return "a request for a level that is none"
	var folder: LevelFolder = _level.folder
	if folder == null or folder.manifest.content_hash() != request.content_hash.hex_encode():
		if _link.rates.take(&"refusals", p_session.id, Time.get_ticks_usec() / 1e6):
			_refuse(p_session.id, request, "the server's world is another one now")
		return ""
	var pieces: Array = _waiting.get_or_add(p_session.id, [])
	if pieces.size() >= MAX_WAITING:
		return "more than %d requests for a level at once" % MAX_WAITING
	var piece: Piece = _make_piece(folder, request)
	if piece == null:
		if pieces.is_empty():
			_waiting.erase(p_session.id)
		return "a request for what is not in the level"
	pieces.append(piece)
	return ""


## A piece of a file; null if there is no such one.
func _make_piece(p_folder: LevelFolder, p_request: LevelRequestMessage) -> Piece:
	var manifest: LevelManifest = p_folder.manifest
	var piece: Piece = Piece.new()
	piece.request = p_request
	if p_request.file == LevelRequestMessage.MANIFEST:
		piece.size = manifest.bytes.size()
		# Who asks for it does not know how long it is.
		p_request.length = mini(p_request.length, piece.size - p_request.offset)
		if p_request.length <= 0:
			return null
		piece.bytes = manifest.bytes.slice(p_request.offset, p_request.offset + p_request.length)
		return piece
	if p_request.file > manifest.files.size():
		return null
	var entry: LevelManifest.Entry = manifest.files[p_request.file - 1]
	if p_request.offset + p_request.length > entry.size:
		return null
	piece.size = entry.size
	piece.path = p_folder.path.path_join(entry.name)
	piece.task = WorkerThreadPool.add_task(piece.read)
	return piece


func _refuse(p_session: int, p_request: LevelRequestMessage, p_why: String) -> void:
	_link.send_whole(p_session, LevelDataMessage.refuse(p_request.number, p_why))


static func _drop(p_piece: Piece) -> void:
	if p_piece.task >= 0:
		WorkerThreadPool.wait_for_task_completion(p_piece.task)
