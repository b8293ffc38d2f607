extends RefCounted
## A client of any role that sends nothing but valid messages, and of those the worst: a trainee
## lists of all sizes, poses that no body can have, bursts of them; an instructor orders of every
## kind; all of them old acknowledgements, commands, stats, calls, requests for levels. It leaves
## and comes back.

const RATES: Array[int] = [1, 10, 60, 144]
## What each role does.
const TRICKS: Dictionary[Roles.Role, Array] = {
	Roles.Role.OBSERVER: [&"ack", &"stats", &"command", &"call", &"request", &"rejoin"],
	Roles.Role.TRAINEE:
	[&"list", &"motion", &"burst", &"ack", &"stats", &"command", &"wearer", &"request", &"rejoin"],
	Roles.Role.INSTRUCTOR:
	[
		&"level",
		&"fields",
		&"order",
		&"effect",
		&"orders",
		&"ack",
		&"stats",
		&"command",
		&"call",
		&"request",
		&"rejoin"
	],
}
## Messages of a burst.
const BURST: int = 100
const HostileOrders: GDScript = preload("hostile_orders.gd")

## How often it has done what.
var done: Dictionary[StringName, int] = {}
## How often it has joined.
var joins: int = 0
## The only tricks that it does, at any time; empty: those of its role, in rounds.
var only: Array[StringName] = []

var _random: RandomNumberGenerator = RandomNumberGenerator.new()
var _port: int = 0
var _link: ClientLink = ClientLink.new()
var _request: JoinRequest = JoinRequest.new()
var _replica: LoadReplica = LoadReplica.new(SharedTables.new())
var _writer: SampleWriter = SampleWriter.new()
var _acks: Array[PackedByteArray] = []
var _orders: HostileOrders = HostileOrders.new(_link, _random)
var _is_lost: bool = false
var _sample: int = 0
var _command: int = 0
## The present round: what is done how often, and until when.
var _tricks: Array[StringName] = []
var _due: Dictionary[StringName, float] = {}
var _rates: Dictionary[StringName, int] = {}
var _round_s: float = 0.0


func _init(p_port: int, p_seed: int, p_role: Roles.Role = Roles.Role.TRAINEE) -> void:
	_port = p_port
	_random.seed = p_seed
	_request.role = p_role
	_link.joined.connect(_on_joined)
	_link.lost.connect(_on_lost)
	_link.refused.connect(_on_lost)
	_link.set_motion_ack_taker(_writer.take_ack)
	_link.state_received.connect(_on_state)
	_open()


## Does what is due at a time, s.
func advance(p_now_s: float) -> void:
	_link.poll()
	if _is_lost:
		_is_lost = false
		_open()
	if not _link.is_joined():
		return
	var ack: PackedByteArray = _replica.acknowledgement(Time.get_ticks_usec(), Vector3.ZERO)
	if not ack.is_empty():
		_acks.append(ack)
		_link.send_fast(ack)
	if p_now_s > _round_s:
		_choose(p_now_s)
	for trick: StringName in _tricks:
		# What was missed while the machine was busy is made up for, as by a client of its own.
		for _again: int in 8:
			if p_now_s < _due[trick] or not _link.is_joined():
				break
			_due[trick] += 1.0 / _rates[trick]
			done[trick] = done.get(trick, 0) + 1
			_do(trick)


## Messages that it has sent.
func messages() -> int:
	var sum: int = 0
	for trick: StringName in done:
		var many: int = BURST if trick == &"burst" or trick == &"orders" else 1
		sum += done[trick] * many * (2 if trick == &"burst" else 1)
	return sum


## Leaves.
func leave() -> void:
	_link.leave()


func _open() -> void:
	_request.name = "fuzz %d" % _random.randi_range(0, 99)
	_request.rate = [0, 1, 30, 240][_random.randi_range(0, 3)]
	_link.open("127.0.0.1", _port, _request)


func _on_state(p_bytes: PackedByteArray, p_arrival_usec: int) -> void:
	_replica.take(p_bytes, p_arrival_usec / 1e6)


## Thrown out, as for a flood: it comes back.
func _on_lost(_why: String) -> void:
	_is_lost = true


func _on_joined() -> void:
	joins += 1
	_replica.clear()
	_writer.restart()


## A round of some tricks, each at a rate of its own.
func _choose(p_now_s: float) -> void:
	_round_s = p_now_s + _random.randf_range(0.2, 0.8)
	_tricks.clear()
	for trick: StringName in TRICKS[_request.role]:
		var is_chosen: bool = _random.randf() < (0.15 if trick == &"rejoin" else 0.6)
		if not only.is_empty():
			is_chosen = only.has(trick)
		if is_chosen:
			_tricks.append(trick)
			_due[trick] = p_now_s
			_rates[trick] = RATES[_random.randi_range(0, RATES.size() - 1)]
	_rates[&"rejoin"] = 4
	_rates[&"burst"] = 2
	_rates[&"orders"] = 2
	_rates[&"level"] = 20
	# As many as a second's limit of packets takes, if all are large.
	_rates[&"effect"] = mini(_rates.get(&"effect", 1), 10)


func _do(p_trick: StringName) -> void:
	match p_trick:
		&"list":
			_link.declare_people(_make_list())
		&"motion":
			_send_motion()
		&"burst":
			for _number: int in BURST:
				_send_motion()
				_link.declare_people(_make_list())
		&"ack":
			if not _acks.is_empty():
				_link.send_fast(_acks[_random.randi_range(0, _acks.size() - 1)])
		&"stats":
			_link.send_fast(StatsMessage.encode(_random.randf() * 1e4, 1e4, 1e4, 240.0))
		&"command":
			_send_command()
		&"orders":
			for _number: int in BURST:
				_orders.send_order()
		&"level":
			_orders.send_level()
		&"fields":
			_orders.send_fields()
		&"order":
			_orders.send_order()
		&"effect":
			_orders.send_effect()
		&"wearer":
			_orders.send_wearer()
		&"call":
			_orders.send_call()
		&"request":
			_orders.send_request()
		&"rejoin":
			if _random.randf() < 0.5:
				_link.leave()
			else:
				_link.close()
			_open()


func _make_list() -> Array[PersonCard]:
	var cards: Array[PersonCard] = []
	for index: int in PersonCard.MAX_PEOPLE:
		if _random.randf() < 0.3:
			continue
		var card: PersonCard = PersonCard.of(
			"é".repeat(_random.randi_range(0, 32)), _random.randf_range(0.21, 1.99), index
		)
		if _random.randf() < 0.7:
			for _limb: int in Limbs.COUNT:
				var is_known: bool = _random.randf() < 0.8
				card.lengths.append(_random.randf_range(0.031, 1.19) if is_known else 0.0)
		cards.append(card)
	return cards


func _send_motion() -> void:
	_sample += 1
	var samples: Array[PoseSample] = []
	var span: float = [0.5, 5.0, 9000.0][_random.randi_range(0, 2)]
	for index: int in _random.randi_range(1, PersonCard.MAX_PEOPLE):
		var pose: PoseSample = PoseSample.new()
		for limb: int in Limbs.COUNT:
			pose.set_orientation(limb, _make_rotation())
		pose.id = _sample
		pose.person = index
		var forward: int = _random.randi_range(-100000, 100000) if _random.randf() < 0.1 else 0
		pose.time_usec = 1780000000000000 + Time.get_ticks_usec() + forward
		pose.root = Vector3(
			_random.randf_range(-span, span), _random.randf_range(0.0, 2.0), _random.randf() * span
		)
		samples.append(pose)
	for bytes: PackedByteArray in _writer.write(samples):
		_link.send_fast(bytes)


func _make_rotation() -> Quaternion:
	var axis: Vector3 = Vector3(_random.randfn(), _random.randfn(), _random.randfn())
	return Quaternion(axis.normalized(), _random.randf() * TAU).normalized()


## A command of the level's, or one that there is not, with fitting values.
func _send_command() -> void:
	var rows: Array[EntityRow] = []
	for id: int in _replica.table.rows:
		if not _replica.table.rows[id].type.commands.is_empty():
			rows.append(_replica.table.rows[id])
	if rows.is_empty():
		return
	var row: EntityRow = rows[_random.randi_range(0, rows.size() - 1)]
	var command: EntityCommand = EntityCommand.new()
	command.number = _command
	_command = (_command + 1) & 0xFFFF
	command.tick = maxi(_replica.newest_tick + _random.randi_range(-20, 20), 0)
	command.entity = row.id if _random.randf() < 0.9 else _random.randi_range(0, 65535)
	command.command = _random.randi_range(0, row.type.commands.size() - 1)
	command.bytes = row.type.commands[command.command].encode([])
	_link.send_fast(CommandMessage.encode([command]))
