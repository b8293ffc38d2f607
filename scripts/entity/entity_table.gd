class_name EntityTable
extends RefCounted
## All entities: the server keeps the table, every client has a copy that follows by deltas.
##
## Numbers: 0 is the world itself, 1 to 1023 are people, 1024 to 65535 everything else. The number
## of a removed entity is not reused for a while. Each change raises [member version] by one; a
## client's snapshot has only entities of the version that the client knows.

## An entity has come.
signal spawned(p_row: EntityRow)
## An entity is gone.
signal despawned(p_row: EntityRow)
## All entities and types are gone; types will be numbered from the start.
signal cleared

## Number of the world itself, which has the fields of the level and of the scenario.
const WORLD: int = 0
## Lowest number of a person.
const FIRST_PERSON: int = 1
## Lowest number of anything else.
const FIRST_OTHER: int = 1024
## First number that is invalid.
const END: int = 65536
## Longest path of a node or scene, characters.
const MAX_PATH: int = 250
## Maximum of entities at a time.
const MAX_ENTITIES: int = 8192
## Maximum of types.
const MAX_TYPES: int = 255

## Types, by number.
var types: Array[EntityType] = []
## Rows, by entity.
var rows: Dictionary[int, EntityRow] = {}
## Number of changes so far.
var version: int = 0

var _people: Dictionary[int, EntityRow] = {}
var _next_person: int = FIRST_PERSON
var _next_other: int = FIRST_OTHER


## Number of a type in the table, which is added if it is new; -1 if it is invalid, another
## type has its name, or there are too many.
func add_type(p_type: EntityType) -> int:
	for number: int in types.size():
		if types[number] == p_type:
			return number
		if types[number].name == p_type.name:
			return number if types[number].is_same(p_type) else -1
	if p_type.find_fault() != "" or types.size() >= MAX_TYPES:
		return -1
	types.append(p_type)
	return types.size() - 1


## Adds an entity under a new number; returns its row, or null if there is no room or
## its type cannot be used (see the log). [param p_row] holds all but [member EntityRow.id],
## [member EntityRow.type_number] and [member EntityRow.version].
func spawn(p_row: EntityRow, p_is_world: bool = false) -> EntityRow:
	var number: int = add_type(p_row.type)
	if number < 0:
		var fault: String = p_row.type.find_fault()
		Log.limited(
			"entity",
			"type",
			(
				"%s: no such type can be used: %s"
				% [p_row.path, fault if fault != "" else "another one has its name"]
			)
		)
		return null
	var id: int = WORLD if p_is_world else _free_id(p_row.is_person())
	var is_fit: bool = is_id_for(id, p_row.type.body) and p_row.path.length() <= MAX_PATH
	if id < 0 or rows.size() >= MAX_ENTITIES or rows.has(id) or not is_fit:
		Log.limited(
			"entity",
			"full",
			"there is no room for %s, or its path or type does not fit" % p_row.describe()
		)
		return null
	p_row.id = id
	p_row.type_number = number
	if p_row.values.is_empty():
		p_row.values = p_row.type.spawn_schema().defaults()
	add(p_row)
	return p_row


## Adds a row that already has its number: on a client.
func add(p_row: EntityRow) -> void:
	version += 1
	p_row.version = version
	rows[p_row.id] = p_row
	if p_row.is_person():
		_people[p_row.id] = p_row
	spawned.emit(p_row)


## Removes an entity.
func despawn(p_id: int) -> void:
	var row: EntityRow = rows.get(p_id)
	if row == null:
		return
	version += 1
	rows.erase(p_id)
	_people.erase(p_id)
	despawned.emit(row)


## Removes all entities; types keep their numbers.
func clear_rows() -> void:
	for id: int in rows.keys():
		despawn(id)


## Removes all entities and types: on a client.
func clear() -> void:
	clear_rows()
	types.clear()
	cleared.emit()


## The row of an entity, or null.
func find(p_id: int) -> EntityRow:
	return rows.get(p_id)


## The people, in the order in which they came.
func people() -> Array[EntityRow]:
	return _people.values()


## The person of a session, or null.
func person_of(p_session: int, p_index: int = 0) -> EntityRow:
	for row: EntityRow in people():
		if row.owner == p_session and row.person_index == p_index:
			return row
	return null


## Whether an entity of a kind of body may have a number.
static func is_id_for(p_id: int, p_body: EntityType.Body) -> bool:
	if p_body == EntityType.Body.PERSON:
		return p_id >= FIRST_PERSON and p_id < FIRST_OTHER
	return (
		(p_id >= FIRST_OTHER and p_id < END) or (p_id == WORLD and p_body == EntityType.Body.NONE)
	)


## The next free number; -1 if all are taken.
func _free_id(p_is_person: bool) -> int:
	var first: int = FIRST_PERSON if p_is_person else FIRST_OTHER
	var end: int = FIRST_OTHER if p_is_person else END
	var next: int = _next_person if p_is_person else _next_other
	for _try: int in end - first:
		var id: int = next
		next = next + 1 if next + 1 < end else first
		if not rows.has(id):
			if p_is_person:
				_next_person = next
			else:
				_next_other = next
			return id
	return -1
