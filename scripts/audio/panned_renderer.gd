class_name PannedRenderer
extends SpatialRenderer
## Makes voices heard by the engine's panning: for loudspeakers.

## The engine leaves its filter for distance out only where that takes everything above its cutoff
## (a gain of exactly 0): this halves what voices cost. At 0 dB and above the filter does nothing.
const _NO_FILTER_DB: float = -1e6
## Just below 0 dB the filter would take something: such levels are 0 dB.
const _ALMOST_FULL_DB: float = -0.02

var _players: Array[AudioStreamPlayer3D] = []


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
	_players[p_slot].play(_used[p_slot])


func _load(p_slot: int, p_stream: AudioStream, p_bus: StringName) -> void:
	_players[p_slot].stream = p_stream
	_players[p_slot].bus = p_bus


func _mute(p_slot: int) -> void:
	_players[p_slot].volume_db = FADED_DB


func _clear(p_slot: int) -> void:
	_players[p_slot].stop()
	_players[p_slot].stream = null
