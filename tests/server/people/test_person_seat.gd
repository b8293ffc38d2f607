extends TestCase
## Seats on the server: those that move in their body, and those that hold people by forces.

const Stage: GDScript = preload("res://tests/actor/ragdoll/stage.gd")
const SOLDIER: PackedScene = preload("res://scenes/actor/soldier.tscn")
const STEP_USEC: int = 16667
const HIPS: float = 1.0115

var _people: ServerPeople = null
var _carrier: AnimatableBody3D = null
var _arm: Node3D = null
var _now_s: float = 1000.0
var _sent: int = 0


## A seat that holds by forces and has a way of two points.
class HoldingSeat:
	extends Seat

	var points: PackedVector3Array = [Vector3(0.0, 0.0, 3.0), Vector3(0.0, 0.0, 2.0)]

	func hold() -> SeatHold:
		var made: SeatHold = SeatHold.new()
		made.legs = SeatHold.Legs.STANDING
		made.lowest = 0.4
		made.highest = 1.1
		return made

	func way_in(_from: Vector3) -> PackedVector3Array:
		return points

	func way_out(_is_free: Callable) -> PackedVector3Array:
		var back: PackedVector3Array = points.duplicate()
		back.reverse()
		return back


func before_each() -> void:
	_people = ServerPeople.new()
	_people.scene = SOLDIER
	_people.setup(EntityTable.new())
	add_child(_people)
	_people.set_people(7, [PersonCard.of("Ada", HIPS), PersonCard.of("Bob", HIPS, 1)], "Ada")
	_people.settle()
	_carrier = AnimatableBody3D.new()
	_carrier.sync_to_physics = false
	_arm = Node3D.new()
	_carrier.add_child(_arm)
	add_child(_carrier)


func after_each() -> void:
	_people.free()
	if is_instance_valid(_carrier):
		_carrier.free()


func test_a_seat_that_turns_in_its_body_takes_its_people_along() -> void:
	var seat: Seat = _add(Seat.new())
	seat.position = Vector3(2.0, 0.0, 0.0)
	await _wait(20)
	_people.attach(7, 1024, _carrier, seat)
	await _wait(5)
	for _tick: int in 60:
		_arm.rotate_y(1.0 / 60.0)
		await _step()
	var wanted: Vector3 = _arm.basis * seat.position + Vector3.UP * HIPS
	almost_equal(_hips(0), wanted, 0.06)
	equal(_people.list()[1].carrier, _carrier, "all go along where nobody is held")


func test_a_seat_that_holds_takes_the_first_of_a_session() -> void:
	var seat: Seat = _add(HoldingSeat.new())
	await _wait(20)
	_people.attach(7, 1024, _carrier, seat)
	equal([_people.list()[0].carrier, _people.list()[1].carrier], [_carrier, null])


func test_the_way_in_and_out_ends() -> void:
	var seat: Seat = _add(HoldingSeat.new())
	await _wait(20)
	var person: ServerPerson = _people.list()[0]
	_people.attach(7, 1024, _carrier, seat)
	equal(person.sitting.phase, PersonSeat.Phase.COMING)
	await _wait(150)
	equal(person.sitting.phase, PersonSeat.Phase.SITTING)
	equal(person.ragdoll.motor.root_mode, RagdollMotor.ROOT_SOFT)
	almost_equal(_hips(0), Vector3(0.0, HIPS, 0.0), 0.06)
	_people.detach(7)
	equal(person.sitting.phase, PersonSeat.Phase.LEAVING)
	await _wait(150)
	is_null(person.sitting)
	equal(person.carrier_id, -1)
	almost_equal(_hips(0), Vector3(0.0, HIPS, 3.0), 0.1)


func test_people_who_started_on_high_ground_sit_as_high_as_others() -> void:
	var start: Transform3D = Transform3D(Basis(Vector3.UP, 1.0), Vector3(2.0, -4.0, 1.0))
	_carrier.position.y = -4.0
	# Two who are in one place push each other aside.
	_people.set_people(7, [PersonCard.of("Ada", HIPS)], "Ada")
	_people.settle()
	for seat: Seat in [_add(HoldingSeat.new()), _add(Seat.new())] as Array[Seat]:
		_people.enter([start])
		await _wait(20)
		_people.attach(7, 1024, _carrier, seat)
		await _wait(150)
		almost_equal(_hips(0).y, HIPS - 4.0, 0.06)
		_people.detach(7)
		await _wait(150)
		is_null(_people.list()[0].sitting)


func test_who_takes_and_leaves_in_every_tick_gets_stuck_nowhere() -> void:
	var seat: Seat = _add(HoldingSeat.new())
	await _wait(20)
	for number: int in 100:
		if number % 2 == 0:
			_people.attach(7, 1024, _carrier, seat)
		else:
			_people.detach(7)
		await _step()
	_people.detach(7)
	await _wait(160)
	is_null(_people.list()[0].sitting)
	is_true(_hips(0).is_finite())


func test_who_sits_down_again_on_the_way_out_sits() -> void:
	var seat: Seat = _add(HoldingSeat.new())
	await _wait(20)
	_people.attach(7, 1024, _carrier, seat)
	await _wait(150)
	_people.detach(7)
	await _wait(20)
	_people.attach(7, 1024, _carrier, seat)
	await _wait(150)
	equal(_people.list()[0].sitting.phase, PersonSeat.Phase.SITTING)
	almost_equal(_hips(0), Vector3(0.0, HIPS, 0.0), 0.06)


func test_who_has_left_meets_the_vehicle_again() -> void:
	var seat: Seat = _add(HoldingSeat.new())
	await _wait(20)
	_people.attach(7, 1024, _carrier, seat)
	await _wait(150)
	_people.detach(7)
	await _wait(150)
	is_null(_people.list()[0].sitting)
	for bone: PhysicalBone3D in _people.list()[0].ragdoll.find_children("*", "PhysicalBone3D"):
		is_false(bone.get_collision_exceptions().has(_carrier), str(bone.name))


func test_a_seat_that_is_freed_with_its_body_lets_go() -> void:
	var seat: Seat = _add(HoldingSeat.new())
	await _wait(20)
	_people.attach(7, 1024, _carrier, seat)
	await _wait(30)
	_carrier.free()
	await _wait(5)
	is_null(_people.list()[0].carrier)
	_people.detach(7)


func test_a_level_that_goes_ends_the_hold() -> void:
	var seat: Seat = _add(HoldingSeat.new())
	await _wait(20)
	_people.attach(7, 1024, _carrier, seat)
	await _wait(150)
	_people.leave()
	is_null(_people.list()[0].sitting)
	equal(_people.list()[0].ragdoll.motor.root_force, 2000.0)


func test_who_rides_is_carried_by_friction_alone() -> void:
	await _wait(20)
	var person: ServerPerson = _people.list()[0]
	var frame: Transform3D = person.ragdoll.motor.get_frame()
	_people.attach_person(person, 1024, _carrier, Transform3D.IDENTITY, true)
	equal(person.carrier_id, 1024)
	_carrier.position.x += 2.0
	await _wait(5)
	almost_equal(person.ragdoll.motor.get_frame().origin, frame.origin, 0.01)
	_people.detach_person(person)
	equal([person.rides, person.carrier_id], [false, -1])


func test_legs_stand_as_high_as_the_hips_are() -> void:
	var person: ServerPerson = _people.list()[0]
	var lengths: Vector3 = SeatedPose.lengths_of(person.ragdoll.profile)
	almost_equal(lengths.x + lengths.y + lengths.z, HIPS, 0.03)
	var hold: SeatHold = SeatHold.new()
	hold.legs = SeatHold.Legs.STANDING
	for height: float in [0.6, 0.8, 0.95]:
		var fitted: PoseSample = SeatedPose.fit(Stage.reset_pose(), hold, height, lengths)
		var thigh: Vector3 = fitted.orientation(Limbs.LEFT_UPPER_LEG) * Vector3.DOWN
		var shin: Vector3 = fitted.orientation(Limbs.LEFT_LOWER_LEG) * Vector3.DOWN
		var down: Vector3 = thigh * lengths.x + shin * lengths.y
		almost_equal(-down.y, height - lengths.z, 0.01)
		almost_equal(down.z, 0.0, 0.01)
		is_true(thigh.z > 0.1, "knees are ahead")


func test_arms_beside_a_hatch_are_on_the_roof() -> void:
	var person: ServerPerson = _people.list()[0]
	var room: HatchRoom = HatchRoom.new(person.ragdoll.profile)
	var sample: PoseSample = Stage.arms_pose(60.0, 60.0)
	var hold: SeatHold = SeatHold.new()
	hold.hatch_radius = 0.31
	hold.rim = 1.2
	room.fit(sample, Vector3(0.0, HIPS, 0.0), hold, 0.0)
	var raised: Vector3 = sample.orientation(Limbs.LEFT_UPPER_ARM) * Vector3.RIGHT
	var before: Vector3 = (
		Stage.arms_pose(60.0, 60.0).orientation(Limbs.LEFT_UPPER_ARM) * Vector3.RIGHT
	)
	is_true(raised.y > before.y + 0.1, "%s, %s" % [raised, before])
	var free: PoseSample = Stage.arms_pose(-30.0, -30.0)
	hold.rim = 1.0
	room.fit(free, Vector3(0.0, HIPS, 0.0), hold, 0.0)
	var kept: Quaternion = Stage.arms_pose(-30.0, -30.0).orientation(Limbs.LEFT_UPPER_ARM)
	is_true(free.orientation(Limbs.LEFT_UPPER_ARM).angle_to(kept) < 0.001)


func _add(p_seat: Seat) -> Seat:
	var entity: Entity = Entity.new()
	_carrier.add_child(entity)
	p_seat.entity = entity
	_arm.add_child(p_seat)
	return p_seat


func _wait(p_ticks: int) -> void:
	for _tick: int in p_ticks:
		await _step()


func _step() -> void:
	for person: int in 2:
		var pose: PoseSample = Stage.reset_pose()
		pose.person = person
		pose.id = _sent
		pose.time_usec = 1780000000000000 + _sent * STEP_USEC
		pose.root = Vector3(0.0, HIPS, 0.0)
		_people.push_sample(7, pose, _now_s)
	_sent += 1
	_people.drive(_now_s, 1.0 / 60.0)
	await get_tree().physics_frame
	_people.measure()
	_now_s += 1.0 / 60.0


func _hips(p_person: int) -> Vector3:
	var state: Transform3D = PhysicsServer3D.body_get_state(
		_people.list()[p_person].ragdoll.get_bodies()[0], PhysicsServer3D.BODY_STATE_TRANSFORM
	)
	return state.origin
