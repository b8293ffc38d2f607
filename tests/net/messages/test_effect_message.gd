extends TestCase

const ROUNDS: int = 10000

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 5


func test_a_file_comes_as_it_was_sent() -> void:
	for size: int in [0, 1, EffectMessage.ROOM, EffectMessage.ROOM + 1, EffectLimits.MAX_BYTES]:
		var bytes: PackedByteArray = _noise(size)
		var parts: EffectParts = EffectParts.new()
		var whole: int = 0
		for message: PackedByteArray in EffectMessage.split(7, "x".repeat(40), bytes):
			is_true(message.size() <= Protocol.MAX_DATAGRAM)
			var part: EffectMessage = EffectMessage.decode(message)
			equal([part.number, part.name], [7, "x".repeat(40)])
			whole += int(parts.take(part))
		equal(whole, 1)
		equal(parts.bytes, bytes)


func test_one_that_is_too_large_is_not_sent() -> void:
	equal(EffectMessage.split(1, "smoke", _noise(EffectLimits.MAX_BYTES + 1)).size(), 0)


func test_a_new_file_replaces_an_unfinished_one() -> void:
	var parts: EffectParts = EffectParts.new()
	var first: Array[PackedByteArray] = EffectMessage.split(1, "smoke", _noise(5000))
	var second: Array[PackedByteArray] = EffectMessage.split(2, "smoke", _noise(3000))
	is_false(parts.take(EffectMessage.decode(first[0])))
	is_false(parts.take(EffectMessage.decode(second[0])))
	is_false(parts.take(EffectMessage.decode(second[1])))
	is_true(parts.take(EffectMessage.decode(second[2])))
	equal(parts.bytes.size(), 3000)
	is_false(parts.take(EffectMessage.decode(first[1])))


func test_parts_that_do_not_fit_are_dropped() -> void:
	var parts: EffectParts = EffectParts.new()
	var messages: Array[PackedByteArray] = EffectMessage.split(1, "smoke", _noise(5000))
	is_false(parts.take(EffectMessage.decode(messages[1])))
	for i: int in [0, 2, 1, 3, 4]:
		is_false(parts.take(EffectMessage.decode(messages[i])))


func test_ten_thousand_broken_messages() -> void:
	var good: Array[PackedByteArray] = EffectMessage.split(9, "smoke", _noise(4000))
	var parts: EffectParts = EffectParts.new()
	var accepted: int = 0
	for round: int in ROUNDS:
		var bytes: PackedByteArray = good[round % good.size()].duplicate()
		for i: int in _random.randi_range(0, 4):
			bytes[_random.randi_range(0, 14)] = _random.randi_range(0, 255)
		bytes.resize(_random.randi_range(0, bytes.size()))
		var message: EffectMessage = EffectMessage.decode(bytes)
		if message == null:
			continue
		accepted += 1
		if not EffectLimits.is_name(message.name) or message.part >= message.parts:
			fail("%s %d of %d" % [message.name, message.part, message.parts])
		parts.take(message)
		is_true(parts.bytes.size() <= EffectLimits.MAX_BYTES)
	is_true(accepted > 100 and accepted < ROUNDS - 100, "%d" % accepted)


func _noise(p_size: int) -> PackedByteArray:
	var bytes: PackedByteArray = []
	bytes.resize(p_size)
	for i: int in p_size:
		bytes[i] = _random.randi_range(0, 255)
	return bytes
