class_name WorldAmbience
extends Node
## What is heard all around: wind, rain, flying sand, the night, a quiet room; by world, weather,
## time of day and whether there is a roof above.

## How slowly it changes, s.
const FOLLOW_S: float = 1.2
## What is quieter is not played, dB.
const _SILENT_DB: float = -58.0
## Wind of each world in clear weather, and what lives there by day and by night, dB; another world
## is like a yard.
const _WINDS: Dictionary[String, float] = {"desert": -24.0, "hangar": -36.0, "stage": -60.0}
const _BIRDS: Dictionary[String, float] = {"town": -32.0, "yard": -34.0, "hangar": -40.0}
const _CRICKETS: Dictionary[String, float] = {"town": -34.0, "desert": -38.0, "yard": -34.0}
const _WIND_DB: float = -31.0
## Strength of each loop where it is full, dB.
const _RAIN_DB: float = -20.0
const _SAND_DB: float = -18.0
const _ROOM_DB: float = -40.0
## Attenuation of the weather by walls and roof, dB.
const _INSIDE_DB: float = -16.0

## Level in the mix of each loop, dB, as it is now.
var levels: Dictionary[StringName, float] = {}

var _players: Dictionary[StringName, AudioStreamPlayer] = {}


func _ready() -> void:
	for name: StringName in [
		&"wind_loop",
		&"sand_wind_loop",
		&"rain_loop",
		&"rain_roof_loop",
		&"crickets_loop",
		&"birds_loop",
		&"room_loop",
	]:
		var player: AudioStreamPlayer = AudioStreamPlayer.new()
		player.bus = SoundBuses.WORLD
		player.volume_db = -80.0
		levels[name] = -80.0
		_players[name] = player
		add_child(player)


## Follows a world (by its name), its weather, and how far the listener is in a room (0 to 1), for a
## time, s.
func advance(p_world: String, p_sky: SkyState, p_enclosure: float, p_delta: float) -> void:
	var wanted: Dictionary[StringName, float] = mix_of(p_world, p_sky, p_enclosure)
	var share: float = 1.0 - exp(-p_delta / FOLLOW_S)
	for name: StringName in _players:
		levels[name] = lerpf(levels[name], maxf(wanted[name], -80.0), share)
		var player: AudioStreamPlayer = _players[name]
		if levels[name] < _SILENT_DB:
			if player.playing:
				player.stop()
			continue
		player.volume_db = levels[name]
		if not player.playing:
			if player.stream == null:
				player.stream = SoundBank.find(name).pick()
			player.play(randf() * player.stream.get_length())


## How loud each loop shall be, dB.
static func mix_of(
	p_world: String, p_sky: SkyState, p_enclosure: float
) -> Dictionary[StringName, float]:
	var rain: float = p_sky.rain if p_sky != null else 0.0
	var dust: float = p_sky.dust if p_sky != null else 0.0
	var is_night: bool = p_sky != null and p_sky.sun.y < -0.05
	var inside: float = clampf((p_enclosure - 0.4) / 0.4, 0.0, 1.0)
	var shelter: float = _INSIDE_DB * inside
	var wind: float = _WINDS.get(p_world, _WIND_DB) + 9.0 * maxf(dust, rain * 0.4)
	var quiet: float = 0.0 if rain + dust < 0.2 else -40.0
	var alive: float = shelter + quiet
	return {
		&"wind_loop": wind + shelter,
		&"sand_wind_loop": _SAND_DB + linear_to_db(maxf(dust, 1e-4)) + shelter,
		&"rain_loop": _RAIN_DB + linear_to_db(maxf(rain, 1e-4)) + shelter * 1.4,
		&"rain_roof_loop":
		_RAIN_DB - 4.0 + linear_to_db(maxf(rain, 1e-4)) + linear_to_db(maxf(inside, 1e-4)),
		&"crickets_loop": (_CRICKETS.get(p_world, -80.0) if is_night else -80.0) + alive,
		&"birds_loop": (-80.0 if is_night else _BIRDS.get(p_world, -80.0)) + alive,
		&"room_loop": _ROOM_DB + linear_to_db(maxf(inside, 1e-4)),
	}
