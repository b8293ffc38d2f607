class_name StreamPort
extends RefCounted
## Receives a motion stream in a thread of its own: datagrams of a UDP port, or the bytes of a TCP
## connection, which is made anew whenever it is lost.
##
## What comes goes at once to [code]func(bytes: PackedByteArray, sender: String, usec: int)[/code]
## in that thread: the sender as "ADDRESS:PORT", and when it came, µs of Unix time. Close it before
## it is given up: a running thread keeps it alive.

## Period of polling, µs: times of arrival are as exact as that.
const POLL_USEC: int = 1000
## Period of polling after a second of silence, µs: waiting costs nearly nothing.
const IDLE_USEC: int = 10000
## Greatest number that is read in a second, so that a flood costs only a small part of a core.
const MAX_PER_SECOND: int = 12000
## Room for what comes while the thread has no processor, bytes.
const ROOM: int = 1 << 20
## Nothing is taken from a TCP connection in larger pieces, bytes.
const PIECE: int = 1 << 16
## Time between two attempts to connect, µs.
const AGAIN_USEC: int = 1000000
## Datagrams that wait to be sent; further ones are dropped.
const MAX_OUTGOING: int = 256

var _take: Callable = Callable()
var _udp: PacketPeerUDP = null
var _tcp: StreamPeerTCP = null
var _host: String = ""
var _tcp_port: int = 0
var _again_usec: int = 0
var _thread: Thread = null
var _second: int = 0
var _in_second: int = 0
var _busy_usec: int = 0
# Shared between threads and guarded.
var _mutex: Mutex = Mutex.new()
var _stops: bool = false
var _outgoing: Array[Parcel] = []
var _left_out: int = 0


## A datagram to send.
class Parcel:
	## The bytes.
	var bytes: PackedByteArray = PackedByteArray()
	## IPv4 address of the receiver.
	var address: String = ""
	## UDP port of the receiver.
	var port: int = 0

	func _init(p_bytes: PackedByteArray, p_address: String, p_port: int) -> void:
		bytes = p_bytes
		address = p_address
		port = p_port


## Opens a UDP port; 0 takes any that is free. With a group it joins that multicast group on all
## networks too. Only this machine reaches it at the address 127.0.0.1. Returns why it can't, or an
## empty text.
func open_udp(
	p_port: int, p_take: Callable, p_group: String = "", p_address: String = "0.0.0.0"
) -> String:
	close()
	_udp = PacketPeerUDP.new()
	_udp.set_broadcast_enabled(true)
	var failure: Error = _udp.bind(p_port, p_address, ROOM)
	if failure != OK:
		_udp = null
		if failure == ERR_UNAVAILABLE:
			return "UDP port %d is in use by another program, or not allowed" % p_port
		return "UDP port %d can't be opened: %s" % [p_port, error_string(failure)]
	if p_group != "":
		join_group(_udp, p_group)
	_begin(p_take)
	return ""


## Joins a multicast group on all networks.
static func join_group(p_peer: PacketPeerUDP, p_group: String) -> void:
	for network: Dictionary in IP.get_local_interfaces():
		# Fails where a network has no multicast; others may have.
		p_peer.join_multicast_group(p_group, network["name"])


## Connects to a server's TCP port, now or whenever it is there.
func open_tcp(p_host: String, p_port: int, p_take: Callable) -> void:
	close()
	_host = p_host
	_tcp_port = p_port
	_tcp = StreamPeerTCP.new()
	_again_usec = 0
	_begin(p_take)


## Ends it and waits for the thread.
func close() -> void:
	if _thread != null:
		_mutex.lock()
		_stops = true
		_mutex.unlock()
		_thread.wait_to_finish()
	_thread = null
	if _udp != null:
		_udp.close()
	if _tcp != null:
		_tcp.disconnect_from_host()
	_udp = null
	_tcp = null


## Whether it is open.
func is_open() -> bool:
	return _thread != null


## The UDP port that is open, 0 if none is.
func get_port() -> int:
	return _udp.get_local_port() if _udp != null else 0


## Where it listens, for people.
func describe() -> String:
	if _host != "" and _tcp != null:
		return "TCP %s:%d" % [_host, _tcp_port]
	return "UDP port %d" % get_port()


## Sends a datagram from the open UDP port; any thread may.
func send(p_bytes: PackedByteArray, p_address: String, p_port: int) -> void:
	_mutex.lock()
	if _outgoing.size() < MAX_OUTGOING:
		_outgoing.append(Parcel.new(p_bytes, p_address, p_port))
	_mutex.unlock()


## How many datagrams, or pieces of a TCP stream, a flood left out.
func get_left_out() -> int:
	_mutex.lock()
	var result: int = _left_out
	_mutex.unlock()
	return result


func _begin(p_take: Callable) -> void:
	_take = p_take
	_stops = false
	_left_out = 0
	_outgoing = []
	_thread = Thread.new()
	_thread.start(_run, Thread.PRIORITY_HIGH)


func _run() -> void:
	while true:
		_mutex.lock()
		var stops: bool = _stops
		var outgoing: Array[Parcel] = _outgoing
		_outgoing = []
		_mutex.unlock()
		if stops:
			return
		if _udp != null:
			for parcel: Parcel in outgoing:
				_udp.set_dest_address(parcel.address, parcel.port)
				_udp.put_packet(parcel.bytes)
			_receive()
		else:
			_read_on()
		var is_idle: bool = Time.get_ticks_usec() - _busy_usec > 1000000
		OS.delay_usec(IDLE_USEC if is_idle else POLL_USEC)


func _receive() -> void:
	while _udp.get_available_packet_count() > 0:
		var bytes: PackedByteArray = _udp.get_packet()
		if _udp.get_packet_error() != OK:
			return
		if _is_admitted():
			var sender: String = "%s:%d" % [_udp.get_packet_ip(), _udp.get_packet_port()]
			_take.call(bytes, sender, roundi(Time.get_unix_time_from_system() * 1e6))


func _is_admitted() -> bool:
	@warning_ignore("integer_division")
	var second: int = Time.get_ticks_msec() / 1000
	if second != _second:
		_second = second
		_in_second = 0
	_in_second += 1
	_busy_usec = Time.get_ticks_usec()
	var is_admitted: bool = _in_second <= MAX_PER_SECOND
	if not is_admitted:
		_mutex.lock()
		_left_out += 1
		_mutex.unlock()
	return is_admitted


func _read_on() -> void:
	_tcp.poll()
	var status: StreamPeerTCP.Status = _tcp.get_status()
	if status == StreamPeerTCP.STATUS_CONNECTED:
		var size: int = mini(_tcp.get_available_bytes(), PIECE)
		if size > 0:
			var taken: Array = _tcp.get_partial_data(size)
			if taken[0] == OK and _is_admitted():
				var now: int = roundi(Time.get_unix_time_from_system() * 1e6)
				_take.call(taken[1], "%s:%d" % [_host, _tcp_port], now)
	elif status != StreamPeerTCP.STATUS_CONNECTING and Time.get_ticks_usec() > _again_usec:
		_again_usec = Time.get_ticks_usec() + AGAIN_USEC
		_tcp.disconnect_from_host()
		var address: String = SourceAddress.resolve(_host)
		if address != "":
			_tcp.connect_to_host(address, _tcp_port)
