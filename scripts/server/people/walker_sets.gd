class_name WalkerSets
extends RefCounted
## The motion sets by which people walk who have one of their own: takes what trainees send
## ([MotionSetMessage]), reads it in a thread, and keeps it as long as the session.
##
## A set that is refused changes nothing. Who sends another one goes on by the old one until that is
## read.

## A session has another set: see [method of_session].
signal changed(p_session: int)

## Sets that were taken over, since the start.
var taken: int = 0
## Sets that were refused, since the start.
var refused: int = 0

var _link: ServerLink = null
var _sets: Dictionary[int, WalkerSet] = {}
var _incoming: Dictionary[int, MessageParts] = {}
# At most one of each session.
var _readings: Dictionary[int, Reading] = {}


## A set that is being read.
class Reading:
	var number: int = 0
	var bytes: PackedByteArray = []
	var found: WalkerSet = null
	var task: int = -1

	func read() -> void:
		found = WalkerSet.read(bytes)


## Takes what comes by a link.
func _init(p_link: ServerLink) -> void:
	_link = p_link
	_link.handle(
		Protocol.Message.MOTION_SET,
		MessageHandlers.Path.RELIABLE,
		_on_part,
		Roles.Capability.SEND_MOTION
	)
	_link.client_lost.connect(_on_lost)
	_link.client_left.connect(_forget)


## The set of a session's people, or null: that of everybody.
func of_session(p_session: int) -> WalkerSet:
	return _sets.get(p_session)


## Takes over what has been read; call it once a tick.
func advance() -> void:
	for session: int in _readings.keys():
		var reading: Reading = _readings[session]
		if WorkerThreadPool.is_task_completed(reading.task):
			WorkerThreadPool.wait_for_task_completion(reading.task)
			_readings.erase(session)
			_take(session, reading)


## Ends: waits for what is being read.
func close() -> void:
	for reading: Reading in _readings.values():
		WorkerThreadPool.wait_for_task_completion(reading.task)
	_readings.clear()


## What has not come wholly is sent anew.
func _on_lost(p_session: int) -> void:
	_incoming.erase(p_session)


func _forget(p_session: int) -> void:
	_incoming.erase(p_session)
	_sets.erase(p_session)


func _on_part(p_session: Session, p_bytes: PackedByteArray, _arrival_usec: int) -> String:
	if MotionSetMessage.is_too_large(p_bytes):
		_incoming.erase(p_session.id)
		_refuse(p_session, p_bytes.decode_u16(1), WalkerSet.describe_limit())
		return ""
	var parts: MessageParts = _incoming.get(p_session.id)
	if parts == null:
		parts = MessageParts.new(MotionSetMessage.MAX_PARTS)
		_incoming[p_session.id] = parts
	var before: int = parts.packet
	var whole: PackedByteArray = parts.join(p_bytes)
	if parts.packet < 0 and before >= 0:
		# What follows of it does not fit either: it is said once.
		return "parts of a motion set that do not follow one another"
	if whole.is_empty():
		return ""
	_incoming.erase(p_session.id)
	_read(p_session, parts.packet, whole)
	return ""


func _read(p_session: Session, p_number: int, p_bytes: PackedByteArray) -> void:
	var now: float = Time.get_ticks_usec() / 1e6
	var is_busy: bool = _readings.has(p_session.id)
	if is_busy or not _link.rates.take(&"motion-set", p_session.id, now):
		_refuse(p_session, p_number, MessageRates.describe(&"motion-set"))
		return
	var reading: Reading = Reading.new()
	reading.number = p_number
	reading.bytes = p_bytes
	# Not one of those that the engine wants soon: the physics has the same threads.
	reading.task = WorkerThreadPool.add_task(reading.read, false, "motion set")
	_readings[p_session.id] = reading


func _take(p_session: int, p_reading: Reading) -> void:
	var session: Session = _link.session(p_session)
	if session == null:
		return
	if p_reading.found.error != "":
		_refuse(session, p_reading.number, p_reading.found.error)
		return
	taken += 1
	_sets[p_session] = p_reading.found
	Log.info(
		"walker",
		(
			"%s walks by a motion set of %d clips (%s)"
			% [session.describe(), p_reading.found.motion.get_clip_count(), p_reading.found.id]
		)
	)
	var outcome: MotionSetMessage.Outcome = MotionSetMessage.Outcome.TAKEN
	_link.send_whole(p_session, MotionSetMessage.answer(p_reading.number, outcome, ""))
	changed.emit(p_session)


func _refuse(p_session: Session, p_number: int, p_why: String) -> void:
	refused += 1
	_link.complain(p_session, "motion set", "sent a motion set that is not taken: " + p_why)
	if _link.rates.take(&"refusals", p_session.id, Time.get_ticks_usec() / 1e6):
		var outcome: MotionSetMessage.Outcome = MotionSetMessage.Outcome.REFUSED
		_link.send_whole(p_session.id, MotionSetMessage.answer(p_number, outcome, p_why))
