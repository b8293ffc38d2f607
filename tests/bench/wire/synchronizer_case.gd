extends Node
## The same world by way of Godot's own MultiplayerSynchronizer, over real sockets: server and
## client are two branches of the tree, each with a multiplayer API of its own.

const MovingWorld: GDScript = preload("moving_world.gd")

## Bits that the server has sent to its client, with headers of UDP, IP and ENet.
var bits: int = 0

var _since_usec: int = 0

var _server: Node3D = Node3D.new()
var _client: Node3D = Node3D.new()
var _server_peer: ENetMultiplayerPeer = ENetMultiplayerPeer.new()
var _client_peer: ENetMultiplayerPeer = ENetMultiplayerPeer.new()
var _limbs: Array[Node3D] = []
var _boxes: Array[Node3D] = []


## Begins; the node must be in the tree. Returns whether there is a port for it.
func open(p_people: int, p_crates: int, p_rate: int) -> bool:
	var probe: PacketPeerUDP = PacketPeerUDP.new()
	probe.bind(0, "127.0.0.1")
	var port: int = probe.get_local_port()
	probe.close()
	if (
		_server_peer.create_server(port) != OK
		or _client_peer.create_client("127.0.0.1", port) != OK
	):
		return false
	for end: Array in [[_server, _server_peer], [_client, _client_peer]]:
		var branch: Node3D = end[0]
		add_child(branch)
		var api: SceneMultiplayer = SceneMultiplayer.new()
		get_tree().set_multiplayer(api, branch.get_path())
		api.multiplayer_peer = end[1]
		_fill(branch, p_people, p_crates, p_rate)
	for person: int in p_people:
		for limb: int in Limbs.COUNT:
			_limbs.append(_server.get_node("Person%d/Limb%d" % [person, limb]))
	for crate: int in p_crates:
		_boxes.append(_server.get_node("Crate%d" % crate))
	return true


## Whether the client has joined.
func is_joined() -> bool:
	return _client_peer.get_connection_status() == MultiplayerPeer.CONNECTION_CONNECTED


## Begins to count.
func restart() -> void:
	bits = 0
	_since_usec = Time.get_ticks_usec()
	_server_peer.host.pop_statistic(ENetConnection.HOST_TOTAL_SENT_DATA)
	_server_peer.host.pop_statistic(ENetConnection.HOST_TOTAL_SENT_PACKETS)


## Puts everything where it is after a step.
func put(p_world: MovingWorld, p_time_s: float) -> void:
	for person: int in p_world.people.size():
		var sample: PoseSample = p_world.pose(person, p_time_s)
		for limb: int in Limbs.COUNT:
			var node: Node3D = _limbs[person * Limbs.COUNT + limb]
			node.position = sample.root
			node.quaternion = sample.orientation(limb)
	for crate: int in p_world.crates.size():
		_boxes[crate].transform = p_world.crates[crate].transform
	var host: ENetConnection = _server_peer.host
	var packets: int = int(host.pop_statistic(ENetConnection.HOST_TOTAL_SENT_PACKETS))
	bits += (int(host.pop_statistic(ENetConnection.HOST_TOTAL_SENT_DATA)) + 28 * packets) * 8


## Bits per second. The engine counts its interval in real time, however fast the simulation runs.
func rate() -> float:
	return bits / ((Time.get_ticks_usec() - _since_usec) / 1e6)


## Ends.
func close() -> void:
	_client_peer.close()
	_server_peer.close()


static func _fill(p_branch: Node3D, p_people: int, p_crates: int, p_rate: int) -> void:
	for person: int in p_people:
		var body: Node3D = Node3D.new()
		body.name = "Person%d" % person
		var paths: Array[String] = []
		for limb: int in Limbs.COUNT:
			var node: Node3D = Node3D.new()
			node.name = "Limb%d" % limb
			body.add_child(node)
			paths.append(str(node.name))
		_watch(body, paths, p_rate)
		p_branch.add_child(body)
	for crate: int in p_crates:
		var box: Node3D = Node3D.new()
		box.name = "Crate%d" % crate
		_watch(box, ["."], p_rate)
		p_branch.add_child(box)


static func _watch(p_node: Node3D, p_paths: Array[String], p_rate: int) -> void:
	var watcher: MultiplayerSynchronizer = MultiplayerSynchronizer.new()
	watcher.name = "Watcher"
	var config: SceneReplicationConfig = SceneReplicationConfig.new()
	for path: String in p_paths:
		config.add_property(NodePath(path + ":position"))
		config.add_property(NodePath(path + ":quaternion"))
	watcher.replication_config = config
	watcher.replication_interval = 1.0 / p_rate
	p_node.add_child(watcher)
