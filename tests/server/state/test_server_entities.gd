extends TestCase
## The server's entities: commands that are carried out or refused, seats, people who are carried.

const Stage: GDScript = preload("res://tests/actor/ragdoll/stage.gd")
const PERSON: PackedScene = preload("res://scenes/actor/person.tscn")
const STEP_USEC: int = 16667

var _link: ServerLink = null
var _level: ServerLevel = null
var _people: ServerPeople = null
var _replication: Replication = null
var _entities: ServerEntities = null
var _refusals: Array[String] = []
var _ticks: int = 0
var _number: int = 0


func before_each() -> void:
	_link = ServerLink.new()
	_level = ServerLevel.new()
	_people = ServerPeople.new()
	_people.scene = PERSON
	add_child(_level)
	add_child(_people)
	_people.setup(_level.table)
	_replication = Replication.new(_link, _level, _people, 60, 1e6, 0.1)
	_entities = ServerEntities.new(_link, _level.table, _people, _replication.encoder)
	_level.entity_added.connect(_on_entity_added)
	_entities.command_refused.connect(
		func(_session: int, what: String) -> void: _refusals.append(what)
	)
	equal(_level.load_level("yard"), "")
	for session: int in [1, 2]:
		_entities.add_session(session)
	_refusals.clear()


func after_each() -> void:
	_level.free()
	_people.free()


func test_a_level_that_is_not_there_changes_nothing() -> void:
	var rows: int = _level.table.rows.size()
	contains(_level.load_level("atlantis"), "no world 'atlantis'")
	contains(_level.load_level("hal"), "did you mean hall?")
	contains(_level.load_level("../hall"), "no world '../hall'")
	equal([_level.level_name, _level.table.rows.size()], ["yard", rows])


func test_another_level_takes_the_place_of_the_first() -> void:
	equal(_level.load_level("hall"), "")
	is_null(_find("door"))
	equal(_level.get_child_count(), 1)
	equal(_level.load_level("yard"), "")
	not_null(_find("door"))


func test_anybody_may_press_a_button() -> void:
	_command(1, _find("door"), "press")
	for _tick: int in 90:
		_advance()
		await get_tree().physics_frame
	equal(_level.level.get_node(^"Props/Door/Entity").get_value(&"opening"), 1.0)
	var id: int = _find("door").id
	equal(_replication.encoder.get_field(id, 0), 1.0)
	equal(_refusals, [] as Array[String])


func test_only_who_sits_there_steers() -> void:
	var table: EntityRow = _find("turntable")
	_command(1, table, "steer", [1.0])
	_advance()
	equal(_entities.refused_commands(1), 1)
	_command(1, table, "take_seat")
	_command(2, table, "take_seat")
	_command(2, table, "steer", [1.0])
	_command(1, table, "steer", [1.0])
	_advance()
	equal([_entities.refused_commands(1), _entities.refused_commands(2)], [1, 1])
	equal(_entities.possession().possessor_of(table.id), 1)
	for _tick: int in 60:
		await get_tree().physics_frame
	var node: Entity = _level.level.get_node(^"Props/Turntable/Disc/Entity")
	is_true(node.get_value(&"speed") > 0.3, "%f" % node.get_value(&"speed"))
	_entities.remove_session(1)
	equal([node.get_value(&"occupant"), _entities.possession().possessor_of(table.id)], [0.0, 0])
	_command(2, table, "take_seat")
	_advance()
	equal(node.get_value(&"occupant"), 2.0)


func test_a_command_of_a_seat_is_taken_from_its_occupant_only() -> void:
	var table: EntityRow = _find("turntable")
	var node: Entity = _level.level.get_node(^"Props/Turntable/Disc/Entity")
	var type: EntityType = node.type.duplicate(true)
	type.commands[type.find_command(&"steer")].seat = &"occupant"
	type.commanded_by = EntityType.CommandedBy.ANYBODY
	node.type = type
	_command(2, table, "steer", [1.0])
	_command(1, table, "take_seat")
	_command(1, table, "steer", [1.0])
	_command(2, table, "steer", [-1.0])
	_advance()
	equal([_entities.refused_commands(1), _entities.refused_commands(2)], [0, 2])


func test_forged_commands_are_refused_and_counted() -> void:
	var door: EntityRow = _find("door")
	for forged: Array in [[9999, 0], [0, 0], [1024, 0], [door.id, 7], [door.id, 255]]:
		var command: EntityCommand = _make_command(forged[0], forged[1], PackedByteArray())
		_send(1, command)
	_send(1, _make_command(door.id, 0, PackedByteArray([1, 2, 3])))
	_advance()
	equal(_entities.refused_commands(1), 6)
	contains(_entities._on_commands(_session(1), PackedByteArray([11, 0, 0, 9]), 0), "none")
	equal(_level.level.get_node(^"Props/Door/Entity").get_value(&"opening"), 0.0)


func test_a_person_who_stands_on_a_turntable_is_carried_along() -> void:
	var centre: Vector3 = (_level.level.get_node(^"Props/Turntable") as Node3D).global_position
	_people.enter([Transform3D(Basis.IDENTITY, centre + Vector3(1.5, 0.02, 0.0))])
	_people.set_people(2, [PersonCard.of("Ada", 1.0115)], "Ada")
	_people.settle()
	var person: ServerPerson = _people.list()[0]
	for _tick: int in 40:
		await _stand(2)
	not_null(person.carrier, "the area has noticed who stands there")
	var table: EntityRow = _find("turntable")
	_command(1, table, "take_seat")
	_command(1, table, "steer", [1.0])
	var disc: Node3D = _level.level.get_node(^"Props/Turntable/Disc")
	var before: Vector3 = disc.to_local(_hips(person))
	for _tick: int in 180:
		await _stand(2)
	is_true(disc.rotation.y > 0.8, "it turns: %f rad" % disc.rotation.y)
	var after: Vector3 = disc.to_local(_hips(person))
	is_true(before.distance_to(after) < 0.06, "carried: off by %f m" % before.distance_to(after))
	is_true(_hips(person).distance_to(centre + Vector3(1.5, 1.0, 0.0)) > 0.5)


func test_who_gets_a_body_after_taking_a_seat_sits_in_it() -> void:
	_command(2, _find("turntable"), "take_seat")
	_advance()
	_people.enter([Transform3D(Basis.IDENTITY, Vector3(5.0, 0.0, 5.0))])
	_people.set_people(2, [PersonCard.of("Ada", 1.0115)], "Ada")
	_people.settle()
	var disc: Node = _level.level.get_node(^"Props/Turntable/Disc")
	equal(_people.list()[0].carrier, disc)


func test_a_scene_that_is_added_is_an_entity() -> void:
	var place: Transform3D = Transform3D(Basis.IDENTITY, Vector3(3.0, 0.0, 3.0))
	var added: Entity = _level.add_instance("res://examples/01_door/door.tscn", place, 7, 1)
	var row: EntityRow = _level.table.find(added.id)
	equal([row.source, row.owner, row.tick], [EntityRow.Source.SCENE, 1, 7])
	_command(2, row, "press")
	_advance()
	await get_tree().physics_frame
	await get_tree().physics_frame
	is_true(added.get_value(&"opening") > 0.0)
	is_null(_level.add_instance("res://scenes/world/props/crate.tscn", place, 7))


func test_nothing_is_added_while_a_level_is_loaded_and_nobody_waits() -> void:
	var has_lock: Semaphore = Semaphore.new()
	var is_over: Semaphore = Semaphore.new()
	var thread: Thread = Thread.new()
	thread.start(
		func() -> void:
			RenderLock.hold()
			has_lock.post()
			is_over.wait()
			RenderLock.release()
	)
	has_lock.wait()
	is_null(_level.add_instance("res://examples/01_door/door.tscn", Transform3D.IDENTITY, 7))
	is_over.post()
	thread.wait_to_finish()
	not_null(_level.add_instance("res://examples/01_door/door.tscn", Transform3D.IDENTITY, 7))


func _on_entity_added(p_row: EntityRow, p_node: Entity, _body: PhysicsBody3D) -> void:
	if p_node != null:
		_entities.bind(p_row, p_node)


func _find(p_type: StringName) -> EntityRow:
	for id: int in _level.table.rows:
		if _level.table.rows[id].type.name == p_type:
			return _level.table.rows[id]
	return null


func _command(
	p_session: int, p_row: EntityRow, p_name: StringName, p_values: PackedFloat32Array = []
) -> void:
	var index: int = p_row.type.find_command(p_name)
	var bytes: PackedByteArray = p_row.type.commands[index].encode(p_values)
	_send(p_session, _make_command(p_row.id, index, bytes))


func _make_command(p_entity: int, p_command: int, p_bytes: PackedByteArray) -> EntityCommand:
	var command: EntityCommand = EntityCommand.new()
	command.number = _number
	_number += 1
	command.entity = p_entity
	command.command = p_command
	command.bytes = p_bytes
	return command


func _send(p_session: int, p_command: EntityCommand) -> void:
	equal(_entities._on_commands(_session(p_session), CommandMessage.encode([p_command]), 0), "")


func _session(p_id: int) -> Session:
	var session: Session = Session.new()
	session.id = p_id
	return session


func _advance() -> void:
	_ticks += 1
	_entities.advance(_ticks, 60)


## A tick in which somebody stands upright.
func _stand(p_session: int) -> void:
	await get_tree().physics_frame
	_advance()
	var pose: PoseSample = Stage.reset_pose()
	pose.id = _ticks
	pose.time_usec = 1780000000000000 + _ticks * STEP_USEC
	pose.root = Vector3(0.0, 1.0115, 0.0)
	_people.push_sample(p_session, pose, 1000.0 + _ticks / 60.0)
	_people.drive(1000.0 + _ticks / 60.0, 1.0 / 60.0)
	_people.measure()


static func _hips(p_person: ServerPerson) -> Vector3:
	var state: Transform3D = PhysicsServer3D.body_get_state(
		p_person.ragdoll.get_bodies()[0], PhysicsServer3D.BODY_STATE_TRANSFORM
	)
	return state.origin
