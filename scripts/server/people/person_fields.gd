class_name PersonFields
extends RefCounted
## Sets the fields of a person's entity: what carries the person, the heading of its own frame, and
## its tether.

## Ticks between two looks at what changes by itself.
const _PERIOD_TICKS: int = 12
## A tether that is shorter than this is none, m.
const _MIN_TETHER_M: float = 0.1
## Turn of a frame between two looks that means that it still turns, rad.
const _STEADY: float = 0.002

var _encoder: SnapshotEncoder = null
var _table: EntityTable = null
## Headings of people's frames at the last look, and those that clients know, rad.
var _headings: Dictionary[int, float] = {}
var _sent: Dictionary[int, float] = {}


func _init(p_encoder: SnapshotEncoder, p_table: EntityTable) -> void:
	_encoder = p_encoder
	_table = p_table


## Says what carries a person from now on; -1 nothing.
func attach(p_person: ServerPerson, p_carrier: int) -> void:
	_encoder.set_frame(p_person.id, p_carrier)
	_put(p_person, EntityType.CARRIER, maxi(p_carrier, 0))
	_send_heading(p_person)


## Looks at everybody, in some of the ticks.
func advance(p_tick: int, p_people: Array[ServerPerson]) -> void:
	if p_tick % _PERIOD_TICKS != 0:
		return
	for person: ServerPerson in p_people:
		var tether: Vector3 = person.ragdoll.motor.get_tether()
		if Vector2(tether.x, tether.z).length() < _MIN_TETHER_M:
			tether = Vector3.ZERO
		_put(person, EntityType.TETHER_X, tether.x)
		_put(person, EntityType.TETHER_Z, tether.z)
		if person.carrier == null:
			_follow_heading(person)


## Forgets somebody who has left.
func forget(p_person: int) -> void:
	_headings.erase(p_person)
	_sent.erase(p_person)


## A platform has turned the person's frame: clients get it once the frame is at rest, as the
## wearer's view jumps with it.
func _follow_heading(p_person: ServerPerson) -> void:
	var heading: float = _heading_of(p_person)
	var is_steady: bool = _is_near(heading, _headings.get(p_person.id, heading))
	_headings[p_person.id] = heading
	if is_steady and not _is_near(heading, _sent.get(p_person.id, heading)):
		_send_heading(p_person)


func _send_heading(p_person: ServerPerson) -> void:
	_headings[p_person.id] = _heading_of(p_person)
	_sent[p_person.id] = _headings[p_person.id]
	_put(p_person, EntityType.HEADING, _sent[p_person.id])


func _put(p_person: ServerPerson, p_field: StringName, p_value: float) -> void:
	var row: EntityRow = _table.find(p_person.id)
	if row != null and row.type.find_field(p_field) >= 0:
		_encoder.set_field(p_person.id, row.type.find_field(p_field), p_value)


static func _is_near(p_heading: float, p_other: float) -> bool:
	return absf(angle_difference(p_heading, p_other)) < _STEADY


static func _heading_of(p_person: ServerPerson) -> float:
	return p_person.ragdoll.motor.get_frame().basis.get_euler().y
