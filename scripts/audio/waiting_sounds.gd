class_name WaitingSounds
extends RefCounted
## Sounds that wait for their moment, such as those of a shot that are still on their way.

## Greatest number of sounds that wait.
const MAX_WAITING: int = 256

var _voices: Array[SoundVoice] = []
var _due_s: PackedFloat64Array = []


## Keeps a sound, whose rank is known, until a moment, s. Where there are too many the one that
## counts least is not kept, be it the new one: returns it, or null.
func add(p_voice: SoundVoice, p_due_s: float) -> SoundVoice:
	var least: SoundVoice = null
	if _voices.size() >= MAX_WAITING:
		var index: int = _find_lowest()
		least = _voices[index]
		if not least.is_over and least.rank_db >= p_voice.rank_db:
			return p_voice
		least.stop()
		_remove(index)
	_voices.append(p_voice)
	_due_s.append(p_due_s)
	return least


## Takes those whose moment has come, s, without those that have been stopped.
func take_due(p_now_s: float) -> Array[SoundVoice]:
	var due: Array[SoundVoice] = []
	for index: int in range(_voices.size() - 1, -1, -1):
		if _due_s[index] <= p_now_s:
			if not _voices[index].is_over:
				due.append(_voices[index])
			_remove(index)
	return due


## How many wait.
func size() -> int:
	return _voices.size()


## Forgets all.
func clear() -> void:
	_voices.clear()
	_due_s.clear()


## What has been stopped counts less than everything.
func _find_lowest() -> int:
	var lowest: int = 0
	var least: float = INF
	for index: int in _voices.size():
		var rank: float = -INF if _voices[index].is_over else _voices[index].rank_db
		if rank < least:
			least = rank
			lowest = index
	return lowest


func _remove(p_index: int) -> void:
	_voices.remove_at(p_index)
	_due_s.remove_at(p_index)
