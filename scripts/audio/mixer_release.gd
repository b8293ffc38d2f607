class_name MixerRelease
## Lets the mixer give back what it plays, before a program ends.
##
## The mixer's thread keeps a sound that has been stopped until it has mixed once more. A program
## that ends before that leaks the sound, and the engine reports it as an error at exit.

## Steps of the mixer to wait for: the first may have begun before the sounds were stopped.
const _STEPS: int = 2
## A mixer that stands still, for want of a sound card, is not waited for any longer, ms.
const _LIMIT_MS: int = 500


## Stops all players below a node, which is disabled so that none begins again, and returns when the
## mixer has let go of them. Await it as the last thing before the program quits.
static func release(p_node: Node) -> void:
	var is_any: bool = false
	for type: String in ["AudioStreamPlayer", "AudioStreamPlayer3D"]:
		for player: Node in p_node.find_children("*", type, true, false):
			is_any = true
			player.call("stop")
	p_node.process_mode = Node.PROCESS_MODE_DISABLED
	if not is_any:
		return
	var tree: SceneTree = p_node.get_tree()
	var begin_ms: int = Time.get_ticks_msec()
	var mixed_ms: float = begin_ms
	var steps: int = 0
	while steps < _STEPS and Time.get_ticks_msec() < begin_ms + _LIMIT_MS:
		await tree.process_frame
		var last_ms: float = Time.get_ticks_msec() - AudioServer.get_time_since_last_mix() * 1000.0
		# Both clocks are read one after the other: a step is longer than that takes.
		if last_ms > mixed_ms + 2.0:
			mixed_ms = last_ms
			steps += 1
