class_name ServerHandshake
extends RefCounted
## A server's pending peers: each gets a challenge and an answer to its join request, through the
## multiplayer API's authentication, as the [Admission] says.

## The list of those who wait has changed.
signal changed
## A join request was refused.
signal refused
## A lost session is to end, as a full server needs its room.
signal displaced(p_session: Session)

var _api: SceneMultiplayer = null
var _peer: ThreadedPeer = null
var _rules: ServerRules = null
var _sessions: SessionTable = null
var _admission: Admission = null


## Handles the arrivals of an API, whose peer is given.
func _init(
	p_api: SceneMultiplayer, p_peer: ThreadedPeer, p_rules: ServerRules, p_sessions: SessionTable
) -> void:
	_api = p_api
	_peer = p_peer
	_rules = p_rules
	_sessions = p_sessions
	_admission = Admission.new(p_rules, p_sessions)
	# Admission has its own time limit: the API would disconnect those who wait.
	_api.auth_timeout = 0.0
	_api.auth_callback = _on_join_request
	_api.peer_authenticating.connect(_on_arriving)
	_api.peer_authentication_failed.connect(_on_turned_away)


## Those who wait, as rows of [method ServerLink.roster].
func rows() -> Array[RosterRow]:
	return _admission.rows()


## A peer was admitted.
func forget(p_peer: int) -> void:
	_admission.forget(p_peer)


## Disconnects those who take too long, and lets those in who have room now, at a time of
## [method Time.get_ticks_usec].
func look_after(p_now_usec: int) -> void:
	for peer: int in _admission.overdue(p_now_usec):
		_admission.forget(peer)
		_on_turned_away(peer)
		if _api.get_authenticating_peers().has(peer):
			_api.disconnect_peer(peer)
	var next: PendingPeer = _admission.let_next_in(p_now_usec)
	while next != null:
		_welcome(next)
		changed.emit()
		next = _admission.let_next_in(p_now_usec)
	_send_positions()


## Admits somebody who waits for an instructor, by the id of the peer. Returns why not, or an empty
## text. Where there is no room, he waits for that from now on: see [method place_of].
func admit(p_peer: int) -> String:
	var pending: PendingPeer = _admission.find(p_peer)
	if pending == null or not pending.waits:
		return "nobody waits under the number %d" % p_peer
	if pending.waits_for != JoinReply.Wait.INSTRUCTOR:
		return "waits for room already, at place %d" % place_of(p_peer)
	if _admission.let_in(pending, Time.get_ticks_usec()):
		_welcome(pending)
	changed.emit()
	return ""


## The position of a peer among those who wait for room, from 1; 0 if it does not.
func place_of(p_peer: int) -> int:
	var pending: PendingPeer = _admission.find(p_peer)
	if pending == null or pending.waits_for == JoinReply.Wait.INSTRUCTOR:
		return 0
	return _admission.places().get(pending, 0)


## Refuses a waiting peer, by its id. Returns why not, or an empty text.
func refuse(p_peer: int, p_why: String) -> String:
	var pending: PendingPeer = _admission.find(p_peer)
	if pending == null or not pending.waits:
		return "nobody waits under the number %d" % p_peer
	_send_away(pending, p_why, false)
	changed.emit()
	return ""


func _on_arriving(p_peer: int) -> void:
	var now: int = Time.get_ticks_usec()
	var address: String = _peer.address_of(p_peer)
	var exporter: PackedByteArray = _peer.exporter_of(p_peer)
	if exporter.is_empty():
		_api.send_auth(p_peer, _admission.arrive(p_peer, address, now))
	else:
		_admission.arrive_sealed(p_peer, address, now, exporter, _peer.role_of(p_peer))


func _on_join_request(p_peer: int, p_bytes: PackedByteArray) -> void:
	var now: int = Time.get_ticks_usec()
	var verdict: Admission.Verdict = _admission.judge(p_peer, p_bytes, now)
	var pending: PendingPeer = _admission.find(p_peer)
	match verdict:
		Admission.Verdict.WELCOME:
			if pending.replaced_peer != 0:
				_peer.dismiss(pending.replaced_peer, DisconnectReason.REPLACED)
			_welcome(pending)
		Admission.Verdict.REFUSED:
			var parts: Array = [pending.address, pending.why]
			Log.limited("net", "join request", "refused a client from %s: %s" % parts)
			refused.emit()
			pending.since_usec = now
			_api.send_auth(p_peer, JoinReply.refusal(pending.why, pending.later))
		Admission.Verdict.WAIT:
			_begin_to_wait(pending)


func _welcome(p_pending: PendingPeer) -> void:
	if p_pending.displaced != null:
		displaced.emit(p_pending.displaced)
	var session: Session = p_pending.session
	_peer.welcome(p_pending.peer)
	var said: Array[PackedByteArray] = [p_pending.challenge, p_pending.request.whole()]
	var key: PackedByteArray = p_pending.key
	if key.is_empty():
		key = _rules.key_of(session.role)
	session.welcome_level = LevelMessage.encode(_rules.level_name, _rules.level_fingerprint)
	_api.send_auth(p_pending.peer, JoinReply.welcome(session, _rules, key, said))
	_api.complete_auth(p_pending.peer)


func _begin_to_wait(p_pending: PendingPeer) -> void:
	var parts: Array = [p_pending.request.name, p_pending.address, p_pending.peer]
	if p_pending.waits_for == JoinReply.Wait.INSTRUCTOR:
		Log.info("net", "'%s' from %s waits to be admitted (%d)" % parts)
	else:
		Log.limited("net", "waits for room", "'%s' from %s waits for room (%d)" % parts)
	for pushed: PendingPeer in _admission.pushed:
		_send_away(pushed, "too many wait here already", true)
	_admission.pushed.clear()
	_peer.keep(p_pending.peer)
	_send_position(p_pending, _admission.places()[p_pending])
	changed.emit()


func _send_away(p_pending: PendingPeer, p_why: String, p_later: bool) -> void:
	_admission.refuse(p_pending, p_why, p_later, Time.get_ticks_usec())
	_api.send_auth(p_pending.peer, JoinReply.refusal(p_why, p_later))


## A peer left before it was admitted.
func _on_turned_away(p_peer: int) -> void:
	var pending: PendingPeer = _admission.find(p_peer)
	var waited: bool = pending != null and pending.waits
	_admission.forget(p_peer)
	var session: Session = _sessions.of_peer(p_peer)
	if session != null and session.was_here:
		_sessions.detach(session, Time.get_ticks_usec())
	elif session != null:
		_sessions.close(session)
	if waited:
		changed.emit()


## Tells those who wait what has changed for them.
func _send_positions() -> void:
	var places: Dictionary[PendingPeer, int] = _admission.places()
	for pending: PendingPeer in places:
		_send_position(pending, places[pending])


func _send_position(p_pending: PendingPeer, p_position: int) -> void:
	if p_pending.sent_position == p_position and p_pending.sent_for == p_pending.waits_for:
		return
	p_pending.sent_position = p_position
	p_pending.sent_for = p_pending.waits_for
	_api.send_auth(p_pending.peer, JoinReply.wait(p_position, p_pending.waits_for))
