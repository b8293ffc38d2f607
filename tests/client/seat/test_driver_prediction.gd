extends TestCase
## When a driver's vehicle is predicted at the client, and when not any more.

const EXAMPLE: PackedScene = preload("res://examples/05_tank/05_tank.tscn")
## Frames to wait for an event that takes a real second: how many frames there are is known then.
const PATIENCE: int = 20000

var _scene: Node3D = null
var _tank: Vehicle = null
var _controls: SeatControls = null
var _prediction: DriverPrediction = null
var _replica: WorldReplica = null
var _now_s: float = 100.0
var _tick: int = 6000
var _has_news: bool = true


func before_each() -> void:
	_scene = EXAMPLE.instantiate()
	add_child(_scene)
	_tank = _scene.get_node(^"Tank")
	_controls = _scene.get_node(^"Controls")
	_replica = Listener.new()
	_prediction = DriverPrediction.new()
	add_child(_prediction)
	_prediction.follow(
		_controls, _replica, func() -> float: return _now_s, func() -> int: return 40000
	)
	await physics_frames(20)
	(_tank.get_node(^"DriverSeat") as Seat).interact()


func after_each() -> void:
	_prediction.free()
	if is_instance_valid(_scene):
		_scene.free()
	PhysicsServer3D.set_active(true)


func test_a_driver_s_vehicle_is_predicted_ahead_of_the_news() -> void:
	await _until(func() -> bool: return _prediction.predicted != null)
	not_null(_prediction.predicted)
	await _frames(10)
	is_true(_controls.command_tick > _tick, "%d, %d" % [_controls.command_tick, _tick])
	is_true(ClientPhysics.is_stepping())
	equal(_prediction.report()["is_active"], true)


func test_without_news_nothing_is_predicted_any_more() -> void:
	await _until(func() -> bool: return _prediction.predicted != null)
	_has_news = false
	await _frames(DriverPrediction.MAX_AGE_TICKS + 10)
	is_null(_prediction.predicted)
	is_false(ClientPhysics.is_stepping())
	equal(_controls.command_tick, -1)
	_has_news = true
	await _until(func() -> bool: return _prediction.predicted != null)
	not_null(_prediction.predicted)


func test_a_vehicle_that_goes_ends_it() -> void:
	await _until(func() -> bool: return _prediction.predicted != null)
	_tank.free()
	await _frames(4)
	is_null(_prediction.predicted)
	is_false(ClientPhysics.is_stepping())


func test_leaving_the_seat_ends_it() -> void:
	await _until(func() -> bool: return _prediction.predicted != null)
	(_tank.get_node(^"DriverSeat") as Seat).interact()
	await _until(func() -> bool: return _prediction.predicted == null)
	is_null(_prediction.predicted)
	is_false(ClientPhysics.is_stepping())


func _until(p_holds: Callable) -> void:
	for _frame: int in PATIENCE:
		if p_holds.call():
			return
		await _frames(1)


## Frames of a client whose server tells of the tank in each tick.
func _frames(p_count: int) -> void:
	for _frame: int in p_count:
		_now_s += 1.0 / 60.0
		_tick += 1
		if _has_news:
			var id: int = 1024
			if is_instance_valid(_tank):
				id = Entity.find_in(_tank).id
			_replica.newest_tick = _tick
			_replica.smoother.push_body(
				id, _tick, _now_s, Transform3D.IDENTITY, Vector3.ZERO, Vector3.ZERO, false
			)
		_replica.evaluate(_now_s)
		await physics_frames(1)


## A replica whose rate is known without a snapshot.
class Listener:
	extends WorldReplica

	func tick_rate() -> float:
		return 60.0
