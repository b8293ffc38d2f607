extends RefCounted
## A client that joins, has people, moves them a little and acknowledges what comes, with as little
## work as possible: what is measured is the server.

## Where who watches is, m.
const EYE: Vector3 = Vector3(0.0, 1.6, 4.0)
## Time between two attempts to join, s.
const RETRY_S: float = 0.5

## Messages about the table are decoded once for all.
static var tables: SharedTables = SharedTables.new()

## Samples a second.
var rate: int = 10
## How often it has joined.
var joins: int = 0
## Snapshots of use.
var snapshots: int = 0
## Largest time between two of them since [method begin_counting], s.
var gap_s: float = 0.0
## Why the server refuses it, or an empty text.
var refusal: String = ""
## What the server has told it.
var told: String = ""
## Heights of the hips of its people, m; empty for an observer.
var heights: PackedFloat32Array = PackedFloat32Array()

var _link: ClientLink = ClientLink.new()
var _request: JoinRequest = JoinRequest.new()
var _replica: LoadReplica = LoadReplica.new(tables)
var _writer: SampleWriter = SampleWriter.new()
var _port: int = 0
var _sample: int = 0
var _due_usec: int = 0
var _arrival_usec: int = 0
var _retry_usec: int = 0


func _init(p_name: String, p_port: int, p_heights: PackedFloat32Array) -> void:
	_port = p_port
	heights = p_heights
	_request.name = p_name
	_request.role = Roles.Role.OBSERVER if p_heights.is_empty() else Roles.Role.TRAINEE
	_link.joined.connect(_on_joined)
	# No lambdas: they would hold this, which holds the link, which holds them.
	_link.lost.connect(_on_lost)
	_link.refused.connect(_on_refused)
	_link.notified.connect(_on_told)
	_link.state_received.connect(_on_state)
	_link.set_motion_ack_taker(_writer.take_ack)


## Begins to join.
func open() -> void:
	_retry_usec = 0
	_link.open("127.0.0.1", _port, _request)


## Leaves.
func close() -> void:
	_link.leave()


## Whether it has been admitted.
func is_joined() -> bool:
	return _link.is_joined()


## People that it knows of.
func people() -> int:
	return _replica.table.people().size()


## Own people that have a body.
func bodies() -> int:
	var own: int = 0
	for row: EntityRow in _replica.table.people():
		own += 1 if row.owner == _link.session else 0
	return own


## Says which people it has.
func declare() -> void:
	var cards: Array[PersonCard] = []
	for index: int in heights.size():
		var card: PersonCard = PersonCard.of(
			"%s %d" % [_request.name, index], heights[index], index
		)
		card.lengths.resize(Limbs.COUNT)
		for limb: int in Limbs.LEGS:
			card.lengths[limb] = 0.42 * heights[index] if limb % 3 != 0 else 0.0
		cards.append(card)
	_link.declare_people(cards)


## Counts anew.
func begin_counting() -> void:
	snapshots = 0
	gap_s = 0.0
	_arrival_usec = 0


## Takes what has come, and sends what is due.
func poll() -> void:
	_link.poll()
	var now: int = _now()
	if _retry_usec > 0 and now > _retry_usec:
		open()
	if not _link.is_joined():
		return
	var ack: PackedByteArray = _replica.acknowledgement(now, EYE)
	if not ack.is_empty() and not _rides_along(ack):
		_link.send_fast(ack)
	if heights.is_empty() or now < _due_usec:
		return
	# A sample that is late does not make the next ones late.
	_due_usec = maxi(_due_usec + 1000000 / rate, now - 1000000 / rate)
	_send()


## Whether an acknowledgement leaves with the next samples.
func _rides_along(_ack: PackedByteArray) -> bool:
	return false


func _send() -> void:
	_sample += 1
	var samples: Array[PoseSample] = []
	for index: int in heights.size():
		var pose: PoseSample = _pose(index)
		pose.id = _sample
		pose.person = index
		pose.time_usec = 1780000000000000 + _now()
		samples.append(pose)
	for bytes: PackedByteArray in _writer.write(samples):
		_link.send_fast(bytes)


## What one of the people does.
func _pose(p_person: int) -> PoseSample:
	var pose: PoseSample = PoseSample.new()
	for limb: int in Limbs.COUNT:
		pose.set_orientation(limb, Quaternion.IDENTITY)
	pose.root = Vector3(0.05 * sin(_sample * 0.2), heights[p_person], 0.0)
	return pose


func _on_lost(_why: String) -> void:
	_retry_usec = _now() + int(RETRY_S * 1e6)


func _on_refused(p_why: String) -> void:
	refusal = p_why


func _on_told(p_text: String) -> void:
	told = p_text


func _on_joined() -> void:
	joins += 1
	_replica.clear()
	_writer.restart()
	if not heights.is_empty():
		declare()


func _on_state(p_bytes: PackedByteArray, p_arrival_usec: int) -> void:
	if not _replica.take(p_bytes, p_arrival_usec / 1e6):
		return
	if Protocol.SNAPSHOTS.has(int(p_bytes[0])):
		snapshots += 1
		if _arrival_usec > 0:
			gap_s = maxf(gap_s, (p_arrival_usec - _arrival_usec) / 1e6)
		_arrival_usec = p_arrival_usec


static func _now() -> int:
	return Time.get_ticks_usec()
