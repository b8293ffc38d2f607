class_name Possession
extends RefCounted
## Which session may command which entities: on the server. An entity has at most one possessor.

## An entity has another possessor now; 0 is nobody.
signal changed(p_entity: int, p_session: int)

var _possessors: Dictionary[int, int] = {}


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
