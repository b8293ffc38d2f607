extends TestCase
## The motion set of somebody who walks, in parts, and the answer.

const ROUNDS: int = 10000

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 9


func test_a_set_comes_as_it_was_sent() -> void:
	for size: int in [1, MessageParts.ROOM, MessageParts.ROOM + 1, MotionSetMessage.MAX_BYTES]:
		var bytes: PackedByteArray = _noise(size)
		var parts: MessageParts = MessageParts.new(MotionSetMessage.MAX_PARTS)
		var whole: PackedByteArray = []
		for message: PackedByteArray in MotionSetMessage.split(bytes, 7):
			is_true(whole.is_empty() and message.size() <= Protocol.MAX_DATAGRAM)
			equal(message[0], Protocol.Message.MOTION_SET)
			is_false(MotionSetMessage.is_too_large(message))
			whole = parts.join(message)
		equal(whole == bytes, true)
		equal(parts.packet, 7)


func test_one_that_is_too_large_is_not_sent_and_not_joined() -> void:
	var bytes: PackedByteArray = []
	bytes.resize(MotionSetMessage.MAX_BYTES + 1)
	equal(MotionSetMessage.split(bytes, 1).size(), 0)
	bytes.resize(MotionSetMessage.MAX_BYTES + MessageParts.ROOM)
	var parts: MessageParts = MessageParts.new(MotionSetMessage.MAX_PARTS)
	var messages: Array[PackedByteArray] = MessageParts.split(bytes, 1, Protocol.Message.MOTION_SET)
	is_true(MotionSetMessage.is_too_large(messages[0]))
	for message: PackedByteArray in messages:
		is_true(parts.join(message).is_empty())


func test_an_answer_comes_as_it_was_sent() -> void:
	for outcome: MotionSetMessage.Outcome in MotionSetMessage.Outcome.values():
		var bytes: PackedByteArray = MotionSetMessage.answer(65535, outcome, "it is large")
		var message: MotionSetMessage = MotionSetMessage.decode_answer(bytes)
		equal([message.number, message.outcome, message.text], [65535, outcome, "it is large"])
		bytes.append(0)
		equal(MotionSetMessage.decode_answer(bytes), null)
	equal(MotionSetMessage.decode_answer([26, 0, 0, 2, 0, 0] as PackedByteArray), null)


func test_ten_thousand_broken_parts_and_answers() -> void:
	var good: Array[PackedByteArray] = MotionSetMessage.split(_noise(4000), 9)
	good.append(MotionSetMessage.answer(3, MotionSetMessage.Outcome.REFUSED, "too soon"))
	var parts: MessageParts = MessageParts.new(MotionSetMessage.MAX_PARTS)
	for round: int in ROUNDS:
		var bytes: PackedByteArray = good[round % good.size()].duplicate()
		for i: int in _random.randi_range(0, 4):
			bytes[_random.randi_range(0, 9)] = _random.randi_range(0, 255)
		bytes.resize(_random.randi_range(0, bytes.size()))
		MotionSetMessage.is_too_large(bytes)
		is_true(parts.join(bytes).size() <= 4 * Protocol.MAX_DATAGRAM)
		var message: MotionSetMessage = MotionSetMessage.decode_answer(bytes)
		if message != null:
			is_true(MotionSetMessage.Outcome.values().has(message.outcome))


func _noise(p_size: int) -> PackedByteArray:
	var words: PackedInt32Array = []
	words.resize(ceili(p_size / 4.0))
	for i: int in words.size():
		words[i] = _random.randi()
	return words.to_byte_array().slice(0, p_size)
