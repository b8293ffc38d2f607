class_name Possession
extends RefCounted
## Which session may command which entities, and who sits where: on the server. An entity has at
## most one possessor, a session at most one seat.

## An entity has another possessor now; 0 is nobody.
signal changed(p_entity: int, p_session: int)
## The command of a session cannot be carried out now; the text says why.
signal refused(p_session: int, p_why: String)

## Least number of ticks between two seats that a session takes: each change moves its people.
const SEAT_TICKS: int = 15

## Says whether a session has people with bodies, who cannot leave every seat: [code]func(session:
## int) -> bool[/code].
var has_people: Callable = func(_session: int) -> bool: return false

var _possessors: Dictionary[int, int] = {}
var _seats: Dictionary[int, SeatGeometry] = {}
# Ticks in which sessions took a seat.
var _sat_ticks: Dictionary[int, int] = {}


## Lets a session possess an entity. Returns false if another one does.
func take(p_session: int, p_entity: int) -> bool:
	var holder: int = possessor_of(p_entity)
	if holder != 0:
		return holder == p_session
	_possessors[p_entity] = p_session
	changed.emit(p_entity, p_session)
	return true


## Ends the possession of an entity.
func release(p_entity: int) -> void:
	if _possessors.erase(p_entity):
		changed.emit(p_entity, 0)


## Ends everything that a session possesses.
func release_all(p_session: int) -> void:
	for entity: int in entities_of(p_session):
		release(entity)


## The session that possesses an entity; 0 nobody.
func possessor_of(p_entity: int) -> int:
	return _possessors.get(p_entity, 0)


## What a session possesses.
func entities_of(p_session: int) -> PackedInt32Array:
	var found: PackedInt32Array = []
	for entity: int in _possessors:
		if _possessors[entity] == p_session:
			found.append(entity)
	return found


## The seat of a session; null none.
func seat_of(p_session: int) -> SeatGeometry:
	# A level that goes takes its seats along.
	var seat: Variant = _seats.get(p_session)
	return seat as SeatGeometry if is_instance_valid(seat) else null


## Notes where a session sits from now on; null nowhere.
func sit(p_session: int, p_seat: SeatGeometry) -> void:
	if p_seat == null:
		_seats.erase(p_session)
	else:
		_seats[p_session] = p_seat
		_sat_ticks[p_session] = Engine.get_physics_frames()


## Whether a session may take a seat already.
func may_sit(p_session: int) -> bool:
	var since: int = Engine.get_physics_frames() - _sat_ticks.get(p_session, -SEAT_TICKS)
	return since >= SEAT_TICKS


## Forgets an entity that is gone, with its seats.
func forget_entity(p_entity: int) -> void:
	release(p_entity)
	for session: int in _seats.keys():
		var seat: SeatGeometry = seat_of(session)
		if seat == null or seat.entity.id == p_entity:
			_seats.erase(session)


## Forgets a session that is gone.
func forget(p_session: int) -> void:
	release_all(p_session)
	_seats.erase(p_session)
	_sat_ticks.erase(p_session)
