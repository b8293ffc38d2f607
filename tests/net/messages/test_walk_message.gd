extends TestCase
## Corrections of walkers on the wire.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")


func test_a_correction_goes_through() -> void:
	var message: WalkMessage = WalkMessage.new()
	message.person = 7
	message.tick = 70000
	message.number = 15
	message.state.resize(WalkMessage.STATE_BYTES)
	message.state[5] = 99
	var read: WalkMessage = WalkMessage.decode(message.encode())
	equal([read.person, read.tick, read.number], [7, 70000, 15])
	equal(read.state, message.state)


func test_damage_is_none() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 1
	var message: WalkMessage = WalkMessage.new()
	message.state.resize(WalkMessage.STATE_BYTES)
	var good: PackedByteArray = message.encode()
	for _time: int in 500:
		var read: WalkMessage = WalkMessage.decode(NetSamples.damage(random, good))
		is_true(read == null or read.state.size() == WalkMessage.STATE_BYTES)
		read = WalkMessage.decode(NetSamples.noise(random, 200))
		is_true(read == null or read.state.size() == WalkMessage.STATE_BYTES)
