extends "sound_part.gd"
## What sound for headphones costs beyond that for loudspeakers, and what the ears hear of it.

const MixCapture: GDScript = preload("mix_capture.gd")
const ProcessTime: GDScript = preload("res://tests/bench/process_time.gd")
const TwoEars: GDScript = preload("two_ears.gd")
const _VOICES: int = 24
## A thousandth of a core for each voice.
const _GOAL_VOICE_MS: float = 1.0
## How much later the far ear of the measured head hears at 90 degrees, ms, and within which share.
const _HEAD_LAG_MS: float = 0.71
const _LAG_SHARE: float = 0.1
## How fast voices move around the listener, rad in a frame.
const _TURN: float = 0.01

## What carries the voices that move.
var _carousel: Node3D = null


## Both; what it leaves, buses, would disturb other parts: it comes last.
func measure_binaural() -> void:
	await _measure_cost()
	await _measure_cues()


## The same loops through both renderers, one half of them moving around the listener.
func _measure_cost() -> void:
	_begin()
	_voices.renderer = PannedRenderer.new(_VOICES)
	_carousel = Node3D.new()
	_add(_carousel)
	for number: int in _VOICES:
		var place: Node3D = Node3D.new()
		place.position = Vector3(sin(number), 0.1, cos(number)) * (4.0 + number * 0.4)
		if number % 2 == 0:
			_carousel.add_child(place)
		else:
			_add(place)
		_voices.start_loop(&"rain_loop", place).gain_db = 0.0
	_tree.process_frame.connect(_turn)
	await _tree.create_timer(1.0).timeout
	var panned: float = await ProcessTime.busy_ms(_tree)
	var ears: BinauralRenderer = BinauralRenderer.new(_VOICES)
	_voices.renderer = ears
	await _tree.create_timer(1.0).timeout
	var binaural: float = await ProcessTime.busy_ms(_tree)
	_tree.process_frame.disconnect(_turn)
	if ears.error != "":
		_report.leave_out("binaural", ears.error)
	var case: String = "%d voices for headphones" % _VOICES
	var each: float = (binaural - panned) / _VOICES
	var metric: String = "processor time a second of one, beyond loudspeakers"
	_report.at_least(case, "heard", _voices.heard(), "", _VOICES)
	_report.at_most(case, metric, each, "ms", _GOAL_VOICE_MS)
	_report.add(case, "processor time a second of all, loudspeakers", panned, "ms")
	_voices.stop_all()
	await _tree.create_timer(0.2).timeout
	_end()


## Noise on the right, as the mix has it for both ears.
func _measure_cues() -> void:
	_begin()
	var mix: RefCounted = MixCapture.new()
	mix.start()
	var ears: BinauralRenderer = BinauralRenderer.new(1)
	ears.listener = Node3D.new()
	ears.add_child(ears.listener)
	_add(ears)
	var slot: int = ears.begin(TwoEars.noise(), SoundBuses.ROOM, 0.0)
	if slot < 0:
		_report.leave_out("noise at 90 degrees", ears.error)
		mix.stop()
		_end()
		return
	ears.update(slot, Vector3(3.0, 0.0, 0.0), -6.0, 1.0, SoundBuses.ROOM)
	ears.start(slot)
	await _tree.create_timer(0.5).timeout
	var heard: PackedVector2Array = await mix.record(_tree, 0.5)
	var case: String = "noise at 90 degrees, for headphones"
	_report.add(case, "louder at the near ear", TwoEars.balance_db(heard), "dB")
	var late_ms: float = TwoEars.lag(heard) * 1000.0 / TwoEars.RATE
	_report.add(case, "later at the far ear", late_ms, "ms")
	_report.within(
		case,
		"the same beside the head's %.2f ms" % _HEAD_LAG_MS,
		100.0 * (late_ms / _HEAD_LAG_MS - 1.0),
		"%",
		100.0 * _LAG_SHARE
	)
	ears.release(slot)
	await _tree.create_timer(0.2).timeout
	mix.stop()
	_end()


func _turn() -> void:
	_carousel.rotate_y(_TURN)
