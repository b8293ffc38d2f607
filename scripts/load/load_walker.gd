class_name LoadWalker
extends RefCounted
## The hands of a load client that walks: a wish for each tick of the server, another each second.
##
## It has no world to predict in, so its server corrects it once each round trip, where an honest
## client's walker is hardly ever corrected: what it costs is the most that a walker can cost.

## Time for which a wish lasts, s.
const _LASTS_S: float = 1.0
## What is wished: velocity ahead and to the right, m/s.
const _WISHES: PackedVector2Array = [
	Vector2(1.6, 0.0),
	Vector2(1.6, 0.0),
	Vector2(3.2, 0.0),
	Vector2(0.0, 0.0),
	Vector2(-1.0, 0.0),
	Vector2(0.0, 1.0),
]

var _link: ClientLink = null
var _replica: WorldReplica = null
var _entities: ClientEntities = null
var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _input: WalkerInput = WalkerInput.new()
var _wish: Vector2 = Vector2.ZERO
var _turn: float = 0.0
var _until: int = -1
var _tick: int = -1


## Walks as a client whose replica it is; each seed walks elsewhere.
func _init(p_link: ClientLink, p_replica: WorldReplica, p_seed: int) -> void:
	_link = p_link
	_replica = p_replica
	_random.seed = p_seed
	_entities = ClientEntities.new(p_replica)
	var stream: LiveStream = LiveStream.new()
	stream.link = p_link
	_entities.use(stream)
	_link.handle(Protocol.Message.WALK, MessageHandlers.Path.RELIABLE, _on_walk)


## A connection begins.
func restart() -> void:
	_tick = -1
	_until = -1
	_input = WalkerInput.new()
	_entities.restart()


## Sends the wish of the tick that is due. Call it as often as ticks are made.
func advance() -> void:
	var row: EntityRow = _replica.table.person_of(_link.session, 0)
	var command: int = row.type.find_command(WalkerInput.COMMAND) if row != null else -1
	if command < 0 or not _link.clock.is_known():
		return
	var rate: float = _replica.tick_rate()
	var there_s: float = _link.clock.round_trip_usec / 2e6
	var reached: float = _link.clock.tick_at(Time.get_ticks_usec()) + there_s * rate
	var due: float = reached + ClientWalker.MARGIN_TICKS
	if int(due) <= _tick:
		return
	_tick = int(due)
	_choose(rate)
	_input.heading = wrapf(_input.heading + _turn / rate, -PI, PI)
	_input.wish = WalkerInput.to_world(_wish.x, _wish.y, _input.heading)
	_entities.send_command(row.id, command, _input.to_values(), _tick)


func _choose(p_rate: float) -> void:
	if _tick < _until:
		return
	_until = _tick + roundi(_LASTS_S * p_rate)
	_wish = _WISHES[_random.randi() % _WISHES.size()]
	_turn = _random.randf_range(-1.5, 1.5)


func _on_walk(p_bytes: PackedByteArray, _arrival_usec: int) -> bool:
	var message: WalkMessage = WalkMessage.decode(p_bytes)
	if message == null:
		return false
	_input.correction = message.number % WalkerInput.CORRECTIONS
	return true
