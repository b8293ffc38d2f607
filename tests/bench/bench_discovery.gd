extends Bench
## How soon a client finds all servers of a network, on this machine, and how large answers are
## beside their questions.
##
## Options: --servers=100, --forged=10000 (answers that a forger sends who is asked, too),
## --rounds=5. Goals: no answer is longer than its question; all servers found within 2 s, with
## forged answers and without.

const AnsweringServer := preload("res://tests/net/discovery/answering_server.gd")
const _HERE: String = "127.0.0.1"
const _GOAL_S: float = 2.0
const _GIVE_UP_S: float = 10.0
const _QUESTION_BYTES: int = 512

var _servers: Array[AnsweringServer] = []
var _forger: PacketPeerUDP = PacketPeerUDP.new()
var _forged: int = 0


func options() -> Dictionary:
	return {"servers": [100, 1, 250], "forged": [10000, 0, 1000000], "rounds": [5, 1, 1000]}


func measure() -> void:
	_forger.bind(0, _HERE)
	for i: int in option("servers") as int:
		var server: AnsweringServer = AnsweringServer.open("Server %d" % i)
		server.said.name = "日".repeat(1000)
		server.said.world = "w".repeat(1000)
		server.said.scenario = "s".repeat(1000)
		server.said.program = "p".repeat(1000)
		server.announce()
		_servers.append(server)
	var answer_bytes: int = _servers[0].said.encode().size() + 9
	var share: float = float(answer_bytes) / _QUESTION_BYTES
	report.at_most("answer", "largest, of the question", share, "", 1.0)
	for is_forged: bool in [false, true]:
		await _find(is_forged)
	for server: AnsweringServer in _servers:
		server.close()
	_forger.close()


func _find(p_is_forged: bool) -> void:
	var times: Statistics = Statistics.new()
	var found: int = _servers.size()
	var polls: Statistics = Statistics.new()
	for _round: int in option("rounds") as int:
		var finder: ServerFinder = ServerFinder.new()
		finder.hosts = [_HERE]
		finder.ports = _ports(p_is_forged)
		_forged = 0
		var begin: int = Time.get_ticks_usec()
		var now_s: float = 0.0
		finder.begin()
		while _count(finder) < _servers.size() and now_s < _GIVE_UP_S:
			var before: int = Time.get_ticks_usec()
			finder.poll()
			polls.add((Time.get_ticks_usec() - before) / 1e3)
			if p_is_forged:
				_forge()
			await process_frame
			now_s = (Time.get_ticks_usec() - begin) / 1e6
		times.add(now_s)
		found = mini(found, _count(finder))
		finder.close()
	var case: String = "with %d forged answers" % option("forged") if p_is_forged else "calm"
	report.at_least(case, "servers found", found, "", _servers.size())
	report.at_most(case, "time until all are found, longest", times.percentile(1.0), "s", _GOAL_S)
	report.add(case, "a look of the client, p99", polls.percentile(0.99), "ms")


## The forger knows the nonce of the question that he is asked, and answers it as often as he can.
func _forge() -> void:
	var nonce: PackedByteArray = []
	while _forger.get_available_packet_count() > 0:
		nonce = _forger.get_packet().slice(6, 14)
		_forger.set_dest_address(_forger.get_packet_ip(), _forger.get_packet_port())
	if nonce.is_empty():
		return
	var said: ServerAnnouncement = ServerAnnouncement.new()
	said.name = "Forged"
	while _forged < (option("forged") as int):
		said.run = _forged
		_forger.put_packet(PackedByteArray([0x4C]) + nonce + said.encode())
		_forged += 1


func _ports(p_is_forged: bool) -> PackedInt32Array:
	var ports: PackedInt32Array = []
	if p_is_forged:
		ports.append(_forger.get_local_port())
	for server: AnsweringServer in _servers:
		ports.append(server.port)
	return ports


func _count(p_finder: ServerFinder) -> int:
	var count: int = 0
	for server: FoundServer in p_finder.servers():
		if server.answers() and server.title() != "Forged":
			count += 1
	return count
