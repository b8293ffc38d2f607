extends TestCase
## A server and its clients over real sockets: joining, samples, snapshots, refusals, leaving.

const LinkPair: GDScript = preload("link_pair.gd")
const NetSamples: GDScript = preload("net_samples.gd")
const SnapshotStream: GDScript = preload("res://tests/wire/snapshot_stream.gd")
const TRAINEE: Roles.Role = Roles.Role.TRAINEE
const OBSERVER: Roles.Role = Roles.Role.OBSERVER

var _pair: LinkPair = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 7
	_pair = LinkPair.new()
	equal(_pair.listen(3), OK)


func after_each() -> void:
	_pair.close()


func test_trainee_joins_and_is_heard() -> void:
	var end: LinkPair.End = _pair.join(TRAINEE, "Grace")
	equal(end.joined, 1)
	equal(_pair.server.session_ids().size(), 1)
	var hello: Dictionary = _pair.joined.values()[0]
	equal([hello["name"], hello["role"]], ["Grace", int(TRAINEE)])
	var sample: PoseSample = NetSamples.pose(_random)
	end.send(sample)
	is_true(_pair.until(func() -> bool: return _pair.pose_count() == 1), "heard")
	var got: PoseSample = _pair.poses.values()[0][0]
	for limb: int in Limbs.COUNT:
		is_true(got.orientation(limb).angle_to(sample.orientation(limb)) < 0.002)
	equal([got.id, got.time_usec], [sample.id, sample.time_usec])


func test_an_acknowledgement_of_motion_waits_for_no_frame() -> void:
	var end: LinkPair.End = _pair.join(TRAINEE, "Grace")
	var acks: Array[PackedByteArray] = []
	var arrived: Semaphore = Semaphore.new()
	end.link.set_motion_ack_taker(
		func(ack: PackedByteArray) -> void:
			acks.append(ack)
			arrived.post()
	)
	var stream: SnapshotStream = SnapshotStream.new([1], [])
	stream.move()
	var ack: PackedByteArray = [7, 3]
	_pair.send_to(end.link.session, stream.datagrams(1, ack))
	# Nobody polls: only the transport's threads run.
	var limit: int = Time.get_ticks_msec() + int(LinkPair.PATIENCE_S * 1000.0)
	while not arrived.try_wait() and Time.get_ticks_msec() < limit:
		OS.delay_msec(1)
	equal(acks, [ack] as Array[PackedByteArray])
	end.link.set_motion_ack_taker(Callable())
	stream.move()
	_pair.send_to(end.link.session, stream.datagrams(1, ack))
	is_true(_pair.until(func() -> bool: return end.snapshots.size() == 2), "both are decoded too")
	equal(acks.size(), 1, "nobody takes them any more")


func test_everybody_gets_world_and_snapshots() -> void:
	var ends: Array[LinkPair.End] = [_pair.join(TRAINEE), _pair.join(OBSERVER, "Bob")]
	var table: EntityTable = NetSamples.table(_random, 300, 8)
	var stream: SnapshotStream = SnapshotStream.new([1, 2], [])
	for body: int in 300:
		stream.bodies.append(body)
	_pair.send_reliably(EntityTableMessage.of_table(table, 0.1).encode())
	for _tick: int in 8:
		_pair.send_snapshot(stream)
		_pair.run(0.02)
	for end: LinkPair.End in ends:
		is_true(
			_pair.until(func() -> bool: return end.bodies.size() == 300), "%d" % end.bodies.size()
		)
		is_true(_pair.until(func() -> bool: return end.tables.size() == 1), "table")
		equal(end.tables[0].spawned.size(), table.rows.size())
		is_true(_pair.until(func() -> bool: return end.snapshots.back() == stream.tick), "newest")


func test_wrong_version_is_told_so() -> void:
	var end: LinkPair.End = _pair.add(TRAINEE, "Ada", 99)
	is_true(_pair.until(func() -> bool: return end.refusal != ""))
	contains(end.refusal, "protocol version 99, the server %d" % Protocol.VERSION)
	_pair.run(0.1)
	equal([end.joined, end.loss, _pair.joined.size()], [0, "", 0])


func test_full_server_and_a_place_that_becomes_free() -> void:
	for i: int in 3:
		_pair.add(OBSERVER, "n%d" % i)
	is_true(_pair.until(func() -> bool: return _pair.joined.size() == 3))
	var late: LinkPair.End = _pair.add(TRAINEE)
	is_true(_pair.until(func() -> bool: return late.places == [1]))
	_pair.ends[0].link.leave()
	is_true(_pair.until(func() -> bool: return _pair.left.size() == 1))
	_pair.await_join(late)
	equal([late.joined, late.refusal, late.loss], [1, "", ""])


func test_client_that_leaves_is_gone_at_once() -> void:
	var end: LinkPair.End = _pair.join(TRAINEE)
	equal(end.joined, 1)
	end.link.leave()
	is_true(_pair.until(func() -> bool: return _pair.left.size() == 1))
	equal(_pair.lost.size(), 0, "nobody had to miss it first")
	equal(_pair.left[0], _pair.joined.keys()[0])
	equal(_pair.server.session_ids().size(), 0)


func test_who_does_not_prove_that_it_leaves_is_only_lost() -> void:
	var end: LinkPair.End = _pair.join(TRAINEE)
	var id: int = end.link.session
	# A farewell with another's token, and a disconnect that says that the client has left.
	var forged: PackedByteArray = [Protocol.Message.LEAVE]
	forged.resize(1 + JoinRequest.TOKEN_SIZE)
	end.link.api().send_bytes(forged, 1, MultiplayerPeer.TRANSFER_MODE_RELIABLE)
	end.link.close()
	is_true(_pair.until(func() -> bool: return _pair.lost.size() == 1))
	equal(_pair.left, [] as Array[int])
	end.link.open("127.0.0.1", _pair.port, end.request)
	is_true(_pair.until(func() -> bool: return _pair.returned.size() == 1))
	equal([end.link.session, _pair.returned], [id, [id] as Array[int]])


func test_client_that_vanishes_is_lost_soon() -> void:
	var stays: LinkPair.End = _pair.join(TRAINEE, "stays")
	var end: LinkPair.End = _pair.join(TRAINEE, "vanishes")
	equal(_pair.joined.size(), 2)
	_pair.ends.erase(end)
	end.cut()
	var stream: SnapshotStream = SnapshotStream.new([], [1])
	_pair.until(
		func() -> bool:
			_pair.send_snapshot(stream)
			return _pair.lost.size() == 1
	)
	equal(_pair.lost.size(), 1)
	equal(_pair.joined[_pair.lost[0]]["name"], "vanishes")
	is_true(stays.link.is_joined())
	equal(_pair.left.size(), 0, "its place is kept")


func test_server_that_goes_is_noticed() -> void:
	var end: LinkPair.End = _pair.join(TRAINEE)
	equal(end.joined, 1)
	_pair.server.close()
	is_true(_pair.until(func() -> bool: return end.loss != ""))
	contains(end.loss, "was closed")
	is_false(end.link.is_joined())


func test_no_server() -> void:
	_pair.server.close()
	var end: LinkPair.End = LinkPair.End.new()
	_pair.ends.append(end)
	end.link.open("127.0.0.1", _pair.port, JoinRequest.new())
	is_true(_pair.until(func() -> bool: return end.loss != ""))
	contains(end.loss, "no server answers at 127.0.0.1:%d" % _pair.port)


func test_address_that_is_none() -> void:
	var end: LinkPair.End = LinkPair.End.new()
	allow_error("Couldn't")
	allow_error("resolve")
	_pair.ends.append(end)
	end.link.open("", 7777, JoinRequest.new())
	is_true(_pair.until(func() -> bool: return end.loss != ""))
	contains(end.loss, "no address that can be connected to")


func test_joins_again_with_the_same_link() -> void:
	var end: LinkPair.End = _pair.join(TRAINEE)
	equal(end.joined, 1)
	end.link.leave()
	is_true(_pair.until(func() -> bool: return _pair.left.size() == 1))
	end.link.open("127.0.0.1", _pair.port, end.request)
	is_true(_pair.until(func() -> bool: return end.joined == 2 and _pair.joined.size() == 2))
	end.send(NetSamples.pose(_random))
	is_true(_pair.until(func() -> bool: return _pair.pose_count() == 1))


func test_port_in_use() -> void:
	var second: ServerLink = ServerLink.new()
	not_equal(second.listen(_pair.port, ServerRules.new()), OK)
	is_false(second.is_listening())
	is_true(_pair.server.is_listening())


func test_traffic_is_counted() -> void:
	var end: LinkPair.End = _pair.join(TRAINEE)
	equal(end.joined, 1)
	# The probes of what the way carries are through.
	_pair.run(0.3)
	var before: int = _pair.server.traffic.received
	for _pose: int in 20:
		end.send(NetSamples.pose(_random))
		_pair.run(0.01)
	is_true(_pair.until(func() -> bool: return _pair.pose_count() == 20))
	var size: int = NetSamples.motion(NetSamples.pose(_random)).size()
	var came: Callable = func() -> int: return _pair.server.traffic.received - before
	is_true(_pair.until(func() -> bool: return came.call() >= 20 * size), "%d bytes" % came.call())
	# With all headers.
	is_true(came.call() < 20 * (size + 60) + 6000, "%d bytes" % came.call())
