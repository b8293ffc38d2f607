extends TestCase
## Large packets in parts.


func test_parts_fit_a_datagram_and_join_again() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 5
	var joiner: MessageParts = MessageParts.new()
	for size: int in [1, 10, MessageParts.ROOM, MessageParts.ROOM + 1, 20000]:
		var bytes: PackedByteArray = PackedByteArray()
		for i: int in size:
			bytes.append(random.randi() & 255)
		var parts: Array[PackedByteArray] = MessageParts.split(bytes, size)
		equal(parts.size(), ceili(float(size) / MessageParts.ROOM))
		var whole: PackedByteArray = PackedByteArray()
		for part: PackedByteArray in parts:
			is_true(part.size() <= Protocol.MAX_DATAGRAM)
			is_true(whole.is_empty(), "complete before the last part")
			whole = joiner.join(part)
		equal(whole, bytes)


func test_parts_of_different_packets_do_not_mix() -> void:
	var bytes: PackedByteArray = PackedByteArray()
	bytes.resize(3000)
	var first: Array[PackedByteArray] = MessageParts.split(bytes, 1)
	bytes.fill(7)
	var second: Array[PackedByteArray] = MessageParts.split(bytes, 2)
	var joiner: MessageParts = MessageParts.new()
	joiner.join(first[0])
	is_true(joiner.join(second[1]).is_empty())
	is_true(joiner.join(first[2]).is_empty(), "a part is missing")
	for part: PackedByteArray in second:
		bytes = joiner.join(part)
	equal(bytes.size(), 3000)
	equal(bytes.count(7), 3000)


func test_no_part_is_taken_beyond_the_last_or_the_most() -> void:
	for announced: int in [0, 2, 5]:
		var joiner: MessageParts = MessageParts.new(4)
		for number: int in 20:
			var part: PackedByteArray = MessageParts.split([1, 2, 3], 9)[0]
			part.encode_u16(3, number)
			part.encode_u16(5, announced)
			var is_whole: bool = announced == 2 and number == 1
			equal(joiner.join(part).size(), 6 if is_whole else 0)
			equal(joiner.packet, 9 if announced == 2 and number < 2 else -1)


func test_garbage_is_no_part() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 6
	var joiner: MessageParts = MessageParts.new()
	for i: int in 5000:
		var bytes: PackedByteArray = PackedByteArray()
		for at: int in random.randi_range(0, 20):
			bytes.append(random.randi() & 255)
		is_true(joiner.join(bytes).size() < Protocol.MAX_DATAGRAM)
