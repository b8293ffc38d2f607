class_name SoundVoice
extends RefCounted
## Something that sounds: one of [SoundVoices]. Who starts a loop keeps it, sets [member gain_db]
## and [member pitch], and calls [method stop].

## What it plays.
var cue: SoundCue = null
## Where it is, m, if it follows nothing.
var place: Vector3 = Vector3.ZERO
## What it follows; null: nothing. It ends with it.
var follow: Node3D = null:
	set(p_value):
		follow = p_value
		_follows = p_value != null
## Place in the frame of what it follows, m.
var offset: Vector3 = Vector3.ZERO
## How much louder it is than its cue, dB.
var gain_db: float = 0.0
## Its pitch, 1 as made.
var pitch: float = 1.0
## Priority when voices are few: so many dB are added to its level.
var priority_db: float = 0.0
## Its rank when voices are few, as last computed, dB.
var rank_db: float = -INF
## Level at the listener as last worked out, dB over full scale.
var level_db: float = -INF
## Whether a wall is between it and the listener.
var is_blocked: bool = false
## Whether it is in a room.
var is_in_room: bool = false
## The renderer's number of it, or -1 while it is not heard.
var slot: int = -1
## When it is over, s of the clock of [SoundVoices]; INF for loops.
var end_s: float = INF
## Whether it is over.
var is_over: bool = false
## Distance from the listener as last worked out, m.
var distance: float = 0.0
## How fast it goes away from the listener, m/s.
var recession: float = 0.0

## Time since its position was last evaluated, s, and frames until it is evaluated again.
var since_s: float = 0.0
var wait_frames: int = 0

var _follows: bool = false
var _last_gain_db: float = INF
var _last_pitch: float = INF


## Ends it; it fades within a few milliseconds.
func stop() -> void:
	is_over = true


## Whether the node that it follows is gone: a freed node can no longer be distinguished from null.
func is_abandoned() -> bool:
	return _follows and not is_instance_valid(follow)


## Where it is now, m.
func position() -> Vector3:
	if follow != null and is_instance_valid(follow) and follow.is_inside_tree():
		place = follow.global_transform * offset
	return place


## Whether gain or pitch have changed since the last call, so that one hears it.
func has_changed() -> bool:
	if absf(gain_db - _last_gain_db) < 0.1 and absf(pitch - _last_pitch) < 0.0005:
		return false
	_last_gain_db = gain_db
	_last_pitch = pitch
	return true
