extends TestCase
## What a server says of itself, and what others may send in its place.


func test_all_comes_back() -> void:
	var said: ServerAnnouncement = _full()
	var read: ServerAnnouncement = ServerAnnouncement.decode(said.encode())
	for property: String in ["protocol", "run", "people", "places", "locked_roles", "seals"]:
		equal(read.get(property), said.get(property), property)
	for property: String in ["has_waiting_room", "name", "world", "scenario", "program"]:
		equal(read.get(property), said.get(property), property)


func test_no_answer_is_longer_than_its_question() -> void:
	var said: ServerAnnouncement = _full()
	for letter: String in ["x", "é", "日", "𝄞", "\u202e", " "]:
		said.name = letter.repeat(10000)
		said.world = letter.repeat(10000)
		said.scenario = letter.repeat(10000)
		said.program = letter.repeat(10000)
		said.people = 1 << 40
		var bytes: PackedByteArray = said.encode()
		is_true(bytes.size() <= 512 - 9, "an answer has %d bytes at most" % bytes.size())
		var read: ServerAnnouncement = ServerAnnouncement.decode(bytes)
		is_true(read != null and read.people == 65535, "it is read: %s" % letter)
		is_true(read.name.to_utf8_buffer().size() <= ServerAnnouncement.MAX_NAME, "the name fits")


func test_nobody_looks_like_somebody_else() -> void:
	var said: ServerAnnouncement = _full()
	said.name = "To\u200bwn\u202e hall\n\t\u0007"
	equal(ServerAnnouncement.decode(said.encode()).name, "Town hall", "unseen letters are left out")
	var bytes: PackedByteArray = _full().encode()
	bytes.encode_u8(20, 7)
	is_true(ServerAnnouncement.decode(bytes) == null, "a bell in a name is refused")


func test_later_versions_are_read() -> void:
	var bytes: PackedByteArray = _full().encode()
	bytes.encode_u8(0, 9)
	bytes.append_array([1, 2, 3, 4])
	equal(ServerAnnouncement.decode(bytes).name, "Hall", "what is new is left unread")
	bytes.encode_u8(0, 0)
	is_true(ServerAnnouncement.decode(bytes) == null, "there is no version 0")


func test_any_bytes_are_survived() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 36
	var good: PackedByteArray = _full().encode()
	var read: int = 0
	for size: int in good.size():
		is_true(
			ServerAnnouncement.decode(good.slice(0, size)) == null, "%d bytes are too few" % size
		)
	for i: int in 5000:
		var bytes: PackedByteArray = good.duplicate()
		for _change: int in 1 + i % 8:
			bytes[random.randi() % bytes.size()] = random.randi() & 0xFF
		var said: ServerAnnouncement = ServerAnnouncement.decode(bytes)
		if said != null:
			read += 1
			is_true(ServerAnnouncement.decode(said.encode()) != null, "what was read can be said")
	for _i: int in 5000:
		var noise: PackedByteArray = []
		for _byte: int in random.randi() % 120:
			noise.append(random.randi() & 0xFF)
		ServerAnnouncement.decode(noise)
	is_true(read > 0, "some altered ones are read")


func _full() -> ServerAnnouncement:
	var said: ServerAnnouncement = ServerAnnouncement.new()
	said.run = -0x123456789ABCDEF
	said.people = 3
	said.places = 32
	said.locked_roles = 5
	said.has_waiting_room = true
	said.seals = true
	said.name = "Hall"
	said.world = "town"
	said.scenario = "evacuation"
	said.program = "0.9"
	return said
