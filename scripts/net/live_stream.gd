class_name LiveStream
extends StateStream
## The state of a server's world, over a connection that is restored whenever it is lost.

## The client has been admitted; again after each loss.
signal joined
## A connection is being made: [method ClientLink.api] is another one from now on.
signal connecting
## The server shows another key than before, and somebody is there who can be asked: see [member
## asks]. Nothing goes on until [method trust_key].
signal key_changed(p_other: OtherServerKey)

## Who has not been admitted yet is not: why. Comes instead of [signal ended] while [member
## is_patient]; [method open] tries again.
signal turned_away(p_why: String)

## Seconds between two attempts to reach a server.
const _RETRY_S: float = 2.0
## Seconds until the first one after a working connection was lost.
const _SOON_S: float = 0.3
## Texts for user and log, by [enum JoinReply.Wait]: what we wait for. Our position follows.
const _STATUS: Array[String] = [
	"Waiting for an instructor, position %d ...",
	"The server is full.\nWaiting for room, position %d ...",
	"No more clients of your address may be here.\nWaiting for room, position %d ...",
]
const _LINES: Array[String] = [
	"waiting for an instructor, position %d",
	"waiting for room, position %d",
	"waiting for room among the clients of this address, position %d",
]

## The connection.
var link: ClientLink = ClientLink.new()
## Who the client is, for the server.
var request: JoinRequest = JoinRequest.new()
## Address of the server.
var host: String = ""
## UDP port of the server.
var port: int = Protocol.DEFAULT_PORT
## Password of the session; never sent in clear.
var password: String = ""
## Seconds without a server after which it gives up; 0 never.
var patience_s: float = 0.0
## Whether somebody can be asked if a changed key is to be trusted; otherwise it ends the stream.
var asks: bool = false
## Whether somebody is there who can try again: a server that does not admit us ends nothing.
var is_patient: bool = false

var _retry_at_s: float = INF
var _alone_since_s: float = 0.0
var _was_joined: bool = false
var _is_asking: bool = false
var _is_open: bool = false


func open() -> String:
	traffic = link.traffic
	_is_open = true
	if not link.joined.is_connected(_on_joined):
		link.joined.connect(_on_joined)
		link.lost.connect(_on_lost)
		link.refused.connect(_on_refused)
		link.waiting.connect(_on_waiting)
		link.state_received.connect(_on_state)
	_alone_since_s = now_s()
	_connect()
	return ""


func advance(_delta_s: float) -> void:
	if _is_asking or not _is_open:
		return
	link.poll()
	var now: float = now_s()
	if not link.is_joined() and now > _retry_at_s:
		_connect()
	if link.is_waiting():
		_alone_since_s = now
	if not link.is_joined() and patience_s > 0.0 and now - _alone_since_s > patience_s:
		var where: Array = [host, port, patience_s]
		_end(EXIT_NO_SERVER, "no server at %s:%d for %.0f s" % where)


## The user trusts the key that the server has shown: joins it.
func trust_key(p_other: OtherServerKey) -> void:
	link.trust.trust(p_other)
	_is_asking = false
	_alone_since_s = now_s()
	_connect()


func now_s() -> float:
	return Time.get_ticks_usec() / 1e6


func frame_s(p_frame_usec: int) -> float:
	return p_frame_usec / 1e6


func server_usec(p_local_usec: int) -> int:
	return link.clock.server_usec(p_local_usec) if link.clock.is_known() else p_local_usec


func knows_server_clock() -> bool:
	return link.clock.is_known()


func session() -> int:
	return link.session


func describe() -> String:
	return "%s:%d" % [host, port]


func security() -> String:
	return "sealed" if link.seals else "NOT SEALED"


func send_fast(p_bytes: PackedByteArray) -> void:
	link.send_fast(p_bytes)


## Leaves the server; [method open] comes back.
func close() -> void:
	_is_open = false
	_is_asking = false
	link.leave()


func _connect() -> void:
	status_changed.emit("Joining %s:%d ..." % [host, port])
	_retry_at_s = INF
	link.open(host, port, request, password)
	connecting.emit()


func _on_joined() -> void:
	Log.info("client", "joined %s:%d" % [host, port])
	status_changed.emit("")
	_was_joined = true
	is_patient = false
	# The server's deltas are relative to what it has sent in this connection.
	restarted.emit()
	joined.emit()


func _on_lost(p_why: String) -> void:
	Log.limited("client", p_why, "%s; trying again" % p_why)
	var sentence: String = p_why.left(1).to_upper() + p_why.substr(1)
	status_changed.emit("%s.\nTrying again ..." % sentence)
	# After a working connection the first attempt comes soon.
	_retry_at_s = now_s() + (_SOON_S if _was_joined else _RETRY_S)
	if _was_joined or link.was_put_off:
		_alone_since_s = now_s()
	if _was_joined:
		restarted.emit()
	_was_joined = false


func _on_refused(p_why: String) -> void:
	var other: OtherServerKey = link.other_key
	if other == null:
		_end(EXIT_REFUSED, "the server refused us: %s" % p_why)
	elif not asks or other.is_pinned:
		_end(EXIT_REFUSED, p_why)
	else:
		Log.warning("client", p_why)
		_is_asking = true
		status_changed.emit("")
		key_changed.emit(other)


func _end(p_code: int, p_why: String) -> void:
	if not is_patient:
		ended.emit(p_code, p_why)
		return
	close()
	turned_away.emit(p_why)


func _on_waiting(p_position: int, p_for: JoinReply.Wait) -> void:
	status_changed.emit(_STATUS[p_for] % p_position)
	Log.limited("client", "waiting %d" % p_for, _LINES[p_for] % p_position)


func _on_state(p_bytes: PackedByteArray, p_arrival_usec: int) -> void:
	received.emit(p_bytes, p_arrival_usec / 1e6)
