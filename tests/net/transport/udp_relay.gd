extends RefCounted
## Stands between one client and a server, in a thread, and repeats, delays and swaps datagrams.

## Where clients send to.
var port: int = 0
## Every datagram goes through so often.
var copies: int = 1
## Chance that a datagram is held back behind later ones.
var hold: float = 0.0
## Chance that a datagram is damaged.
var damage: float = 0.0
## How long each datagram takes, µs.
var delay_usec: int = 0
## Keeps datagrams of long ago and sends them again.
var replays: bool = false
## Datagrams that were sent on.
var passed: int = 0

var _front: PacketPeerUDP = PacketPeerUDP.new()
var _back: PacketPeerUDP = PacketPeerUDP.new()
var _thread: Thread = Thread.new()
var _stop: bool = false
var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _client_known: bool = false
var _held: Array[Array] = []
var _late: Array[Array] = []
var _old: Array[Array] = []


## Begins to pass datagrams on.
func start(p_server_port: int) -> void:
	_random.seed = 21
	_front.bind(0, "127.0.0.1")
	port = _front.get_local_port()
	_back.connect_to_host("127.0.0.1", p_server_port)
	_thread.start(_run)


## Ends.
func stop() -> void:
	_stop = true
	_thread.wait_to_finish()


func _run() -> void:
	while not _stop:
		while _front.get_available_packet_count() > 0:
			var bytes: PackedByteArray = _front.get_packet()
			_front.set_dest_address(_front.get_packet_ip(), _front.get_packet_port())
			_client_known = true
			_pass(_back, bytes)
		while _client_known and _back.get_available_packet_count() > 0:
			_pass(_front, _back.get_packet())
		if not _held.is_empty() and _random.randf() < 0.3:
			_send(_held.pop_at(_random.randi_range(0, _held.size() - 1)))
		if replays and not _old.is_empty():
			_send(_old[_random.randi_range(0, _old.size() - 1)])
		while not _late.is_empty() and Time.get_ticks_usec() >= (_late[0][2] as int):
			_put(_late.pop_front())
		OS.delay_usec(500)


func _pass(p_to: PacketPeerUDP, p_bytes: PackedByteArray) -> void:
	var item: Array = [p_to, p_bytes]
	if _random.randf() < hold:
		_held.append(item)
		return
	for _copy: int in copies:
		_send(item)
	if damage > 0.0 and _random.randf() < damage and not p_bytes.is_empty():
		var bad: PackedByteArray = p_bytes.duplicate()
		bad[_random.randi_range(0, bad.size() - 1)] ^= 1 << _random.randi_range(0, 7)
		_send([p_to, bad])
	if replays and _old.size() < 500:
		_old.append(item)


func _send(p_item: Array) -> void:
	if delay_usec > 0:
		_late.append([p_item[0], p_item[1], Time.get_ticks_usec() + delay_usec])
	else:
		_put(p_item)


func _put(p_item: Array) -> void:
	passed += 1
	(p_item[0] as PacketPeerUDP).put_packet(p_item[1])
