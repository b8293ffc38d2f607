extends TestCase
## A program that ends leaves nothing with the mixer.


func goes_by_clock() -> bool:
	return true


func test_a_sound_that_has_just_begun_is_given_back() -> void:
	var node: Node = Node.new()
	add_child(node)
	var stream: WeakRef = _play_below(node)
	await MixerRelease.release(node)
	node.queue_free()
	await process_frames(1)
	is_true(stream.get_ref() == null)


func test_no_player_is_no_wait() -> void:
	var node: Node = Node.new()
	add_child(node)
	var frame: int = Engine.get_process_frames()
	await MixerRelease.release(node)
	equal(Engine.get_process_frames(), frame)
	is_false(node.can_process())


## Plays a loop below a node; only the player and the mixer hold it.
func _play_below(p_node: Node) -> WeakRef:
	var stream: AudioStreamWAV = AudioStreamWAV.new()
	stream.format = AudioStreamWAV.FORMAT_16_BITS
	var data: PackedByteArray = []
	data.resize(9600)
	stream.data = data
	stream.loop_mode = AudioStreamWAV.LOOP_FORWARD
	stream.loop_end = 4800
	var player: AudioStreamPlayer = AudioStreamPlayer.new()
	player.stream = stream
	p_node.add_child(player)
	player.play()
	return weakref(stream)
