class_name TransportThread
extends TransportHost
## An ENet host that is served by a thread of its own.
##
## The thread waits for its socket and for the others, by a [TransportPump]: what arrives is taken
## in at once, and what others want sent leaves at once. It never touches anything of the main
## thread's, but hands it events and fast datagrams by a [TransportMailbox]. Set the public members
## before [method start_server] or [method start_client].

## Maximum of ENet connections. Half-open ones can be neither seen nor ended from here, and occupy a
## slot for half a minute: hence as many slots as ENet allows.
const SLOTS: int = 4095

## Events in a row before what came is handed over.
const _MAX_EVENTS: int = 128
## Maximum of bytes that wait for the main thread: a client whose main thread stalls longer is lost.
const _MAX_WAITING_BYTES: int = 32 << 20
const _HOUSEKEEPING_USEC: int = 100000
## The same on a client, which has one connection to look after, µs.
const _CLIENT_HOUSEKEEPING_USEC: int = 250000
## After this time with errors only the host counts as dead, µs.
const _DEAD_USEC: int = 500000
const _LINGER_MS: int = 300
## Wait where the socket cannot be watched, as with DTLS, ms: what others want sent waits as long.
const _BLIND_WAIT_MS: int = 1
## With more events than so many in [constant _HOUSEKEEPING_USEC] the thread takes pauses and then
## takes in all that has come meanwhile, see [method TransportPump.pause].
const _BUSY_EVENTS: int = 60

## On a client: makes what is sent to the server again and again, in the thread:
## [code]func() -> PackedByteArray[/code].
var beacon: Callable = Callable()
## When [member beacon] is due again, from how often it was: [code]func(count: int) -> int[/code],
## µs.
var beacon_period: Callable = Callable()
## DTLS, or null.
var tls: TLSOptions = null

## What the thread and the others hand each other.
var mailbox: TransportMailbox = TransportMailbox.new()

var _thread: Thread = Thread.new()
var _pump: TransportPump = TransportPump.new()
var _id: int = 0
var _taken: int = 0
var _errors_since_usec: int = 0
var _housekept_usec: int = 0
var _housekeeping_usec: int = _CLIENT_HOUSEKEEPING_USEC
var _recent_events: int = 0
var _busy: bool = false
var _left: int = 0
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
	return error if error != OK else _thread.start(_run)


## Whether the thread works.
func is_running() -> bool:
	return _thread.is_started() and _thread.is_alive()


## Sends everybody the reason, ends the thread and closes the port. Takes 0.3 s at most.
func stop(p_reason: int) -> void:
	if not _thread.is_started():
		return
	_post([_order_close, [p_reason]], true)
	_thread.wait_to_finish()
	_host = null


## Sends something to one (an id), to all (0), or to all except one (minus its id).
func send(p_target: int, p_channel: int, p_bytes: PackedByteArray, p_flags: int) -> bool:
	var must: bool = p_flags & ENetPacketPeer.FLAG_RELIABLE != 0
	return _post([_order_send, [p_target, p_channel, p_bytes, p_flags]], must)


## Sends fast datagrams, each to the peer of the same index.
func send_fast_each(p_peers: PackedInt32Array, p_datagrams: Array[PackedByteArray]) -> bool:
	return _post([_order_send_each, [p_peers, p_datagrams]], false)


## Ends a connection: at once and silently, or after what is still to be sent.
func disconnect_peer(p_id: int, p_now: bool, p_code: int) -> void:
	_post([_order_disconnect, [p_id, p_now, p_code]], true)


## Says that a client is welcome, and whether it may call; the guard then lets it complete.
func welcome(p_id: int, p_may_call: bool) -> void:
	_post([_order_welcome, [p_id, p_may_call]], true)


## Keeps a client that has not been admitted yet, because somebody is to decide about it.
func keep(p_id: int) -> void:
	_post([_order_keep, [p_id]], true)


func _post(p_order: Array, p_must: bool) -> bool:
	var room: bool = mailbox.post(p_order, p_must)
	_pump.wake()
	return room


func _open() -> Error:
	_host = ENetConnection.new()
	var error: Error = OK
	if _server:
		error = _host.create_host_bound(_address, _port, SLOTS, CHANNELS)
	elif tls != null:
		error = _host.create_host(1, CHANNELS)
	else:
		# Bound at once: by its port the pump finds the socket.
		error = _host.create_host_bound("*", 0, 1, CHANNELS)
	if error == OK and tls != null:
		if _server:
			error = _host.dtls_server_setup(tls)
		else:
			error = _host.dtls_client_setup(_address, tls)
	if error == OK:
		_pump.attach(_host, tls == null)
	return error


func _run() -> void:
	if not _server:
		_begin_client()
	var before: int = Time.get_ticks_usec()
	while not _closing:
		for order: Array in mailbox.take_orders():
			(order[0] as Callable).callv(order[1])
		_serve()
		var now: int = Time.get_ticks_usec()
		if not _server:
			_look_after_client(now, now - before)
		before = now
		if now - _housekept_usec > _housekeeping_usec:
			_housekept_usec = now
			_busy = _recent_events > _BUSY_EVENTS
			_recent_events = 0
			_keep_house(now)
			var stats: Dictionary = {"peers": _describe_peers(), "cpu_usec": ThreadClock.get_usec()}
			stats.merge(_counts)
			mailbox.publish(stats)
		mailbox.hand_over(_events, _fast)
		_events.clear()
		_fast.clear()
		if _busy:
			_pump.pause()
	mailbox.hand_over(_events, _fast)
	_disconnect_everybody()
	_pump.detach()
	_host.destroy()


## Nothing waits any more when the main thread has taken what there was.
func _note_taken(p_taken: int) -> void:
	if p_taken != _taken:
		_taken = p_taken
		_waiting_bytes = 0
		for id: int in _connections:
			_connections[id].waiting = 0


func _begin_client() -> void:
	var remote: ENetPacketPeer = _host.connect_to_host(_address, _port, CHANNELS, _id)
	if remote == null:
		_fail("%s:%d is no address that can be connected to" % [_address, _port])
	else:
		_set_up(remote)


func _serve() -> void:
	var due: int = _housekept_usec + _housekeeping_usec
	if beacon.is_valid() and not _connections.is_empty():
		due = mini(due, _beacon_usec)
	var wait_usec: int = maxi(due - Time.get_ticks_usec(), 0)
	_left = _MAX_EVENTS
	_answered = false
	for number: int in _MAX_EVENTS:
		# Every packet that an event announces must be taken, or the next event would get it.
		var event: Array = _pump.serve(number == 0 and not _busy, wait_usec, _BLIND_WAIT_MS)
		if number == 0:
			_note_taken(mailbox.taken())
		if number == 0 and _busy:
			_expect()
		match event[0]:
			ENetConnection.EVENT_CONNECT:
				_on_connect(event[1], event[2])
			ENetConnection.EVENT_DISCONNECT:
				_on_disconnect(event[1], event[2])
			ENetConnection.EVENT_RECEIVE:
				_on_receive(event[1], event[3])
			ENetConnection.EVENT_ERROR:
				if not _survives_error():
					return
			_:
				_errors_since_usec = 0
				return
		_recent_events += 1
		_left -= 1
		if event[0] != ENetConnection.EVENT_ERROR:
			_errors_since_usec = 0
			if _left <= 0:
				break
	if _answered:
		_host.flush()


## To find that nothing is left takes ENet as long as the rest, as it looks at all its slots: so
## a busy thread asks for no more events than datagrams have come. What is left nevertheless comes
## with the next turn.
func _expect() -> void:
	var came: int = int(_host.pop_statistic(ENetConnection.HOST_TOTAL_RECEIVED_PACKETS))
	_count("received_packets", came)
	if came > 0:
		_left = mini(came, _MAX_EVENTS)


## A datagram from port 0 makes a few errors, as no answer can be sent there; the host is none the
## worse for it. Errors that do not end are another matter.
func _survives_error() -> bool:
	var now: int = Time.get_ticks_usec()
	_count("errors")
	if _errors_since_usec == 0:
		_errors_since_usec = now
	if now - _errors_since_usec < _DEAD_USEC / 5:
		return true
	OS.delay_usec(20000)
	if now - _errors_since_usec > _DEAD_USEC:
		_errors_since_usec = 0
		_reopen()
	return false


func _reopen() -> void:
	for id: int in _connections.keys():
		_drop(_connections[id], DisconnectReason.LOST)
	_pump.detach()
	_host.destroy()
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
		return
	if p_gap_usec > TIMEOUTS_MS[1] * 1000:
		# The server has given us up; waiting until we notice it would take as long again.
		_fail("this machine stood still for %.1f s" % (p_gap_usec / 1e6))
	elif _waiting_bytes > _MAX_WAITING_BYTES:
		_fail("%d bytes wait to be taken in" % _waiting_bytes)
	elif beacon.is_valid() and p_now_usec >= _beacon_usec:
		_beacons += 1
		_beacon_usec = p_now_usec + (beacon_period.call(_beacons) as int)
		_connections.values()[0].remote.send(FAST_CHANNEL, beacon.call(), _FAST_FLAGS)


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
	for i: int in p_peers.size():
		var connection: TransportConnection = _connections.get(p_peers[i])
		# Who has died is still here, but takes nothing: send() would report an error.
		if connection != null and connection.remote.is_active():
			if connection.stage != TransportConnection.Stage.LEAVING:
				connection.remote.send(FAST_CHANNEL, p_datagrams[i], _FAST_FLAGS)


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


func _order_welcome(p_id: int, p_may_call: bool) -> void:
	var connection: TransportConnection = _connections.get(p_id)
	if connection != null and connection.stage == TransportConnection.Stage.ARRIVING:
		connection.stage = TransportConnection.Stage.WELCOMED
		connection.may_call = p_may_call


func _order_keep(p_id: int) -> void:
	if _connections.has(p_id):
		_connections[p_id].kept = true


func _order_close(p_reason: int) -> void:
	_reason = p_reason
	_closing = true


func _disconnect_everybody() -> void:
	for id: int in _connections:
		if _connections[id].remote.is_active():
			_connections[id].remote.peer_disconnect_later(_reason)
	var limit: int = Time.get_ticks_msec() + _LINGER_MS
	while not _connections.is_empty() and Time.get_ticks_msec() < limit:
		var event: Array = _host.service(5)
		if event[0] == ENetConnection.EVENT_DISCONNECT:
			_connections.erase((event[1] as ENetPacketPeer).get_meta(&"id", 0))
		elif event[0] == ENetConnection.EVENT_RECEIVE:
			(event[1] as ENetPacketPeer).get_packet()
		elif event[0] == ENetConnection.EVENT_ERROR:
			return
