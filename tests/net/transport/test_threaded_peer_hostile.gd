extends TestCase
## Attacks on the transport itself, each with a legitimate client that must not notice: chosen ids,
## clients that take nothing in, repeated and swapped datagrams, bad snapshots.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")
const SnapshotStream: GDScript = preload("res://tests/wire/snapshot_stream.gd")
const UdpRelay: GDScript = preload("res://tests/net/transport/udp_relay.gd")
const TRAINEE: Roles.Role = Roles.Role.TRAINEE

var _pair: LinkPair = null
var _good: LinkPair.End = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _stream: SnapshotStream = null
var _hosts: Array[ENetConnection] = []


func before_each() -> void:
	_stream = SnapshotStream.new([1, 2], [3, 4, 5])
	_random.seed = 9
	_begin(true)


func after_each() -> void:
	_pair.close()
	for host: ENetConnection in _hosts:
		host.destroy()


func test_chosen_ids() -> void:
	_begin_unsealed()
	var good_id: int = _good.peer().get_unique_id()
	for id: int in [0, 1, -5, -2147483648, 0x80000001, good_id, good_id]:
		var host: ENetConnection = _connect(id & 0xFFFFFFFF)
		var is_refused: Callable = func() -> bool:
			return not host.get_peers().any(
				func(peer: ENetPacketPeer) -> bool: return peer.is_active()
			)
		is_true(_serve(host, is_refused), "id %d" % id)
	_check_good()
	equal(_pair.server.session_ids().size(), 1)
	is_true(_pair.until(func() -> bool: return _pair.server.stats()["refused_ids"] == 7))


func test_a_client_that_never_acknowledges() -> void:
	_begin_unsealed()
	var bad: ENetConnection = _connect(77)
	is_true(_serve(bad, func() -> bool: return _pair.server_peer().has_peer(77)))
	# It is connected and says nothing any more; the server has challenged it.
	var stands: Callable = func() -> bool: return not _pair.server_peer().has_peer(77)
	_check_good()
	is_true(_pair.until(stands), "gone")
	_check_good()


func test_a_client_that_takes_nothing_in() -> void:
	var bad: LinkPair.End = _pair.join(TRAINEE, "bad")
	var session: int = bad.link.session
	# It acknowledges just enough for ENet, but never says that it has taken in what it was sent.
	var api: SceneMultiplayer = _pair.server.api()
	var peer: int = _pair.server.session(session).peer
	var connection: TransportConnection = _pair.server_peer()._thread._connections[peer]
	_pair.ends.erase(bad)
	bad.peer()._thread._server = true
	var block: PackedByteArray = []
	block.resize(60000)
	for _block: int in 90:
		if api.get_peers().has(peer):
			api.send_bytes(block, peer, MultiplayerPeer.TRANSFER_MODE_RELIABLE)
		_pair.run(0.002)
	is_true(_pair.until(func() -> bool: return _pair.left.has(session)))
	is_true(connection.window.is_exceeded())
	equal(_pair.server.stats()["thrown_out"], 1)
	bad.link.close()
	_check_good()


func test_large_reliable_traffic_is_receipted() -> void:
	var peer: int = _pair.server.session(_good.link.session).peer
	var connection: TransportConnection = _pair.server_peer()._thread._connections[peer]
	for _world: int in 30:
		_pair.send_reliably(NetSamples.table_bytes(_random, 4000, 8))
		_pair.run(0.02)
	is_true(_pair.until(func() -> bool: return _good.tables.size() == 30))
	is_true(_pair.until(func() -> bool: return connection.window.get_unreceipted() < 200000))
	is_true(_good.link.is_joined())


func test_repeated_and_swapped_datagrams() -> void:
	var relay: UdpRelay = UdpRelay.new()
	relay.copies = 2
	relay.hold = 0.2
	relay.damage = 0.05
	relay.replays = true
	relay.start(_pair.port)
	var odd: LinkPair.End = LinkPair.End.new()
	odd.request.role = TRAINEE
	_pair.ends.append(odd)
	odd.link.open("127.0.0.1", relay.port, odd.request)
	is_true(_pair.until(func() -> bool: return odd.joined == 1), odd.loss)
	for _pose: int in 60:
		odd.send(NetSamples.pose(_random))
		_pair.run(0.016)
	_check_good()
	var counted: Callable = func() -> int: return _pair.poses.get(odd.link.session, []).size()
	is_true(
		_pair.until(func() -> bool: return counted.call() >= 55),
		"%d of 60 poses through the relay" % counted.call()
	)
	# Long enough for the relay to repeat all that it has kept.
	_pair.run(0.2)
	var count: int = counted.call()
	is_true(count <= 300, "%d of 60 poses through the relay" % count)
	relay.stop()


func test_snapshots_that_are_none() -> void:
	_stream.move()
	var good: PackedByteArray = _stream.datagrams(99)[0]
	var peer: int = _pair.server.session(_good.link.session).peer
	var large: PackedByteArray = good.duplicate()
	large.resize(2000)
	for round: int in 100:
		var bad: PackedByteArray = good.slice(0, _random.randi_range(1, good.size() - 1))
		var whom: PackedInt32Array = [_good.link.session, _good.link.session]
		_pair.server.send_datagrams(whom, [bad, NetSamples.damage(_random, good)])
		_pair.server_peer()._thread.send_fast(peer, large)
		_pair.run(0.005)
	_check_good()


func test_engine_commands_do_not_harm_a_client() -> void:
	# A hostile server may make the client's engine complain, but not more.
	var peer: int = _pair.server.session(_good.link.session).peer
	for round: int in 20:
		_pair.server_peer().set_target_peer(peer)
		_pair.server_peer().put_packet(PackedByteArray([3, _random.randi_range(0, 255), 1, 2]))
	_check_good()


## The good client sends 60 poses in a second, all of which arrive, and gets as many snapshots.
func _check_good() -> void:
	var session: int = _good.link.session
	var before: int = _pair.poses.get(session, []).size()
	var heard: int = _good.snapshots.size()
	for _pose: int in 30:
		_good.send(NetSamples.pose(_random))
		_pair.send_snapshot(_stream)
		_pair.run(1.0 / 60.0)
	var all: Callable = func() -> bool: return _pair.poses.get(session, []).size() - before >= 30
	is_true(_pair.until(all), "%d poses" % (_pair.poses.get(session, []).size() - before))
	is_true(_pair.until(func() -> bool: return _good.snapshots.size() - heard >= 30))
	is_true(_good.link.is_joined(), "the good client is still there")


func _connect(p_id: int) -> ENetConnection:
	var host: ENetConnection = ENetConnection.new()
	host.create_host(1, TransportThread.CHANNELS)
	host.connect_to_host("127.0.0.1", _pair.port, TransportThread.CHANNELS, p_id)
	_hosts.append(host)
	return host


## Serves a host until something holds.
func _serve(p_host: ENetConnection, p_holds: Callable) -> bool:
	var serve: Callable = func() -> bool:
		var event: Array = p_host.service(1)
		if event[0] == ENetConnection.EVENT_RECEIVE:
			(event[1] as ENetPacketPeer).get_packet()
		return p_holds.call()
	return _pair.until(serve)


func _begin(p_seals: bool) -> void:
	_pair = LinkPair.new()
	_pair.rules.seals = p_seals
	equal(_pair.listen(8), OK)
	_good = _pair.join(TRAINEE, "good")
	equal(_good.joined, 1)


## Begins anew for an attacker who speaks ENet as it is.
func _begin_unsealed() -> void:
	_pair.close()
	_begin(false)
