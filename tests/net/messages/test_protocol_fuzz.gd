extends TestCase
## Throws random and damaged packets at every decoder: they answer "none" or something valid, and
## nothing reaches the engine's log.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")
const SnapshotStream: GDScript = preload("res://tests/wire/snapshot_stream.gd")
const LogTrap: GDScript = preload("res://tests/net/log_trap.gd")
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


func test_motion() -> void:
	for _round: int in ROUNDS:
		# With and without baselines: a reader that knows something has more to get wrong.
		var reader: SampleReader = SampleReader.new()
		var writer: SampleWriter = SampleWriter.new()
		for _clean: int in _random.randi_range(0, 2):
			reader.read(_motion(writer))
			writer.take_ack(reader.take_ack())
		var samples: Array[PoseSample] = reader.read(_hostile(_motion(writer)))
		if samples.is_empty() and reader.error != "":
			_is_reason(reader.error)
		for sample: PoseSample in samples:
			_accepted += 1
			_is_empty(sample.find_fault())
	# Wherever it is damaged, what follows reads as other numbers: mostly too many or too few.
	_check_mixture(ROUNDS / 400)


func test_snapshots() -> void:
	var stream: SnapshotStream = SnapshotStream.new([1, 2], [3, 4, 5])
	for round: int in ROUNDS:
		# With and without baselines: a decoder that knows something has more to get wrong.
		stream.move()
		var decoder: SnapshotDecoder = SnapshotStream.decoder()
		var first: PackedByteArray = stream.datagrams(round)[0]
		decoder.decode(first)
		stream.take_ack(round, decoder.get_ack(Vector3.ZERO))
		stream.move()
		if decoder.decode(_hostile(stream.datagrams(round)[0])) != SnapshotDecoder.OK:
			continue
		_accepted += 1
		for id: int in decoder.get_bodies():
			var place: Transform3D = decoder.get_body_transform(id)
			if not place.is_finite() or absf(place.basis.determinant() - 1.0) > 1e-3:
				fail("a body at %s" % place)
		for id: int in decoder.get_people():
			var turns: PackedFloat32Array = decoder.get_orientations(id)
			for limb: int in Limbs.COUNT:
				var norm: float = (
					Vector4(
						turns[limb * 4],
						turns[limb * 4 + 1],
						turns[limb * 4 + 2],
						turns[limb * 4 + 3]
					)
					. length()
				)
				if absf(norm - 1.0) > 1e-3:
					fail("a limb turned by a norm of %f" % norm)
	# Most damage shows at the end, which is not where the coder would have it.
	_check_mixture(ROUNDS / 1000)


func test_entity_table() -> void:
	var good: PackedByteArray = NetSamples.table_bytes(_random, 4, 2)
	for _round: int in ROUNDS:
		var message: EntityTableMessage = EntityTableMessage.decode(_hostile(good), [])
		if message == null:
			continue
		_accepted += 1
		for row: EntityRow in message.spawned:
			if not EntityTable.is_id_for(row.id, row.type.body):
				fail(row.describe())
	_check_mixture()


func test_level() -> void:
	var good: PackedByteArray = LevelMessage.encode("hall", PackedByteArray([1, 2, 3]))
	for _round: int in ROUNDS:
		var level: LevelMessage = LevelMessage.decode(_hostile(good))
		if level != null:
			_accepted += 1
			if level.fingerprint.size() != Protocol.FINGERPRINT_SIZE:
				fail("%d bytes" % level.fingerprint.size())
	_check_mixture()


func test_level_request_and_data() -> void:
	var asked: LevelRequestMessage = LevelRequestMessage.new()
	asked.content_hash.resize(LevelRequestMessage.HASH_SIZE)
	asked.length = 5000
	var bytes: PackedByteArray = NetSamples.noise(_random, 900)
	var answers: Array[PackedByteArray] = [
		LevelDataMessage.encode(3, 10, 5000, bytes), LevelDataMessage.refuse(3, "it is gone")
	]
	for round: int in ROUNDS:
		var request: LevelRequestMessage = LevelRequestMessage.decode(_hostile(asked.encode()))
		if request != null:
			_accepted += 1
			if request.length < 1 or request.length > LevelRequestMessage.MAX_LENGTH:
				fail("%d bytes" % request.length)
		var answer: LevelDataMessage = LevelDataMessage.decode(_hostile(answers[round % 2]))
		if answer != null and answer.data.size() > LevelDataMessage.ROOM:
			fail("%d bytes" % answer.data.size())
	_check_mixture()


func test_join_request() -> void:
	var sent: JoinRequest = JoinRequest.new()
	sent.name = "Adä😀"
	var good: PackedByteArray = sent.encode(PackedByteArray([1]), PackedByteArray([2]))
	for _round: int in ROUNDS:
		var request: JoinRequest = JoinRequest.decode(_hostile(good))
		if request.error != "":
			_is_reason(request.error)
			continue
		_accepted += 1
		if request.name == "" or request.name.length() > 32:
			fail("'%s'" % request.name)
		if request.role < 0 or request.role >= Roles.Role.size():
			fail("role %d" % request.role)
	_check_mixture()


func test_challenge() -> void:
	var good: PackedByteArray = ServerRules.new().challenge().encode()
	for _round: int in ROUNDS:
		var challenge: Challenge = Challenge.decode(_hostile(good))
		if challenge.error != "":
			_is_reason(challenge.error)
			continue
		_accepted += 1
		if challenge.rounds > PasswordKey.MAX_ROUNDS or challenge.nonce.size() != 32:
			fail("%d rounds" % challenge.rounds)
	_check_mixture()


func test_join_reply() -> void:
	var good: PackedByteArray = JoinReply.refusal("the server is füll 😀", true)
	for _round: int in ROUNDS:
		var answer: JoinReply = JoinReply.decode(_hostile(good))
		_accepted += 1 if answer.why.begins_with("the s") else 0
		var silent: bool = answer.kind == JoinReply.Kind.REFUSED and answer.why == ""
		if answer.why.length() > 800 or silent:
			fail("%d characters" % answer.why.length())
	_check_mixture()


func test_notice() -> void:
	var good: Array[PackedByteArray] = [
		NoticeMessage.calibrate(7, 2, 40000),
		NoticeMessage.dismiss("kicked by instructor 'Idä'"),
		NoticeMessage.tell("the server has room for 128 people"),
	]
	for round: int in ROUNDS:
		var notice: NoticeMessage = NoticeMessage.decode(_hostile(good[round % good.size()]))
		if notice == null:
			continue
		_accepted += 1
		if notice.text.length() > 4 * NoticeMessage.MAX_TEXT or notice.number > 0xFFFF:
			fail("%d characters" % notice.text.length())
	_check_mixture()


func test_clock_packet() -> void:
	var question: PackedByteArray = ClockMessage.question(77)
	var good: PackedByteArray = ClockMessage.answer(question, 5000000, 300, 4990000, 60)
	var sync: ClockSync = ClockSync.new()
	for round: int in ROUNDS:
		var packet: ClockMessage = ClockMessage.decode(_hostile(good))
		if packet == null:
			continue
		_accepted += 1
		sync.arrived(packet, 100 + round * 10)
		if sync.is_known() and not is_finite(sync.tick_at(round)):
			fail("no tick")
	_check_mixture()


func test_packet_parts() -> void:
	var whole: PackedByteArray = NetSamples.table_bytes(_random, 300, 2)
	var parts: Array[PackedByteArray] = MessageParts.split(whole, 1)
	is_true(parts.size() > 3)
	var joiner: MessageParts = MessageParts.new()
	for round: int in ROUNDS:
		var part: PackedByteArray = parts[round % parts.size()]
		var joined: PackedByteArray = joiner.join(_hostile(part) if _random.randf() < 0.1 else part)
		_accepted += 1 if joined == whole else 0
		if joined.size() > parts.size() * Protocol.MAX_DATAGRAM:
			fail("%d bytes" % joined.size())
	_check_mixture()


func test_joined_packets_stay_as_they_are() -> void:
	var whole: PackedByteArray = NetSamples.table_bytes(_random, 300, 2)
	var joiner: MessageParts = MessageParts.new()
	var joined: PackedByteArray = []
	for part: PackedByteArray in MessageParts.split(whole, 1):
		joined = joiner.join(part)
	equal(joined, whole)
	joiner.join(MessageParts.split(PackedByteArray([1]), 2)[0])
	equal(joined, whole, "a later packet does not change one that was handed out")


func _motion(p_writer: SampleWriter) -> PackedByteArray:
	return p_writer.write([NetSamples.pose(_random)] as Array[PoseSample])[0]


func _hostile(p_good: PackedByteArray) -> PackedByteArray:
	if _random.randf() < 0.3:
		return NetSamples.noise(_random, 60)
	return NetSamples.damage(_random, p_good)


## The damage must neither always nor never be found, or this tests little.
func _check_mixture(p_least: int = ROUNDS / 100) -> void:
	is_true(_accepted > p_least, "%d of %d accepted" % [_accepted, ROUNDS])
	is_true(_accepted < ROUNDS * 9 / 10, "%d of %d accepted" % [_accepted, ROUNDS])


func _is_reason(p_text: String) -> void:
	if p_text.length() < 10:
		fail("no reason: '%s'" % p_text)


func _is_empty(p_text: String) -> void:
	if p_text != "":
		fail(p_text)
