extends TestCase
## Changes of the entity table on the wire.

const Samples: GDScript = preload("res://tests/entity/entity_samples.gd")
const NetSamples: GDScript = preload("res://tests/net/net_samples.gd")

var _random: RandomNumberGenerator = RandomNumberGenerator.new()


func before_each() -> void:
	_random.seed = 4


func test_a_late_joiner_gets_the_whole_table() -> void:
	var table: EntityTable = _table(20)
	var copy: EntityTable = EntityTable.new()
	copy.spawn(Samples.row(Samples.turret(), "Old"))
	var message: EntityTableMessage = _through_wire(EntityTableMessage.of_table(table, 0.1), copy)
	is_true(message.apply(copy))
	equal([copy.version, copy.types.size()], [table.version, table.types.size()])
	equal(copy.rows.keys(), table.rows.keys())
	for id: int in table.rows:
		_is_same(copy.find(id), table.find(id))


func test_changes_follow() -> void:
	var table: EntityTable = _table(5)
	var copy: EntityTable = EntityTable.new()
	_through_wire(EntityTableMessage.of_table(table, 0.1), copy).apply(copy)
	var gone: int = table.rows.keys()[2]
	table.despawn(gone)
	var fresh: EntityRow = table.spawn(Samples.row(table.types[0], "Fresh"))
	var changes: EntityTableMessage = EntityTableMessage.new()
	changes.version = table.version
	changes.despawned = [gone]
	changes.spawned = [fresh]
	is_true(_through_wire(changes, copy).apply(copy))
	equal([copy.find(gone), copy.find(fresh.id).path, copy.version], [null, "Fresh", table.version])


func test_changes_that_do_not_fit_change_nothing() -> void:
	var copy: EntityTable = EntityTable.new()
	copy.spawn(Samples.row(Samples.turret(), "Here"))
	var again: EntityTableMessage = EntityTableMessage.new()
	again.spawned = [copy.rows.values()[0]]
	is_false(again.apply(copy))
	var ghost: EntityTableMessage = EntityTableMessage.new()
	ghost.despawned = [4000]
	is_false(ghost.apply(copy))
	equal([copy.rows.size(), copy.version], [1, 1])


func test_a_prop_cannot_become_a_person() -> void:
	for pair: Array in [
		[2049, EntityType.Body.PERSON], [1, EntityType.Body.RIGID], [0, EntityType.Body.RIGID]
	]:
		var row: EntityRow = Samples.row(Samples.turret(pair[1]), "X")
		row.id = pair[0]
		row.values = row.type.spawn_schema().defaults()
		var message: EntityTableMessage = EntityTableMessage.new()
		message.is_full = true
		message.types = [row.type]
		message.spawned = [row]
		equal(EntityTableMessage.decode(message.encode(), []), null)


func test_four_thousand_entities_fit() -> void:
	var table: EntityTable = EntityTable.new()
	for number: int in 4000:
		table.spawn(Samples.row(Samples.turret(EntityType.Body.RIGID), "Props/Crate%d" % number))
	var bytes: PackedByteArray = EntityTableMessage.of_table(table, 0.1).encode()
	is_true(MessageParts.split(bytes, 0).size() > 0, "%d bytes" % bytes.size())
	equal(EntityTableMessage.decode(bytes, []).spawned.size(), 4000)


func test_damaged_messages_never_break_a_table() -> void:
	var bytes: PackedByteArray = EntityTableMessage.of_table(_table(6), 0.1).encode()
	for _time: int in 1500:
		var copy: EntityTable = _table(3)
		var damaged: PackedByteArray = NetSamples.damage(_random, bytes)
		var message: EntityTableMessage = EntityTableMessage.decode(damaged, copy.types)
		if message != null and message.apply(copy):
			for id: int in copy.rows:
				is_true(EntityTable.is_id_for(id, copy.rows[id].type.body))
		else:
			equal(copy.rows.size(), 3)


func _through_wire(p_message: EntityTableMessage, p_copy: EntityTable) -> EntityTableMessage:
	return EntityTableMessage.decode(p_message.encode(), p_copy.types)


func _table(p_count: int) -> EntityTable:
	var table: EntityTable = EntityTable.new()
	for number: int in p_count:
		var type: EntityType = EntityType.person()
		if number % 2 == 0:
			type = Samples.turret()
		var row: EntityRow = Samples.row(type, "" if number % 2 == 1 else "Turret%d" % number)
		row.owner = number
		row.tick = number * 1000
		if row.is_person():
			row.person_name = NetSamples.text(_random)
			row.skeleton = NetSamples.skeleton(_random)
			row.person_index = number % 8
		table.spawn(row)
	return table


func _is_same(p_copy: EntityRow, p_row: EntityRow) -> void:
	equal([p_copy.path, p_copy.owner, p_copy.tick], [p_row.path, p_row.owner, p_row.tick])
	equal([p_copy.type_number, p_copy.source], [p_row.type_number, p_row.source])
	equal([p_copy.person_name, p_copy.person_index], [p_row.person_name, p_row.person_index])
	equal(p_copy.skeleton.joints_in_limb, p_row.skeleton.joints_in_limb)
	for index: int in p_row.values.size():
		almost_equal(p_copy.values[index], p_row.values[index], 1e-4)
