extends TestCase
## What two ears hear of a voice, measured in the captured mix.

const Capture: GDScript = preload("res://tests/bench/sound/mix_capture.gd")
const TwoEars: GDScript = preload("res://tests/bench/sound/two_ears.gd")
const RATE: int = TwoEars.RATE

var _ears: BinauralRenderer = null
var _listener: Node3D = null
var _capture: Capture = null


func before_each() -> void:
	_capture = Capture.new()
	_capture.start()
	_listener = Node3D.new()
	add_child(_listener)
	_ears = BinauralRenderer.new(2)
	_ears.listener = _listener
	add_child(_ears)
	equal(_ears.error, "")


func after_each() -> void:
	_capture.stop()


func test_a_voice_on_the_right_is_louder_and_earlier_on_the_right() -> void:
	var heard: PackedVector2Array = await _hear(Vector3(3.0, 0.0, 0.0))
	var balance: float = TwoEars.balance_db(heard)
	is_true(balance > 4.0, "%.1f dB" % balance)
	var lag_ms: float = TwoEars.lag(heard) * 1000.0 / RATE
	# Of the measured head: 0.71 ms at 90 degrees.
	almost_equal(lag_ms, 0.71, 0.1)


func test_it_stays_where_it_is_when_the_head_turns() -> void:
	_listener.rotate_y(-PI / 2.0)
	var heard: PackedVector2Array = await _hear(Vector3(3.0, 0.0, 0.0))
	almost_equal(TwoEars.balance_db(heard), 0.0, 1.5, "it is ahead now")
	almost_equal(TwoEars.lag(heard), 0.0, 2.0)


func test_no_more_voices_than_it_has_and_each_is_given_back() -> void:
	var noise: AudioStreamWAV = TwoEars.noise()
	for _round: int in 5:
		var slots: Array[int] = []
		for _voice: int in 3:
			slots.append(_ears.begin(noise, SoundBuses.ROOM, 0.0))
		equal(slots[2], -1)
		equal(_ears.sounding(), 2)
		for slot: int in slots.slice(0, 2):
			_ears.update(slot, Vector3.FORWARD, -10.0, 1.0, SoundBuses.MUFFLED)
			_ears.start(slot)
			_ears.release(slot)
		equal(_ears.sounding(), 0)
		await process_frames(5)


func test_a_second_renderer_uses_the_same_buses() -> void:
	var count: int = AudioServer.bus_count
	var other: BinauralRenderer = BinauralRenderer.new(2)
	add_child(other)
	equal(AudioServer.bus_count, count)


## What is heard of noise at a place, for a quarter of a second.
func _hear(p_place: Vector3) -> PackedVector2Array:
	var slot: int = _ears.begin(TwoEars.noise(), SoundBuses.ROOM, 0.0)
	_ears.update(slot, p_place, -6.0, 1.0, SoundBuses.ROOM)
	_ears.start(slot)
	_capture.clear()
	var heard: PackedVector2Array = []
	# The mixer goes by the clock, whatever the frames do.
	while heard.size() < 4 * RATE:
		await get_tree().process_frame
		OS.delay_msec(5)
		heard.append_array(_capture.take())
		if heard.size() > RATE / 2 and Capture.level_db(heard) > -60.0:
			break
	_ears.release(slot)
	is_true(Capture.level_db(heard) > -60.0, "it is heard")
	return heard
