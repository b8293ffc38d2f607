class_name Admission
extends RefCounted
## Who may come in: judges the greetings of a server's clients.

## What the door says of a greeting.
enum Verdict {
	## The client is to be ignored: it has said everything already.
	NONE,
	## [member PendingPeer.session] is its session.
	WELCOME,
	## It was refused, see [member PendingPeer.why].
	REFUSED,
	## An instructor decides.
	WAIT,
}

## Seconds that a client has to say who it is, and to take in the answer.
const GREETING_S: float = 3.0
## Clients that may wait for an instructor.
const MAX_WAITING: int = 64

var _rules: ServerRules = null
var _book: SessionTable = null
var _guesses: LoginRateLimiter = LoginRateLimiter.new()
var _visitors: Dictionary[int, PendingPeer] = {}


## Somebody who has not come in yet.
class PendingPeer:
	var peer: int = 0
	var address: String = ""
	var since_usec: int = 0
	var challenge: PackedByteArray = PackedByteArray()
	var greeting: JoinRequest = null
	var session: Session = null
	## The connection that the session had until now; 0 if none.
	var replaced_peer: int = 0
	var why: String = ""
	## Whether trying later may help.
	var later: bool = false
	var waits: bool = false
	var refused: bool = false


func _init(p_rules: ServerRules, p_book: SessionTable) -> void:
	_rules = p_rules
	_book = p_book


## Somebody has come; returns the challenge.
func arrive(p_peer: int, p_address: String, p_now_usec: int) -> PackedByteArray:
	var visitor: PendingPeer = PendingPeer.new()
	visitor.peer = p_peer
	visitor.address = p_address
	visitor.since_usec = p_now_usec
	visitor.challenge = _rules.challenge().encode()
	_visitors[p_peer] = visitor
	return visitor.challenge


## Somebody, or null.
func find(p_peer: int) -> PendingPeer:
	return _visitors.get(p_peer)


## Somebody has come in or gone away.
func forget(p_peer: int) -> void:
	_visitors.erase(p_peer)


## Judges what somebody says.
func judge(p_peer: int, p_bytes: PackedByteArray, p_now_usec: int) -> Verdict:
	var visitor: PendingPeer = _visitors.get(p_peer)
	if visitor == null or visitor.greeting != null or visitor.refused:
		return Verdict.NONE
	var greeting: JoinRequest = JoinRequest.decode(p_bytes)
	if greeting.error != "":
		return _refuse(visitor, greeting.error, false)
	visitor.greeting = greeting
	if _rules.bans.has(visitor.address):
		return _refuse(visitor, "your address is banned", false)
	var known: Session = _book.of_token(greeting.token)
	if known != null and known.role != greeting.role:
		known = null
	var verdict: Verdict = _judge_password(visitor, known != null, p_now_usec)
	if verdict != Verdict.WELCOME:
		return verdict
	if known != null:
		visitor.replaced_peer = known.peer
		_book.detach(known, p_now_usec)
		_book.attach(known, greeting, p_peer, visitor.address)
		visitor.session = known
		return Verdict.WELCOME
	return _judge_room(visitor, p_now_usec)


## Lets somebody in who has waited.
func admit(p_visitor: PendingPeer, p_now_usec: int) -> void:
	p_visitor.waits = false
	p_visitor.since_usec = p_now_usec
	p_visitor.session = _book.open(p_visitor.greeting, p_visitor.peer, p_visitor.address)


## Refuses somebody.
func refuse(p_visitor: PendingPeer, p_why: String, p_now_usec: int) -> void:
	_refuse(p_visitor, p_why, false)
	p_visitor.since_usec = p_now_usec


## Those who wait for an instructor, in the order of their coming.
func waiting() -> Array[PendingPeer]:
	var all: Array[PendingPeer] = _visitors.values()
	return all.filter(func(visitor: PendingPeer) -> bool: return visitor.waits)


## Those who wait, for an instructor; see [method ServerLink.roster].
func rows() -> Array[Dictionary]:
	var list: Array[Dictionary] = []
	for visitor: PendingPeer in waiting():
		var row: Dictionary = {"session": 0, "peer": visitor.peer, "state": "waiting"}
		row["name"] = visitor.greeting.name
		row["role"] = visitor.greeting.role
		row["address"] = visitor.address
		list.append(row)
	return list


## Those who are to be sent away: they have said nothing, or nothing of use.
func overdue(p_now_usec: int) -> Array[int]:
	var peers: Array[int] = []
	for peer: int in _visitors:
		var visitor: PendingPeer = _visitors[peer]
		var patience_s: float = 0.5 if visitor.refused else GREETING_S
		if not visitor.waits and p_now_usec - visitor.since_usec > int(patience_s * 1e6):
			peers.append(peer)
	return peers


func _judge_password(p_visitor: PendingPeer, p_known: bool, p_now_usec: int) -> Verdict:
	var role: Protocol.Role = p_visitor.greeting.role
	if _rules.password_of(role) == "":
		var local: bool = ServerRules.is_loopback(p_visitor.address)
		if role == Protocol.Role.INSTRUCTOR and not local:
			return _refuse(
				p_visitor, "instructors from elsewhere need a server with a password", false
			)
		return Verdict.WELCOME
	# Whoever knows a session's token does not guess: an attacker from the same address must not
	# keep those out who come back.
	if not p_known and not _guesses.may_guess(p_visitor.address, p_now_usec):
		return _refuse(p_visitor, "too many wrong passwords came from your address", true)
	if p_visitor.greeting.is_proven(p_visitor.challenge, _rules.key_of(role)):
		return Verdict.WELCOME
	_guesses.note_wrong(p_visitor.address, p_now_usec)
	return _refuse(p_visitor, "the password is wrong", false)


func _judge_room(p_visitor: PendingPeer, p_now_usec: int) -> Verdict:
	var instructor: bool = p_visitor.greeting.role == Protocol.Role.INSTRUCTOR
	var rows: Array[PendingPeer] = waiting()
	if _book.all().size() >= _rules.max_clients:
		return _refuse(p_visitor, "the server is full (%d clients)" % _rules.max_clients, false)
	var mine: int = _book.count_at(p_visitor.address)
	for visitor: PendingPeer in rows:
		mine += 1 if visitor.address == p_visitor.address else 0
	if _rules.max_per_address > 0 and mine >= _rules.max_per_address:
		var most: int = _rules.max_per_address
		return _refuse(p_visitor, "%d clients of your address are here already" % most, false)
	if _rules.waiting_room and not instructor:
		if rows.size() >= MAX_WAITING:
			return _refuse(p_visitor, "the waiting room is full", true)
		p_visitor.waits = true
		return Verdict.WAIT
	admit(p_visitor, p_now_usec)
	return Verdict.WELCOME


func _refuse(p_visitor: PendingPeer, p_why: String, p_later: bool) -> Verdict:
	p_visitor.refused = true
	p_visitor.waits = false
	p_visitor.why = p_why
	p_visitor.later = p_later
	return Verdict.REFUSED
