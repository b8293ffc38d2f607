class_name SoundSurroundings
extends RefCounted
## What is between listener and sources, and how the rooms of both reverberate: by rays against what
## never moves.

## Distance from the source within which a ray's hit is the surface that was struck, not a wall, m.
const NEAR_SOURCE_M: float = 0.35
## Height up to which a roof is searched, m.
const _ROOF_M: float = 20.0
## Height above a source at which a ray to its roof begins, m.
const _ABOVE_M: float = 0.2
## The reverberation is set again after so many frames.
const _SET_FRAMES: int = 8

## How the surroundings of the listener reverberate.
var room: RoomProbe = RoomProbe.new()
## The same where a source was heard last in a room that the listener is not in.
var source_room: RoomProbe = RoomProbe.new()

var _query: PhysicsRayQueryParameters3D = PhysicsRayQueryParameters3D.new()
var _frame: int = 0


func _init() -> void:
	_query.collision_mask = PhysicsLayers.STATIC


## What a surface swallows: see [member RoomProbe.absorption_of].
func set_absorption(p_of: Callable) -> void:
	room.absorption_of = p_of
	source_room.absorption_of = p_of


## Looks around from the ears (m) once in a frame.
func advance(p_space: PhysicsDirectSpaceState3D, p_ear: Vector3) -> void:
	_frame += 1
	room.look(p_space, p_ear)
	if _frame % _SET_FRAMES == 0:
		SoundBuses.set_room(SoundBuses.ROOM, room)


## Whether a wall is between the ears and a position, m.
func is_walled(p_space: PhysicsDirectSpaceState3D, p_ear: Vector3, p_place: Vector3) -> bool:
	var offset: Vector3 = p_place - p_ear
	if offset.length() < NEAR_SOURCE_M * 2.0:
		return false
	_query.from = p_ear
	_query.to = p_place - offset.normalized() * NEAR_SOURCE_M
	return not p_space.intersect_ray(_query).is_empty()


## Whether a source at a position (m) is in a room that the listener is not in; sets the
## reverberation of its bus.
func is_in_other_room(p_space: PhysicsDirectSpaceState3D, p_place: Vector3) -> bool:
	if room.is_room():
		return false
	_query.from = p_place + Vector3.UP * _ABOVE_M
	_query.to = p_place + Vector3.UP * _ROOF_M
	if p_space.intersect_ray(_query).is_empty():
		return false
	source_room.look(p_space, p_place + Vector3.UP * _ABOVE_M, 12)
	if source_room.is_room():
		SoundBuses.set_room(SoundBuses.SOURCE_ROOM, source_room)
	return source_room.is_room()
