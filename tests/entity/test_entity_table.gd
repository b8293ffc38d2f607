extends TestCase
## Numbers of entities, their limits, and what a table tells.

const Samples: GDScript = preload("res://tests/entity/entity_samples.gd")

var _table: EntityTable = null


func before_each() -> void:
	_table = EntityTable.new()


func test_people_and_others_have_numbers_of_their_own() -> void:
	var person: EntityRow = _table.spawn(Samples.row(EntityType.person()))
	var turret: EntityRow = _table.spawn(Samples.row(Samples.turret(), "Turret"))
	equal([person.id, turret.id], [EntityTable.FIRST_PERSON, EntityTable.FIRST_OTHER])
	equal(_table.people(), [person] as Array[EntityRow])
	is_true(EntityTable.is_id_for(1, EntityType.Body.PERSON))
	is_false(EntityTable.is_id_for(1, EntityType.Body.RIGID))
	is_false(EntityTable.is_id_for(2049, EntityType.Body.PERSON))
	is_false(EntityTable.is_id_for(65536, EntityType.Body.RIGID))
	is_true(EntityTable.is_id_for(EntityTable.WORLD, EntityType.Body.NONE))


func test_a_number_rests_before_it_is_used_again() -> void:
	var type: EntityType = Samples.turret()
	var first: EntityRow = _table.spawn(Samples.row(type))
	_table.despawn(first.id)
	not_equal(_table.spawn(Samples.row(type)).id, first.id)


func test_four_thousand_entities_and_a_limit() -> void:
	var type: EntityType = Samples.turret()
	for _each: int in EntityTable.MAX_ENTITIES:
		_table.spawn(Samples.row(type))
	equal(_table.rows.size(), EntityTable.MAX_ENTITIES)
	equal(_table.spawn(Samples.row(type)), null)


func test_every_change_has_a_version() -> void:
	var spawned: Array[int] = []
	_table.spawned.connect(func(row: EntityRow) -> void: spawned.append(row.version))
	var row: EntityRow = _table.spawn(Samples.row(Samples.turret()))
	_table.spawn(Samples.row(Samples.turret()))
	_table.despawn(row.id)
	_table.despawn(row.id)
	equal([spawned, _table.version], [[1, 2], 3])


func test_a_new_entity_has_the_defaults() -> void:
	var row: EntityRow = _table.spawn(Samples.row(Samples.turret()))
	almost_equal(row.values[1], 0.1, 0.001)
	equal(row.values[2], 40.0)


func test_two_types_cannot_have_one_name() -> void:
	equal(_table.add_type(Samples.turret()), 0)
	equal(_table.add_type(Samples.turret()), 0)
	var other: EntityType = Samples.turret()
	other.fields.pop_back()
	equal(_table.add_type(other), -1)
