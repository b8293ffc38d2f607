extends SceneTree
## Runs the example of the package: as a server until it is ended, or as a client until it has got
## its ball and an answer.

var _example: Node = null


func _initialize() -> void:
	var scene: PackedScene = load("res://addons/threaded_peer/example/threaded_peer.tscn")
	_example = scene.instantiate()
	_example.connect(&"spawned", _on_spawned)
	_example.connect(&"answered", _on_answered)
	root.add_child(_example)
	process_frame.connect(_on_first_frame, CONNECT_ONE_SHOT)


## Only now the example is ready.
func _on_first_frame() -> void:
	if get_multiplayer().multiplayer_peer is ThreadedPeer and get_multiplayer().is_server():
		print("listening")


func _on_spawned(p_ball: Node) -> void:
	print("spawned a %s" % p_ball.get_class())
	if not get_multiplayer().is_server():
		if str(p_ball.name).to_int() != get_multiplayer().get_unique_id():
			printerr("the ball of somebody else")
		_example.call(&"push")


func _on_answered(p_pushes: int) -> void:
	print("answered %d" % p_pushes)
	quit()
