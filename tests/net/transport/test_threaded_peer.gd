extends TestCase
## Godot's multiplayer API over the threaded peer: authentication, calls, spawner, channels,
## targets, and the fast path beside it.

const Caller: GDScript = preload("caller.gd")
const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")

var _server: ThreadedPeer = null
var _clients: Array[ThreadedPeer] = []
var _port: int = 0
var _apis: Array[SceneMultiplayer] = []
var _roots: Array[Node] = []


func before_each() -> void:
	var probe: PacketPeerUDP = PacketPeerUDP.new()
	probe.bind(0, "127.0.0.1")
	_port = probe.get_local_port()
	probe.close()
	_server = ThreadedPeer.new()
	equal(_server.create_server(_port, "127.0.0.1"), OK)


func after_each() -> void:
	for api: SceneMultiplayer in _apis:
		# What the test has connected holds the API.
		api.auth_callback = Callable()
		for link: Dictionary in api.peer_authenticating.get_connections():
			api.peer_authenticating.disconnect(link["callable"])
		api.multiplayer_peer = null
	for client: ThreadedPeer in _clients:
		client.close()
	_server.close()


func test_calls_go_both_ways() -> void:
	var callers: Array[Caller] = await _make_callers(2)
	callers[1].ask.rpc_id(1, "hello")
	await _until(func() -> bool: return callers[1].heard.size() == 1)
	equal(callers[1].heard, ["hello back"] as Array[String])
	equal(callers[2].heard, [] as Array[String])
	callers[0].tell.rpc("all")
	await _until(func() -> bool: return callers[1].heard.size() + callers[2].heard.size() == 3)
	equal(callers[2].heard, ["all"] as Array[String])


func test_every_mode_and_channel_arrives() -> void:
	var callers: Array[Caller] = await _make_callers(1)
	callers[0].tell_unreliably.rpc("u")
	callers[0].tell_in_order.rpc("o")
	callers[0].tell_aside.rpc("a")
	await _until(func() -> bool: return callers[1].heard.size() == 3)
	callers[1].heard.sort()
	equal(callers[1].heard, ["a", "o", "u"] as Array[String])


func test_a_large_reliable_call_arrives_whole() -> void:
	var callers: Array[Caller] = await _make_callers(1)
	var text: String = "0123456789".repeat(100000)
	callers[0].tell.rpc(text)
	await _until(func() -> bool: return callers[1].heard.size() == 1)
	equal(callers[1].heard[0].length(), text.length())
	callers[0].tell.rpc("after")
	await _until(func() -> bool: return callers[1].heard.size() == 2)
	equal(callers[1].heard[1], "after", "the probes are nobody's packets")


func test_a_spawner_spawns_and_removes() -> void:
	await _make_callers(1)
	for root: Node in _roots:
		var spawner: MultiplayerSpawner = MultiplayerSpawner.new()
		spawner.name = "Spawner"
		spawner.spawn_path = ^".."
		spawner.spawn_function = func(name: Variant) -> Node:
			var node: Node = Node.new()
			node.name = name
			return node
		root.add_child(spawner)
	var thing: Node = (_roots[0].get_node("Spawner") as MultiplayerSpawner).spawn("thing")
	await _until(func() -> bool: return _roots[1].has_node("thing"))
	is_true(_roots[1].has_node("thing"))
	thing.queue_free()
	await _until(func() -> bool: return not _roots[1].has_node("thing"))
	is_false(_roots[1].has_node("thing"))


func test_authentication_keeps_strangers_out() -> void:
	var heard: Array[String] = []
	var server_api: SceneMultiplayer = _make_api(_server)
	server_api.auth_callback = func(peer: int, bytes: PackedByteArray) -> void:
		heard.append(bytes.get_string_from_ascii())
		if heard.back() == "friend":
			server_api.complete_auth(peer)
		else:
			server_api.disconnect_peer(peer)
	var outcomes: Array[String] = []
	for word: String in ["friend", "foe"]:
		var client: ThreadedPeer = _connect()
		var api: SceneMultiplayer = _make_api(client)
		api.auth_callback = func(_peer: int, _bytes: PackedByteArray) -> void: pass
		api.peer_authenticating.connect(
			func(peer: int) -> void:
				api.send_auth(peer, word.to_ascii_buffer())
				api.complete_auth(peer)
		)
		api.connected_to_server.connect(outcomes.append.bind(word + " in"))
		api.peer_authentication_failed.connect(
			func(_peer: int) -> void: outcomes.append(word + " out")
		)
	await _until(func() -> bool: return outcomes.size() >= 2)
	outcomes.sort()
	equal(outcomes, ["foe out", "friend in"] as Array[String])


func test_targets_one_all_and_all_but_one() -> void:
	for _client: int in 3:
		_connect()
	await _until(func() -> bool: return _count_peers() == 3)
	var ids: Array = _clients.map(func(peer: ThreadedPeer) -> int: return peer.get_unique_id())
	for target: int in [ids[0], 0, -ids[1]]:
		_server.set_target_peer(target)
		equal(_server.put_packet(PackedByteArray([target & 0x7F, 1])), OK)
	var count: Callable = func() -> Array:
		return _clients.map(
			func(peer: ThreadedPeer) -> int: return peer.get_available_packet_count()
		)
	await _until(func() -> bool: return count.call() == [3, 1, 2])
	_settle()
	equal(count.call(), [3, 1, 2])
	_server.set_target_peer(12345)
	equal(_server.put_packet(PackedByteArray([1])), ERR_INVALID_PARAMETER)
	_server.set_target_peer(0)
	_server.transfer_channel = ThreadedPeer.MAX_TRANSFER_CHANNEL + 1
	equal(_server.put_packet(PackedByteArray([1])), ERR_INVALID_PARAMETER)


func test_what_was_sent_last_arrives_before_the_end() -> void:
	var client: ThreadedPeer = _connect()
	await _until(func() -> bool: return _count_peers() == 1)
	_server.set_target_peer(client.get_unique_id())
	for number: int in 200:
		_server.put_packet(PackedByteArray([number]))
	_server.dismiss(client.get_unique_id(), DisconnectReason.DISMISSED)
	var got: Array[int] = []
	await _until(
		func() -> bool:
			while client.get_available_packet_count() > 0:
				got.append(client.get_packet()[0])
			return client.get_connection_status() == MultiplayerPeer.CONNECTION_DISCONNECTED
	)
	equal(got.size(), 200)
	equal(client.reason_of(1), DisconnectReason.DISMISSED)


func test_a_forced_end_is_told_to_the_other_side_only() -> void:
	var client: ThreadedPeer = _connect()
	await _until(func() -> bool: return _count_peers() == 1)
	var told: Array[int] = []
	_server.peer_disconnected.connect(told.append)
	_server.disconnect_peer(client.get_unique_id(), true)
	await _until(
		func() -> bool:
			return client.get_connection_status() == MultiplayerPeer.CONNECTION_DISCONNECTED
	)
	equal(told.size(), 0)
	is_false(_server.has_peer(client.get_unique_id()))


func test_new_connections_can_be_refused() -> void:
	_server.refuse_new_connections = true
	var client: ThreadedPeer = _connect()
	await _until(
		func() -> bool:
			return client.get_connection_status() == MultiplayerPeer.CONNECTION_DISCONNECTED
	)
	equal(_count_peers(), 0)


func test_fast_datagrams_carry_their_arrival() -> void:
	var client: ThreadedPeer = _connect()
	await _until(func() -> bool: return _count_peers() == 1)
	var sent: int = Time.get_ticks_usec()
	is_true(client.send_fast(1, PackedByteArray([Protocol.Message.MOTION, 7])))
	# Until the thread has it, without taking it.
	await _until(func() -> bool: return not _server._thread.mailbox._fast.is_empty())
	var came: int = Time.get_ticks_usec()
	OS.delay_msec(50)
	var got: Array[FastPacket] = _server.take_fast()
	equal(got.size(), 1)
	equal([got[0].peer, got[0].bytes[1]], [client.get_unique_id(), 7])
	var arrived: int = got[0].arrival_usec
	is_true(sent < arrived and arrived <= came, "%d us after it came" % (arrived - came))
	is_false(client.send_fast(1, PackedByteArray(range(256)).slice(0) + _bytes(1000)), "too large")


func test_a_client_without_a_thread_is_served_by_polling() -> void:
	var client: ThreadedPeer = ThreadedPeer.new()
	client.has_thread = false
	equal(client.create_client("127.0.0.1", _port), OK)
	_clients.append(client)
	await _until(func() -> bool: return _count_peers() == 1)
	client.set_target_peer(1)
	equal(client.put_packet(PackedByteArray([1, 2, 3])), OK)
	is_true(client.send_fast(1, PackedByteArray([Protocol.Message.MOTION, 7])))
	var fast: Array[FastPacket] = []
	await _until(
		func() -> bool:
			fast.append_array(_server.take_fast())
			return _server.get_available_packet_count() == 1 and fast.size() == 1
	)
	equal(_server.get_packet(), PackedByteArray([1, 2, 3]))
	equal(fast[0].bytes[1], 7)
	_server.set_target_peer(client.get_unique_id())
	equal(_server.put_packet(PackedByteArray([4])), OK)
	await _until(func() -> bool: return client.get_available_packet_count() == 1)
	equal(client.get_packet(), PackedByteArray([4]))
	var gone: Array[int] = []
	_server.peer_disconnected.connect(gone.append)
	var began: int = Time.get_ticks_msec()
	client.close()
	await _until(func() -> bool: return gone.size() == 1)
	# Had it left without a word, the server would have waited for it.
	is_true(Time.get_ticks_msec() - began < TransportHost.SILENT_MS, "it says that it leaves")


func test_a_client_without_a_thread_finds_no_server() -> void:
	_server.close()
	var client: ThreadedPeer = ThreadedPeer.new()
	client.has_thread = false
	var why: Array[String] = []
	client.failed.connect(why.append)
	equal(client.create_client("nobody.invalid", _port), OK)
	_clients.append(client)
	await _until(func() -> bool: return why.size() == 1)
	is_true("is no address" in why[0], why[0])
	equal(client.get_connection_status(), MultiplayerPeer.CONNECTION_DISCONNECTED)
	client.poll()
	equal(why.size(), 1, "it is told once")


func test_a_main_thread_that_stands_still_loses_only_the_oldest() -> void:
	var client: ThreadedPeer = _connect()
	await _until(func() -> bool: return _count_peers() == 1)
	for number: int in TransportMailbox.MAX_FAST * 2:
		var bytes: PackedByteArray = [Protocol.Message.MOTION, 0, 0, 0, 0]
		bytes.encode_u32(1, number)
		client.send_fast(1, bytes)
		if number % 20 == 0:
			# The system drops what does not fit the socket's buffer.
			_await_newest(number)
	_await_newest(TransportMailbox.MAX_FAST * 2 - 1)
	var got: Array[FastPacket] = _server.take_fast()
	is_true(got.size() > TransportMailbox.MAX_FAST / 4, "%d kept" % got.size())
	is_true(got.size() <= TransportMailbox.MAX_FAST, "%d kept" % got.size())
	equal(got.back().bytes.decode_u32(1), TransportMailbox.MAX_FAST * 2 - 1, "the newest")


func test_a_dead_host_is_opened_again() -> void:
	var client: ThreadedPeer = _connect()
	await _until(func() -> bool: return _count_peers() == 1)
	var gone: Array[int] = []
	var opened: Array[int] = []
	_server.peer_disconnected.connect(gone.append)
	_server.reopened.connect(func() -> void: opened.append(1))
	allow_error("isn't currently active")
	allow_error("Host already destroyed")
	_server._thread._host.destroy()
	await _until(func() -> bool: return opened.size() == 1)
	equal(gone, [client.get_unique_id()] as Array[int])
	_connect()
	await _until(func() -> bool: return _count_peers() == 1)
	equal(_count_peers(), 1, "somebody may join again")


func test_a_thread_that_has_ended_is_started_again() -> void:
	var client: ThreadedPeer = _connect()
	await _until(func() -> bool: return _count_peers() == 1)
	var gone: Array[int] = []
	_server.peer_disconnected.connect(gone.append)
	_server._thread._closing = true
	await _until(func() -> bool: return gone.size() == 1)
	equal(gone, [client.get_unique_id()] as Array[int])
	_connect()
	await _until(func() -> bool: return _count_peers() == 1)
	equal(_count_peers(), 1, "somebody may join again")


func test_a_port_in_use_and_a_peer_in_use() -> void:
	var second: ThreadedPeer = ThreadedPeer.new()
	equal(second.create_server(_port, "127.0.0.1"), ERR_CANT_CREATE)
	equal(second.get_connection_status(), MultiplayerPeer.CONNECTION_DISCONNECTED)
	equal(_server.create_server(_port), ERR_ALREADY_IN_USE)


func _bytes(p_size: int) -> PackedByteArray:
	var bytes: PackedByteArray = []
	bytes.resize(p_size)
	return bytes


func _connect() -> ThreadedPeer:
	var client: ThreadedPeer = ThreadedPeer.new()
	equal(client.create_client("127.0.0.1", _port), OK)
	_clients.append(client)
	return client


func _make_api(p_peer: ThreadedPeer) -> SceneMultiplayer:
	var api: SceneMultiplayer = SceneMultiplayer.new()
	api.server_relay = false
	api.multiplayer_peer = p_peer
	_apis.append(api)
	return api


## A node for the server and each client, below roots of their own with APIs of their own.
func _make_callers(p_clients: int) -> Array[Caller]:
	var callers: Array[Caller] = []
	for number: int in p_clients + 1:
		var root: Node = Node.new()
		add_child(root)
		_roots.append(root)
		var api: SceneMultiplayer = _make_api(_server if number == 0 else _connect())
		get_tree().set_multiplayer(api, root.get_path())
		var caller: Caller = Caller.new()
		caller.name = "Caller"
		root.add_child(caller)
		callers.append(caller)
	await _until(func() -> bool: return _apis[0].get_peers().size() == p_clients)
	await _until(
		func() -> bool:
			return _apis.slice(1).all(
				func(api: SceneMultiplayer) -> bool: return api.get_peers().has(1)
			)
	)
	return callers


func _count_peers() -> int:
	var count: int = 0
	for client: ThreadedPeer in _clients:
		count += 1 if _server.has_peer(client.get_unique_id()) else 0
	return count


## Until the newest datagram that waits for the server's main thread has a number.
func _await_newest(p_number: int) -> void:
	var mailbox: TransportMailbox = _server._thread.mailbox
	var limit: int = Time.get_ticks_msec() + int(LinkPair.PATIENCE_S * 1000.0)
	while Time.get_ticks_msec() < limit:
		mailbox._mutex.lock()
		var newest: FastPacket = null if mailbox._fast.is_empty() else mailbox._fast.back()
		mailbox._mutex.unlock()
		if newest != null and newest.bytes.decode_u32(1) == p_number:
			return
		OS.delay_usec(200)
	fail("datagram %d did not come" % p_number)


## Gives some time to what should not come.
func _settle() -> void:
	OS.delay_msec(20)
	for client: ThreadedPeer in _clients:
		client.poll()


func _poll() -> void:
	if _apis.is_empty():
		_server.poll()
		for client: ThreadedPeer in _clients:
			client.poll()
	for api: SceneMultiplayer in _apis:
		api.poll()


func _until(p_holds: Callable) -> void:
	await until(p_holds, _poll)
