extends TestCase
## Base of tests of what is heard: voices that a test may use, and their end behind it.

var _voices: SoundVoices = null


## The voices are in the tree and hear from where they stand.
func goes_by_clock() -> bool:
	return true


func before_each() -> void:
	_voices = SoundVoices.new()
	add_child(_voices)
	_voices.listener = _voices
	await process_frames(1)


func after_each() -> void:
	await MixerRelease.release(_voices)
	_voices.free()
	SoundBank.clear()


## Nodes besides the voices that go on in [method run_frames].
func others() -> Array[Node]:
	return []


## Runs so many frames of a sixtieth of a second: the machine's own may be of any length.
func run_frames(p_count: int) -> void:
	var stepped: Array[Node] = others() + ([_voices] as Array[Node])
	for node: Node in stepped:
		node.set_process(false)
	for _frame: int in p_count:
		for node: Node in stepped:
			node.call(&"_process", 1.0 / 60.0)
		await process_frames(1)
	for node: Node in stepped:
		node.set_process(true)
