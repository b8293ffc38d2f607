extends RefCounted
## A server and clients in one process, over 127.0.0.1, and what they told.

const SnapshotStream: GDScript = preload("res://tests/wire/snapshot_stream.gd")
## How long a busy machine may take for what is certain to come, s.
const PATIENCE_S: float = 60.0
## Ports that the system gives to nobody by itself.
const FIRST_PORT: int = 20000
const LAST_PORT: int = 32767

## Who joined the server: session to join request.
var joined: Dictionary[int, Dictionary] = {}
## Who left the server.
var left: Array[int] = []
## Whose connection was lost.
var lost: Array[int] = []
## Who came back.
var returned: Array[int] = []
## Samples that came: session to list.
var poses: Dictionary[int, Array] = {}
## Acknowledgements that came.
var acks: Array[PackedByteArray] = []
## The server's end.
var server: ServerLink = ServerLink.new()
## Whom the server lets in.
var rules: ServerRules = ServerRules.new()
## The server's UDP port.
var port: int = 0
## Called with each poll of the server, if valid.
var on_poll: Callable = Callable()
## Clients with what they heard.
var ends: Array[End] = []


func _init() -> void:
	# All come from one address.
	rules.max_per_address = 0


## A client's end with what it heard.
class End:
	var link: ClientLink = ClientLink.new()
	var request: JoinRequest = JoinRequest.new()
	var joined: int = 0
	var refusal: String = ""
	var loss: String = ""
	var places: Array[int] = []
	var waits_for: JoinReply.Wait = JoinReply.Wait.INSTRUCTOR
	## Ticks of the snapshots that made sense.
	var snapshots: Array[int] = []
	## Bodies that snapshots told of.
	var bodies: Dictionary[int, bool] = {}
	var datagrams: int = 0
	## Tables that came.
	var tables: Array[EntityTableMessage] = []
	var _decoder: SnapshotDecoder = SnapshotStream.decoder()

	func _init() -> void:
		link.joined.connect(_on_joined)
		link.refused.connect(_on_refused)
		link.lost.connect(_on_lost)
		link.waiting.connect(_on_waiting)
		link.state_received.connect(_on_state)

	## The client's peer; another one after each [method ClientLink.open].
	func peer() -> ThreadedPeer:
		return link.api().multiplayer_peer

	## Cuts the connection without a reason.
	func cut() -> void:
		peer().close_with(DisconnectReason.LOST)

	## Sends a sample, coded against nothing.
	func send(p_sample: PoseSample) -> void:
		link.send_fast(SampleWriter.new().write([p_sample] as Array[PoseSample])[0])

	func _on_joined() -> void:
		joined += 1
		_decoder.clear()

	func _on_refused(p_why: String) -> void:
		refusal = p_why

	func _on_lost(p_why: String) -> void:
		loss = p_why

	func _on_waiting(p_place: int, p_for: JoinReply.Wait) -> void:
		places.append(p_place)
		waits_for = p_for

	func _on_state(p_bytes: PackedByteArray, _p_arrival_usec: int) -> void:
		if p_bytes[0] == Protocol.Message.TABLE:
			tables.append(EntityTableMessage.decode(p_bytes, []))
		if not Protocol.SNAPSHOTS.has(int(p_bytes[0])):
			return
		datagrams += 1
		if _decoder.decode(p_bytes) == SnapshotDecoder.OK:
			snapshots.append(_decoder.get_tick())
			for body: int in _decoder.get_bodies():
				bodies[body] = true


## Sends everybody a snapshot of a world, a tick on.
func send_snapshot(p_stream: SnapshotStream) -> void:
	p_stream.move()
	for session: int in joined:
		send_to(session, p_stream.datagrams(session))


## Sends everybody who is here a message, reliably.
func send_reliably(p_bytes: PackedByteArray) -> void:
	server.send_reliably(server.session_ids(), p_bytes)


## Sends a client datagrams.
func send_to(p_session: int, p_datagrams: Array[PackedByteArray]) -> void:
	var sessions: PackedInt32Array = []
	for _datagram: PackedByteArray in p_datagrams:
		sessions.append(p_session)
	server.send_datagrams(sessions, p_datagrams)


## Opens a server on a free port, and seals unless [member rules] say otherwise.
func listen(p_most_clients: int = 8) -> Error:
	port = free_port()
	rules.max_clients = p_most_clients
	server.client_joined.connect(_on_joined)
	server.client_left.connect(left.append)
	server.client_lost.connect(lost.append)
	server.client_returned.connect(returned.append)
	server.pose_received.connect(_on_pose)
	server.ack_received.connect(_on_ack)
	return server.listen(port, rules)


## A UDP port that nobody uses at the moment, and none of those that the system gives out by itself:
## between this call and its use a client could be given it.
static func free_port() -> int:
	# Tests that run beside this one may have the same seed.
	var chance: RandomNumberGenerator = RandomNumberGenerator.new()
	chance.randomize()
	var probe: PacketPeerUDP = PacketPeerUDP.new()
	var found: int = chance.randi_range(FIRST_PORT, LAST_PORT)
	while probe.bind(found, "127.0.0.1") != OK:
		found = chance.randi_range(FIRST_PORT, LAST_PORT)
	probe.close()
	return found


## A client that begins to join.
func add(
	p_role: Roles.Role,
	p_name: String = "Ada",
	p_version: int = Protocol.VERSION,
	p_password: String = ""
) -> End:
	var end: End = End.new()
	end.request.role = p_role
	end.request.name = p_name
	end.request.version = p_version
	end.link.seals = rules.seals
	ends.append(end)
	end.link.open("127.0.0.1", port, end.request, p_password)
	return end


## A client that has joined, on both sides.
func join(p_role: Roles.Role, p_name: String = "Ada", p_password: String = "") -> End:
	var end: End = add(p_role, p_name, Protocol.VERSION, p_password)
	await_join(end)
	return end


## Polls everybody until a client has joined, on both sides. Who listens for what the server sends
## at once begins before.
func await_join(p_end: End) -> void:
	until(func() -> bool: return p_end.joined == 1 and joined.has(p_end.link.session))


## Polls everybody until something holds, for so many seconds at most. Returns whether it holds.
func until(p_holds: Callable, p_limit_s: float = PATIENCE_S) -> bool:
	var limit: int = Time.get_ticks_usec() + int(p_limit_s * 1e6)
	while Time.get_ticks_usec() < limit:
		poll()
		if p_holds.call():
			return true
		OS.delay_usec(1000)
	return false


## Polls everybody for so many seconds.
func run(p_seconds: float) -> void:
	until(func() -> bool: return false, p_seconds)


## Polls everybody once.
func poll() -> void:
	server.poll()
	if on_poll.is_valid():
		on_poll.call()
	for end: End in ends:
		end.link.poll()


## The server's peer.
func server_peer() -> ThreadedPeer:
	return server.api().multiplayer_peer


## Ends everything.
func close() -> void:
	for end: End in ends:
		end.link.close()
	server.close()


## Number of samples that came from all.
func pose_count() -> int:
	var count: int = 0
	for session: int in poses:
		count += poses[session].size()
	return count


func _on_joined(p_session: int, p_hello: Dictionary) -> void:
	joined[p_session] = p_hello


func _on_pose(p_session: int, p_sample: PoseSample, _p_arrival_usec: int) -> void:
	poses.get_or_add(p_session, []).append(p_sample)


func _on_ack(_p_session: int, p_bytes: PackedByteArray, _p_arrival_usec: int) -> void:
	acks.append(p_bytes)
