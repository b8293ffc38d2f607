extends TestCase
## People who belong to the server itself, and who is near whom.

const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")
const PERSON: PackedScene = preload("res://scenes/actor/person.tscn")

var _actors: ServerPeople = null
var _table: EntityTable = null
var _now_s: float = 1000.0


func before_each() -> void:
	_actors = ServerPeople.new()
	_actors.scene = PERSON
	_table = EntityTable.new()
	_actors.setup(_table)
	add_child(_actors)


func after_each() -> void:
	_actors.free()


func test_the_server_has_people_of_its_own() -> void:
	_add(7, "Ada", 0.95)
	var guard: int = _actors.enlist(PersonCard.of("", 0.95), "Guard")
	var other: int = _actors.enlist(PersonCard.of("", 0.95), "Other")
	is_true(guard < 0 and other < 0 and guard != other)
	_actors.settle()
	equal(_actors.list().map(_name), ["Ada", "Guard", "Other"])
	var person: ServerPerson = _actors.list()[1]
	var row: EntityRow = _table.find(person.id)
	equal([row.owner, row.person_name], [0, "Guard"], "it is no client's")
	var bytes: EntityTableMessage = EntityTableMessage.new()
	bytes.spawned.append(row)
	equal(EntityTableMessage.decode(bytes.encode(), _table.types).spawned[0].owner, 0)
	var sample: PoseSample = NetSamples.pose(RandomNumberGenerator.new())
	sample.time_usec = 1000000
	_actors.push_sample(guard, sample, _now_s)
	equal(person.newest, sample)
	equal([_actors.list()[0].newest, _actors.list()[2].newest], [null, null])
	_actors.remove(guard)
	_actors.settle()
	equal(_actors.list().map(_name), ["Ada", "Other"])
	_actors.changes.max_people = 2
	equal(_actors.enlist(PersonCard.of("", 0.95), "Third"), 0, "there is no room")


func test_those_near_enough_hear_somebody() -> void:
	for session: int in [7, 8, 9]:
		_add(session, "n%d" % session, 0.95)
	_actors.enlist(PersonCard.of("", 0.95), "Guard")
	_actors.settle()
	var all: Array[ServerPerson] = _actors.list()
	var away_m: float = all[0].hips().distance_to(all[1].hips())
	equal(NearbySessions.find(all, 7, 0.5 * away_m), PackedInt32Array())
	equal(NearbySessions.find(all, 7, 100.0), PackedInt32Array([8, 9]), "no client is the guard")
	equal(NearbySessions.find(all, 55, 100.0), PackedInt32Array(), "who has no body")


func _add(p_session: int, p_name: String, p_hip_height: float) -> void:
	_actors.set_people(p_session, [PersonCard.of(p_name, p_hip_height)], p_name)
	_actors.settle()


func _name(p_person: ServerPerson) -> String:
	return p_person.name
