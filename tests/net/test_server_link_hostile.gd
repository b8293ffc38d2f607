extends TestCase
## What hostile or broken clients send must not disturb anybody else, nor flood the log.

const LinkPair: GDScript = preload("link_pair.gd")
const NetSamples: GDScript = preload("net_samples.gd")
const SnapshotStream: GDScript = preload("res://tests/wire/snapshot_stream.gd")
const TRAINEE: Roles.Role = Roles.Role.TRAINEE
const OBSERVER: Roles.Role = Roles.Role.OBSERVER

## What Godot's own peer needs beyond its three channels to have as many as ours.
const _MORE_CHANNELS: int = TransportThread.CHANNELS - 3

var _pair: LinkPair = null
var _good: LinkPair.End = null
var _good_peer: int = 0
var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _stream: SnapshotStream = null


func before_each() -> void:
	_stream = SnapshotStream.new([1, 2], [3, 4, 5])
	_random.seed = 8
	_begin(true)


func after_each() -> void:
	_pair.close()


func test_pose_that_is_none() -> void:
	var bad: LinkPair.End = _pair.join(TRAINEE, "bad")
	for _round: int in 5:
		# No codec can write what is no rotation; but a person may be too far away.
		var sample: PoseSample = NetSamples.pose(_random)
		sample.root.x = 30000.0
		bad.send(sample)
		var bytes: PackedByteArray = NetSamples.motion(NetSamples.pose(_random))
		bad.link.send_fast(bytes + PackedByteArray([Protocol.Message.MOTION]))
	_check_good_client_is_unaffected(0.3)
	equal(_pair.pose_count(), _poses_of_good(), "poses of the bad one")
	is_true(bad.link.is_joined(), "a mistake is forgiven")


func test_packets_of_wrong_size_and_kind() -> void:
	var bad: LinkPair.End = _pair.join(TRAINEE, "bad")
	var pose: PackedByteArray = NetSamples.motion(NetSamples.pose(_random))
	for _round: int in 100:
		_send(bad, NetSamples.noise(_random, 1000))
		_send(bad, pose.slice(0, _random.randi_range(1, pose.size() - 1)))
		_send(bad, pose + PackedByteArray([0]) + NetSamples.noise(_random, 50))
	_send(bad, PackedByteArray([Protocol.Message.SNAPSHOT]))
	_send(bad, PackedByteArray([Protocol.Message.TABLE]))
	_check_good_client_is_unaffected(0.3)
	equal(_pair.pose_count(), _poses_of_good(), "poses of the bad one")


func test_observer_may_not_send_poses() -> void:
	var bad: LinkPair.End = _pair.join(OBSERVER, "bad")
	for _pose: int in 20:
		bad.send(NetSamples.pose(_random))
	_check_good_client_is_unaffected(0.2)
	equal(_pair.pose_count(), _poses_of_good(), "poses of the observer")


func test_too_many_poses_are_dropped() -> void:
	var bad: LinkPair.End = _pair.join(TRAINEE, "bad")
	var bad_peer: int = _pair.joined.keys()[1]
	var began: int = Time.get_ticks_usec()
	# In small bursts: the system drops what does not fit the socket's buffer, from anybody.
	# A starved machine may spread them over two seconds, and then has to take all.
	var is_too_many: Callable = func() -> bool: return _pair.server.stats().get("dropped_in", 0) > 0
	for _round: int in 30:
		for _burst: int in 20:
			for _pose: int in 50:
				bad.send(NetSamples.pose(_random))
			_pair.run(0.002)
		if _pair.until(is_too_many, 0.5):
			break
	is_true(is_too_many.call(), "some are dropped")
	_check_good_client_is_unaffected(0.3)
	var taken: int = _pair.poses.get(bad_peer, []).size()
	var seconds: float = (Time.get_ticks_usec() - began) / 1e6
	# One second may have begun before, one may not be over.
	var allowed: float = MessageRates.MOTIONS * (seconds + 2.0)
	is_true(taken > 10 and taken <= allowed, "%d poses taken in %.1f s" % [taken, seconds])


func test_flood_ends_the_connection() -> void:
	var bad: LinkPair.End = _pair.join(TRAINEE, "bad")
	var bytes: PackedByteArray = PackedByteArray([99, 0, 0])
	var is_out: Callable = func() -> bool:
		for _packet: int in 300:
			_send(bad, bytes)
		_good.send(NetSamples.pose(_random))
		return _pair.left.size() > 0
	is_true(_pair.until(is_out), "thrown out")
	equal(_pair.left.size(), 1)
	is_false(_good_peer in _pair.left)
	_check_good_client_is_unaffected(0.3)


func test_raw_datagrams() -> void:
	_begin_unsealed()
	var raw: PacketPeerUDP = PacketPeerUDP.new()
	raw.connect_to_host("127.0.0.1", _pair.port)
	for _round: int in 40:
		for _datagram: int in 50:
			raw.put_packet(NetSamples.noise(_random, 1400))
		_pair.run(0.005)
	_check_good_client_is_unaffected(0.5)
	var late: LinkPair.End = _pair.join(OBSERVER, "late")
	equal(late.joined, 1, "somebody may still join")
	raw.close()


func test_datagrams_like_those_of_the_transport() -> void:
	_begin_unsealed()
	# Real datagrams of a client, caught on a port of ours and damaged.
	var raw: PacketPeerUDP = PacketPeerUDP.new()
	raw.connect_to_host("127.0.0.1", _pair.port)
	var caught: Array[PackedByteArray] = _catch_datagrams()
	is_true(caught.size() > 0, "caught none")
	for _round: int in 40:
		for _datagram: int in 20:
			var one: PackedByteArray = caught[_random.randi_range(0, caught.size() - 1)]
			raw.put_packet(NetSamples.damage(_random, one))
		_pair.run(0.005)
	_check_good_client_is_unaffected(0.5)
	raw.close()


func test_zero_length_datagrams() -> void:
	_begin_unsealed()
	var raw: PacketPeerUDP = PacketPeerUDP.new()
	raw.connect_to_host("127.0.0.1", _pair.port)
	for _round: int in 100:
		raw.put_packet(PackedByteArray())
		raw.put_packet(PackedByteArray())
		_good.send(NetSamples.pose(_random))
		_pair.run(0.01)
	var nearly_all: Callable = func() -> bool: return _poses_of_good() > 95
	is_true(_pair.until(nearly_all), "%d of 100 poses arrived" % _poses_of_good())
	raw.close()


func test_half_open_clients_take_no_place() -> void:
	_begin_unsealed()
	var silent: Array[ENetMultiplayerPeer] = []
	for _client: int in 20:
		var peer: ENetMultiplayerPeer = ENetMultiplayerPeer.new()
		peer.create_client("127.0.0.1", _pair.port, _MORE_CHANNELS)
		silent.append(peer)
	var poll: Callable = func() -> bool:
		for peer: ENetMultiplayerPeer in silent:
			peer.poll()
		return false
	_pair.until(poll, 0.3)
	var late: LinkPair.End = _pair.join(OBSERVER, "late")
	equal(late.joined, 1, "somebody may still join")
	equal(_pair.server.session_ids().size(), 2)
	_check_good_client_is_unaffected(0.3)
	for peer: ENetMultiplayerPeer in silent:
		peer.close()


func test_name_that_would_garble_the_log() -> void:
	_pair.join(OBSERVER, "a\n2026 INFO net: b")
	equal(_pair.joined.values()[1]["name"], "a2026 INFO net: b")


## The good client sends 60 poses a second, all of which arrive, and gets snapshots.
func _check_good_client_is_unaffected(p_seconds: float) -> void:
	_await_empty_socket()
	var before: int = _poses_of_good()
	var heard: int = _good.snapshots.size()
	var count: int = int(p_seconds * 60.0)
	for _pose: int in count:
		_good.send(NetSamples.pose(_random))
		_pair.send_snapshot(_stream)
		_pair.run(1.0 / 60.0)
	var all: Callable = func() -> bool: return _poses_of_good() - before >= count
	is_true(_pair.until(all), "%d of %d poses" % [_poses_of_good() - before, count])
	var is_told: Callable = func() -> bool: return _good.snapshots.size() - heard >= count - 1
	is_true(_pair.until(is_told), "%d of %d snapshots" % [_good.snapshots.size() - heard, count])
	is_true(_good.link.is_joined(), "the good client is still there")
	is_true(_pair.server.is_listening(), "the port is still open")


## Until a pose arrives behind what was sent at the server: a starved server's socket is full, and
## the system drops what comes then, from anybody.
func _await_empty_socket() -> void:
	for _try: int in 60:
		var pose: PoseSample = NetSamples.pose(_random)
		_good.send(pose)
		var is_heard: Callable = func() -> bool:
			return (_pair.poses.get(_good_peer, []) as Array).any(
				func(one: PoseSample) -> bool: return one.id == pose.id
			)
		if _pair.until(is_heard, 1.0):
			return
	fail("the good client is not heard at all")


func _poses_of_good() -> int:
	return _pair.poses.get(_good_peer, []).size()


## Sends any bytes as an admitted client.
func _send(p_end: LinkPair.End, p_bytes: PackedByteArray) -> void:
	if p_end.link.is_joined() and not p_bytes.is_empty():
		p_end.link.api().send_bytes(p_bytes, 1, MultiplayerPeer.TRANSFER_MODE_UNRELIABLE)
		p_end.link.send_fast(p_bytes)


func _catch_datagrams() -> Array[PackedByteArray]:
	var net: PacketPeerUDP = PacketPeerUDP.new()
	net.bind(0, "127.0.0.1")
	var client: ENetMultiplayerPeer = ENetMultiplayerPeer.new()
	client.create_client("127.0.0.1", net.get_local_port())
	var caught: Array[PackedByteArray] = []
	for _poll: int in 100:
		client.poll()
		OS.delay_msec(10)
		while net.get_available_packet_count() > 0:
			caught.append(net.get_packet())
	client.close()
	net.close()
	return caught


func test_commands_of_the_engine_do_not_reach_it() -> void:
	var bad: LinkPair.End = _pair.join(TRAINEE, "bad")
	# As a client that speaks ENet, but is none of ours: calls, spawns, system commands, anything.
	var raw: ThreadedPeer = bad.link.get("_peer")
	for round: int in 200:
		var bytes: PackedByteArray = NetSamples.noise(_random, 40)
		bytes.insert(0, _random.randi_range(0, 255))
		raw.set_target_peer(1)
		raw.transfer_mode = MultiplayerPeer.TRANSFER_MODE_RELIABLE
		raw.put_packet(bytes)
		if round % 20 == 0:
			_pair.run(0.01)
	_check_good_client_is_unaffected(0.3)


func test_a_stranger_without_greeting_floods() -> void:
	_begin_unsealed()
	var raw: ENetMultiplayerPeer = ENetMultiplayerPeer.new()
	equal(raw.create_client("127.0.0.1", _pair.port, _MORE_CHANNELS), OK)
	for round: int in 300:
		raw.poll()
		if raw.get_connection_status() == MultiplayerPeer.CONNECTION_CONNECTED:
			raw.set_target_peer(1)
			raw.put_packet(PackedByteArray([_random.randi_range(0, 255), round & 255, 3, 4]))
		_pair.run(0.002)
	_check_good_client_is_unaffected(0.3)
	raw.close()


func _begin(p_seals: bool) -> void:
	_pair = LinkPair.new()
	_pair.rules.seals = p_seals
	equal(_pair.listen(8), OK)
	_good = _pair.join(TRAINEE, "good")
	equal(_good.joined, 1)
	_good_peer = _pair.joined.keys()[0]


## Begins anew for an attacker who speaks ENet as it is.
func _begin_unsealed() -> void:
	_pair.close()
	_begin(false)
