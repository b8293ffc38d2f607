class_name UntilDrawn
extends RefCounted
## Keeps skies, and what holds them, until the next frame is drawn.
##
## The engine lists a new [Sky] for the next frame, which makes two textures for it. One that is
## gone by then stays in the list of Compatibility (4.6.3): nobody ever frees those textures, and
## it says at its end that they leaked. So levels that are read and given up between two frames must
## not take their skies with them.


## Keeps something: a sky, a scene, or whatever holds one. Null is nothing.
static func keep(p_what: RefCounted) -> void:
	# Without a window no frame is drawn, and nothing is made.
	if p_what == null or DisplayServer.get_name() == "headless":
		return
	# Not kept by an object: whoever asks for it may be gone before.
	var let_go: Callable = func() -> void: _let_go(p_what)
	RenderingServer.frame_post_draw.connect(let_go, CONNECT_ONE_SHOT)


## The skies of a branch.
static func skies_of(p_branch: Node) -> Array[Sky]:
	var skies: Array[Sky] = []
	for node: Node in p_branch.find_children("*", "WorldEnvironment", true, false):
		var environment: Environment = (node as WorldEnvironment).environment
		if environment != null and environment.sky != null:
			skies.append(environment.sky)
	return skies


## The signal has held it by holding the call.
static func _let_go(_p_what: RefCounted) -> void:
	pass
