class_name VehiclePrediction
extends VehicleCase
## A driver's own vehicle, predicted at the driver's client: how soon it obeys, how far it is from
## the truth, and how far corrections pull the picture.
##
## Server and client are two worlds in one process; commands and news go over a simulated network,
## and places are rounded as on the wire.

## The network: half of the round trip, s, what it varies by, s, and the share that is lost.
const ONE_WAY_S: float = 0.04
const JITTER_S: float = 0.01
const LOSS: float = 0.02
## News come in every so many ticks.
const NEWS_TICKS: int = 2
## Rounding of the wire, m and rad.
const _STEP_M: float = 0.002
const _STEP_RAD: float = 0.001
## The client's ticks are ahead of the server's by so many.
const LEAD_TICKS: int = 8
const SECONDS: float = 60.0
## A vehicle that goes so fast has obeyed, m/s.
const MOVES: float = 0.05

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _server: VehicleGround = null
var _client: VehicleGround = null
var _truth: Vehicle = null
var _predicted: PredictedVehicle = null
var _input: VehicleInput = VehicleInput.new()
## Commands and news on their way: what, and the tick in which they arrive.
var _commands: Array[Array] = []
var _news: Array[Array] = []
var _errors: Statistics = Statistics.new()
var _pulls: Statistics = Statistics.new()
var _tick: int = 0
## Of the vehicle in the newest news, m/s.
var _newest_speed: float = 0.0


func run() -> void:
	_random.seed = 16
	_begin()
	var obeys: Array[int] = await _start_up()
	for step: int in roundi(SECONDS * 60.0):
		if step % 90 == 0:
			_input.throttle = _random.randf_range(0.2, 1.0) if step % 540 > 90 else -0.6
			_input.steer = _random.randf_range(-1.0, 1.0) if _random.randf() < 0.5 else 0.0
		await _advance()
	var title: String = "%s on %s, %.0f ms there and back" % [preset, gear, ONE_WAY_S * 2000.0]
	report.at_most(
		title, "input to motion, own response left out", obeys[1] - obeys[0], "frames", 2.0
	)
	report.add(title, "the same without prediction", obeys[2] - obeys[0], "frames")
	report.add(title, "error at news, p50", _errors.percentile(0.5) * 1000.0, "mm")
	report.add(title, "error at news, p99", _errors.percentile(0.99) * 1000.0, "mm")
	report.at_most(
		title, "pull of the picture, largest", _pulls.percentile(1.0) * 100.0, "cm", 10.0
	)
	_server.free_all()
	_client.free_all()


func _begin() -> void:
	_server = VehicleGround.new(tree.root)
	_client = VehicleGround.new(tree.root)
	for ground: VehicleGround in [_server, _client]:
		ground.add_floor()
		ground.view.add_child(VehicleBumps.create())
	_truth = _server.add_vehicle(preset, kind)
	var shown: Vehicle = _client.add_vehicle(preset, kind)
	shown.freeze = true
	shown.collision_layer = 0
	_predicted = PredictedVehicle.create(shown, _input)
	_client.view.add_child(_predicted)
	_predicted.tick = LEAD_TICKS


## Full throttle from rest. Returns the ticks until the server's vehicle moves after it was told,
## the shown one after the input, and the server's in the news after the input.
func _start_up() -> Array[int]:
	for _step: int in 60:
		await _advance()
	var since: int = _tick
	_input.throttle = 1.0
	var told: int = -1
	var result: Array[int] = [-1, -1, -1]
	while result.has(-1) and _tick - since < 120:
		var was: Vector3 = _predicted.get_shown(0.0).origin
		await _advance()
		if told < 0 and _truth.input.throttle > 0.5:
			told = _tick
		if result[0] < 0 and told >= 0 and _truth.linear_velocity.length() > MOVES:
			result[0] = _tick - told
		var speed: float = _predicted.get_shown(0.0).origin.distance_to(was) * 60.0
		if result[1] < 0 and speed > MOVES:
			result[1] = _tick - since
		if result[2] < 0 and _newest_speed > MOVES:
			result[2] = _tick - since
	return result


## A tick of the server and a step of the client.
func _advance() -> void:
	_tick += 1
	_predicted.begin_step(_tick + LEAD_TICKS)
	_send(_commands, [_tick + LEAD_TICKS, _input.to_values()], false)
	_take_commands()
	_take_news()
	_pulls.add(_predicted.get_pull())
	await tree.physics_frame
	_predicted.fade(1.0 / 60.0)
	if _tick % NEWS_TICKS == 0:
		var place: Transform3D = _truth.global_transform
		place.origin = place.origin.snappedf(_STEP_M)
		var turn: Vector3 = place.basis.get_euler().snappedf(_STEP_RAD)
		place.basis = Basis.from_euler(turn)
		_send(_news, [_tick - 1, place, _truth.angular_velocity, _truth.linear_velocity], true)


func _send(p_queue: Array[Array], p_what: Array, p_may_lose: bool) -> void:
	if p_may_lose and _random.randf() < LOSS:
		return
	var late_s: float = ONE_WAY_S + _random.randf_range(-JITTER_S, JITTER_S)
	p_queue.append([_tick + ceili(late_s * 60.0)] + p_what)


func _take_commands() -> void:
	while not _commands.is_empty() and _commands[0][0] <= _tick and _commands[0][1] <= _tick:
		_truth.input.take_values(_commands.pop_front()[2])


func _take_news() -> void:
	while not _news.is_empty() and _news[0][0] <= _tick:
		var news: Array = _news.pop_front()
		_newest_speed = (news[4] as Vector3).length()
		if _predicted.correct(news[1], news[2], news[4], news[3]):
			_errors.add(_predicted.error_m)
