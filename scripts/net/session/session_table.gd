class_name SessionTable
extends RefCounted
## All sessions of a server: those that are here and those whose connection is lost.

## How long the session of a lost client is kept, s.
const KEPT_S: float = 60.0

## Highest number of a session.
const MAX_ID: int = 65535

var _sessions: Dictionary[int, Session] = {}
var _by_peer: Dictionary[int, Session] = {}
var _next_id: int = 1
## Numbers of sessions of each network, and of each site.
var _at_network: Dictionary[String, int] = {}
var _at_site: Dictionary[String, int] = {}


## A new session.
func open(p_request: JoinRequest, p_peer: int, p_address: String) -> Session:
	var session: Session = Session.new()
	# 16 bits, as a field of an entity can hold it.
	while _sessions.has(_next_id):
		_next_id = _next_id % MAX_ID + 1
	session.id = _next_id
	_next_id = _next_id % MAX_ID + 1
	session.role = p_request.role
	session.name = _free_name(p_request.name)
	session.token = Crypto.new().generate_random_bytes(JoinRequest.TOKEN_SIZE)
	_sessions[session.id] = session
	attach(session, p_request, p_peer, p_address)
	return session


## Ties a session to a connection.
func attach(p_session: Session, p_request: JoinRequest, p_peer: int, p_address: String) -> void:
	_count(p_session, -1)
	p_session.rate = p_request.rate
	p_session.peer = p_peer
	p_session.address = p_address
	p_session.network = AddressNetwork.of(p_address)
	p_session.site = AddressNetwork.site_of(p_address)
	_count(p_session, 1)
	p_session.is_here = false
	_by_peer[p_peer] = p_session


## A session's client goes on from another address.
func move(p_session: Session, p_address: String) -> void:
	_count(p_session, -1)
	p_session.address = p_address
	p_session.network = AddressNetwork.of(p_address)
	p_session.site = AddressNetwork.site_of(p_address)
	_count(p_session, 1)


## Unties a session from its connection.
func detach(p_session: Session, p_now_usec: int) -> void:
	_by_peer.erase(p_session.peer)
	p_session.peer = 0
	p_session.is_here = false
	p_session.lost_usec = p_now_usec


## Ends a session.
func close(p_session: Session) -> void:
	if _sessions.erase(p_session.id):
		_count(p_session, -1)
	_by_peer.erase(p_session.peer)
	p_session.peer = 0
	p_session.is_here = false


## A session by its number, or null.
func find(p_id: int) -> Session:
	return _sessions.get(p_id)


## The session of a connection, or null.
func of_peer(p_peer: int) -> Session:
	return _by_peer.get(p_peer)


## The session of a token, or null; takes as long for any token.
func of_token(p_token: PackedByteArray) -> Session:
	var found: Session = null
	if p_token.size() != JoinRequest.TOKEN_SIZE:
		return null
	var crypto: Crypto = Crypto.new()
	for id: int in _sessions:
		if crypto.constant_time_compare(_sessions[id].token, p_token):
			found = _sessions[id]
	return found


## Those who are here.
func here() -> Array[Session]:
	return all().filter(func(session: Session) -> bool: return session.is_here)


## All, also those whose connection is lost.
func all() -> Array[Session]:
	return _sessions.values()


## Those whose connection was lost too long ago.
func overdue(p_now_usec: int) -> Array[Session]:
	return all().filter(
		func(session: Session) -> bool:
			return session.peer == 0 and p_now_usec - session.lost_usec > int(KEPT_S * 1e6)
	)


## Those whose connection was lost so many seconds ago or more, the first one first.
func lost_for(p_seconds: float, p_now_usec: int) -> Array[Session]:
	var until_usec: int = p_now_usec - int(p_seconds * 1e6)
	var lost: Array[Session] = []
	for id: int in _sessions:
		if _sessions[id].peer == 0 and _sessions[id].lost_usec <= until_usec:
			lost.append(_sessions[id])
	lost.sort_custom(func(a: Session, b: Session) -> bool: return a.lost_usec < b.lost_usec)
	return lost


## Number of all, those included whose connection is lost.
func count() -> int:
	return _sessions.size()


## Number of sessions from a network.
func count_at(p_network: String) -> int:
	return _at_network.get(p_network, 0)


## Number of sessions from a site.
func count_at_site(p_site: String) -> int:
	return _at_site.get(p_site, 0)


## All, for an instructor; see [method ServerLink.roster].
func rows() -> Array[RosterRow]:
	var list: Array[RosterRow] = []
	for id: int in _sessions:
		var session: Session = _sessions[id]
		var row: RosterRow = RosterRow.new()
		row.session = session.id
		row.peer = session.peer
		row.role = session.role
		row.name = session.name
		row.address = session.address
		row.suit = session.suit
		row.state = RosterRow.State.HERE if session.is_here else RosterRow.State.LOST
		list.append(row)
	return list


func _count(p_session: Session, p_change: int) -> void:
	if p_session.network == "":
		return
	_add(_at_network, p_session.network, p_change)
	_add(_at_site, p_session.site, p_change)


static func _add(r_counts: Dictionary[String, int], p_key: String, p_change: int) -> void:
	r_counts[p_key] = r_counts.get(p_key, 0) + p_change
	if r_counts[p_key] <= 0:
		r_counts.erase(p_key)


## A name that no other session has: people are distinguished by it on screen and in orders.
func _free_name(p_name: String) -> String:
	var taken: Dictionary[String, bool] = {}
	for id: int in _sessions:
		taken[_sessions[id].name.to_lower()] = true
	var name: String = p_name
	var number: int = 1
	while taken.has(name.to_lower()):
		number += 1
		var suffix: String = " (%d)" % number
		name = p_name.left(Protocol.MAX_NAME - suffix.length()) + suffix
	return name
