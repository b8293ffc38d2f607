class_name SoundCue
extends RefCounted
## One sound by name: its takes, how loud it is, how far it is heard.

## The name.
var name: StringName = &""
## Its takes: one of them is played at random.
var takes: Array[AudioStream] = []
## Level 1 m away, dB over full scale: sounds keep their distances apart, the mix is limited.
var level_db: float = 0.0
## Attenuation per doubling of the distance, dB: 6 in the open.
var slope_db: float = 6.0
## Distance from which on it is not heard, m.
var range_m: float = 60.0
## Takes differ in pitch by up to this share.
var pitch_spread: float = 0.05
## Priority when voices are few: so many dB are added to its level.
var priority_db: float = 0.0
## What a caption says of it; empty: none.
var caption: String = ""
## How long its longest take is, s.
var length_s: float = 0.0


## Level at a distance from it (m), in the open, dB over full scale; -INF beyond its range.
func level_at(p_distance: float) -> float:
	if p_distance >= range_m:
		return -INF
	var away: float = maxf(p_distance, 1.0)
	var level: float = level_db - slope_db * log(away) / log(2.0)
	# The last fifth of the range fades out.
	var left: float = (range_m - p_distance) / (range_m * 0.2)
	return level if left >= 1.0 else level + linear_to_db(maxf(left, 1e-4))


## Whether it goes on until it is stopped.
func is_loop() -> bool:
	return not takes.is_empty() and (takes[0] as AudioStreamWAV).loop_mode != 0


## One of the takes.
func pick() -> AudioStream:
	return takes[randi() % takes.size()]
