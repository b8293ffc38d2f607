@abstract class_name SpatialRenderer
extends Node3D
## Makes voices heard at their positions. [SoundVoices] decides which ones, how loud, and on which
## bus; a renderer gives them to the ears: [PannedRenderer] to loudspeakers, [BinauralRenderer] to
## headphones.
##
## All players are made at the start. Some more than can sound are there for those that fade: the
## mixer brings a level to nothing within one of its steps of 512 frames (11 ms).

## Players for voices that fade.
const SPARE: int = 12
## Level of a voice that fades, dB.
const FADED_DB: float = -80.0
## Frames after which a voice that fades is silent.
const _FADE_FRAMES: int = 2

## How many voices can sound at once.
var capacity: int = 0

var _free: PackedInt32Array = []
## Slots that sound, and how much of each was past already when it began, s.
var _used: Dictionary[int, float] = {}
## Slots that fade, and the frame in which they began to.
var _fading: Dictionary[int, int] = {}
var _frame: int = 0


func _process(_delta: float) -> void:
	_frame += 1
	for slot: int in _fading.keys():
		if _frame - _fading[slot] > _FADE_FRAMES:
			_end_fade(slot)


## Begins a voice; returns its number, or -1 where none is free. [param p_from_s]: how much of it is
## past already.
func begin(p_stream: AudioStream, p_bus: StringName, p_from_s: float) -> int:
	if _used.size() >= capacity:
		return -1
	if _free.is_empty():
		# All that fade would need another moment: the first of them is cut.
		_end_fade(_fading.keys()[0])
	var slot: int = _free[_free.size() - 1]
	_free.resize(_free.size() - 1)
	_used[slot] = p_from_s
	_load(slot, p_stream, p_bus)
	return slot


## Sets where a voice is (m), its level (dB over full scale), pitch and bus.
@abstract func update(
	p_slot: int, p_place: Vector3, p_level_db: float, p_pitch: float, p_bus: StringName
) -> void

## Starts what was begun and has been updated for the first time.
@abstract func start(p_slot: int) -> void


## Ends a voice; it fades within a few milliseconds, then its number is free.
func release(p_slot: int) -> void:
	_mute(p_slot)
	_fading[p_slot] = _frame
	_used.erase(p_slot)


## How many voices sound, without those that fade.
func sounding() -> int:
	return _used.size()


func _end_fade(p_slot: int) -> void:
	_clear(p_slot)
	_fading.erase(p_slot)
	_free.append(p_slot)


## Gives a player what it is to play.
@abstract func _load(p_slot: int, p_stream: AudioStream, p_bus: StringName) -> void

## Brings a player to [constant FADED_DB].
@abstract func _mute(p_slot: int) -> void

## Stops a player, which is silent.
@abstract func _clear(p_slot: int) -> void
