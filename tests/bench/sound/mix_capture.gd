extends RefCounted
## What the mix holds, captured from the Master bus behind the limiter. Headless programs mix in
## real time, so that captures take as long as they are.

var _effect: AudioEffectCapture = AudioEffectCapture.new()


## Begins to capture.
func start() -> void:
	SoundBuses.make()
	_effect.buffer_length = 4.0
	AudioServer.add_bus_effect(0, _effect)


## Ends it.
func stop() -> void:
	for index: int in range(AudioServer.get_bus_effect_count(0) - 1, -1, -1):
		if AudioServer.get_bus_effect(0, index) == _effect:
			AudioServer.remove_bus_effect(0, index)


## Forgets what has come.
func clear() -> void:
	_effect.clear_buffer()


## What has come since, left and right.
func take() -> PackedVector2Array:
	return _effect.get_buffer(_effect.get_frames_available())


## Waits so long, s, and returns what came meanwhile.
func record(p_tree: SceneTree, p_seconds: float) -> PackedVector2Array:
	clear()
	await p_tree.create_timer(p_seconds).timeout
	return take()


## Both sides in one.
static func mono(p_frames: PackedVector2Array) -> PackedFloat32Array:
	var sum: PackedFloat32Array = []
	sum.resize(p_frames.size())
	for index: int in p_frames.size():
		sum[index] = (p_frames[index].x + p_frames[index].y) * 0.5
	return sum


## Power of both sides together, dB below full scale.
static func level_db(p_frames: PackedVector2Array) -> float:
	var sum: float = 0.0
	for frame: Vector2 in p_frames:
		sum += frame.length_squared()
	return 10.0 * log(maxf(sum / maxi(p_frames.size(), 1), 1e-14)) / log(10.0)


## Greatest value of either side, dB below full scale.
static func peak_db(p_frames: PackedVector2Array) -> float:
	var peak: float = 0.0
	for frame: Vector2 in p_frames:
		peak = maxf(peak, maxf(absf(frame.x), absf(frame.y)))
	return linear_to_db(maxf(peak, 1e-7))
