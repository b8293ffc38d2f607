class_name OwnMotionSet
extends RefCounted
## The gait of this client's user ([code]--motion-set[/code]): gives it to what shows the own body,
## and sends it to the server, whose body is to walk alike.
##
## It is sent slowly beside the session's own traffic, once in each session: the server keeps it for
## who comes back, and says so. What was not answered before the connection was lost is sent again.

## What has become of it, for reports and those who wait for it.
enum State {
	## There is none: the user walks as everybody does.
	NONE,
	## It waits for a session in which the user walks.
	WAITS,
	## Its parts are being sent, or the server is reading it.
	SENT,
	## The server's body walks by it.
	TAKEN,
	## The server does not take it.
	REFUSED,
}

## How fast it is sent, parts/s: 45 kB/s, a guided recording in a quarter of a minute.
const PARTS_PER_S: float = 40.0

## The set, or null.
var own: WalkerSet = null
## What has become of it in the present session.
var state: State = State.NONE

var _link: ClientLink = null
var _bytes: PackedByteArray = []
var _parts: Array[PackedByteArray] = []
var _due: float = 0.0
var _number: int = 0


## Reads the file that the options name, if any. Returns what is wrong, or an empty text.
func open(p_link: ClientLink, p_path: String) -> String:
	_link = p_link
	_link.handle(Protocol.Message.MOTION_SET, MessageHandlers.Path.RELIABLE, _on_answer)
	_link.joined.connect(_on_joined)
	if p_path == "":
		return ""
	var file: FileAccess = FileAccess.open(p_path, FileAccess.READ)
	if file == null:
		var why: String = error_string(FileAccess.get_open_error())
		return "--motion-set: cannot read %s: %s" % [p_path, why]
	# One byte more shows that there are too many.
	_bytes = file.get_buffer(MotionSetMessage.MAX_BYTES + 1)
	own = WalkerSet.read(_bytes)
	if own.error != "":
		return "--motion-set: %s: %s" % [p_path, own.error]
	state = State.WAITS
	return ""


## Lets the walker of a source, or the legs that carry it, go by the set.
func give_to(p_source: MotionSource) -> void:
	if own == null:
		return
	if p_source is WalkerSource:
		(p_source as WalkerSource).use_set(own)
	elif p_source is WalkedLegs:
		(p_source as WalkedLegs).use_set(own)


## Goes on by a frame's length, s; sends while the user walks.
func advance(p_delta_s: float, p_walks: bool) -> void:
	if not p_walks or not _link.is_joined():
		return
	if state == State.WAITS:
		state = State.SENT
		_number = _number % 0xFFFF + 1
		_parts = MotionSetMessage.split(_bytes, _number)
		_due = 0.0
	# Long frames do not lead to bursts.
	_due = minf(_due + p_delta_s * PARTS_PER_S, 4.0)
	while _due >= 1.0 and not _parts.is_empty():
		_due -= 1.0
		_link.send_reliably(_parts.pop_front())


## For the client's report.
func report() -> Dictionary:
	return {} if own == null else {"id": own.id, "state": State.find_key(state)}


func _on_joined() -> void:
	_parts.clear()
	var is_answered: bool = state == State.TAKEN or state == State.REFUSED
	if own != null and not (is_answered and _link.came_back):
		state = State.WAITS


func _on_answer(p_bytes: PackedByteArray, _arrival_usec: int) -> bool:
	var message: MotionSetMessage = MotionSetMessage.decode_answer(p_bytes)
	if message == null:
		return false
	if state != State.SENT or message.number != _number:
		return true
	if message.outcome == MotionSetMessage.Outcome.TAKEN:
		state = State.TAKEN
		Log.info("walker", "the server's body walks by your motion set")
	else:
		state = State.REFUSED
		Log.warning("walker", "the server does not take your motion set: " + message.text)
	return true
