extends TestCase
## A level's shared nodes over a real link: calls both ways, what is refused, spawner and
## synchronizer.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")
const BELL: PackedScene = preload("res://examples/04_bell/04_bell.tscn")
const TRAINEE: Roles.Role = Roles.Role.TRAINEE
const OBSERVER: Roles.Role = Roles.Role.OBSERVER

var _pair: LinkPair = null
var _server: SharedServer = null
var _server_level: Node3D = null


## A client with its level, and what it heard.
class Station:
	var end: LinkPair.End = null
	var shared: SharedClient = null
	var level: Node3D = null
	var refusals: Array[String] = []
	var rings: Array[String] = []

	func bell() -> Node:
		return level.get_node(^"Shared/Bell")

	func board() -> Node:
		return level.get_node(^"Shared/Bell/Board")


func before_each() -> void:
	_pair = LinkPair.new()
	_pair.listen()
	_server = SharedServer.new(_pair.server)
	_server_level = _load(_server.api, "Server")
	_server.api.release()


func after_each() -> void:
	_pair.close()
	for child: Node in get_children():
		child.free()
	_server.api.detach()


func test_a_trainee_rings_and_everybody_sees_and_hears_it() -> void:
	var ada: Station = _join(TRAINEE, "Ada")
	var eve: Station = _join(OBSERVER, "Eve")
	ada.bell().press()
	var seen: Callable = func() -> bool:
		return ada.rings.size() == 1 and eve.rings.size() == 1 and eve.bell().count == 1
	is_true(_pair.until(seen))
	equal([ada.rings, eve.rings], [["Ada"] as Array[String], ["Ada"] as Array[String]])
	is_true(_pair.until(func() -> bool: return eve.board().get_child_count() == 1))
	equal((eve.board().get_child(0) as Label3D).text, "1: Ada")
	equal([ada.refusals.size(), eve.refusals.size()], [0, 0])


func test_who_comes_later_finds_all_that_was_spawned() -> void:
	var ada: Station = _join(TRAINEE, "Ada")
	for ring: int in 3:
		ada.bell().press()
	is_true(_pair.until(func() -> bool: return ada.board().get_child_count() == 3))
	var late: Station = _join(OBSERVER, "late")
	var seen: Callable = func() -> bool:
		return late.board().get_child_count() == 3 and late.bell().count == 3
	is_true(_pair.until(seen))
	late.end.link.close()
	_pair.run(0.2)
	ada.bell().press()
	is_true(_pair.until(func() -> bool: return ada.bell().count == 4))


func test_each_refusal_is_an_error_at_the_caller() -> void:
	var ada: Station = _join(TRAINEE, "Ada")
	var eve: Station = _join(OBSERVER, "Eve")
	eve.bell().press()
	equal(eve.refusals.size(), 1, "known at once")
	contains(eve.refusals[0], "a role of observer may not call 'ring'")
	# The server checks it too.
	eve.shared._role = TRAINEE
	eve.bell().press()
	is_true(_pair.until(func() -> bool: return eve.refusals.size() == 2))
	contains(eve.refusals[1], "may not call 'ring'")
	ada.bell().rpc_id(1, &"_sound", "x")
	contains(ada.refusals[-1], "is for the server alone")
	ada.bell().rpc_id(1, &"ring", 5)
	contains(ada.refusals[-1], "takes 0 arguments, not 1")
	ada.bell().rpc_id(7, &"ring")
	contains(ada.refusals[-1], "clients call the server only")
	ada.refusals.clear()
	for ring: int in 6:
		ada.bell().press()
	is_true(_pair.until(func() -> bool: return ada.refusals.size() == 2))
	contains(ada.refusals[0], "more than 4 calls in a second")
	equal(_server_level.get_node(^"Shared/Bell").count, 4)


func test_forged_calls_and_noise_make_no_engine_error() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 11
	var ada: Station = _join(TRAINEE, "Ada")
	for path: String in ["..", "../..", "/root", "Bell/..", "%Bell", "Bell:count", "", "Nobody"]:
		for method: String in ["ring", "free", "queue_free", "_sound", "count", "", "set"]:
			var call: CallMessage = CallMessage.new()
			call.path = path
			call.method = method
			ada.end.link.send_reliably(call.encode())
	for method: String in ["free", "set_script", "_ready", "press", "rpc", "_sound"]:
		var call: CallMessage = CallMessage.new()
		call.path = "Bell"
		call.method = method
		ada.end.link.send_reliably(call.encode())
	for round: int in 400:
		var noise: PackedByteArray = NetSamples.noise(random, 80)
		noise.insert(0, Protocol.Message.CALL)
		ada.end.link.send_reliably(noise)
		if round % 40 == 0:
			_pair.run(0.05)
	# The engine's own packets: calls, paths and confirmations of paths that nobody was sent.
	for round: int in 60:
		var bytes: PackedByteArray = [round % 3, 1, random.randi() % 4, 0, 0, 0]
		ada.end.peer().set_target_peer(1)
		ada.end.peer().put_packet(bytes)
	_pair.run(0.3)
	is_true(ada.end.link.is_joined())
	equal(_server_level.get_node(^"Shared/Bell").count, 0)
	ada.bell().press()
	is_true(_pair.until(func() -> bool: return ada.rings.size() == 1), "and calls go on")


func test_a_level_that_is_changed_is_shared_anew() -> void:
	var ada: Station = _join(TRAINEE, "Ada")
	ada.bell().press()
	is_true(_pair.until(func() -> bool: return ada.board().get_child_count() == 1))
	_server_level.free()
	_server_level = _load(_server.api, "Server")
	_server_level.get_node(^"Shared/Bell").ring()
	# The clients hear of the level in the meantime; before that nothing of it may reach them.
	_pair.run(0.2)
	equal(ada.board().get_child_count(), 0, "the old notes are gone")
	ada.level.free()
	ada.level = _load(ada.shared.api, "Ada")
	ada.level.get_node(^"Shared/Bell").rung.connect(ada.rings.append)
	_server.api.release()
	is_true(_pair.until(func() -> bool: return ada.board().get_child_count() == 1))
	ada.bell().press()
	is_true(_pair.until(func() -> bool: return ada.bell().count == 2))


func test_a_level_without_shared_nodes_takes_packets_without_an_engine_error() -> void:
	var ada: Station = _join(TRAINEE, "Ada")
	_server_level.free()
	var plain: Node3D = Node3D.new()
	_server.api.attach(self, plain)
	plain.free()
	var taken: int = _pair.server.refused.get("kind", 0)
	ada.end.link.send_reliably([200])
	is_true(_pair.until(func() -> bool: return _pair.server.refused.get("kind", 0) > taken))


func test_nodes_do_not_come_before_what_waits_for_their_client() -> void:
	var ada: Station = _join(TRAINEE, "Ada")
	is_true(_pair.until(func() -> bool: return _pair.joined.has(ada.end.link.session)))
	# A large world is sent in parts over many ticks; the level is named behind it.
	var world: PackedByteArray = PackedByteArray([Protocol.Message.TABLE])
	world.resize(300000)
	_pair.server.send_reliably([ada.end.link.session], world, true)
	_server_level.free()
	_server_level = _load(_server.api, "Server")
	var sent: PackedByteArray = LevelMessage.encode("other", PackedByteArray())
	_pair.server.send_reliably([ada.end.link.session], sent)
	_server.api.release()
	_server_level.get_node(^"Shared/Bell").ring()
	var changed: Array[bool] = []
	ada.end.link.state_received.connect(
		func(bytes: PackedByteArray, _arrival: int) -> void:
			if bytes == sent:
				changed.append(true)
				ada.level.free()
				ada.level = _load(ada.shared.api, "Ada")
	)
	# An engine error at the client would fail the test.
	is_true(_pair.until(func() -> bool: return changed.size() == 1), ada.end.loss)
	is_true(_pair.until(func() -> bool: return ada.bell().count == 1))
	is_true(_pair.until(func() -> bool: return ada.board().get_child_count() == 1))


func test_values_come_back_as_they_were_sent() -> void:
	var values: Array = [
		null,
		true,
		-5,
		1 << 40,
		2.5,
		"tëxt",
		&"name",
		Vector2(1, -2),
		Vector3(1, 2, 3),
		Quaternion(0, 0, 0, 1),
		Color(1, 0.5, 0, 1),
		Transform3D(Basis.IDENTITY, Vector3(1, 2, 3)),
		PackedByteArray([1, 2, 255]),
		[1, [2, "x"]],
		{"a": 1, 2: [Vector3.UP]},
	]
	var bytes: PackedByteArray = []
	equal(CallValues.append(bytes, values), "")
	var reader: ByteReader = ByteReader.new(bytes)
	equal(CallValues.read(reader), values)
	is_true(reader.is_complete())
	for size: int in bytes.size():
		var cut: ByteReader = ByteReader.new(bytes.slice(0, size))
		CallValues.read(cut)
		is_false(cut.is_complete(), "cut to %d" % size)
	contains(CallValues.append(PackedByteArray(), Node), "cannot be sent")
	contains(CallValues.append(PackedByteArray(), "x".repeat(2000)), "too large")


func _join(p_role: Roles.Role, p_name: String) -> Station:
	var side: Station = Station.new()
	side.end = LinkPair.End.new()
	side.end.request.role = p_role
	side.end.request.name = p_name
	side.shared = SharedClient.new(side.end.link, p_role)
	_pair.ends.append(side.end)
	var peers: int = _server.api.get_peers().size()
	side.end.link.open("127.0.0.1", _pair.port, side.end.request)
	side.shared.reconnect()
	side.end.link.joined.connect(
		func() -> void:
			side.level = _load(side.shared.api, p_name)
			side.level.get_node(^"Shared").call_refused.connect(
				func(_method: StringName, why: String) -> void: side.refusals.append(why)
			)
			side.bell().rung.connect(side.rings.append)
	)
	is_true(_pair.until(func() -> bool: return side.end.joined == 1))
	# Until then nothing is sent there.
	is_true(_pair.until(func() -> bool: return _server.api.get_peers().size() > peers))
	return side


## A level at one of the sides: each is somewhere else in the tree.
func _load(p_api: SharedApi, p_name: String) -> Node3D:
	var holder: Node3D = get_node_or_null(NodePath(p_name))
	if holder == null:
		holder = Node3D.new()
		holder.name = p_name
		add_child(holder)
	var level: Node3D = Node3D.new()
	level.name = "Level"
	var example: Node = BELL.instantiate()
	var shared: Node = example.get_node(^"Shared")
	example.remove_child(shared)
	example.free()
	shared.owner = null
	level.add_child(shared)
	p_api.attach(holder, level)
	holder.add_child(level)
	return level
