extends TestCase
## The turret of a vehicle: it follows the gunner within its limits and takes its shapes along.

var _ground: VehicleGround = null
var _tank: Vehicle = null
var _turret: VehicleTurret = null


func before_each() -> void:
	_ground = VehicleGround.new(self)
	_ground.add_floor()
	_tank = _ground.add_vehicle("tank", VehicleParameters.GearKind.RAYS)
	_turret = _tank.get_node(^"Turret")
	await _ground.run(0.3)


func after_each() -> void:
	_ground.free_all()


func test_it_turns_no_faster_than_it_can_and_stops_at_the_gun_s_limits() -> void:
	_turret.aim = Vector2(1.0, 1.0)
	await _ground.run(2.0)
	var turned: float = _tank.state.turret_yaw
	is_true(turned > 0.8 * 2.0 * _turret.yaw_rate and turned < 2.0 * _turret.yaw_rate)
	await _ground.run(3.0)
	almost_equal(_tank.state.gun_pitch, _turret.pitch_max, 0.01)
	_turret.aim = Vector2(0.0, -1.0)
	await _ground.run(5.0)
	almost_equal(_tank.state.gun_pitch, _turret.pitch_min, 0.01)


func test_the_aim_stays_in_the_world_while_the_hull_turns() -> void:
	await _ground.run(0.5)
	var before: Vector3 = -_turret.gun.global_basis.z
	_tank.input.steer = 0.6
	await _ground.run(5.0)
	var after: Vector3 = -_turret.gun.global_basis.z
	is_true(_tank.state.turret_yaw < -1.0, "the hull has turned: %.2f" % _tank.state.turret_yaw)
	is_true(before.angle_to(after) < 0.02, "%.3f rad" % before.angle_to(after))


func test_nonsense_is_nothing() -> void:
	for aim: Vector2 in [Vector2(NAN, 0.0), Vector2(0.0, INF), Vector2(NAN, NAN)]:
		_turret.aim = aim
		equal(_turret.aim, Vector2.ZERO)
	_turret.aim = Vector2(50.0, -50.0)
	equal(_turret.aim, Vector2(1.0, -1.0))


func test_shapes_of_the_turret_turn_with_it() -> void:
	is_true(_turret.shapes.size() > 0)
	var shape: CollisionShape3D = _turret.shapes[0]
	var before: Basis = shape.basis
	_turret.aim = Vector2(1.0, 0.0)
	await _ground.run(2.0)
	var turned: Basis = shape.basis * before.inverse()
	almost_equal(turned.get_euler().y, _tank.state.turret_yaw, 0.02)
