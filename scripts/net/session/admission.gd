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
	## An instructor decides, or room has to come: see [WaitingLine].
	WAIT,
}

## Seconds that a client has for its join request, and for confirming the reply.
const REQUEST_S: float = 3.0
## Time after its loss from which on a lost session makes room for others, s.
const RETURN_S: float = 10.0

## Peers that waited and have to go, as the line is full: the caller refuses them.
var pushed: Array[PendingPeer] = []

var _rules: ServerRules = null
var _sessions: SessionTable = null
var _logins: LoginRateLimiter = LoginRateLimiter.new()
var _pending: Dictionary[int, PendingPeer] = {}
var _line: WaitingLine = WaitingLine.new()


func _init(p_rules: ServerRules, p_sessions: SessionTable) -> void:
	_rules = p_rules
	_sessions = p_sessions


## A peer has connected; returns the challenge, which it must be sent.
func arrive(p_peer: int, p_address: String, p_now_usec: int) -> PackedByteArray:
	var pending: PendingPeer = PendingPeer.new(p_peer, p_address, p_now_usec)
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
	if _pending.has(p_peer):
		_line.remove(_pending[p_peer])
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


## Those who wait, in the order in which they came.
func waiting() -> Array[PendingPeer]:
	return _line.all()


## Their positions, from 1.
func places() -> Dictionary[PendingPeer, int]:
	return _line.places()


## An instructor admits somebody who waits for that: in at once where there is room, and into the
## line of those who wait for room otherwise. Returns whether he is in.
func let_in(p_pending: PendingPeer, p_now_usec: int) -> bool:
	if _may_enter(p_pending, p_now_usec):
		_admit(p_pending, p_now_usec)
		return true
	_line.move_back(p_pending)
	return false


## Admits the first of those who wait for room who has it now; null if there is none.
func let_next_in(p_now_usec: int) -> PendingPeer:
	var next: PendingPeer = _next_who_may(p_now_usec)
	if next != null:
		_admit(next, p_now_usec)
	return next


## Refuses a peer.
func refuse(p_pending: PendingPeer, p_why: String, p_later: bool, p_now_usec: int) -> void:
	_refuse(p_pending, p_why, p_later)
	p_pending.since_usec = p_now_usec


## Those who wait, for an instructor; see [method ServerLink.roster].
func rows() -> Array[RosterRow]:
	var list: Array[RosterRow] = []
	for pending: PendingPeer in waiting():
		list.append(pending.row())
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
	# A client with the token of a session does not guess: an attacker from the same address must
	# not keep it out.
	if not p_known and not _logins.take(p_pending.address, p_now_usec / 1e6):
		return _refuse(p_pending, "too many wrong passwords came from your address", true)
	if p_pending.request.is_proven(p_pending.challenge, _rules.key_of(role)):
		if not p_known:
			_logins.give_back(p_pending.address)
		return Verdict.WELCOME
	return _refuse(p_pending, "the password is wrong", false)


func _judge_room(p_pending: PendingPeer, p_now_usec: int) -> Verdict:
	var moderates: bool = Roles.can(p_pending.request.role, Roles.Capability.MODERATE)
	if _rules.waiting_room and not moderates:
		p_pending.waits_for = JoinReply.Wait.INSTRUCTOR
	elif _may_enter(p_pending, p_now_usec):
		_admit(p_pending, p_now_usec)
		return Verdict.WELCOME
	p_pending.displaced = null
	if not _line.add(p_pending, _rules.share_of_address(), pushed):
		return _refuse(p_pending, "too many wait here already", true)
	return Verdict.WAIT


## Whether there is room for a peer, and nobody else waits for it before. Sets what the peer waits
## for if not.
func _may_enter(p_pending: PendingPeer, p_now_usec: int) -> bool:
	var lost: Array[Session] = _sessions.lost_for(RETURN_S, p_now_usec)
	if not _has_room(p_pending, lost):
		return false
	if _next_who_may(p_now_usec) == null:
		return true
	p_pending.waits_for = JoinReply.Wait.ROOM
	return false


func _next_who_may(p_now_usec: int) -> PendingPeer:
	if _line.all().is_empty():
		return null
	var lost: Array[Session] = _sessions.lost_for(RETURN_S, p_now_usec)
	for pending: PendingPeer in _line.all():
		if _rules.bans.has(pending.address):
			continue
		if pending.waits_for != JoinReply.Wait.INSTRUCTOR and _has_room(pending, lost):
			return pending
	return null


## Whether there is room for one more. Where there is none, a lost session may end for the peer:
## [member PendingPeer.displaced]. Sets what the peer waits for if not.
func _has_room(p_pending: PendingPeer, p_lost: Array[Session]) -> bool:
	var most: int = _rules.share_of_address()
	var of_network: int = _sessions.count_at(p_pending.network)
	var of_site: int = _sessions.count_at_site(p_pending.site)
	p_pending.displaced = null
	if most > 0 and (of_network >= most or of_site >= ServerRules.SITE_SHARES * most):
		for session: Session in p_lost:
			var is_own: bool = session.network == p_pending.network
			if is_own or (of_network < most and session.site == p_pending.site):
				p_pending.displaced = session
				return true
		p_pending.waits_for = JoinReply.Wait.SHARE
		return false
	if _sessions.count() < _rules.max_clients:
		return true
	if not p_lost.is_empty():
		p_pending.displaced = p_lost[0]
		return true
	p_pending.waits_for = JoinReply.Wait.ROOM
	return false


func _admit(p_pending: PendingPeer, p_now_usec: int) -> void:
	_line.remove(p_pending)
	p_pending.since_usec = p_now_usec
	p_pending.session = _sessions.open(p_pending.request, p_pending.peer, p_pending.address)


func _refuse(p_pending: PendingPeer, p_why: String, p_later: bool) -> Verdict:
	_line.remove(p_pending)
	p_pending.refused = true
	p_pending.why = p_why
	p_pending.later = p_later
	return Verdict.REFUSED
