class_name BlendedLoops
extends RefCounted
## Loops of one sound at several values (an engine's revolutions, a speed), blended into one that
## follows a value without a seam.

## What a loop that is faded out gets, dB.
const _OFF_DB: float = -100.0

var _blend: LoopBlend = null
var _voices: Array[SoundVoice] = []


## Starts the loops [code]PREFIX_VALUE_loop[/code] on a node.
func _init(
	p_voices: SoundVoices,
	p_prefix: String,
	p_names: PackedStringArray,
	p_values: PackedFloat32Array,
	p_follow: Node3D,
	p_offset: Vector3 = Vector3.ZERO
) -> void:
	_blend = LoopBlend.new(p_values)
	for name: String in p_names:
		var cue: StringName = StringName("%s_%s_loop" % [p_prefix, name])
		_voices.append(p_voices.start_loop(cue, p_follow, p_offset))


## Sets the value, and how loud all is, dB.
func set_value(p_value: float, p_gain_db: float) -> void:
	_blend.set_value(p_value)
	for loop: int in _voices.size():
		if _voices[loop] == null:
			continue
		var gain: float = _blend.gains[loop]
		_voices[loop].gain_db = p_gain_db + linear_to_db(gain) if gain > 1e-4 else _OFF_DB
		_voices[loop].pitch = _blend.pitches[loop]


## Ends all.
func stop() -> void:
	for voice: SoundVoice in _voices:
		if voice != null:
			voice.stop()
	_voices.clear()


## The voices, for measurements.
func voices() -> Array[SoundVoice]:
	return _voices
