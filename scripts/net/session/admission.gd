class_name Admission
extends RefCounted
## Decides on the join requests of a server's clients.

## The outcome of a join request.
enum Verdict {
	## It is ignored: the client has sent one already.
	NONE,
	## [member PendingPeer.session] is its session.
	WELCOME,
	## It was refused, see [member PendingPeer.why].
	REFUSED,
	## An instructor decides.
	WAIT,
}

## Seconds that a client has for its join request, and for confirming the reply.
const REQUEST_S: float = 3.0
## Clients that may wait for an instructor.
const MAX_WAITING: int = 64

var _rules: ServerRules = null
var _sessions: SessionTable = null
var _logins: LoginRateLimiter = LoginRateLimiter.new()
var _pending: Dictionary[int, PendingPeer] = {}


## A connection that has not been admitted yet.
class PendingPeer:
	var peer: int = 0
	var address: String = ""
	var since_usec: int = 0
	var challenge: PackedByteArray = PackedByteArray()
	## Key of the proofs, which only this client and the server have; empty without sealing.
	var key: PackedByteArray = PackedByteArray()
	## The role that a sealed connection was made for.
	var sealed_role: int = 0
	var request: JoinRequest = null
	var session: Session = null
	## The connection that the session had until now; 0 if none.
	var replaced_peer: int = 0
	## The lost session that ends to make room for this one, or null.
	var displaced: Session = null
	var why: String = ""
	## Whether trying later may help.
	var later: bool = false
	var waits: bool = false
	var refused: bool = false


func _init(p_rules: ServerRules, p_sessions: SessionTable) -> void:
	_rules = p_rules
	_sessions = p_sessions


## A peer has connected; returns the challenge, which it must be sent.
func arrive(p_peer: int, p_address: String, p_now_usec: int) -> PackedByteArray:
	var pending: PendingPeer = PendingPeer.new()
	pending.peer = p_peer
	pending.address = p_address
	pending.since_usec = p_now_usec
	pending.challenge = _rules.challenge().encode()
	_pending[p_peer] = pending
	return pending.challenge


## A peer has connected and has proven the password of a role by that: both ends know the key, and
## the challenge without a word.
func arrive_sealed(
	p_peer: int, p_address: String, p_now_usec: int, p_key: PackedByteArray, p_role: int
) -> void:
	arrive(p_peer, p_address, p_now_usec)
	var pending: PendingPeer = _pending[p_peer]
	pending.challenge = Challenge.SEALED.to_ascii_buffer()
	pending.key = p_key
	pending.sealed_role = p_role


## A pending peer, or null.
func find(p_peer: int) -> PendingPeer:
	return _pending.get(p_peer)


## A peer was admitted or has gone.
func forget(p_peer: int) -> void:
	_pending.erase(p_peer)


## Decides on a join request.
func judge(p_peer: int, p_bytes: PackedByteArray, p_now_usec: int) -> Verdict:
	var pending: PendingPeer = _pending.get(p_peer)
	if pending == null or pending.request != null or pending.refused:
		return Verdict.NONE
	var request: JoinRequest = JoinRequest.decode(p_bytes)
	if request.error != "":
		return _refuse(pending, request.error, false)
	pending.request = request
	if _rules.bans.has(pending.address):
		return _refuse(pending, "your address is banned", false)
	var known: Session = _sessions.of_token(request.token)
	if known != null and known.role != request.role:
		known = null
	var verdict: Verdict = _judge_password(pending, known != null, p_now_usec)
	if verdict != Verdict.WELCOME:
		return verdict
	if known != null:
		pending.replaced_peer = known.peer
		_sessions.detach(known, p_now_usec)
		_sessions.attach(known, request, p_peer, pending.address)
		pending.session = known
		return Verdict.WELCOME
	return _judge_room(pending, p_now_usec)


## Whether there is room for one more. A full server has it where a connection is lost:
## [member PendingPeer.displaced] is the session that is to end then.
func has_room(p_pending: PendingPeer) -> bool:
	if _sessions.all().size() < _rules.max_clients:
		return true
	p_pending.displaced = _sessions.longest_lost()
	return p_pending.displaced != null


## Admits a waiting peer.
func admit(p_pending: PendingPeer, p_now_usec: int) -> void:
	p_pending.waits = false
	p_pending.since_usec = p_now_usec
	p_pending.session = _sessions.open(p_pending.request, p_pending.peer, p_pending.address)


## Refuses a waiting peer.
func refuse(p_pending: PendingPeer, p_why: String, p_now_usec: int) -> void:
	_refuse(p_pending, p_why, false)
	p_pending.since_usec = p_now_usec


## Those who wait for an instructor, in the order in which they came.
func waiting() -> Array[PendingPeer]:
	var all: Array[PendingPeer] = _pending.values()
	return all.filter(func(pending: PendingPeer) -> bool: return pending.waits)


## Those who wait, for an instructor; see [method ServerLink.roster].
func rows() -> Array[RosterRow]:
	var list: Array[RosterRow] = []
	for pending: PendingPeer in waiting():
		var row: RosterRow = RosterRow.new()
		row.peer = pending.peer
		row.name = pending.request.name
		row.role = pending.request.role
		row.address = pending.address
		list.append(row)
	return list


## The peers to disconnect: they have sent no valid join request in time.
func overdue(p_now_usec: int) -> Array[int]:
	var peers: Array[int] = []
	for peer: int in _pending:
		var pending: PendingPeer = _pending[peer]
		var patience_s: float = 0.5 if pending.refused else REQUEST_S
		if not pending.waits and p_now_usec - pending.since_usec > int(patience_s * 1e6):
			peers.append(peer)
	return peers


func _judge_password(p_pending: PendingPeer, p_known: bool, p_now_usec: int) -> Verdict:
	var role: Roles.Role = p_pending.request.role
	if not p_pending.key.is_empty():
		var fits: bool = p_pending.sealed_role == role
		if not fits or not p_pending.request.is_proven(p_pending.challenge, p_pending.key):
			return _refuse(p_pending, "the connection was made for another role", false)
	if _rules.password_of(role) == "":
		var local: bool = ServerRules.is_loopback(p_pending.address)
		if Roles.can(role, Roles.Capability.MODERATE) and not local:
			return _refuse(
				p_pending, "instructors from elsewhere need a server with a password", false
			)
		return Verdict.WELCOME
	if not p_pending.key.is_empty():
		return Verdict.WELCOME
	# Whoever knows a session's token does not guess: an attacker from the same address must not
	# keep those out who come back.
	if not p_known and not _logins.may_guess(p_pending.address, p_now_usec):
		return _refuse(p_pending, "too many wrong passwords came from your address", true)
	if p_pending.request.is_proven(p_pending.challenge, _rules.key_of(role)):
		return Verdict.WELCOME
	_logins.note_wrong(p_pending.address, p_now_usec)
	return _refuse(p_pending, "the password is wrong", false)


func _judge_room(p_pending: PendingPeer, p_now_usec: int) -> Verdict:
	var role: Roles.Role = p_pending.request.role
	var moderates: bool = Roles.can(role, Roles.Capability.MODERATE)
	var rows: Array[PendingPeer] = waiting()
	if not has_room(p_pending):
		return _refuse(p_pending, "the server is full (%d clients)" % _rules.max_clients, false)
	var mine: int = _sessions.count_at(p_pending.address)
	for pending: PendingPeer in rows:
		mine += 1 if pending.address == p_pending.address else 0
	if _rules.max_per_address > 0 and mine >= _rules.max_per_address:
		p_pending.displaced = _sessions.longest_lost(p_pending.address)
		if p_pending.displaced == null:
			var most: int = _rules.max_per_address
			return _refuse(p_pending, "%d clients of your address are here already" % most, false)
	if _rules.waiting_room and not moderates:
		if rows.size() >= MAX_WAITING:
			return _refuse(p_pending, "the waiting room is full", true)
		p_pending.waits = true
		p_pending.displaced = null
		return Verdict.WAIT
	admit(p_pending, p_now_usec)
	return Verdict.WELCOME


func _refuse(p_pending: PendingPeer, p_why: String, p_later: bool) -> Verdict:
	p_pending.refused = true
	p_pending.waits = false
	p_pending.why = p_why
	p_pending.later = p_later
	return Verdict.REFUSED
