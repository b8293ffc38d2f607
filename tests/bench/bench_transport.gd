extends Bench
## How long a datagram takes from one client over the server's thread to another, over real sockets,
## beside Godot's own ENetMultiplayerPeer that is polled every frame.
##
## Options: --seconds=5 (each case), --hz=60 (datagrams per second and pairs' sender), --bytes=281,
## --fps=60 (frames of the polled peer), --clients=32 (connections in the case of many), --case=all
## (or threads, client, server, polled, sealing). Goals: p50 of the thread at most 1 ms; an
## idle client's thread at most 0.3 % of a core; a server's at most 2 ms a tick.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const SealingCase: GDScript = preload("res://tests/bench/transport/sealing_case.gd")

const _GOAL_MS: float = 1.0
## Share of a core that a client's thread may take while nothing is sent, %.
const _GOAL_IDLE: float = 0.3
## Values of --case.
const _CASES: Array[String] = ["all", "threads", "client", "server", "polled", "sealing"]
## First byte of the datagrams.
const _KIND: int = 1


## A server's thread that passes each datagram on to everybody else, as the server does with poses.
class Relay:
	var peer: ThreadedPeer = null

	func pass_on(p_bytes: PackedByteArray, _p_arrival_usec: int) -> PackedByteArray:
		# To all: who sent it drops it.
		peer.send_fast(0, p_bytes)
		return PackedByteArray()


func options() -> Dictionary:
	return {
		"seconds": 5.0,
		"hz": [60, 1, 1000],
		"bytes": [281, 16, TransportLimits.new().max_datagram],
		"fps": [60, 1, 1000],
		"clients": [32, 1, 1000],
		"case": ["all", _CASES]
	}


func measure() -> void:
	for seals: bool in [true, false]:
		if _is_wanted("threads"):
			await _run_threaded(seals)
		if _is_wanted("client"):
			await _run_idle(seals)
		if _is_wanted("server"):
			await _run_many(seals)
	if _is_wanted("polled"):
		_run_polled()
	if _is_wanted("sealing"):
		SealingCase.run(report)


func _is_wanted(p_case: String) -> bool:
	return (option("case") as String) in ["all", p_case]


## A to B over the server's thread: the arrival is that of B's thread.
func _run_threaded(p_seals: bool) -> void:
	var port: int = LinkPair.free_port()
	var server: ThreadedPeer = _make_peer(p_seals)
	var relay: Relay = Relay.new()
	relay.peer = server
	server.callbacks.instant_kind = _KIND
	server.callbacks.instant = relay.pass_on
	server.create_server(port, "127.0.0.1")
	var clients: Array[ThreadedPeer] = await _join(server, port, 2)
	var delays: Statistics = Statistics.new()
	var sent: int = 0
	var period: int = 1000000 / (option("hz") as int)
	var due: int = Time.get_ticks_usec()
	var end: int = due + int((option("seconds") as float) * 1e6)
	clients[1].take_fast()
	while Time.get_ticks_usec() < end:
		# Not in step with the threads' milliseconds.
		due += period + randi_range(-900, 900)
		OS.delay_usec(maxi(due - Time.get_ticks_usec(), 0))
		clients[0].send_fast(1, _stamped())
		sent += 1
	OS.delay_msec(50)
	for packet: FastPacket in clients[1].take_fast():
		delays.add((packet.arrival_usec - packet.bytes.decode_u64(1)) / 1000.0)
	_add_delays("threads" + _suffix(p_seals), delays, sent, true)
	_close(server, clients)


## The same over Godot's own peer, which is polled at the beginning of each frame.
func _run_polled() -> void:
	var port: int = LinkPair.free_port()
	var server: ENetMultiplayerPeer = ENetMultiplayerPeer.new()
	server.create_server(port, 8)
	var clients: Array[ENetMultiplayerPeer] = []
	for _client: int in 2:
		var client: ENetMultiplayerPeer = ENetMultiplayerPeer.new()
		client.create_client("127.0.0.1", port)
		clients.append(client)
	for _round: int in 200:
		server.poll()
		clients[0].poll()
		clients[1].poll()
		OS.delay_msec(1)
	var delays: Statistics = Statistics.new()
	var sent: int = 0
	var frame: int = 1000000 / (option("fps") as int)
	var now: int = Time.get_ticks_usec()
	# Each of the three has frames of its own, not in step with each other.
	var due: Array[int] = [now, now + frame / 3, now + frame * 2 / 3]
	var end: int = now + int((option("seconds") as float) * 1e6)
	while now < end:
		var next: int = due.find(due.min())
		OS.delay_usec(maxi(due[next] - Time.get_ticks_usec(), 0))
		now = Time.get_ticks_usec()
		due[next] += frame + randi_range(-500, 500)
		match next:
			0:
				clients[0].poll()
				clients[0].set_target_peer(1)
				clients[0].transfer_mode = MultiplayerPeer.TRANSFER_MODE_UNRELIABLE
				clients[0].put_packet(_stamped())
				sent += 1
			1:
				server.poll()
				while server.get_available_packet_count() > 0:
					var bytes: PackedByteArray = server.get_packet()
					server.set_target_peer(clients[1].get_unique_id())
					server.transfer_mode = MultiplayerPeer.TRANSFER_MODE_UNRELIABLE
					server.put_packet(bytes)
			2:
				clients[1].poll()
				now = Time.get_ticks_usec()
				while clients[1].get_available_packet_count() > 0:
					var bytes: PackedByteArray = clients[1].get_packet()
					delays.add((now - bytes.decode_u64(1)) / 1000.0)
	_add_delays("ENetMultiplayerPeer, polled", delays, sent, false)
	server.close()
	for client: ENetMultiplayerPeer in clients:
		client.close()


## What the thread of a connected client costs that sends nothing and is sent nothing, and of one
## that is sent as many datagrams as a server sends and answers each.
func _run_idle(p_seals: bool) -> void:
	var port: int = LinkPair.free_port()
	var server: ThreadedPeer = _make_peer(p_seals)
	server.create_server(port, "127.0.0.1")
	var clients: Array[ThreadedPeer] = await _join(server, port, 1)
	var idle: float = await _measure_client(server, clients[0], false)
	var active: float = await _measure_client(server, clients[0], true)
	var case: String = "client's thread" + _suffix(p_seals)
	report.at_most(case, "CPU, idle", idle, "%", _GOAL_IDLE)
	report.add(case, "CPU, 60 Hz in, 60 Hz out", active, "%")
	_close(server, clients)


## The share of a core that a client's thread takes, %, as the thread itself counts.
func _measure_client(p_server: ThreadedPeer, p_client: ThreadedPeer, p_active: bool) -> float:
	# Its count is told four times a second.
	OS.delay_msec(600)
	var cpu: int = p_client.stats()["cpu_usec"]
	var begin: int = Time.get_ticks_usec()
	var due: int = begin
	while Time.get_ticks_usec() - begin < int((option("seconds") as float) * 1e6):
		due += 1000000 / 60
		OS.delay_usec(maxi(due - Time.get_ticks_usec(), 0))
		if p_active:
			p_server.send_fast(p_client.get_unique_id(), _stamped())
			p_client.send_fast(1, _stamped())
		p_server.take_fast()
		p_client.take_fast()
	var spent: int = (p_client.stats()["cpu_usec"] as int) - cpu
	await process_frame
	return 100.0 * spent / (Time.get_ticks_usec() - begin)


## What the server's thread costs with many connections: at rest, and with poses in and as many
## datagrams to each out as a server sends.
func _run_many(p_seals: bool) -> void:
	var port: int = LinkPair.free_port()
	var count: int = option("clients")
	var server: ThreadedPeer = _make_peer(p_seals)
	server.create_server(port, "127.0.0.1")
	var clients: Array[ThreadedPeer] = await _join(server, port, count)
	var idle: float = await _measure_server(server, clients, false)
	var active: float = await _measure_server(server, clients, true)
	var case: String = "server's thread, %d clients" % count + _suffix(p_seals)
	report.add(case, "CPU at rest", idle, "ms/s")
	report.add(case, "CPU, %d Hz in, 60 Hz out" % option("hz"), active, "ms/s")
	report.at_most(case, "CPU a tick", active / 60.0, "ms", 2.0)
	_close(server, clients)


## What the server's thread takes, ms of a core per second, as the thread itself counts.
func _measure_server(
	p_server: ThreadedPeer, p_clients: Array[ThreadedPeer], p_active: bool
) -> float:
	OS.delay_msec(300)
	var cpu: int = p_server.stats()["cpu_usec"]
	var begin: int = Time.get_ticks_usec()
	var due: int = begin
	var period: int = 1000000 / (option("hz") as int)
	while Time.get_ticks_usec() - begin < int((option("seconds") as float) * 1e6):
		due += period
		OS.delay_usec(maxi(due - Time.get_ticks_usec(), 0))
		var ids: PackedInt32Array = []
		var datagrams: Array[PackedByteArray] = []
		for client: ThreadedPeer in p_clients:
			if p_active:
				client.send_fast(1, _stamped())
				ids.append(client.get_unique_id())
				datagrams.append(_stamped())
			client.take_fast()
		# As a server hands over its snapshots.
		if p_active:
			p_server.send_fast_each(ids, datagrams)
		p_server.take_fast()
	var spent: int = (p_server.stats()["cpu_usec"] as int) - cpu
	await process_frame
	return spent * 1000.0 / (Time.get_ticks_usec() - begin)


func _join(p_server: ThreadedPeer, p_port: int, p_count: int) -> Array[ThreadedPeer]:
	var clients: Array[ThreadedPeer] = []
	for _client: int in p_count:
		var client: ThreadedPeer = _make_peer(p_server.sealing.seals)
		client.create_client("127.0.0.1", p_port)
		clients.append(client)
	var limit: int = Time.get_ticks_msec() + 5000
	var missing: int = p_count
	while missing > 0 and Time.get_ticks_msec() < limit:
		await process_frame
		p_server.poll()
		missing = 0
		for client: ThreadedPeer in clients:
			client.poll()
			missing += 0 if p_server.has_peer(client.get_unique_id()) else 1
	return clients


func _make_peer(p_seals: bool) -> ThreadedPeer:
	var peer: ThreadedPeer = ThreadedPeer.new()
	peer.sealing.seals = p_seals
	return peer


func _suffix(p_seals: bool) -> String:
	return ", sealed" if p_seals else ""


func _close(p_server: ThreadedPeer, p_clients: Array[ThreadedPeer]) -> void:
	# The server first: its clients need not wait for it then.
	p_server.close()
	for client: ThreadedPeer in p_clients:
		client.close()


func _add_delays(p_case: String, p_delays: Statistics, p_sent: int, p_goal: bool) -> void:
	report.at_most(
		p_case, "A to server to B, p50", p_delays.percentile(0.5), "ms", _GOAL_MS, p_goal
	)
	report.add(p_case, "A to server to B, p95", p_delays.percentile(0.95), "ms")
	report.add(p_case, "A to server to B, p99", p_delays.percentile(0.99), "ms")
	report.add(p_case, "lost", 100.0 * (p_sent - p_delays.count()) / maxi(p_sent, 1), "%")


## A datagram like a pose that carries the time at which it was sent.
func _stamped() -> PackedByteArray:
	var bytes: PackedByteArray = PackedByteArray()
	bytes.resize(option("bytes"))
	bytes.encode_u8(0, _KIND)
	bytes.encode_u64(1, Time.get_ticks_usec())
	return bytes
