class_name ServerEffects
extends ServerPart
## Gives new texts of effects to all clients while a session runs: those that change in the folder
## of --effects, and those that instructors send.
##
## Every text is checked before anybody gets it; a broken one is named in the log and to whoever
## sent it, and everything stays as it was. Who comes later gets the newest, and who is behind gets
## the newest only.

## Effects that have been changed in a session.
const MAX_EFFECTS: int = 128
## Texts that wait for their check.
const MAX_WAITING: int = 32
## Time after a text that does not compile in which the engine's compiler does not speak, s: it
## writes to the log. What is wrong on which line is then told for the first of them only.
const QUIET_S: float = 3.0
## Parts that are sent in a tick, to all sessions together, and to each.
const PARTS_PER_TICK: int = 12
const PARTS_OF_SESSION: int = 2

## Texts that were given to clients, since the start.
var accepted: int = 0
## Texts that were refused, since the start.
var refused: int = 0

var _link: ServerLink = null
var _folder: EffectFolder = null
var _texts: Dictionary[String, PackedByteArray] = {}
var _versions: Dictionary[String, int] = {}
var _readers: Dictionary[int, Reader] = {}
var _incoming: Dictionary[int, EffectParts] = {}
var _quiet_s: float = 0.0
var _checks: Array[Check] = []
var _number: int = 0


## What a session has got, and what it is being sent.
class Reader:
	var has: Dictionary[String, int] = {}
	var name: String = ""
	var version: int = 0
	var parts: Array[PackedByteArray] = []


## A text that is being checked. Its words are read in a thread: a large one takes longer than a
## tick has.
class Check:
	var name: String = ""
	var bytes: PackedByteArray = []
	var session: int = 0
	var order: int = 0
	var file: EffectFile = null
	var task: int = -1

	func read() -> void:
		file = EffectFile.from_bytes(bytes)


func open(p_context: ServerContext) -> String:
	super(p_context)
	_link = context.link
	_folder = EffectFolder.new(context.options.file("effects"))
	# Made here, as threads use it.
	EffectSettings.keys()
	_link.handle(
		Protocol.Message.EFFECT, MessageHandlers.Path.RELIABLE, _on_part, Roles.Capability.DIRECT
	)
	_link.client_joined.connect(_on_joined)
	_link.client_returned.connect(_begin)
	_link.client_lost.connect(_forget)
	_link.client_left.connect(_forget)
	return _folder.find_fault()


## Looks for changes and sends what a tick has room for.
func advance(_now_usec: int, p_delta_s: float) -> void:
	_quiet_s -= p_delta_s
	var changed: Dictionary[String, PackedByteArray] = _folder.advance(p_delta_s)
	for name: String in changed:
		if EffectFile.is_name(name):
			_add_check(name, changed[name])
		else:
			Log.limited("effects", name, "%s is not used: %s" % [name.left(60), _bad_name()])
	_finish_checks()
	_send()


## Ends: waits for what is being read.
func close() -> void:
	if _folder != null:
		_folder.close()
	for check: Check in _checks:
		if check.task >= 0:
			WorkerThreadPool.wait_for_task_completion(check.task)
	_checks.clear()


func report() -> Dictionary:
	return {"effects": {"effects": _texts.size(), "accepted": accepted, "refused": refused}}


func _on_joined(p_session: int, _p_hello: Dictionary) -> void:
	_begin(p_session)


func _begin(p_session: int) -> void:
	_readers[p_session] = Reader.new()


func _forget(p_session: int) -> void:
	_readers.erase(p_session)
	_incoming.erase(p_session)


func _on_part(p_session: Session, p_bytes: PackedByteArray, _arrival_usec: int) -> String:
	var message: EffectMessage = EffectMessage.decode(p_bytes)
	if message == null:
		return "a part of an effect that is none"
	var parts: EffectParts = _incoming.get_or_add(p_session.id, EffectParts.new())
	if not parts.take(message):
		return ""
	_incoming.erase(p_session.id)
	var now: float = Time.get_ticks_usec() / 1e6
	if not _link.rates.take(&"effect", p_session.id, now):
		_link.complain(p_session, "haste", "sends effects too soon after one another")
		if _link.rates.take(&"refusals", p_session.id, now):
			var what: String = MessageRates.describe(&"effect")
			_answer(p_session.id, message.number, message.name, what)
		return ""
	if _checks.size() >= MAX_WAITING:
		_answer(p_session.id, message.number, message.name, "too many effects wait already")
		return ""
	_add_check(message.name, parts.bytes, p_session.id, message.number)
	return ""


func _add_check(
	p_name: String, p_bytes: PackedByteArray, p_session: int = 0, p_order: int = 0
) -> void:
	var check: Check = Check.new()
	check.name = p_name
	check.bytes = p_bytes
	check.session = p_session
	check.order = p_order
	check.task = WorkerThreadPool.add_task(check.read)
	_checks.append(check)


## One a tick: compiling takes a millisecond.
func _finish_checks() -> void:
	if _checks.is_empty() or not WorkerThreadPool.is_task_completed(_checks[0].task):
		return
	var check: Check = _checks.pop_front()
	WorkerThreadPool.wait_for_task_completion(check.task)
	var problems: Array[EffectProblem] = ShaderCheck.problems(check.file, _quiet_s > 0.0)
	if not problems.is_empty() and check.file.problems.is_empty() and _quiet_s <= 0.0:
		_quiet_s = QUIET_S
	var fault: String = "" if problems.is_empty() else str(problems[0])
	if fault == "" and not _texts.has(check.name) and _texts.size() >= MAX_EFFECTS:
		fault = "there are already %d changed effects" % MAX_EFFECTS
	if fault != "":
		refused += 1
		var file: String = "%s.%s" % [check.name, EffectFile.EXTENSION]
		Log.limited("effects", check.name, "%s is not taken over: %s" % [file, fault])
	else:
		accepted += 1
		_texts[check.name] = check.bytes
		_versions[check.name] = _versions.get(check.name, 0) + 1
		Log.info("effects", "'%s' goes to all clients" % check.name)
	_answer(check.session, check.order, check.name, fault)


func _answer(p_session: int, p_order: int, p_name: String, p_fault: String) -> void:
	if p_session == 0 or not _readers.has(p_session):
		return
	var outcome: AnswerMessage.Outcome = AnswerMessage.Outcome.DONE
	var text: String = "effect '%s': everybody gets it" % p_name
	if p_fault != "":
		outcome = AnswerMessage.Outcome.FAILED
		text = "effect '%s': %s" % [p_name, p_fault]
	_link.send_reliably([p_session], AnswerMessage.encode(p_order, outcome, text))


## A few parts to each session in turn.
func _send() -> void:
	if _texts.is_empty():
		return
	var room: int = PARTS_PER_TICK
	var sessions: Array[int] = _readers.keys()
	for session: int in sessions:
		for i: int in PARTS_OF_SESSION:
			if room == 0 or not _send_part(session, _readers[session]):
				break
			room -= 1
		# Who was served goes to the end of the queue.
		if room < PARTS_PER_TICK:
			var reader: Reader = _readers[session]
			_readers.erase(session)
			_readers[session] = reader
		if room == 0:
			return


func _send_part(p_session: int, p_reader: Reader) -> bool:
	if p_reader.parts.is_empty() or p_reader.version != _versions[p_reader.name]:
		p_reader.parts.clear()
		for name: String in _texts:
			if p_reader.has.get(name, 0) != _versions[name]:
				_number = (_number + 1) & 0xFFFF
				p_reader.name = name
				p_reader.version = _versions[name]
				p_reader.parts = EffectMessage.split(_number, name, _texts[name])
				break
	if p_reader.parts.is_empty():
		return false
	_link.send_whole(p_session, p_reader.parts.pop_front())
	if p_reader.parts.is_empty():
		p_reader.has[p_reader.name] = p_reader.version
	return true


static func _bad_name() -> String:
	return "an effect's name has small letters, digits and _"
