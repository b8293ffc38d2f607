extends RefCounted
## A walker's client and its server over a bad network, tick by tick: the product's own commands,
## queue, mover and prediction; only the time and the line are made.

const WalkerCourse: GDScript = preload("res://tests/bench/walker/walker_course.gd")
const TICK_S: float = 1.0 / 60.0
## Ticks that inputs arrive before their tick, as at clients.
const MARGIN_TICKS: float = ClientWalker.MARGIN_TICKS
const PERSON: int = 1

## The client's side.
var prediction: WalkerPrediction = WalkerPrediction.new()
## How far a tick's picture was pulled beyond what the walker moved, m.
var pulls: Statistics = Statistics.new()
## Frames by which an input was seen later than offline.
var late_frames: int = 0
## Bytes of commands.
var sent_bytes: int = 0

var _server: WalkerMover = null
var _queue: CommandQueue = CommandQueue.new()
var _schema: EntitySchema = WalkerCourse.walk_schema()
var _chance: RandomNumberGenerator = RandomNumberGenerator.new()
var _loss: float = 0.0
var _one_way: Vector2 = Vector2.ZERO
var _tick: int = 0
var _lead: int = 0
var _sent: Array[EntityCommand] = []
var _number: int = 0
var _correction: int = 0
var _input: WalkerInput = WalkerInput.new()
## What is on the way: at the tick of its arrival.
var _up: Dictionary[int, Array] = {}
var _down: Dictionary[int, Array] = {}
var _last_down: int = 0


## Both on a course; the delay there and back and how much it varies, ms; the share that is lost.
func _init(
	p_course: WalkerCourse, p_delay_ms: float, p_jitter_ms: float, p_loss: float, p_seed: int
) -> void:
	_chance.seed = p_seed
	_loss = p_loss
	_one_way = Vector2(p_delay_ms, p_jitter_ms) / 2000.0 / TICK_S
	_server = p_course.mover()
	_server.place(Vector3(20.0, 1.0, 0.0), 0.0)
	var here: WalkerMover = p_course.mover()
	prediction.mover = here
	prediction.mover.set_state(_server.get_state())
	_lead = ceili(_one_way.x + MARGIN_TICKS)
	prediction.restart_at(_lead)


## Simulated time, s.
func seconds() -> float:
	return _tick * TICK_S


## A tick of both, by what the client's user wishes in it.
func advance(p_input: WalkerInput) -> void:
	_tick += 1
	_advance_client(p_input)
	_advance_server()


func _advance_client(p_input: WalkerInput) -> void:
	var before: Vector3 = prediction.shown()
	for message: PackedByteArray in _down.get(_tick, []):
		var read: WalkMessage = WalkMessage.decode(message)
		prediction.correct(read.tick, read.number, read.state, TICK_S)
	_down.erase(_tick)
	var pulled: float = prediction.shown().distance_to(before)
	var offset: Vector3 = prediction.offset
	var input: WalkerInput = p_input.rounded(_schema)
	input.check = prediction.mover.get_check()
	input.correction = prediction.correction
	_send(input, _tick + _lead)
	prediction.advance(_tick + _lead, input, TICK_S)
	late_frames += 0 if prediction.tick == _tick + _lead else 1
	pulls.add(pulled + (prediction.offset - offset).length())


func _send(p_input: WalkerInput, p_tick: int) -> void:
	var command: EntityCommand = EntityCommand.new()
	command.number = _number
	command.tick = p_tick
	command.entity = PERSON
	command.bytes = _schema.encode(p_input.to_values())
	_number = (_number + 1) & 0xFFFF
	_sent.append(command)
	while _sent.size() > CommandMessage.MAX_REPEATED:
		_sent.pop_front()
	var bytes: PackedByteArray = CommandMessage.encode(_sent)
	sent_bytes += bytes.size()
	if _chance.randf() >= _loss:
		_put(_up, _arrival(), bytes)


func _advance_server() -> void:
	for bytes: PackedByteArray in _up.get(_tick, []):
		for command: EntityCommand in CommandMessage.decode(bytes):
			_queue.push(command, _tick)
	_up.erase(_tick)
	var is_fresh: bool = false
	for command: EntityCommand in _queue.take(_tick, 60):
		_input = WalkerInput.of_values(_schema.decode(ByteReader.new(command.bytes)))
		is_fresh = true
	var differs: bool = is_fresh and _input.check != _server.get_check()
	_input.apply(_server, TICK_S)
	if differs and _input.correction == _correction:
		_correction = (_correction + 1) % WalkerInput.CORRECTIONS
		var message: WalkMessage = WalkMessage.new()
		message.tick = _tick
		message.number = _correction
		message.state = _server.get_state()
		# Reliable ones come late where they are lost, and in their order.
		var lost: int = 0
		while _chance.randf() < _loss:
			lost += 6
		_last_down = maxi(_last_down, _arrival() + lost)
		_put(_down, _last_down, message.encode())


func _arrival() -> int:
	return _tick + maxi(roundi(_one_way.x + _chance.randf_range(-1.0, 1.0) * _one_way.y), 1)


static func _put(r_way: Dictionary[int, Array], p_tick: int, p_bytes: PackedByteArray) -> void:
	if not r_way.has(p_tick):
		r_way[p_tick] = []
	r_way[p_tick].append(p_bytes)
