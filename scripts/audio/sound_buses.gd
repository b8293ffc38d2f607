class_name SoundBuses
extends RefCounted
## The buses that all sounds are mixed on, made by script, and what the user sets of them.
##
## [constant WORLD], [constant VOICES] and [constant INTERFACE] have volumes. Sounds of the world
## play on [constant ROOM] (with the reverberation of where the listener is), [constant MUFFLED]
## (behind a wall) or [constant SOURCE_ROOM] (in a room into which the listener hears). A limiter on
## Master keeps the sum below full scale.

## What is heard of the world.
const WORLD: StringName = &"World"
## Speech and radio.
const VOICES: StringName = &"Voices"
## Sounds of the menu and of messages.
const INTERFACE: StringName = &"Interface"
## The world as heard where the listener is.
const ROOM: StringName = &"Room"
## The world behind a wall.
const MUFFLED: StringName = &"Muffled"
## Sources in a room that the listener is not in.
const SOURCE_ROOM: StringName = &"Source Room"
## Buses whose volume a user sets, in the order of the menu.
const SETTABLE: Array[StringName] = [&"Master", WORLD, VOICES, INTERFACE]
## Nothing leaves the mix above this, dB below full scale.
const CEILING_DB: float = -1.2
## What a wall takes: all above this, Hz.
const MUFFLED_HZ: float = 700.0
## Each bus but Master, and where it sends: those before it.
const _SENDS: Dictionary[StringName, StringName] = {
	WORLD: &"Master",
	VOICES: &"Master",
	INTERFACE: &"Master",
	ROOM: WORLD,
	MUFFLED: ROOM,
	SOURCE_ROOM: ROOM,
}


## Makes the buses and their effects, once in a process.
static func make() -> void:
	if AudioServer.get_bus_index(ROOM) >= 0:
		return
	for bus: StringName in _SENDS:
		var index: int = AudioServer.bus_count
		AudioServer.add_bus()
		AudioServer.set_bus_name(index, bus)
		AudioServer.set_bus_send(index, _SENDS[bus])
	var low: AudioEffectLowPassFilter = AudioEffectLowPassFilter.new()
	low.cutoff_hz = MUFFLED_HZ
	low.db = AudioEffectFilter.FILTER_12DB
	AudioServer.add_bus_effect(AudioServer.get_bus_index(MUFFLED), low)
	for bus: StringName in [ROOM, SOURCE_ROOM]:
		var reverb: AudioEffectReverb = AudioEffectReverb.new()
		reverb.dry = 1.0
		reverb.wet = 0.0
		AudioServer.add_bus_effect(AudioServer.get_bus_index(bus), reverb)
		AudioServer.set_bus_effect_enabled(AudioServer.get_bus_index(bus), 0, false)
	var limiter: AudioEffectHardLimiter = AudioEffectHardLimiter.new()
	limiter.ceiling_db = CEILING_DB
	limiter.release = 0.1
	AudioServer.add_bus_effect(0, limiter, 0)


## Sets how loud a bus is: 0 is silent, 1 as made.
static func set_volume(p_bus: StringName, p_share: float) -> void:
	var index: int = AudioServer.get_bus_index(p_bus)
	if index < 0 or not is_finite(p_share):
		return
	AudioServer.set_bus_volume_linear(index, clampf(p_share, 0.0, 1.0))
	AudioServer.set_bus_mute(index, p_share <= 0.0)


## How loud a bus is, 0 to 1.
static func volume(p_bus: StringName) -> float:
	var index: int = AudioServer.get_bus_index(p_bus)
	return AudioServer.get_bus_volume_linear(index) if index >= 0 else 1.0


## Lets the limiter work or not.
static func set_limited(p_is_limited: bool) -> void:
	for effect: int in AudioServer.get_bus_effect_count(0):
		if AudioServer.get_bus_effect(0, effect) is AudioEffectHardLimiter:
			AudioServer.set_bus_effect_enabled(0, effect, p_is_limited)


## Gives a bus the reverberation of a room; null: none.
static func set_room(p_bus: StringName, p_room: RoomProbe) -> void:
	var bus: int = AudioServer.get_bus_index(p_bus)
	if bus < 0:
		return
	var reverb: AudioEffectReverb = AudioServer.get_bus_effect(bus, 0) as AudioEffectReverb
	var wet: float = p_room.wetness() if p_room != null else 0.0
	AudioServer.set_bus_effect_enabled(bus, 0, wet > 0.005)
	if wet <= 0.005:
		return
	reverb.wet = wet
	reverb.room_size = p_room.reverb_size()
	reverb.damping = clampf(p_room.absorption * 2.0, 0.1, 0.9)
	reverb.predelay_msec = clampf(p_room.mean_path_m / 0.343, 20.0, 120.0)
	reverb.hipass = 0.05
