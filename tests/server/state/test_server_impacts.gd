extends TestCase
## What strikes what in a world of the server's.

const PERSON: PackedScene = preload("res://scenes/actor/person.tscn")
const CRATE: PackedScene = preload("res://scenes/world/props/crate.tscn")

var _level: ServerLevel = null
var _people: ServerPeople = null
var _impacts: ServerImpacts = null
var _tick: int = 0


func before_each() -> void:
	_level = ServerLevel.new()
	_people = ServerPeople.new()
	_people.scene = PERSON
	add_child(_level)
	add_child(_people)
	_people.setup(_level.table)
	_impacts = ServerImpacts.new(_level, _people)
	equal(_level.load_level("hall"), "")
	await _run(120)


func after_each() -> void:
	_level.free()
	_people.free()


func test_what_rests_is_silent() -> void:
	equal((await _run(120)).size(), 0)


func test_a_crate_that_falls_strikes_the_ground() -> void:
	var crate: RigidBody3D = _crate()
	crate.position = Vector3(4.0, 1.6, 4.0)
	crate.linear_velocity = Vector3.ZERO
	var heard: Array[Impact] = await _run(90)
	is_true(heard.size() >= 1 and heard.size() < 12, "%d" % heard.size())
	var first: Impact = heard[0]
	equal(first.other, Impact.NO_ENTITY)
	equal(ContactMaterial.numbered(first.material).key, "wood")
	equal(ContactMaterial.numbered(first.other_material).key, "concrete")
	almost_equal(first.place.y, 0.0, 0.1)
	# From a metre it has 4.4 m/s.
	var expected: float = crate.mass * 4.4
	is_true(first.impulse > expected * 0.4 and first.impulse < expected * 2.5, "%f" % first.impulse)
	equal((await _run(60)).size(), 0, "then it rests")


func test_a_crate_that_is_pushed_scrapes() -> void:
	var crate: RigidBody3D = _crate()
	crate.position = Vector3(4.0, 0.26, 4.0)
	var heard: Array[Impact] = []
	for _push: int in 10:
		crate.linear_velocity = Vector3(2.0, 0.0, 0.0)
		heard.append_array(await _run(3))
	var scrapes: Array[Impact] = heard.filter(
		func(impact: Impact) -> bool: return impact.slip > 0.0
	)
	is_true(scrapes.size() >= 1, "%d of %d" % [scrapes.size(), heard.size()])


func test_what_has_gone_is_silent_and_nothing_fails() -> void:
	var crate: RigidBody3D = _crate()
	crate.linear_velocity = Vector3(0.0, 3.0, 0.0)
	await _run(10)
	crate.queue_free()
	await _run(60)
	equal(_level.load_level("yard"), "")
	await _run(30)


func test_no_more_than_the_network_may_carry() -> void:
	var count: int = 0
	for prop: RigidBody3D in _level.level.get_props():
		prop.linear_velocity = Vector3(0.0, 4.0, 0.0)
	for impact: Impact in await _run(120):
		count += 1
	is_true(count <= ServerImpacts.RATE * 2.0 + ServerImpacts.BURST)


func _crate() -> RigidBody3D:
	return _level.level.get_props()[0]


## Runs so many ticks; returns what is heard.
func _run(p_ticks: int) -> Array[Impact]:
	var heard: Array[Impact] = []
	for _step: int in p_ticks:
		await physics_frames(1)
		_tick += 1
		heard.append_array(ImpactMessage.decode(_impacts.take_message(_tick, 1.0 / 60.0)))
	return heard
