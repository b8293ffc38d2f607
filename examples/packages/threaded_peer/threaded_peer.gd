extends Node
## Two programs that talk over a [ThreadedPeer]: the server spawns a ball for each client, whose
## button pushes it by a remote call; the server answers each push by one.
##
## Start it once with [code]-- --server[/code], and as often as you like without.

## A ball is there, on the server and on every client.
signal spawned(p_ball: Node3D)
## The server has answered a push; on a client.
signal answered(p_pushes: int)

const _PORT: int = 7780

var _peer: ThreadedPeer = ThreadedPeer.new()
var _pushes: int = 0

@onready var _balls: Node3D = $Balls
@onready var _spawner: MultiplayerSpawner = $Spawner


func _ready() -> void:
	_spawner.spawn_function = _make_ball
	_balls.child_entered_tree.connect(func(ball: Node) -> void: spawned.emit(ball))
	var port: int = _read_port()
	if OS.get_cmdline_user_args().has("--server"):
		var error: Error = _peer.create_server(port)
		if error != OK:
			push_error("UDP port %d cannot be opened: %s" % [port, error_string(error)])
			return
		multiplayer.peer_connected.connect(_on_peer_connected)
		multiplayer.peer_disconnected.connect(_on_peer_disconnected)
	else:
		_peer.create_client("127.0.0.1", port)
		_peer.failed.connect(func(why: String) -> void: push_warning(why))
	multiplayer.multiplayer_peer = _peer


func _exit_tree() -> void:
	_peer.close()


## Pushes the ball of this client.
func push() -> void:
	_push.rpc_id(1, Vector3.RIGHT)


@rpc("any_peer", "call_remote", "reliable")
func _push(p_by: Vector3) -> void:
	if not multiplayer.is_server() or not p_by.is_finite() or p_by.length() > 1.0:
		return
	var ball: Node3D = _balls.get_node_or_null(str(multiplayer.get_remote_sender_id()))
	if ball == null:
		return
	ball.position += p_by
	_pushes += 1
	_answer.rpc_id(multiplayer.get_remote_sender_id(), _pushes)


@rpc("authority", "call_remote", "reliable")
func _answer(p_pushes: int) -> void:
	answered.emit(p_pushes)


func _on_peer_connected(p_id: int) -> void:
	_spawner.spawn(p_id)


func _on_peer_disconnected(p_id: int) -> void:
	var ball: Node = _balls.get_node_or_null(str(p_id))
	if ball != null:
		ball.queue_free()


## What the spawner adds on both sides.
func _make_ball(p_id: Variant) -> Node:
	var ball: MeshInstance3D = MeshInstance3D.new()
	ball.mesh = SphereMesh.new()
	ball.name = str(p_id)
	return ball


func _read_port() -> int:
	for argument: String in OS.get_cmdline_user_args():
		if argument.begins_with("--port="):
			return argument.trim_prefix("--port=").to_int()
	return _PORT


func _on_button_pressed() -> void:
	push()
