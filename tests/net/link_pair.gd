extends RefCounted
## A server and clients in one process, over 127.0.0.1, and what they told.

## Who joined the server: peer to greeting.
var joined: Dictionary[int, Dictionary] = {}
## Who left the server.
var left: Array[int] = []
## Samples that came: peer to list.
var poses: Dictionary[int, Array] = {}
## The server's end.
var server: ServerLink = ServerLink.new()
## The server's UDP port.
var port: int = 0
## Clients with what they heard.
var ends: Array[End] = []


## A client's end with what it heard.
class End:
	var link: ClientLink = ClientLink.new()
	var joined: int = 0
	var refusal: String = ""
	var loss: String = ""
	var snapshots: Array[Snapshot] = []
	var worlds: Array[WorldDescription] = []

	func _init() -> void:
		link.joined.connect(_on_joined)
		link.refused.connect(_on_refused)
		link.lost.connect(_on_lost)
		link.snapshot_received.connect(_on_snapshot)
		link.world_received.connect(_on_world)

	func _on_joined() -> void:
		joined += 1

	func _on_refused(p_why: String) -> void:
		refusal = p_why

	func _on_lost(p_why: String) -> void:
		loss = p_why

	func _on_snapshot(p_snapshot: Snapshot, _p_bytes: PackedByteArray) -> void:
		snapshots.append(p_snapshot)

	func _on_world(p_world: WorldDescription, _p_bytes: PackedByteArray) -> void:
		worlds.append(p_world)


## Opens a server on a free port.
func listen(p_most_clients: int = 8) -> Error:
	var probe: PacketPeerUDP = PacketPeerUDP.new()
	probe.bind(0, "127.0.0.1")
	port = probe.get_local_port()
	probe.close()
	server.client_joined.connect(_on_joined)
	server.client_left.connect(_on_left)
	server.pose_received.connect(_on_pose)
	return server.listen(port, p_most_clients)


## A client that begins to join.
func add(p_role: Protocol.Role, p_name: String = "Ada", p_version: int = Protocol.VERSION) -> End:
	return add_raw(Protocol.encode_hello(p_role, p_name, 0.97, p_version))


## A client that has joined, on both sides.
func join(p_role: Protocol.Role, p_name: String = "Ada") -> End:
	var before: int = joined.size()
	var end: End = add(p_role, p_name)
	until(func() -> bool: return end.joined == 1 and joined.size() == before + 1)
	return end


## A client that says something else first.
func add_raw(p_hello: PackedByteArray) -> End:
	var end: End = End.new()
	ends.append(end)
	end.link.open("127.0.0.1", port, p_hello)
	return end


## Polls everybody until something holds, for so many seconds at most. Returns whether it holds.
func until(p_holds: Callable, p_limit_s: float = 3.0) -> bool:
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
	for end: End in ends:
		end.link.poll()


## Ends everything.
func close() -> void:
	for end: End in ends:
		end.link.close()
	server.close()


## Number of samples that came from all.
func pose_count() -> int:
	var count: int = 0
	for peer: int in poses:
		count += poses[peer].size()
	return count


func _on_joined(p_peer: int, p_hello: Dictionary) -> void:
	joined[p_peer] = p_hello


func _on_left(p_peer: int) -> void:
	left.append(p_peer)


func _on_pose(p_peer: int, p_sample: PoseSample) -> void:
	poses.get_or_add(p_peer, []).append(p_sample)
