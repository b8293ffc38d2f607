class_name PannedRenderer
extends SpatialRenderer
## Makes voices heard by the engine's panning: for loudspeakers.
##
## All players are made at the start. Some more than can sound are there for those that fade: the
## mixer brings a level to nothing within one of its steps of 512 frames (11 ms).

## Players for voices that fade.
const SPARE: int = 12
## Frames after which a voice that fades is silent.
const _FADE_FRAMES: int = 2
## The engine leaves its filter for distance out only where that takes everything above its cutoff
## (a gain of exactly 0): this halves what voices cost. At 0 dB and above the filter does nothing.
const _NO_FILTER_DB: float = -1e6
## Just below 0 dB the filter would take something: such levels are 0 dB.
const _ALMOST_FULL_DB: float = -0.02

var _players: Array[AudioStreamPlayer3D] = []
var _free: PackedInt32Array = []
var _begin_s: Dictionary[int, float] = {}
## Players that fade, and the frame in which they began to.
var _fading: Dictionary[int, int] = {}
var _frame: int = 0
var _sounding: int = 0


func _init(p_capacity: int = 48) -> void:
	capacity = p_capacity
	for index: int in p_capacity + SPARE:
		var player: AudioStreamPlayer3D = AudioStreamPlayer3D.new()
		# Level, range and Doppler are worked out by SoundVoices, for all renderers alike.
		player.attenuation_model = AudioStreamPlayer3D.ATTENUATION_DISABLED
		player.attenuation_filter_db = _NO_FILTER_DB
		player.max_db = 6.0
		player.area_mask = 0
		player.panning_strength = 1.6
		player.top_level = true
		add_child(player)
		_players.append(player)
		_free.append(index)


func _process(_delta: float) -> void:
	_frame += 1
	for slot: int in _fading.keys():
		if _frame - _fading[slot] > _FADE_FRAMES:
			_end_fade(slot)


func begin(p_stream: AudioStream, p_bus: StringName, p_from_s: float) -> int:
	if _sounding >= capacity:
		return -1
	if _free.is_empty():
		# All that fade would need another moment: the first of them is cut.
		_end_fade(_fading.keys()[0])
	var slot: int = _free[_free.size() - 1]
	_free.resize(_free.size() - 1)
	_players[slot].stream = p_stream
	_players[slot].bus = p_bus
	_begin_s[slot] = p_from_s
	_sounding += 1
	return slot


func update(
	p_slot: int, p_place: Vector3, p_level_db: float, p_pitch: float, p_bus: StringName
) -> void:
	var player: AudioStreamPlayer3D = _players[p_slot]
	# Each set costs more than the comparison.
	if not player.position.is_equal_approx(p_place):
		player.position = p_place
	var level: float = 0.0 if p_level_db > _ALMOST_FULL_DB and p_level_db < 0.0 else p_level_db
	if absf(player.volume_db - level) > 0.01:
		player.volume_db = level
	if absf(player.pitch_scale - p_pitch) > 1e-3:
		player.pitch_scale = p_pitch
	if player.bus != p_bus:
		player.bus = p_bus


func start(p_slot: int) -> void:
	_players[p_slot].play(_begin_s[p_slot])


func release(p_slot: int) -> void:
	_players[p_slot].volume_db = -80.0
	_fading[p_slot] = _frame
	_begin_s.erase(p_slot)
	_sounding -= 1


func sounding() -> int:
	return _sounding


func _end_fade(p_slot: int) -> void:
	_players[p_slot].stop()
	_players[p_slot].stream = null
	_fading.erase(p_slot)
	_free.append(p_slot)
