class_name TransportThread
extends TransportHost
## An ENet host that is served by a thread of its own, or by [method serve].
##
## The thread waits for its socket and for the others, by a [TransportPump]: what arrives is taken
## in at once, and what others want sent leaves at once. It never touches anything of the main
## thread's, but hands it events and fast datagrams by a [TransportMailbox]. Set the public members
## before [method start_server] or [method start_client].

## Slots of ENet for connections in the making (1024, see [SealedSocket]) and for those that have
## not been admitted ([constant TransportHost.MAX_ARRIVING]).
const ARRIVING_SLOTS: int = 1024 + MAX_ARRIVING
## Maximum of ENet connections.
const MAX_SLOTS: int = 4095
## Where ENet is: nobody but the socket can reach it there.
const INNER_ADDRESS: String = "127.0.0.1"

## Maximum of bytes that wait for the main thread: a client whose main thread stalls longer is lost.
const _MAX_WAITING_BYTES: int = 32 << 20
const _HOUSEKEEPING_USEC: int = 100000
## Period of housekeeping on a client, which has one connection to look after, µs.
const _CLIENT_HOUSEKEEPING_USEC: int = 250000
## Errors in a row after which the host counts as dead.
const _MAX_ERRORS: int = 20
const _LINGER_MS: int = 300
## With more events than so many in [constant _HOUSEKEEPING_USEC] the thread takes pauses and then
## takes in all that has come meanwhile, see [method TransportPump.pause].
const _BUSY_EVENTS: int = 60

## Whether a client has a thread. Without one nothing moves but by [method serve]: for programs with
## more clients than a machine can keep threads awake for.
var has_thread: bool = true
## The queues between the thread and all others.
var mailbox: TransportMailbox = TransportMailbox.new()

var _host: ENetConnection = null
var _thread: Thread = Thread.new()
var _serving: bool = false
var _served_usec: int = 0
var _pump: TransportPump = TransportPump.new()
var _id: int = 0
var _taken: int = 0
var _errors_in_a_row: int = 0
var _began: bool = false
var _excuse: String = ""
var _housekept_usec: int = 0
var _housekeeping_usec: int = _CLIENT_HOUSEKEEPING_USEC
var _recent_events: int = 0
var _busy: bool = false
var _narrow: int = 0
var _beacons: int = 0
var _beacon_usec: int = 0
var _reason: int = 0


## Opens a port. Without a guard there is no limit to what is let through.
func start_server(p_port: int, p_address: String = "*") -> Error:
	_server = true
	_housekeeping_usec = _HOUSEKEEPING_USEC
	_address = p_address
	_port = p_port
	var error: Error = _open()
	return error if error != OK else _thread.start(_run)


## Begins to connect to a server under an id.
func start_client(p_host: String, p_port: int, p_id: int) -> Error:
	_address = p_host
	_port = p_port
	_id = p_id
	var error: Error = _open()
	if error != OK:
		return error
	if has_thread:
		return _thread.start(_run)
	_begin()
	return OK


## Whether the host is served: its thread works, or [method serve] does.
func is_running() -> bool:
	return _serving if not has_thread else _thread.is_started() and _thread.is_alive()


## Without a thread: takes in what has arrived, and sends what is to be sent.
func serve() -> void:
	if _serving:
		_turn(false)
		if _closing:
			_end(0)


## Sends everybody the reason, ends the thread and closes the port. Takes 0.3 s at most, and no
## time without a thread.
func stop(p_reason: int) -> void:
	if _serving:
		_order_close(p_reason)
		_end(0)
	elif _thread.is_started():
		_post([_order_close, [p_reason]], true)
		_thread.wait_to_finish()
	_host = null


## Sends a packet through ENet to one (an id), to all (0), or to all except one (minus its id).
func send(p_target: int, p_channel: int, p_bytes: PackedByteArray, p_flags: int) -> bool:
	var must: bool = p_flags & ENetPacketPeer.FLAG_RELIABLE != 0
	return _post([_order_send, [p_target, p_channel, p_bytes, p_flags]], must)


## Sends a fast datagram to one (an id), to all (0), or to all except one (minus its id).
func send_fast(p_target: int, p_bytes: PackedByteArray) -> bool:
	return _post([_order_send_fast, [p_target, p_bytes]], false)


## Sends fast datagrams, each to the peer of the same index.
func send_fast_each(p_peers: PackedInt32Array, p_datagrams: Array[PackedByteArray]) -> bool:
	return _post([_order_send_each, [p_peers, p_datagrams]], false)


## Ends a connection: at once and silently, or after what is still to be sent.
func disconnect_peer(p_id: int, p_now: bool, p_code: int) -> void:
	_post([_order_disconnect, [p_id, p_now, p_code]], true)


## Says that a client is welcome: the guard then lets it complete.
func welcome(p_id: int) -> void:
	_post([_order_welcome, [p_id]], true)


## Keeps a client that has not been admitted yet, because somebody is to decide about it.
func keep(p_id: int) -> void:
	_post([_order_keep, [p_id]], true)


## Asks other passwords, by role, of those who come from now on.
func set_passwords(p_of_roles: PackedStringArray) -> void:
	_post([_order_passwords, [p_of_roles]], true)


## Tells clients that look for servers this, from now on; see [member announcement].
func announce(p_bytes: PackedByteArray) -> void:
	_post([_order_announcement, [p_bytes]], true)


func _post(p_order: Array, p_must: bool) -> bool:
	var room: bool = mailbox.post(p_order, p_must)
	_pump.wake()
	return room


func _open() -> Error:
	_socket = SealedSocket.new()
	sealing.set_up(_socket)
	var clients: int = guard.limits.max_clients if guard != null else TransportLimits.MIN_CLIENTS
	var slots: int = mini(ARRIVING_SLOTS + clients, MAX_SLOTS) if _server else 1
	if _server:
		_socket.set_announcement(announcement)
		_socket.set_limits(guard.limits.max_packet if guard != null else 0, CHANNELS, slots)
		var opened: Error = _socket.open_server(_address, _port)
		if opened != OK:
			return opened
	_host = ENetConnection.new()
	# Bound at once: by its port the socket finds it.
	var error: Error = _host.create_host_bound(INNER_ADDRESS, 0, slots, CHANNELS)
	if error == OK:
		error = _socket.tie(_host)
	if error == OK and _server:
		_pump.attach(_host, _socket)
	return error


func _run() -> void:
	_begin()
	while not _closing:
		_turn(true)
		if _busy:
			_pump.pause()
	_end(_LINGER_MS)


func _begin() -> void:
	_serving = not has_thread
	if not _server:
		_begin_client()
	_served_usec = Time.get_ticks_usec()


## Takes orders, serves the host, after waiting for something to do if it may, and hands over what
## has happened.
func _turn(p_waits: bool) -> void:
	for order: Array in mailbox.take_orders():
		(order[0] as Callable).callv(order[1])
	_serve(p_waits)
	var now: int = Time.get_ticks_usec()
	if not _server:
		_look_after_client(now, now - _served_usec)
	_served_usec = now
	if now - _housekept_usec > _housekeeping_usec:
		_housekept_usec = now
		_note_path()
		_busy = _recent_events > _BUSY_EVENTS
		_recent_events = 0
		_pump.set_busy(_busy)
		_keep_house(now)
		_publish_stats()
	if not _events.is_empty() or not _fast.is_empty():
		mailbox.hand_over(_events, _fast)
		_events.clear()
		_fast.clear()


func _publish_stats() -> void:
	var stats: Dictionary = {"peers": _peers, "cpu_usec": ThreadClock.get_usec()}
	stats.merge(_counts)
	stats.merge(_socket.stats())
	if not _server:
		stats["excuse"] = _excuse
	mailbox.publish(stats)


func _end(p_linger_ms: int) -> void:
	_serving = false
	mailbox.hand_over(_events, _fast)
	_disconnect_everybody(p_linger_ms)
	_pump.send_out()
	_pump.detach()
	_host.destroy()
	_socket.close()


## Nothing waits any more when the main thread has taken what there was.
func _note_taken(p_taken: int) -> void:
	if p_taken != _taken:
		_taken = p_taken
		_waiting_bytes = 0
		for id: int in _connections:
			_connections[id].waiting = 0


## Looks the server's name up, if it is no address, and begins the handshake.
func _begin_client() -> void:
	var opened: Error = _socket.open_client(_address, _port)
	for kind: IP.Type in [IP.TYPE_IPV4, IP.TYPE_IPV6]:
		if opened == ERR_CANT_RESOLVE:
			opened = _socket.open_client(IP.resolve_hostname(_address, kind), _port)
	if opened != OK:
		_fail("%s:%d is no address that can be connected to" % [_address, _port])
		return
	_pump.attach(_host, _socket)


## ENet begins when the handshake is done; the server may refuse it in either.
func _go_on_connecting() -> void:
	match _socket.get_state():
		SealedSocket.STATE_FAILED:
			_fail(sealing.explain(_socket), true)
			if _socket.get_notice() == SealedSocket.NOTICE_OTHER_KEY:
				_events[-1].server_key = _socket.get_server_key()
		SealedSocket.STATE_OPEN:
			if not _began:
				_began = true
				var port: int = _socket.get_inner_port()
				_set_up(_host.connect_to_host(INNER_ADDRESS, port, CHANNELS, _id))
		_:
			# Shown if it does not come any further.
			_excuse = sealing.explain(_socket)


func _serve(p_waits: bool) -> void:
	var due: int = _housekept_usec + _housekeeping_usec
	if callbacks.beacon.is_valid() and not _connections.is_empty():
		due = mini(due, _beacon_usec)
	var waits: bool = p_waits and not _busy
	var wait_usec: int = maxi(due - Time.get_ticks_usec(), 0) if waits else 0
	var first: bool = true
	while true:
		var event: Array = _pump.serve(first, wait_usec)
		if first:
			_note_taken(mailbox.taken())
			first = false
		_recent_events += _receive_all_fast(_socket.take_fast(Time.get_ticks_usec()))
		match event[0]:
			ENetConnection.EVENT_CONNECT:
				_on_connect(event[1], event[2])
			ENetConnection.EVENT_DISCONNECT:
				_on_disconnect(event[1], event[2])
			ENetConnection.EVENT_RECEIVE:
				_on_receive(event[1], event[3])
			ENetConnection.EVENT_ERROR:
				_take_error()
				return
			_:
				_errors_in_a_row = 0
				break
		_recent_events += 1
	_pump.send_out()


## A network that carries only small datagrams works, but costs more: the user may know one that is
## wider.
func _note_path() -> void:
	var most: int = _socket.get_max_datagram()
	if most > 0 and most < SealedSocket.WIDE_DATAGRAM and most != _narrow:
		_trouble(
			"path",
			(
				(
					"the network carries no datagrams of more than about %d bytes (a VPN or tunnel?):"
					+ " all is sent in smaller ones, which takes more of it"
				)
				% most
			)
		)
	_narrow = most


## The socket lets nothing through that makes an error: a host that makes them is broken.
func _take_error() -> void:
	_count("errors")
	_errors_in_a_row += 1
	if _errors_in_a_row > _MAX_ERRORS:
		_errors_in_a_row = 0
		_reopen()


func _reopen() -> void:
	for id: int in _connections.keys():
		_drop(_connections[id], DisconnectReason.LOST)
	_pump.detach()
	_host.destroy()
	_socket.close()
	if not _server:
		_fail("a network error ended the connection")
		return
	var error: Error = _open()
	if error == OK:
		_note(TransportEvent.Kind.REOPENED, 0, "reopened", "a network error closed the port")
	else:
		_trouble("closed", "the port cannot be opened again: %s" % error_string(error))


func _look_after_client(p_now_usec: int, p_gap_usec: int) -> void:
	if _connections.is_empty():
		if not _closing:
			_go_on_connecting()
		return
	if p_gap_usec > SILENT_MS * 1000:
		# The server has given us up; waiting until we notice it would take as long again.
		_fail("this machine stood still for %.1f s" % (p_gap_usec / 1e6))
	elif _socket.get_silent_usec() > SILENT_MS * 1000:
		_fail("nothing has come from the server for %.1f s" % (SILENT_MS / 1e3))
	elif _waiting_bytes > _MAX_WAITING_BYTES:
		_fail("%d bytes wait to be taken in" % _waiting_bytes)
	elif callbacks.beacon.is_valid() and p_now_usec >= _beacon_usec:
		_beacons += 1
		_beacon_usec = p_now_usec + (callbacks.beacon_period.call(_beacons) as int)
		_socket.send_fast(MultiplayerPeer.TARGET_PEER_SERVER, callbacks.beacon.call())


func _order_send(p_target: int, p_channel: int, p_bytes: PackedByteArray, p_flags: int) -> void:
	if p_target > 0:
		if _connections.has(p_target):
			_send(_connections[p_target], p_channel, p_bytes, p_flags)
		return
	for id: int in _connections:
		if id != -p_target:
			_send(_connections[id], p_channel, p_bytes, p_flags)


func _order_send_each(p_peers: PackedInt32Array, p_datagrams: Array[PackedByteArray]) -> void:
	_pump.note_handed_over()
	_socket.send_fast_each(p_peers, p_datagrams)


func _order_send_fast(p_target: int, p_bytes: PackedByteArray) -> void:
	if p_target > 0:
		_socket.send_fast(p_target, p_bytes)
		return
	for id: int in _connections:
		if id != -p_target:
			_socket.send_fast(id, p_bytes)


func _order_disconnect(p_id: int, p_now: bool, p_code: int) -> void:
	var connection: TransportConnection = _connections.get(p_id)
	if connection == null:
		return
	if p_now:
		_connections.erase(p_id)
		connection.remote.peer_disconnect(p_code)
	elif connection.stage != TransportConnection.Stage.LEAVING:
		connection.stage = TransportConnection.Stage.LEAVING
		connection.leaving_usec = Time.get_ticks_usec()
		connection.remote.peer_disconnect_later(p_code)


func _order_welcome(p_id: int) -> void:
	var connection: TransportConnection = _connections.get(p_id)
	if connection != null and connection.stage == TransportConnection.Stage.ARRIVING:
		connection.stage = TransportConnection.Stage.WELCOMED


func _order_keep(p_id: int) -> void:
	if _connections.has(p_id):
		_connections[p_id].kept = true


func _order_close(p_reason: int) -> void:
	_reason = p_reason
	_closing = true


func _disconnect_everybody(p_linger_ms: int) -> void:
	for id: int in _connections:
		if _connections[id].remote.is_active():
			_connections[id].remote.peer_disconnect_later(_reason)
	var limit: int = Time.get_ticks_msec() + p_linger_ms
	while not _connections.is_empty():
		# At least once, so that it leaves.
		var event: Array = _pump.serve(true, 5000 if p_linger_ms > 0 else 0)
		if event[0] == ENetConnection.EVENT_DISCONNECT:
			_connections.erase((event[1] as ENetPacketPeer).get_meta(&"id", 0))
		elif event[0] == ENetConnection.EVENT_RECEIVE:
			(event[1] as ENetPacketPeer).get_packet()
		_socket.take_fast(0)
		_pump.send_out()
		if event[0] == ENetConnection.EVENT_ERROR or Time.get_ticks_msec() >= limit:
			return
