extends TestCase
## Armour holds or is pierced; who is knocked out does nothing until the vehicle is repaired.

const AHEAD: Vector3 = Vector3(0.0, 0.0, -1.0)

var _range: FiringRange = null


func before_each() -> void:
	_range = FiringRange.new(self)
	await _range.settle()


func after_each() -> void:
	_range.free_all()


func test_front_holds_and_side_does_not() -> void:
	_hit(Vector3(0.0, 1.0, 1.0) * 3.0, Vector3.BACK * 1600.0, Vector3.FORWARD)
	is_true(_damage() != VehicleState.Damage.KNOCKED_OUT, "the front")
	_range.armour.repair()
	_hit(Vector3(1.7, 1.2, 0.0), Vector3.LEFT * 1600.0, Vector3.RIGHT)
	equal(_damage(), VehicleState.Damage.KNOCKED_OUT)


func test_the_turrets_front_turns_with_it() -> void:
	var place: Vector3 = _range.tank.to_global(Vector3(1.0, 2.2, 0.0))
	almost_equal(_range.armour.steel_at(place, Vector3.RIGHT), 70.0, 1e-3)
	_range.tank.state.turret_yaw = -PI / 2.0
	almost_equal(_range.armour.steel_at(place, Vector3.RIGHT), 600.0, 1e-3)
	almost_equal(_range.armour.steel_at(place, Vector3.UP), 40.0, 1e-3)
	var low: Vector3 = _range.tank.to_global(Vector3(1.7, 1.0, 0.0))
	almost_equal(_range.armour.steel_at(low, Vector3.RIGHT), 70.0, 1e-3)


func test_flat_hits_and_slow_ones_get_through_less() -> void:
	var dart: Ammunition = _range.gun.ammunition[0]
	var place: Vector3 = _range.tank.to_global(Vector3(1.7, 1.0, 0.0))
	var straight: float = _range.armour.take_hit(dart, Vector3.LEFT * 1650.0, place, Vector3.RIGHT)
	var slanted: Vector3 = Vector3(-0.5, 0.0, -sqrt(0.75)) * 1650.0
	almost_equal(_range.armour.take_hit(dart, slanted, place, Vector3.RIGHT), straight * 0.5, 0.01)
	almost_equal(_range.armour.take_hit(dart, Vector3(NAN, 0, 0), place, Vector3.RIGHT), 0.0, 0.0)


func test_who_is_knocked_out_does_nothing_until_it_is_repaired() -> void:
	_range.tank.get_node("DriverSeat")
	_hit(Vector3(1.7, 1.2, 0.0), Vector3.LEFT * 1600.0, Vector3.RIGHT)
	await _range.ground.run(0.1)
	equal(_range.entity.get_value(&"damage"), 2.0)
	is_true(not _range.tank.state.engine_on)
	_range.command(&"engine", [1.0])
	for _tick: int in 180:
		_range.command(&"drive", [1.0, 0.5, 0.0, 0.0, 1.0])
		_range.command(&"aim", [1.0, 0.0])
		_range.command(&"fire")
		_range.command(&"fire_coax", [1.0])
		await _range.ground.run(1.0 / 60.0)
	is_true(Vector2(_range.tank.position.x, _range.tank.position.z).length() < 0.3)
	almost_equal(_range.tank.state.turret_yaw, 0.0, 0.05)
	equal(_range.gun.left[0], 24)
	equal(_range.coax.left[0], 4700)
	var type: EntityType = _range.entity.type
	equal(type.commands[type.find_command(&"repair")].capability, Roles.Capability.DIRECT)
	_range.command(&"fire_coax", [0.0])
	_range.command(&"repair")
	await _range.ground.run(0.5)
	equal(_range.entity.get_value(&"damage"), 0.0)
	is_true(_range.tank.state.engine_on)
	_range.command(&"fire")
	equal(_range.gun.left[0], 23)


func test_a_tank_shoots_another_one() -> void:
	var other: Vehicle = VehicleGround.create("tank")
	other.position = Vector3(0.0, 0.05, -150.0)
	other.rotation.y = PI / 2.0
	_range.ground.view.add_child(other)
	await _range.ground.run(1.0)
	_range.aim_at(other.global_position + Vector3(0.0, 1.2, 0.0))
	await _range.ground.run(0.1)
	_range.command(&"fire")
	await _range.ground.run(1.0)
	equal(_range.hits[0][2], &"metal")
	equal(other.state.damage, VehicleState.Damage.KNOCKED_OUT)
	is_true(other.global_basis.y.y > 0.98)


func test_bullets_wear_down_a_truck_and_not_a_tank() -> void:
	var ball: Ammunition = _range.coax.ammunition[0]
	var truck: Vehicle = VehicleGround.create("truck")
	truck.position = Vector3(20.0, 0.05, 0.0)
	_range.ground.view.add_child(truck)
	var armour: VehicleArmour = VehicleArmour.find_in(truck)
	for shot: int in 40:
		armour.take_hit(
			ball, Vector3.LEFT * 800.0, truck.to_global(Vector3(1, 1, 0)), Vector3.RIGHT
		)
		_hit(Vector3(1.7, 1.2, 0.0), Vector3.LEFT * 800.0, Vector3.RIGHT, ball)
		if shot == 6:
			equal(truck.state.damage, VehicleState.Damage.DAMAGED)
	equal(truck.state.damage, VehicleState.Damage.KNOCKED_OUT)
	equal(_damage(), VehicleState.Damage.WHOLE)


func test_a_burst_near_a_truck_pierces_it() -> void:
	var truck: Vehicle = VehicleGround.create("truck")
	truck.position = Vector3(0.0, 0.05, -60.0)
	_range.ground.view.add_child(truck)
	await _range.ground.run(1.0)
	var space: PhysicsDirectSpaceState3D = _range.space()
	ShellHits.burst(space, Vector3(0.0, 0.4, -55.0), _range.gun.ammunition[1])
	equal(truck.state.damage, VehicleState.Damage.DAMAGED)
	await _range.ground.run(2.0)
	is_true(truck.global_basis.y.y > 0.9 and truck.linear_velocity.length() < 1.0)


func _hit(
	p_place: Vector3, p_velocity: Vector3, p_normal: Vector3, p_kind: Ammunition = null
) -> void:
	var kind: Ammunition = p_kind if p_kind != null else _range.gun.ammunition[0]
	_range.armour.take_hit(kind, p_velocity, _range.tank.to_global(p_place), p_normal)


func _damage() -> VehicleState.Damage:
	return _range.tank.state.damage
