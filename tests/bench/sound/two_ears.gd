extends RefCounted
## What two ears hear of noise: how levels and times differ between them.

const RATE: int = 48000
## The later ear is looked for within so many frames: a head's width takes 34.
const _REACH: int = 60
const _COMPARED: int = 4000


## A second of white noise that goes on.
static func noise() -> AudioStreamWAV:
	var dice: RandomNumberGenerator = RandomNumberGenerator.new()
	dice.seed = 3
	var bytes: PackedByteArray = []
	bytes.resize(RATE * 2)
	for frame: int in RATE:
		bytes.encode_s16(frame * 2, dice.randi_range(-8000, 8000))
	var made: AudioStreamWAV = AudioStreamWAV.new()
	made.format = AudioStreamWAV.FORMAT_16_BITS
	made.mix_rate = RATE
	made.data = bytes
	made.loop_mode = AudioStreamWAV.LOOP_FORWARD
	made.loop_end = RATE
	return made


## By how much the right ear's sound is louder, dB.
static func balance_db(p_heard: PackedVector2Array) -> float:
	var sums: Vector2 = Vector2.ZERO
	for frame: Vector2 in p_heard:
		sums += frame * frame
	return 10.0 * log(sums.y / maxf(sums.x, 1e-12)) / log(10.0)


## By how many frames the left ear hears later, at the end of what was captured.
static func lag(p_heard: PackedVector2Array) -> int:
	var from: int = maxi(p_heard.size() - _COMPARED - 2000, _REACH + 20)
	var best: float = -INF
	var found: int = 0
	for by: int in range(-_REACH, _REACH + 1):
		var sum: float = 0.0
		for index: int in range(from, mini(from + _COMPARED, p_heard.size() - _REACH)):
			sum += p_heard[index].y * p_heard[index + by].x
		if sum > best:
			best = sum
			found = by
	return found
