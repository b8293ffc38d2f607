class_name DoorSounds
extends RefCounted
## Hinges that creak and doors that fall shut, from how doors are displayed.

## Distance from the listener beyond which doors are silent, m.
const MAX_DISTANCE_M: float = 30.0
## Doors near the listener are looked for so often, s.
const _SEARCH_S: float = 0.5
## Angular speed below which a door is silent, and above which no hinge creaks, degrees/s.
const _MIN_SPEED: float = 6.0
const _CREAK_SPEED: float = 70.0
## Angle from shut at which a moving door falls into its frame, degrees.
const _SHUT_DEG: float = 2.0
## Least time between two creaks of a hinge, s.
const _MIN_GAP_S: float = 1.4

var _voices: SoundVoices = null
var _all: Array[Door] = []
var _near: Array[Door] = []
var _angles: Dictionary[Door, float] = {}
var _creaked_s: Dictionary[Door, float] = {}
var _clock_s: float = 0.0
var _searched_s: float = -1.0


## Plays on such voices.
func _init(p_voices: SoundVoices) -> void:
	_voices = p_voices


## Takes the doors of a level that has come.
func take_level(p_level: Level) -> void:
	_all.clear()
	_near.clear()
	_angles.clear()
	_creaked_s.clear()
	for prop: RigidBody3D in p_level.get_props():
		if prop is Door:
			_all.append(prop as Door)


## Looks at the doors near by after a time, s.
func advance(p_delta: float) -> void:
	_clock_s += p_delta
	if _clock_s - _searched_s > _SEARCH_S:
		_search()
	for door: Door in _near:
		if not is_instance_valid(door) or p_delta <= 0.0:
			continue
		var angle: float = door.angle()
		if _angles.has(door):
			_listen(door, _angles[door], angle, p_delta)
		_angles[door] = angle


func _search() -> void:
	_searched_s = _clock_s
	_near.clear()
	var ear: Vector3 = _voices.ear()
	for door: Door in _all:
		if is_instance_valid(door) and door.global_position.distance_to(ear) < MAX_DISTANCE_M:
			_near.append(door)
	for door: Variant in _angles.keys():
		if not is_instance_valid(door) or not _near.has(door):
			_angles.erase(door)


func _listen(p_door: Door, p_before: float, p_angle: float, p_delta: float) -> void:
	var speed: float = absf(p_angle - p_before) / p_delta
	if speed < _MIN_SPEED or speed > 1500.0:
		return
	var place: Vector3 = p_door.global_position + Vector3.UP * p_door.size.y * 0.5
	var was_open: bool = absf(p_before) > _SHUT_DEG
	if was_open and (absf(p_angle) <= _SHUT_DEG or p_angle * p_before < 0.0):
		_voices.play(&"door_shut", place, linear_to_db(clampf(speed / 90.0, 0.1, 2.0)))
	elif speed < _CREAK_SPEED and _clock_s - _creaked_s.get(p_door, -9.0) > _MIN_GAP_S:
		_creaked_s[p_door] = _clock_s
		_voices.play(&"door_creak", place, linear_to_db(clampf(speed / 40.0, 0.2, 1.2)) - 8.0)
