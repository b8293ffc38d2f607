extends TestCase
## Throws random and damaged packets at every decoder: they answer "none" or something valid, and
## nothing reaches the engine's log.

const NetSamples: GDScript = preload("net_samples.gd")
const LogTrap: GDScript = preload("log_trap.gd")
const ROUNDS: int = 20000

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _trap: Logger = LogTrap.new()
var _accepted: int = 0


func before_each() -> void:
	_random.seed = 4
	_accepted = 0
	OS.add_logger(_trap)


func after_each() -> void:
	OS.remove_logger(_trap)
	equal("\n".join(_trap.call("take")).left(300), "", "printed")


func test_pose_packet() -> void:
	var good: PackedByteArray = PosePacket.encode(NetSamples.pose(_random))
	for _round: int in ROUNDS:
		var sample: PoseSample = PosePacket.decode(_hostile(good))
		if sample == null:
			_is_reason(PosePacket.error)
		else:
			_accepted += 1
			_is_empty(sample.find_fault())
	_check_mixture()


func test_snapshot_packet() -> void:
	var good: PackedByteArray = SnapshotPacket.encode(NetSamples.snapshot(_random, 5, 2))[0]
	for _round: int in ROUNDS:
		var snapshot: Snapshot = SnapshotPacket.decode(_hostile(good))
		if snapshot == null:
			continue
		_accepted += 1
		if snapshot.tick_rate < 1 or snapshot.tick < 0 or snapshot.bodies.size() > 255:
			fail("tick %d at %d/s" % [snapshot.tick, snapshot.tick_rate])
		for id: int in snapshot.bodies:
			var place: Transform3D = snapshot.bodies[id]
			if not place.is_finite() or absf(place.basis.determinant() - 1.0) > 1e-3:
				fail("a body at %s" % place)
	_check_mixture()


func test_world_description() -> void:
	var good: PackedByteArray = NetSamples.world(_random, 4, 2).encode()
	for _round: int in ROUNDS:
		var world: WorldDescription = WorldDescription.decode(_hostile(good))
		if world == null:
			continue
		_accepted += 1
		for id: int in world.bodies:
			_check_body(world.bodies[id])
	_check_mixture()


func test_hello() -> void:
	var good: PackedByteArray = Protocol.encode_hello(Protocol.Role.TRAINEE, "Adä😀", 0.97)
	for _round: int in ROUNDS:
		var hello: Dictionary = Protocol.decode_hello(_hostile(good))
		if hello.has("error"):
			_is_reason(hello["error"])
			continue
		_accepted += 1
		var height: float = hello["hip_height"]
		var name: String = hello["name"]
		if not (height > 0.2 and height < 2.0) or name == "" or name.length() > 32:
			fail(str(hello))
		if hello["role"] != 0 and hello["role"] != 1:
			fail(str(hello))
	_check_mixture()


func test_answer() -> void:
	var good: PackedByteArray = Protocol.encode_answer("the server is füll 😀")
	for _round: int in ROUNDS:
		var why: String = Protocol.decode_answer(_hostile(good))
		_accepted += 1 if why.begins_with("the s") else 0
		if why.length() > 200:
			fail("%d characters" % why.length())
	_check_mixture()


func test_packet_parts() -> void:
	var whole: PackedByteArray = NetSamples.world(_random, 80, 2).encode()
	var parts: Array[PackedByteArray] = PacketParts.split(whole, 1)
	is_true(parts.size() > 3)
	var joiner: PacketParts = PacketParts.new()
	for round: int in ROUNDS:
		var part: PackedByteArray = parts[round % parts.size()]
		var joined: PackedByteArray = joiner.join(_hostile(part) if _random.randf() < 0.1 else part)
		_accepted += 1 if joined == whole else 0
		if joined.size() > parts.size() * Protocol.MAX_DATAGRAM:
			fail("%d bytes" % joined.size())
	_check_mixture()


func test_joined_packets_stay_as_they_are() -> void:
	var whole: PackedByteArray = NetSamples.world(_random, 80, 2).encode()
	var joiner: PacketParts = PacketParts.new()
	var joined: PackedByteArray = []
	for part: PackedByteArray in PacketParts.split(whole, 1):
		joined = joiner.join(part)
	equal(joined, whole)
	joiner.join(PacketParts.split(PackedByteArray([1]), 2)[0])
	equal(joined, whole, "a later packet does not change one that was handed out")


func _hostile(p_good: PackedByteArray) -> PackedByteArray:
	if _random.randf() < 0.3:
		return NetSamples.noise(_random, 60)
	return NetSamples.damage(_random, p_good)


func _check_body(p_body: WorldDescription.Body) -> void:
	if p_body.actor < WorldDescription.FIXED or p_body.id < 0 or p_body.id > 65535:
		fail("body %d of actor %d" % [p_body.id, p_body.actor])
	for shape: Array in p_body.shapes:
		var made: Shape3D = WorldDescription.make_shape(shape)
		if made == null or not (shape[2] as Transform3D).is_finite():
			fail(str(shape))


## The damage must neither always nor never be found, or this tests little.
func _check_mixture() -> void:
	is_true(_accepted > ROUNDS / 100, "%d of %d accepted" % [_accepted, ROUNDS])
	is_true(_accepted < ROUNDS * 9 / 10, "%d of %d accepted" % [_accepted, ROUNDS])


func _is_reason(p_text: String) -> void:
	if p_text.length() < 10:
		fail("no reason: '%s'" % p_text)


func _is_empty(p_text: String) -> void:
	if p_text != "":
		fail(p_text)
