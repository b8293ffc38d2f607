class_name SessionInbox
extends RefCounted
## Hands the messages of a server's clients to the handlers of their kind, if the sender's role may
## send it, and logs what is wrong with them.
##
## Each session has a turn in each tick: messages that do not fit into it wait for the next. No
## client can cost the others more than that, whatever it sends.

## A session has sent more messages over the reliable channel than can be processed.
signal overrun(p_session: Session)

## Processor time of a session's turn, µs: no message begins after it.
const TURN_USEC: int = 250
## Datagrams of the fast path that a session may have waiting; older ones are dropped.
const MAX_FAST: int = 64
## Messages of the reliable channel that a session may have waiting.
const MAX_RELIABLE: int = 512

## Datagrams that were dropped, as newer ones came before their turn.
var dropped: int = 0
## Number of messages that were refused since the start, by the key of the complaint.
var refused: Dictionary[String, int] = {}
## Limits of how often sessions may send each message.
var rates: MessageRates = MessageRates.new()

var _handlers: MessageHandlers = MessageHandlers.new()
var _turns: Dictionary[Session, Turn] = {}
## Those of whom something waits: mostly nobody, of however many there are.
var _waiting: Dictionary[Session, bool] = {}
## Number of the turns at hand.
var _round: int = 0


## The time that a session has used of its turn, and the messages that wait for the next one.
class Turn:
	## The number of the turn that [member spent_usec] belongs to.
	var number: int = 0
	var spent_usec: int = 0
	var reliable: Array[FastPacket] = []
	var fast: Array[FastPacket] = []

	func is_over() -> bool:
		return spent_usec >= TURN_USEC

	## Nothing is spent of the turn with this number yet.
	func begin(p_number: int) -> void:
		if number != p_number:
			number = p_number
			spent_usec = 0


## Registers the handler of a kind of message; see [method MessageHandlers.add].
## [code]func(session: Session, bytes: PackedByteArray, arrival_usec: int) -> String[/code] returns
## what is wrong with it, or an empty text.
func handle(
	p_kind: int, p_path: MessageHandlers.Path, p_handler: Callable, p_capability: int = 0
) -> void:
	_handlers.add(p_kind, p_path, p_handler, p_capability)


## A tick begins: everybody's next turn does, with what waits for it.
func begin_turns() -> void:
	_round += 1
	for session: Session in _waiting.keys():
		var turn: Turn = _turns.get(session)
		if turn == null:
			continue  # An instructor's message before has ended it.
		turn.begin(_round)
		while not turn.is_over() and not turn.reliable.is_empty():
			_process(session, turn, turn.reliable.pop_front(), MessageHandlers.Path.RELIABLE)
		while not turn.is_over() and not turn.fast.is_empty():
			_process(session, turn, turn.fast.pop_front(), MessageHandlers.Path.FAST)
		if turn.reliable.is_empty() and turn.fast.is_empty():
			_waiting.erase(session)


## A session's message has come.
func take(p_session: Session, p_packet: FastPacket, p_path: MessageHandlers.Path) -> void:
	var turn: Turn = _turns.get(p_session)
	if turn == null:
		turn = Turn.new()
		_turns[p_session] = turn
	turn.begin(_round)
	var is_fast: bool = p_path == MessageHandlers.Path.FAST
	var waiting: Array[FastPacket] = turn.fast if is_fast else turn.reliable
	if waiting.is_empty() and not turn.is_over():
		_process(p_session, turn, p_packet, p_path)
		return
	waiting.append(p_packet)
	_waiting[p_session] = true
	if is_fast and waiting.size() > MAX_FAST:
		waiting.pop_front()
		dropped += 1
		complain(p_session, "turn", "sends more than can be processed: old datagrams are dropped")
	elif not is_fast and waiting.size() == MAX_RELIABLE:
		complain(p_session, "waiting", "has sent more than can be taken in")
		overrun.emit(p_session)


## Forgets what waits of a session.
func forget(p_session: Session) -> void:
	_turns.erase(p_session)
	_waiting.erase(p_session)


## Counts and logs what a client did wrong; [param p_key] limits how often it is logged.
func complain(p_about: Session, p_key: String, p_what: String) -> void:
	count(p_key)
	log_about(p_about, p_key, p_what)


## Counts something in [member refused].
func count(p_key: String) -> void:
	refused[p_key] = refused.get(p_key, 0) + 1


## Logs what was counted elsewhere.
func log_about(p_about: Session, p_key: String, p_what: String) -> void:
	Log.limited("net", "%s %d" % [p_key, p_about.id], "%s %s" % [p_about.describe(), p_what])


func _process(
	p_session: Session, p_turn: Turn, p_packet: FastPacket, p_path: MessageHandlers.Path
) -> void:
	# A message before this one may have ended the session.
	if not p_session.is_here:
		return
	var begin_usec: int = ThreadClock.get_usec()
	_hand_over(p_session, p_packet.bytes, p_path, p_packet.arrival_usec)
	p_turn.spent_usec += ThreadClock.get_usec() - begin_usec


func _hand_over(
	p_session: Session, p_bytes: PackedByteArray, p_path: MessageHandlers.Path, p_arrival_usec: int
) -> void:
	var entry: MessageHandlers.Handler = _handlers.find(p_bytes, p_path)
	var kind: int = Protocol.kind_of(p_bytes)
	if entry == null:
		var parts: Array = [p_bytes.size(), kind]
		complain(p_session, "kind", "sent %d bytes of unknown kind %d" % parts)
		return
	if entry.capability != 0 and Roles.ROWS[p_session.role][1] & entry.capability == 0:
		var what: Variant = Protocol.Message.find_key(kind)
		# Features have kinds of their own beside those of the protocol.
		var name: String = str(what) if what != null else "kind %d" % kind
		complain(p_session, "role", "sent %s, which its role may not" % name)
		return
	if MessageRates.OF_MESSAGES.has(kind):
		var what: StringName = MessageRates.OF_MESSAGES[kind]
		if not rates.take(what, p_session.id, Time.get_ticks_usec() / 1e6):
			complain(p_session, "rate", "sends more than is taken of kind '%s'" % what)
			return
	var fault: String = entry.handler.call(p_session, p_bytes, p_arrival_usec)
	if fault != "":
		complain(p_session, "message %d" % kind, "sent " + fault)
