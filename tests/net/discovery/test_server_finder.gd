extends TestCase
## Real servers of this machine are found, and forged ones do no harm. Nothing leaves the machine:
## the finder is told whom to ask.

const AnsweringServer := preload("res://tests/net/discovery/answering_server.gd")
const HERE: String = "127.0.0.1"

var _finder: ServerFinder = null


func goes_by_clock() -> bool:
	return true


func after_each() -> void:
	if _finder != null:
		_finder.close()
	_finder = null


func test_a_server_is_found_changes_and_vanishes() -> void:
	for seals: bool in [true, false]:
		var server: AnsweringServer = AnsweringServer.open("Hall", seals)
		server.said.world = "town"
		server.said.locked_roles = 1 << Roles.Role.TRAINEE
		server.announce()
		_begin([server.port])
		await _until(
			func() -> bool:
				return _names() == ["Hall"] and _finder.servers()[0].announcement.world == "town"
		)
		var found: FoundServer = _finder.servers()[0]
		equal([found.address.host, found.address.port], [HERE, server.port], "where it is")
		is_true(found.needs_password(Roles.Role.TRAINEE), "a trainee needs a password")
		is_true(not found.needs_password(Roles.Role.OBSERVER), "an observer needs none")
		is_true(found.delay_s >= 0.0 and found.delay_s < 3.0, "%f s there and back" % found.delay_s)
		is_true(found.is_same_version() and found.answers(), "it answers")
		server.said.people = 5
		server.announce()
		await _until(func() -> bool: return _finder.servers()[0].announcement.people == 5)
		server.close()
		await _until(func() -> bool: return _finder.servers().is_empty())
		is_true(true, "it was found, has changed and is gone")
		after_each()


func test_a_favourite_stays_though_nothing_answers() -> void:
	var server: AnsweringServer = AnsweringServer.open("Hall")
	_finder = ServerFinder.new()
	_finder.want(ServerAddress.parse("%s:%d" % [HERE, server.port]))
	_finder.want(ServerAddress.parse("localhost:%d" % server.port))
	_finder.begin()
	equal(_names(), ["%s:%d" % [HERE, server.port], "localhost:%d" % server.port], "at first")
	await _until(func() -> bool: return _names() == ["Hall", "Hall"])
	server.close()
	await _until(
		func() -> bool:
			return not _finder.servers().any(func(one: FoundServer) -> bool: return one.answers())
	)
	equal(_names(), ["Hall", "Hall"], "both stay")
	for found: FoundServer in _finder.servers():
		_finder.unwant(found)
	equal(_finder.servers().size(), 0, "who does not answer is gone then")


func test_a_server_with_several_addresses_is_one() -> void:
	var server: AnsweringServer = AnsweringServer.open("Hall")
	_finder = ServerFinder.new()
	_finder.hosts = [HERE]
	_finder.ports = [server.port]
	_finder.begin()
	await _until(func() -> bool: return _names() == ["Hall"])
	_finder.want(ServerAddress.parse("localhost:%d" % server.port))
	await _until(func() -> bool: return _finder.servers()[0].answers())
	equal(_names(), ["Hall"], "one entry")
	equal(_finder.servers()[0].address.host, "localhost", "by the address that the user gave")
	server.close()


func test_ten_thousand_forged_answers_do_no_harm() -> void:
	var server: AnsweringServer = AnsweringServer.open("Hall")
	var forger: PacketPeerUDP = PacketPeerUDP.new()
	equal(forger.bind(0, HERE), OK, "the forger has a port")
	_finder = ServerFinder.new()
	_finder.hosts = [HERE]
	_finder.ports = [server.port, forger.get_local_port()]
	_finder.begin()
	# A forger who is asked knows a question: he answers it 10,000 times, with and without its nonce.
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	var sent: int = 0
	while sent < 10000:
		_finder.poll()
		while forger.get_available_packet_count() > 0:
			var question: PackedByteArray = forger.get_packet()
			equal(question.size(), 512, "the question's size")
			forger.set_dest_address(forger.get_packet_ip(), forger.get_packet_port())
			for i: int in 2500:
				forger.put_packet(_forged(question.slice(6, 14), random, i))
				sent += 1
		await process_frames(1)
	await _until(func() -> bool: return _names().has("Hall"))
	is_true(_finder.servers().size() <= 2, "one entry of the forger at most: %s" % [_names()])
	server.close()
	forger.close()


func test_the_list_has_an_end_and_who_answers_keeps_the_place() -> void:
	_finder = ServerFinder.new()
	for i: int in 400:
		var answer: DiscoveryAnswer = DiscoveryAnswer.new()
		answer.address = "192.0.2.%d" % (i % 250)
		answer.port = 7777 + floori(i / 250.0)
		var said: ServerAnnouncement = ServerAnnouncement.new()
		said.name = "Server %d" % i
		said.run = i + 1
		_finder.call("_take", answer, said)
	equal(_finder.servers().size(), ServerFinder.MAX_FOUND, "the list is full")
	equal(_names()[0], "Server 0", "those who came first are there")


func _begin(p_ports: PackedInt32Array) -> void:
	_finder = ServerFinder.new()
	_finder.hosts = [HERE]
	_finder.ports = p_ports
	_finder.begin()


func _names() -> Array:
	return _finder.servers().map(func(one: FoundServer) -> String: return one.title())


func _until(p_is_so: Callable) -> void:
	await until(p_is_so, _finder.poll)


func _forged(
	p_nonce: PackedByteArray, p_random: RandomNumberGenerator, p_index: int
) -> PackedByteArray:
	var said: ServerAnnouncement = ServerAnnouncement.new()
	said.name = "Forged %d" % p_index
	said.run = p_random.randi()
	var nonce: PackedByteArray = p_nonce.duplicate()
	if p_index % 3 == 0:
		nonce[p_index % 8] ^= 1 + p_random.randi() % 255
	var bytes: PackedByteArray = PackedByteArray([0x4C]) + nonce + said.encode()
	if p_index % 3 == 1:
		bytes[9 + p_random.randi() % (bytes.size() - 9)] = p_random.randi() & 0xFF
	return bytes
