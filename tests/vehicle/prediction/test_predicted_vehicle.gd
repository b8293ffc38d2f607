extends TestCase
## A predicted vehicle drives as the server's does, and follows it where it does not.

var _server: VehicleGround = null
var _client: VehicleGround = null
var _truth: Vehicle = null
var _predicted: PredictedVehicle = null
var _input: VehicleInput = VehicleInput.new()
var _tick: int = 0


func before_each() -> void:
	_tick = 0
	_server = VehicleGround.new(self)
	_client = VehicleGround.new(self)
	_server.add_floor()
	_client.add_floor()
	_truth = _server.add_vehicle("tank", VehicleParameters.GearKind.SPHERES)
	_truth.input = _input
	var shown: Vehicle = _client.add_vehicle("tank", VehicleParameters.GearKind.SPHERES)
	shown.freeze = true
	shown.collision_layer = 0
	_predicted = PredictedVehicle.create(shown, _input)
	_client.view.add_child(_predicted)
	_predicted.tick = 0


func after_each() -> void:
	_server.free_all()
	_client.free_all()


func test_the_same_input_leads_to_the_same_place() -> void:
	await _advance(60)
	_input.throttle = 1.0
	_input.steer = 0.2
	await _advance(240)
	is_true(_truth.position.length() > 8.0)
	almost_equal(_predicted.ghost.position, _truth.position, 0.02)


func test_what_only_the_server_knows_is_followed_without_a_jump() -> void:
	_input.throttle = 0.6
	await _advance(180)
	# Something has pushed it by half a metre.
	_truth.shift(Transform3D(Basis.IDENTITY, Vector3(0.5, 0.0, 0.0)), Vector3.ZERO, Vector3.ZERO)
	var worst: float = 0.0
	var before: Vector3 = _predicted.get_shown(0.0).origin
	for _news: int in 60:
		await _advance(2)
		_tell()
		var now: Vector3 = _predicted.get_shown(0.0).origin
		worst = maxf(worst, absf(now.x - before.x))
		before = now
	is_true(worst < 0.06, "largest step to the side: %.3f m" % worst)
	almost_equal(_predicted.get_shown(0.0).origin.x, _truth.position.x, 0.02)
	equal(_predicted.restarts, 0)


func test_a_vehicle_that_was_put_elsewhere_begins_anew() -> void:
	await _advance(60)
	_truth.teleport(Transform3D(Basis(Vector3.UP, 2.0), Vector3(40.0, 0.0, 10.0)))
	await _advance(3)
	_tell()
	await _advance(30)
	_tell()
	equal(_predicted.restarts, 1)
	almost_equal(_predicted.get_shown(0.0).origin, _truth.position, 0.1)


func test_a_turn_is_small_wherever_the_vehicle_looks_to() -> void:
	for heading: int in range(-180, 180, 10):
		var was: Basis = Basis(Vector3.UP, deg_to_rad(heading - 0.1))
		var place: Basis = Basis(Vector3.UP, deg_to_rad(heading + 0.1))
		_predicted.restart(Transform3D(was, Vector3.UP), Vector3.ZERO, Vector3.ZERO, heading + 200)
		_predicted.begin_step(heading + 201)
		_predicted.correct(
			heading + 200, Transform3D(place, Vector3.UP), Vector3.ZERO, Vector3.ZERO
		)
	equal(_predicted.restarts, 0)


func test_news_of_ticks_that_nobody_remembers_are_not_compared() -> void:
	await _advance(10)
	is_false(_predicted.correct(99999, Transform3D.IDENTITY, Vector3.ZERO, Vector3.ZERO))
	is_false(_predicted.correct(-5, Transform3D.IDENTITY, Vector3.ZERO, Vector3.ZERO))


func test_it_stands_in_nobody_s_way() -> void:
	equal(_predicted.ghost.collision_layer, 0)
	is_null(Entity.find_in(_predicted.ghost))


func _advance(p_ticks: int) -> void:
	for _step: int in p_ticks:
		_tick += 1
		_predicted.begin_step(_tick)
		await physics_frames(1)
		_predicted.fade(1.0 / 60.0)


## The server's news of the last tick that is remembered.
func _tell() -> void:
	_predicted.correct(
		_tick - 1, _truth.global_transform, _truth.linear_velocity, _truth.angular_velocity
	)
