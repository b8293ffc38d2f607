extends TestCase
## People in and on vehicles: the way in and out, how a seat holds them, seats below a turret.

const STANDING_HIPS: float = 1.0115

var _ground: VehicleGround = null
var _vehicle: Vehicle = null
var _rider: HatchRider = null


func after_each() -> void:
	_ground.free_all()
	await get_tree().physics_frame


func test_the_commander_climbs_in_and_out() -> void:
	await _begin("tank")
	var ticks: int = await _sit(^"Turret/CommanderSeat")
	is_true(ticks > 60 and ticks < 150, "%d ticks" % ticks)
	var hips: Vector3 = _vehicle.to_local(_rider.hips())
	almost_equal(hips, Vector3(0.52, 1.24 + STANDING_HIPS, 0.27), 0.06)
	is_true(await _leave() < 150)
	await _wait(60)
	hips = _vehicle.to_local(_rider.hips())
	is_true(absf(hips.x) > 1.9, "beside the tank: %s" % hips)
	is_true(hips.y > 0.8 and hips.y < 1.15, "on the ground: %s" % hips)
	equal(_rider.person.ragdoll.motor.root_mode, RagdollMotor.ROOT_GROUNDED)


func test_the_way_in_does_not_leap() -> void:
	await _begin("tank")
	var seat: Seat = _vehicle.get_node(^"Turret/CommanderSeat")
	_rider.people.attach(HatchRider.SESSION, 1024, _vehicle, seat)
	var before: Vector3 = _rider.hips()
	var longest: float = 0.0
	for _tick: int in 150:
		await _step()
		longest = maxf(longest, before.distance_to(_rider.hips()))
		before = _rider.hips()
	is_true(longest < 0.25, "%f m in a tick" % longest)


func test_a_seat_below_the_turret_turns_with_it() -> void:
	await _begin("tank")
	await _sit(^"Turret/CommanderSeat")
	var turret: VehicleTurret = _vehicle.get_node(^"Turret")
	turret.aim = Vector2(1.0, 0.0)
	var farthest: float = 0.0
	for _tick: int in 180:
		await _step()
		var hips: Vector3 = _rider.person.sitting.hips_in_seat()
		farthest = maxf(farthest, Vector2(hips.x, hips.z).length())
	is_true(turret.rotation.y > 1.0, "%f rad" % turret.rotation.y)
	is_true(farthest < 0.03, "off the seat by %f m" % farthest)
	is_true(_rider.mean_deg() < 2.0)


func test_whoever_stands_in_a_hatch_looks_ahead() -> void:
	await _begin("tank")
	await _sit(^"Turret/CommanderSeat")
	var chest: Basis = _rider.person.ragdoll.motor.get_frame().basis
	almost_equal(chest.z, -_vehicle.global_basis.z, 0.05)


func test_the_vehicle_feels_the_person() -> void:
	await _begin("scootmobile")
	await _wait(60)
	var before: float = _load()
	await _sit(^"DriverSeat")
	await _wait(120)
	var more: float = (_load() - before) / 9.8
	is_true(more > 50.0 and more < 110.0, "%f kg more on the wheels" % more)


func test_the_scootmobile_carries_its_rider() -> void:
	await _begin("scootmobile")
	await _sit(^"DriverSeat")
	var kick: Vector3 = _vehicle.linear_velocity
	is_true(kick.length() < 1.0, "who sits down kicks it: %s" % kick)
	var tilt: float = 0.0
	for tick: int in 300:
		_vehicle.input.throttle = 0.5
		_vehicle.input.steer = 0.4 if tick > 150 else 0.0
		await _step()
		tilt = maxf(tilt, rad_to_deg(_vehicle.global_basis.y.angle_to(Vector3.UP)))
		is_true(_rider.person.sitting.hips_in_seat().length() < 0.15)
	is_true(tilt < 15.0, "%f deg" % tilt)
	is_true(_vehicle.position.length() > 5.0, "%s" % _vehicle.position)


func test_a_motion_that_jumps_throws_nobody_out() -> void:
	await _begin("tank")
	await _sit(^"Turret/CommanderSeat")
	var pose: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		pose.set_orientation(limb, Quaternion.IDENTITY)
	for place: Vector3 in [
		Vector3(9.0, 1.0, 0.0), Vector3(-4.0, 3.0, 7.0), Vector3(0.0, -5.0, 0.0)
	]:
		pose.root = place
		_rider.hold(pose)
		for _tick: int in 40:
			await _step()
			var hips: Vector3 = _rider.person.sitting.hips_in_seat()
			is_true(Vector2(hips.x, hips.z).length() < 0.2, "%s" % hips)
			is_true(hips.y > 0.2 and hips.y < 1.3, "%s" % hips)


func test_whoever_is_inside_touches_nothing() -> void:
	await _begin("tank")
	await _sit(^"DriverSeat")
	for body: RID in _rider.person.ragdoll.get_bodies():
		equal(PhysicsServer3D.body_get_collision_layer(body), 0)
	await _leave()
	for body: RID in _rider.person.ragdoll.get_bodies():
		equal(PhysicsServer3D.body_get_collision_layer(body), PhysicsLayers.PEOPLE)


func test_every_seat_of_every_preset_is_taken_and_left() -> void:
	for preset: String in ["tank", "carrier", "truck", "scootmobile"]:
		await _begin(preset)
		for node: Node in _vehicle.find_children("*", "Marker3D", true, false):
			if node is VehicleSeat:
				is_true(await _sit(_vehicle.get_path_to(node)) < 250, "%s in" % node.name)
				is_true(await _leave() < 250, "%s out" % node.name)
		_ground.free_all()
		await get_tree().physics_frame
	await _begin("tank")


func test_from_seat_to_seat_there_is_no_ladder() -> void:
	await _begin("tank")
	await _sit(^"Turret/GunnerSeat")
	is_true(await _sit(^"Turret/CommanderSeat") < 60)


func test_a_vehicle_that_is_freed_lets_go() -> void:
	await _begin("tank")
	await _sit(^"Turret/CommanderSeat")
	_vehicle.free()
	await _wait(5)
	is_null(_rider.person.carrier)
	is_null(_rider.person.sitting)
	is_true(_rider.hips().is_finite())


func test_a_person_who_is_gone_leaves_no_joint() -> void:
	await _begin("tank")
	await _sit(^"Turret/CommanderSeat")
	_rider.people.remove(HatchRider.SESSION)
	_rider.people.settle()
	equal(_rider.people.list().size(), 0)
	for _tick: int in 20:
		await get_tree().physics_frame
	is_true(_vehicle.global_position.is_finite())


func test_nobody_gets_out_of_a_fast_vehicle() -> void:
	await _begin("tank")
	var seat: VehicleSeat = _vehicle.get_node(^"DriverSeat")
	equal(seat.find_hindrance(), "")
	_vehicle.linear_velocity = Vector3(0.0, 0.0, -8.0)
	contains(seat.find_hindrance(), "faster than 3 m/s")


func test_where_ladders_are_blocked_people_get_out_on_the_roof() -> void:
	await _begin("tank")
	var seat: VehicleSeat = _vehicle.get_node(^"Turret/CommanderSeat")
	var none: PackedVector3Array = seat.way_out(func(_at: Vector3) -> bool: return false)
	almost_equal(none[-1].y, 2.24, 0.01)
	var free: PackedVector3Array = seat.way_out(func(_at: Vector3) -> bool: return true)
	almost_equal(free[-1], Vector3(2.1, 0.0, -2.42), 0.01)
	var left: PackedVector3Array = seat.way_out(func(at: Vector3) -> bool: return at.x < 0.0)
	almost_equal(left[-1], Vector3(-2.1, 0.0, -2.42), 0.01)


func _begin(p_preset: String) -> void:
	_ground = VehicleGround.new(get_tree().root)
	_ground.add_floor()
	var start: Transform3D = Transform3D(Basis.IDENTITY, Vector3.UP * 0.02)
	_vehicle = _ground.add_vehicle(p_preset, VehicleParameters.GearKind.RAYS, start)
	var beside: Transform3D = Transform3D(Basis.IDENTITY, Vector3(-2.8, 0.0, -1.5))
	_rider = HatchRider.new(_ground, _vehicle, beside)
	await _wait(40)


func _step() -> void:
	_rider.drive()
	await get_tree().physics_frame
	_rider.measure()


func _wait(p_ticks: int) -> void:
	for _tick: int in p_ticks:
		await _step()


## Takes a seat; returns the ticks until it holds.
func _sit(p_seat: NodePath) -> int:
	_rider.people.attach(HatchRider.SESSION, 1024, _vehicle, _vehicle.get_node(p_seat))
	var ticks: int = 0
	while _rider.person.sitting.phase != PersonSeat.Phase.SITTING and ticks < 300:
		await _step()
		ticks += 1
	await _wait(20)
	return ticks


func _leave() -> int:
	_rider.people.detach(HatchRider.SESSION)
	var ticks: int = 0
	while _rider.person.carrier != null and ticks < 300:
		await _step()
		ticks += 1
	return ticks


func _load() -> float:
	var sum: float = 0.0
	for force: float in _vehicle.stats().spring_forces:
		sum += force
	return sum
