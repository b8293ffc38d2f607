extends TestCase
## Shells fly as the reference does, hit what is in their way, and are forgotten.

var _range: FiringRange = null


func before_each() -> void:
	_range = FiringRange.new(self)
	await _range.settle()


func after_each() -> void:
	_range.free_all()


func test_a_shell_hits_a_wall_where_it_should_by_its_drop() -> void:
	_range.gun.dispersion = 0.0
	_range.ground.add_box(
		Vector3(40.0, 60.0, 1.0), Transform3D(Basis.IDENTITY, Vector3(0.0, 20.0, -1000.5))
	)
	_range.aim_at(Vector3(0.0, 8.0, -1000.0))
	await _range.ground.run(0.1)
	var muzzle: Transform3D = _range.gun.global_transform
	_range.command(&"fire")
	await _range.ground.run(1.2)
	equal(_range.hits.size(), 1)
	var way: Vector3 = -muzzle.basis.z
	var at_wall: Vector3 = muzzle.origin + way * ((-1000.0 - muzzle.origin.z) / way.z)
	var place: Vector3 = _range.hits[0][0]
	almost_equal(place.z, -1000.0, 0.02)
	# 0.62 s of flight: 1.86 m.
	almost_equal(at_wall.y - place.y, 1.87, 0.08)
	almost_equal(place.x, at_wall.x, 0.1)
	almost_equal(_range.hits[0][1], Vector3.BACK, 0.03)
	equal(_range.hits[0][2], &"stone")
	equal(_range.shells.flying().size(), 0)


func test_no_shell_goes_through_a_thin_wall_or_starts_behind_one() -> void:
	_range.ground.add_box(
		Vector3(40.0, 20.0, 0.05), Transform3D(Basis.IDENTITY, Vector3(0.0, 9.0, -30.0))
	)
	_range.command(&"fire")
	await _range.ground.run(0.2)
	equal(_range.hits.size(), 1)
	# The muzzle is beyond this one, 7 m ahead of the tank's middle; the breech is not.
	_range.ground.add_box(
		Vector3(40.0, 20.0, 0.05), Transform3D(Basis.IDENTITY, Vector3(0.0, 9.0, -5.0))
	)
	await _range.ground.run(6.2)
	_range.command(&"fire")
	await _range.ground.run(0.2)
	equal(_range.hits.size(), 2)
	almost_equal(_range.hits[1][0].z as float, -5.0, 0.1)


func test_a_client_flies_the_same_shell() -> void:
	var told: Array[PackedFloat32Array] = []
	_range.entity.happened.connect(
		func(p_event: StringName, p_values: PackedFloat32Array) -> void:
			if p_event == Shells.FIRED:
				told.append(p_values)
	)
	_range.aim_at(Vector3(300.0, 200.0, -1000.0))
	await _range.ground.run(0.1)
	_range.command(&"fire")
	equal(told.size(), 1)
	var schema: EntitySchema = _range.entity.type.events[_range.entity.type.find_event(&"fired")]
	var received: PackedFloat32Array = schema.decode(ByteReader.new(schema.encode(told[0])))
	var flight: ShellFlight = _range.shells.kinds[int(received[0])].make_flight()
	var place: Vector3 = Vector3(received[1], received[2], received[3])
	var way: Vector3 = Shells.direction_of(Vector2(received[4], received[5]))
	is_true(flight.launch(place, way * received[6]))
	await _range.ground.run(2.0)
	equal(_range.shells.flying().size(), 1)
	var server: ShellFlight = _range.shells.flying()[0].flight
	# A client's frames are of any length.
	while flight.get_age() < server.get_age() - 1e-6:
		flight.advance(minf(0.0137, server.get_age() - flight.get_age()))
	almost_equal(flight.get_position(), server.get_position(), 0.01)
	is_true(schema.size() <= 26, "%d bytes" % schema.size())


func test_a_shell_that_hits_nothing_is_forgotten() -> void:
	var up: Vector3 = Vector3(0.0, 2000.0, -2000.0)
	_range.aim_at(up)
	await _range.ground.run(0.1)
	_range.command(&"fire")
	await _range.ground.run(1.0)
	equal(_range.shells.flying().size(), 1)
	await _range.ground.run(Shells.LIFE_S)
	equal(_range.shells.flying().size(), 0)
	equal(_range.hits.size(), 0)


func test_what_is_not_finite_is_not_fired() -> void:
	var dart: Ammunition = _range.gun.ammunition[0]
	var here: Vector3 = Vector3(0.0, 2.0, -8.0)
	is_true(not _range.shells.launch(dart, here, here, Vector3(NAN, 0.0, 0.0)))
	is_true(not _range.shells.launch(dart, here, Vector3(INF, 0.0, 0.0), Vector3.FORWARD))
	is_true(not _range.shells.launch(dart, here, here, Vector3.FORWARD * 1e6))
	is_true(not _range.shells.launch(Ammunition.new(), here, here, Vector3.FORWARD))
	equal(_range.shells.flying().size(), 0)
	# A forged event, or one of a later version, is dropped.
	_range.shells._on_happened(Shells.FIRED, [14.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
	_range.shells._on_happened(Shells.IMPACT, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 31.0, 7.0])
	equal(_range.hits.size(), 1)


func test_targets_that_are_freed_in_flight_do_no_harm() -> void:
	for number: int in 20:
		var crate: RigidBody3D = _range.add_crate(Vector3(0.0, 1.9, -20.0 - number))
		crate.freeze = true
		_range.gun.loaded = 1.0
		_range.command(&"fire")
		crate.queue_free()
		await _range.ground.run(0.05)
	await _range.ground.run(2.0)
	is_true(_range.hits.size() >= 1)
	equal(_range.shells.flying().size(), 0)


func test_only_some_impacts_of_bullets_are_sent() -> void:
	var sent: Array[int] = [0]
	_range.entity.happened.connect(
		func(p_event: StringName, _values: PackedFloat32Array) -> void:
			sent[0] += 1 if p_event == Shells.BULLET_IMPACT else 0
	)
	var ball: Ammunition = _range.coax.ammunition[0]
	for number: int in 50:
		var from: Vector3 = Vector3(0.2 * number, 2.0, -20.0)
		is_true(_range.shells.launch(ball, from, from, Vector3.DOWN * 800.0))
	await _range.ground.run(0.1)
	equal(sent[0], Shells.MAX_BULLET_IMPACTS)
	equal(_range.shells.flying().size(), 0)
	var type: EntityType = _range.entity.type
	is_true(not type.events[type.find_event(Shells.BULLET_IMPACT)].is_reliable)


func test_the_air_is_never_too_full() -> void:
	var ball: Ammunition = _range.coax.ammunition[0]
	var from: Vector3 = Vector3(0.0, 2.0, -20.0)
	for _number: int in 1000:
		_range.shells.launch(ball, from, from, Vector3.UP * 800.0)
	equal(_range.shells.flying().size(), Shells.MAX_FLYING)
