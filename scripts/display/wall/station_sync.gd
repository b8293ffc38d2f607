class_name StationSync
extends RefCounted
## Keeps the displays of a station in step: all show the same moment of the world, from the same
## place of it.
##
## The first client listens at an address; each other client sends it every frame what it would show
## by itself, and receives what all show: datagrams of [StationMessage] from and to that address
## only, which also pass where multicast does not. What has another form, another layout or another
## sender is not heard. Only what is shown is agreed on: the moment at which a panel's refresh
## begins is not, because the engine has no genlock.

## Most datagrams that wait for a frame.
const _MAX_WAITING: int = 256
## How often the socket is looked at, µs. A frame would be too seldom: displays whose frames keep
## step would find one another late by always the same part of a frame.
const _LOOK_USEC: int = 1_000

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
var _ear: Thread = Thread.new()
var _mutex: Mutex = Mutex.new()
var _is_open: bool = false
## What was heard since the last frame: bytes, address, port, time of arrival (µs) in turn.
var _heard: Array = []
# What is agreed on for this frame, until it has been sent; null: nothing.
var _message: StationMessage = null


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
		_is_open = true
		_ear.start(_listen)
		return ""
	var text: String = "the station cannot listen at %s:%d (%s): it is the first client's own"
	return text % [p_host, p_port, error_string(error)] + " address; is another station running?"


## Ends.
func close() -> void:
	_mutex.lock()
	_is_open = false
	_mutex.unlock()
	if _ear.is_started():
		_ear.wait_to_finish()
	_socket.close()


## Whether the first client leads this one.
func follows() -> bool:
	return _agreement.leader_message() != null


## Where the first client has the station, and its viewer's eyes, at the tick that is shown here;
## null: nothing is known.
func leader_place() -> StationMessage:
	return _agreement.track.at(_shown)


## Hears the others; see [method WallDisplay.agree]. [method tell] answers them.
func agree(p_tick: float, p_at_usec: int, p_rate: float) -> float:
	_read()
	_shown = _agreement.agree(p_tick, p_at_usec, p_rate, Time.get_ticks_usec())
	var message: StationMessage = StationMessage.new()
	message.kind = StationMessage.Kind.LEAD if _agreement.leads else StationMessage.Kind.WANT
	message.fingerprint = _fingerprint
	message.sender = _id
	message.sequence = _sequence
	_sequence += 1
	message.at_usec = p_at_usec
	message.tick = _shown if _agreement.leads else p_tick
	message.rate = p_rate
	_message = message
	return _shown


## Tells the others what has been agreed on for this frame, and where the station is in the world
## and the eyes in the station, m, at that tick. Call it when everything is in its place.
func tell(p_mount: Transform3D, p_eye: Vector3, p_right: Vector3) -> void:
	if _message == null:
		return
	var now: int = Time.get_ticks_usec()
	_message.sent_usec = now
	_message.mount = p_mount
	_message.eye = p_eye
	_message.right = p_right
	_send(_message.encode(), now)
	_message = null


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
	_mutex.lock()
	var heard: Array = _heard
	_heard = []
	_mutex.unlock()
	for at: int in range(0, heard.size(), 4):
		_take(heard[at], heard[at + 1], heard[at + 2], heard[at + 3])


func _take(p_bytes: PackedByteArray, p_from: String, p_port: int, p_arrival_usec: int) -> void:
	var message: StationMessage = StationMessage.decode(p_bytes)
	if message == null or message.fingerprint != _fingerprint or message.sender == _id:
		_refused += 1
	elif not _agreement.leads and (p_from != _host or p_port != _port):
		_refused += 1
	elif _agreement.leads and not _may_speak(message.sender, p_from, p_port):
		_refused += 1
	else:
		_peers[message.sender] = [p_from, p_port, p_arrival_usec]
		_agreement.take(message, p_arrival_usec)


## A thread's own: only it reads the socket.
func _listen() -> void:
	while true:
		_mutex.lock()
		var goes_on: bool = _is_open
		_mutex.unlock()
		if not goes_on:
			return
		while _socket.get_available_packet_count() > 0:
			var bytes: PackedByteArray = _socket.get_packet()
			var from: Array = [_socket.get_packet_ip(), _socket.get_packet_port()]
			_mutex.lock()
			if _heard.size() < 4 * _MAX_WAITING:
				_heard.append_array([bytes, from[0], from[1], Time.get_ticks_usec()])
			_mutex.unlock()
		OS.delay_usec(_LOOK_USEC)


## A number stays with the address that it came from first; there are so many at most.
func _may_speak(p_sender: int, p_from: String, p_port: int) -> bool:
	if _peers.has(p_sender):
		return _peers[p_sender][0] == p_from and _peers[p_sender][1] == p_port
	return _peers.size() < WallLayout.MAX_SCREENS
