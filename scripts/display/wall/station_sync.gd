class_name StationSync
extends RefCounted
## Keeps the displays of a station in step: all show the same moment of the world, from the same
## place of it.
##
## The first client listens at an address; each other one tells it each frame what it would show by
## itself, and is told what all show: datagrams of [StationMessage] from and to that address only,
## which also pass where multicast does not. What has another form, another layout or another sender
## is not heard. Only what is shown is agreed on: the moment at which a panel's refresh begins is
## not, because the engine has no genlock.

## Most datagrams that are read in a frame.
const _MAX_READS: int = 256

var _agreement: StationAgreement = null
var _fingerprint: int = 0
var _socket: PacketPeerUDP = PacketPeerUDP.new()
var _id: int = 0
var _sequence: int = 0
var _host: String = ""
var _port: int = 0
var _refused: int = 0
## Where others are, by their number: address, port, time of the last message.
var _peers: Dictionary[int, Array] = {}
var _shown: float = -1.0
var _mount: Transform3D = Transform3D.IDENTITY
var _eye: Vector3 = Vector3.ZERO
var _right: Vector3 = Vector3.RIGHT


## Takes the fingerprint of the layout, and whether this is the first client.
func _init(p_fingerprint: int, p_leads: bool) -> void:
	_fingerprint = p_fingerprint & 0xFFFFFFFF
	_agreement = StationAgreement.new(p_leads)
	_id = randi()


## Opens the first client's address, or speaks to it. Returns what is wrong, or an empty text.
func open(p_host: String, p_port: int) -> String:
	_host = p_host
	_port = p_port
	var error: Error = OK
	if _agreement.leads:
		error = _socket.bind(p_port, p_host)
	else:
		error = _socket.bind(0, "127.0.0.1" if p_host.begins_with("127.") else "*")
		_socket.set_dest_address(p_host, p_port)
	if error == OK:
		return ""
	var text: String = "the station cannot listen at %s:%d (%s): it is the first client's own"
	return text % [p_host, p_port, error_string(error)] + " address; is another station running?"


## Ends.
func close() -> void:
	_socket.close()


## Whether the first client leads this one.
func follows() -> bool:
	return _agreement.leader_message() != null


## What the first client said last: where the station is, and its viewer's eyes; null: nothing.
func leader_message() -> StationMessage:
	return _agreement.leader_message()


## Says where the station is in the world, and the eyes in the station, m.
func place(p_mount: Transform3D, p_eye: Vector3, p_right: Vector3) -> void:
	_mount = p_mount
	_eye = p_eye
	_right = p_right


## Hears and tells; see [method WallDisplay.agree].
func agree(p_tick: float, p_at_usec: int, p_rate: float) -> float:
	_read()
	var now: int = Time.get_ticks_usec()
	_shown = _agreement.agree(p_tick, p_at_usec, p_rate, now)
	var message: StationMessage = StationMessage.new()
	message.kind = StationMessage.Kind.LEAD if _agreement.leads else StationMessage.Kind.WANT
	message.fingerprint = _fingerprint
	message.sender = _id
	message.sequence = _sequence
	_sequence += 1
	message.sent_usec = now
	message.at_usec = p_at_usec
	message.tick = _shown if _agreement.leads else p_tick
	message.rate = p_rate
	message.mount = _mount
	message.eye = _eye
	message.right = _right
	_send(message.encode(), now)
	return _shown


## Stats.
func report() -> Dictionary:
	return {
		"leads": _agreement.leads,
		"displays": _agreement.count() + 1,
		"shown_tick": _shown,
		"wait_ticks": _agreement.wait,
		"refused": _refused,
	}


func _send(p_bytes: PackedByteArray, p_now_usec: int) -> void:
	if not _agreement.leads:
		_socket.put_packet(p_bytes)
		return
	for peer: int in _peers.keys():
		if p_now_usec - int(_peers[peer][2]) > StationClock.FORGET_USEC:
			_peers.erase(peer)
			continue
		_socket.set_dest_address(_peers[peer][0], _peers[peer][1])
		_socket.put_packet(p_bytes)


func _read() -> void:
	for _packet: int in _MAX_READS:
		if _socket.get_available_packet_count() == 0:
			return
		var bytes: PackedByteArray = _socket.get_packet()
		var now: int = Time.get_ticks_usec()
		var from: String = _socket.get_packet_ip()
		var port: int = _socket.get_packet_port()
		var message: StationMessage = StationMessage.decode(bytes)
		if message == null or message.fingerprint != _fingerprint or message.sender == _id:
			_refused += 1
		elif not _agreement.leads and (from != _host or port != _port):
			_refused += 1
		elif _agreement.leads and not _may_speak(message.sender, from, port):
			_refused += 1
		else:
			_peers[message.sender] = [from, port, now]
			_agreement.take(message, now)


## A number stays with the address that it came from first; there are so many at most.
func _may_speak(p_sender: int, p_from: String, p_port: int) -> bool:
	if _peers.has(p_sender):
		return _peers[p_sender][0] == p_from and _peers[p_sender][1] == p_port
	return _peers.size() < WallLayout.MAX_SCREENS
