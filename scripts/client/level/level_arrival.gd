class_name LevelArrival
extends RefCounted
## Lets a client wait for the server's level without stalling: gets it from the server where this
## machine lacks it, loads it over several frames, and keeps what the server says of its entities
## until it is there. The client stays joined all the while.

## What to show in the middle of the screen; empty when there is nothing to wait for.
signal progressed(p_text: String)

## What the client waits for.
enum Wait {
	## Nothing: the level is there.
	NOTHING,
	## The files of the level.
	FILES,
	## The level to be loaded.
	LOAD,
	## Another level of the server, as this one cannot be had.
	ANOTHER,
}

## Bytes of messages that are kept while a level loads; a server that sends more is too much.
const MAX_KEPT: int = 64 << 20

## What the client waits for.
var wait: Wait = Wait.NOTHING
## Levels that were loaded.
var loaded: int = 0
## Seconds that the last level took from its name to the screen.
var seconds: float = 0.0
## Bytes of the last level that were downloaded.
var downloaded: int = 0
## Longest part of the work in a frame, µs of processor time.
var longest_usec: int = 0
## Lets what spawners and synchronizers send wait for their level: [method ClientLink.hold_shared].
var hold_shared: Callable = Callable()
## The download.
var download: LevelDownload = null

var _scene: ClientScene = null
var _store: ReceivedLevels = null
var _loader: LevelLoader = LevelLoader.new()
var _reference: LevelReference = null
var _named: PackedByteArray = PackedByteArray()
var _kept: Array[PackedByteArray] = []
var _kept_bytes: int = 0
var _began_usec: int = 0
var _is_fresh: bool = false
var _text: String = ""


## Sends requests by a callable: [code]func(bytes: PackedByteArray) -> void[/code].
func _init(p_scene: ClientScene, p_store: ReceivedLevels, p_send: Callable) -> void:
	_scene = p_scene
	_store = p_store
	download = LevelDownload.new(p_send, p_store)
	# Without a window no picture can freeze, and people's avatars may come at any time.
	_loader.has_thread = not RenderLock.is_needed()


## Takes a message about the state of the world. Returns whether it has been kept for later, or is
## useless before the level is there.
func keeps(p_bytes: PackedByteArray) -> bool:
	var kind: int = Protocol.kind_of(p_bytes)
	if kind == Protocol.Message.LEVEL:
		return _begin(p_bytes)
	if wait == Wait.NOTHING:
		return false
	var is_kept: bool = kind == Protocol.Message.TABLE or kind == Protocol.Message.EVENTS
	if is_kept and wait != Wait.ANOTHER:
		_kept.append(p_bytes)
		_kept_bytes += p_bytes.size()
		if _kept_bytes > MAX_KEPT:
			_refuse("the server sends too much while it loads")
	return true


## Takes an answer of the server to a request. Returns whether it makes sense.
func take_data(p_bytes: PackedByteArray) -> bool:
	return download.take(p_bytes)


## Goes on with what is waited for; the frame has this length, s. When the level is there, what was
## kept is given to a callable: [code]func(bytes: PackedByteArray) -> void[/code].
func advance(p_delta_s: float, p_take: Callable) -> void:
	var begin: int = ThreadClock.get_usec()
	_loader.advance()
	if wait == Wait.FILES:
		download.advance(p_delta_s)
		_look_at_download()
	if wait == Wait.LOAD:
		_look_at_loader(p_take)
	if wait != Wait.NOTHING or _loader.is_leaving():
		longest_usec = maxi(longest_usec, ThreadClock.get_usec() - begin)
	_tell()


## How much of the level that is waited for is there, 0 to 1: its files first, then its nodes. 1
## where nothing is waited for.
func progress() -> float:
	return download.progress() if wait == Wait.FILES else _loader.progress()


## How much of the first level is there, 0 to 1: 0 before the server has named it.
func first_progress() -> float:
	if loaded > 0:
		return 1.0
	# Its last part is to be seen by those who wait, not to be seen through.
	return minf(progress(), 0.99) if wait != Wait.NOTHING else 0.0


## How it stands, for a report.
func report() -> Dictionary:
	return {
		"name": _reference.name if _reference != null else "",
		"waits_for": (Wait.keys()[wait] as String).to_lower(),
		"progress": progress(),
		"loaded": loaded,
		"seconds": seconds,
		"downloaded_bytes": downloaded,
		"resumed_bytes": download.resumed,
		"longest_ms": longest_usec / 1000.0,
		"text": _text,
	}


## See [method LevelLoader.end_reading].
func end_reading(p_tree: SceneTree) -> void:
	await _loader.end_reading(p_tree)


## Ends.
func close() -> void:
	download.cancel()
	_loader.close()


## A connection begins: what was kept of the last one is void.
func restart() -> void:
	if wait != Wait.NOTHING:
		_clear()
		_reference = null
		wait = Wait.NOTHING
	# The class that restores the connection shows texts of its own meanwhile.
	_text = ""


func _begin(p_bytes: PackedByteArray) -> bool:
	var message: LevelMessage = LevelMessage.decode(p_bytes)
	if message == null:
		return false
	_reference = LevelReference.parse(message.name)
	var is_ours: bool = _reference.content_hash == ""
	if is_ours and not LevelStore.has(_reference.name):
		return false
	_clear()
	if hold_shared.is_valid():
		hold_shared.call(true)
	_named = p_bytes
	_began_usec = Time.get_ticks_usec()
	longest_usec = 0
	downloaded = 0
	_is_fresh = false
	_scene.clear()
	_scene.get_level().dismiss(_loader)
	wait = Wait.LOAD
	if is_ours:
		_loader.begin_own(_reference.name)
	elif _store.has(_reference.content_hash):
		_load_received()
	else:
		wait = Wait.FILES
		download.begin(_reference)
	_tell()
	return true


func _load_received() -> void:
	_store.touch(_reference.content_hash)
	var folder: String = _store.folder_of(_reference.content_hash)
	_loader.begin_folder(_reference.name, folder, _reference.content_hash)
	wait = Wait.LOAD


func _look_at_download() -> void:
	if download.state == LevelDownload.State.FAILED:
		_refuse(download.fault)
	elif download.state == LevelDownload.State.DONE:
		downloaded = download.here - download.resumed
		_is_fresh = true
		_load_received()


func _look_at_loader(p_take: Callable) -> void:
	match _loader.state:
		LevelLoader.State.FAILED:
			_on_broken()
		LevelLoader.State.READ:
			_scene.get_level().prepare(_loader.level)
			_loader.enter(_scene.get_level())
		LevelLoader.State.DONE:
			_loader.state = LevelLoader.State.IDLE
			wait = Wait.NOTHING
			loaded += 1
			seconds = (Time.get_ticks_usec() - _began_usec) / 1e6
			_scene.get_level().fingerprint = _loader.fingerprint
			p_take.call(_named)
			for bytes: PackedByteArray in _kept:
				p_take.call(bytes)
			_kept.clear()
			if hold_shared.is_valid():
				hold_shared.call(false)
			var parts: Array = [_reference.name, seconds, longest_usec / 1000.0]
			Log.info("client", "world '%s' is there after %.1f s (frames waited %.1f ms)" % parts)


## What was received before and has been damaged since is downloaded again; what has just come is
## the server's fault.
func _on_broken() -> void:
	var why: String = _loader.fault
	_loader.state = LevelLoader.State.IDLE
	if _reference.content_hash != "" and not _is_fresh:
		var text: String = "the stored world '%s' is damaged (%s): getting it again"
		Log.limited("client", "store", text % [_reference.name, why])
		_store.remove(_reference.content_hash)
		wait = Wait.FILES
		download.begin(_reference)
		return
	_store.remove(_reference.content_hash)
	_refuse(why)


func _refuse(p_why: String) -> void:
	_clear()
	wait = Wait.ANOTHER
	var text: String = "the server's world '%s' is refused: %s"
	_text = text % [ByteReader.clean(_reference.name.left(LevelStore.MAX_NAME)), p_why]
	Log.limited("client", "refused", _text)
	progressed.emit(
		"%s.\nWaiting for another one ..." % (_text.left(1).to_upper() + _text.substr(1))
	)


func _clear() -> void:
	download.cancel()
	if _loader.state == LevelLoader.State.ENTERING:
		_scene.get_level().forget()
	_loader.cancel()
	_kept.clear()
	_kept_bytes = 0


func _tell() -> void:
	var text: String = ""
	if wait == Wait.ANOTHER:
		return
	if wait == Wait.FILES:
		var title: String = _reference.name
		if download.manifest != null:
			title = download.manifest.title
		text = "Downloading world '%s': %s" % [title, download.describe()]
	elif wait == Wait.LOAD:
		text = "Loading world '%s': %.0f %%" % [_reference.name, 100.0 * _loader.progress()]
	if text != _text:
		_text = text
		progressed.emit(text)
