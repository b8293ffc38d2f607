class_name SpatialRenderer
extends Node3D
## Makes voices heard at their places. [SoundVoices] decides which ones, how loud, and on which bus;
## a renderer gives them to the ears: [PannedRenderer] to loudspeakers, others to headphones.

## How many voices can sound at once.
var capacity: int = 0


## Begins a voice; returns its number, or -1 where none is free. [param p_from_s]: how much of it is
## past already.
func begin(_stream: AudioStream, _bus: StringName, _from_s: float) -> int:
	return -1


## Sets where a voice is (m), its level (dB over full scale), pitch and bus.
func update(_slot: int, _place: Vector3, _level_db: float, _pitch: float, _bus: StringName) -> void:
	pass


## Starts what was begun and has been updated for the first time.
func start(_slot: int) -> void:
	pass


## Ends a voice; it fades within a few milliseconds, then its number is free.
func release(_slot: int) -> void:
	pass


## How many voices sound, without those that fade.
func sounding() -> int:
	return 0
