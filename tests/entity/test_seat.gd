extends TestCase
## Seats: several in one entity, one for each session, and who may command what from which.

const FIELDS: Array[StringName] = [&"driver", &"gunner"]

var _scene: Node3D = null
var _entity: Entity = null
var _seats: Array[Seat] = []


## A seat that says why nobody can leave it.
class StuckSeat:
	extends Seat

	var hindrance: String = "the door is shut"

	func find_hindrance() -> String:
		return hindrance


func before_each() -> void:
	_scene = Node3D.new()
	var body: AnimatableBody3D = AnimatableBody3D.new()
	_scene.add_child(body)
	_entity = Entity.new()
	_entity.type = _make_type()
	body.add_child(_entity)
	_seats.clear()
	for index: int in FIELDS.size():
		var seat: Seat = Seat.new()
		seat.entity = _entity
		seat.index = index
		seat.occupant_field = FIELDS[index]
		body.add_child(seat)
		_seats.append(seat)
	_scene.add_child(LocalSession.new())
	add_child(_scene)


func after_each() -> void:
	_scene.free()


func test_a_seat_is_taken_by_its_index() -> void:
	_seats[1].interact()
	equal([_seats[0].occupant(), _seats[1].occupant()], [0, LocalSession.SESSION])
	is_false(_seats[0].is_mine())
	equal(_possession().possessor_of(_entity.id), 0, "only the first seat possesses the entity")


func test_taking_a_seat_leaves_the_one_before() -> void:
	_seats[1].interact()
	await physics_frames(Possession.SEAT_TICKS)
	_seats[0].interact()
	equal([_seats[0].occupant(), _seats[1].occupant()], [LocalSession.SESSION, 0])
	equal(_possession().possessor_of(_entity.id), LocalSession.SESSION)
	_seats[0].interact()
	equal(_seats[0].occupant(), 0)
	equal(_possession().possessor_of(_entity.id), 0)


func test_a_seat_that_is_taken_stays_taken() -> void:
	is_true(_seats[0].take(7))
	is_false(_seats[0].take(8))
	equal(_seats[0].occupant(), 7)
	equal(_possession().seat_of(8), null)


func test_who_changes_seats_all_the_time_waits() -> void:
	var refusals: Array[String] = []
	_possession().refused.connect(func(_session: int, why: String) -> void: refusals.append(why))
	var taken: int = 0
	for turn: int in 1000:
		taken += 1 if _seats[turn % 2].take(7) else 0
	equal(taken, 1, "all in one tick")
	contains(refusals[-1], "takes seats faster")
	await physics_frames(Possession.SEAT_TICKS)
	is_true(_seats[1].take(7))


func test_a_seat_that_cannot_be_left_now_is_kept() -> void:
	_seats[0].free()
	var refusals: Array[String] = []
	_possession().refused.connect(func(_session: int, why: String) -> void: refusals.append(why))
	var stuck: StuckSeat = StuckSeat.new()
	stuck.entity = _entity
	stuck.index = 2
	stuck.occupant_field = FIELDS[0]
	_entity.get_body().add_child(stuck)
	is_true(stuck.take(LocalSession.SESSION))
	_possession().has_people = func(_session: int) -> bool: return true
	stuck.interact()
	equal(stuck.occupant(), LocalSession.SESSION)
	equal(refusals, ["the door is shut"] as Array[String])
	await physics_frames(Possession.SEAT_TICKS)
	is_false(_add_other().take(LocalSession.SESSION), "nor for a seat elsewhere")
	equal(stuck.occupant(), LocalSession.SESSION)
	_possession().has_people = func(_session: int) -> bool: return false
	stuck.interact()
	equal(stuck.occupant(), 0, "who has no body leaves at any time")


func test_a_seat_below_what_turns_is_where_that_has_it() -> void:
	var arm: Node3D = Node3D.new()
	_entity.get_body().add_child(arm)
	_seats[0].reparent(arm, false)
	_seats[0].position = Vector3(1.0, 2.0, 0.0)
	arm.rotation.y = PI / 2.0
	_entity.get_body().position = Vector3(50.0, 0.0, 0.0)
	almost_equal(_seats[0].frame_in_body().origin, Vector3(0.0, 2.0, -1.0), 1e-5)


func test_a_session_that_is_gone_sits_nowhere() -> void:
	_seats[0].take(7)
	_possession().forget_entity(_entity.id)
	equal(_possession().seat_of(7), null)
	equal(_possession().possessor_of(_entity.id), 0)


func test_a_command_of_a_seat_needs_its_field() -> void:
	var type: EntityType = _make_type()
	equal(type.find_fault(), "")
	type.commands[-1].seat = &"loader"
	contains(type.find_fault(), "needs the field 'loader'")


## A seat of another entity of the same session.
func _add_other() -> Seat:
	var body: AnimatableBody3D = AnimatableBody3D.new()
	var entity: Entity = Entity.new()
	entity.type = _make_type()
	body.add_child(entity)
	var seat: Seat = Seat.new()
	seat.entity = entity
	seat.occupant_field = FIELDS[0]
	body.add_child(seat)
	_scene.add_child(body)
	entity.start(_entity.get_host(), _entity.id + 1, entity.type.spawn_schema().defaults())
	return seat


func _possession() -> Possession:
	return _entity.get_host().possession()


static func _make_type() -> EntityType:
	var type: EntityType = EntityType.new()
	type.name = &"carriage"
	type.body = EntityType.Body.RIGID
	type.commanded_by = EntityType.CommandedBy.ANYBODY
	for field: StringName in FIELDS:
		type.fields.append(EntityField.create_count(field, Seat.MAX_SESSION))
	type.commands = [
		EntitySchema.create(Seat.TAKE, [EntityField.create_count(&"seat", 31)]),
		EntitySchema.create(Seat.LEAVE),
		EntitySchema.create(&"aim"),
	]
	type.commands[2].seat = &"gunner"
	return type
