class_name GuideCues
extends Node
## What a wearer hears of a calibration: a beep for each of the last seconds before a step, a high
## one when a pose is to be held, two when that is over, and the result in words where the system
## can speak.

## Seconds before a step that are counted by beeps.
const COUNTED_S: int = 3
const _RATE_HZ: int = 22050
## Pitch, Hz, and length, s, of the tones.
const _TONES: Dictionary[StringName, Vector2] = {
	&"count": Vector2(660.0, 0.1),
	&"begin": Vector2(1175.0, 0.35),
	&"end": Vector2(880.0, 0.18),
	&"good": Vector2(1320.0, 0.5),
	&"bad": Vector2(220.0, 0.6),
}

var _player: AudioStreamPlayer = null
var _streams: Dictionary[StringName, AudioStreamWAV] = {}
var _phase: CalibrationProcess.Phase = CalibrationProcess.Phase.IDLE
var _step: CalibrationGuide.Step = null
var _counted: int = 0


func _ready() -> void:
	_player = AudioStreamPlayer.new()
	_player.bus = SoundBuses.INTERFACE
	add_child(_player)


## Follows a calibration; call it in every frame.
func follow(p_process: CalibrationProcess) -> void:
	var step: CalibrationGuide.Step = p_process.current_step()
	if step != _step or p_process.phase != _phase:
		_change(p_process)
	_step = step
	_phase = p_process.phase
	var left: int = ceili(p_process.seconds_left)
	if _phase == CalibrationProcess.Phase.COUNTDOWN and left != _counted and left <= COUNTED_S:
		_counted = left
		_play(&"count")


## A calibration has ended with a result. One that is accepted at once is never seen by
## [method follow].
func conclude(p_result: CalibrationResult) -> void:
	_phase = CalibrationProcess.Phase.DONE
	_step = null
	_play(&"good" if p_result.error == "" and p_result.word() != "poor" else &"bad")
	_speak(spoken(p_result))


## What is said of a result.
static func spoken(p_result: CalibrationResult) -> String:
	if p_result.error != "":
		return "It did not work. " + p_result.error
	if p_result.calibration == null:
		return "Sensors are elsewhere." if p_result.is_reassigned() else "All sensors are right."
	var degrees: int = roundi(p_result.error_deg)
	var text: String = "%s. Off by about %d degrees." % [p_result.word().capitalize(), degrees]
	if not p_result.advice.is_empty():
		text += " " + p_result.advice[0]
	return text


func _change(p_process: CalibrationProcess) -> void:
	match p_process.phase:
		CalibrationProcess.Phase.HOLD, CalibrationProcess.Phase.MOVE:
			_play(&"begin")
		CalibrationProcess.Phase.DONE:
			conclude(p_process.result)
		CalibrationProcess.Phase.COUNTDOWN:
			_counted = 0
		_:
			if _phase == CalibrationProcess.Phase.HOLD or _phase == CalibrationProcess.Phase.MOVE:
				_play(&"end")


func _play(p_tone: StringName) -> void:
	if not _streams.has(p_tone):
		_streams[p_tone] = _make(_TONES[p_tone].x, _TONES[p_tone].y)
	_player.stream = _streams[p_tone]
	_player.play()


func _speak(p_text: String) -> void:
	var is_on: bool = ProjectSettings.get_setting("audio/general/text_to_speech", false)
	if not is_on or not DisplayServer.has_feature(DisplayServer.FEATURE_TEXT_TO_SPEECH):
		return
	# Where no speech service runs, there are none: the result is on the screen.
	var voices: PackedStringArray = DisplayServer.tts_get_voices_for_language("en")
	if not voices.is_empty():
		DisplayServer.tts_speak(p_text, voices[0])


## A tone that swells and fades, so that it does not click.
static func _make(p_pitch_hz: float, p_length_s: float) -> AudioStreamWAV:
	var frames: int = roundi(p_length_s * _RATE_HZ)
	var bytes: PackedByteArray = PackedByteArray()
	bytes.resize(frames * 2)
	for frame: int in frames:
		var edge: float = minf(minf(frame, frames - frame) / (0.01 * _RATE_HZ), 1.0)
		var wave: float = sin(TAU * p_pitch_hz * frame / _RATE_HZ) * edge
		bytes.encode_s16(frame * 2, roundi(wave * 12000.0))
	var stream: AudioStreamWAV = AudioStreamWAV.new()
	stream.format = AudioStreamWAV.FORMAT_16_BITS
	stream.mix_rate = _RATE_HZ
	stream.data = bytes
	return stream
