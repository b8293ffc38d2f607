class_name ClientHandshake
extends RefCounted
## A client's half of the handshake, the counterpart of [ServerHandshake]: it answers the challenge
## with the join request, proves the password, and has the server prove that it knows it too.
##
## It outlasts a connection: it keeps what the server gave us to come back with.

## The server has admitted us, and has proven the password if there is one.
signal welcomed(p_reply: JoinReply)
## We wait; our position among those who wait for the same, from 1.
signal waiting(p_position: int, p_for: JoinReply.Wait)
## The server will not admit us, however often we ask.
signal refused(p_why: String)
## The server cannot admit us now.
signal put_off(p_why: String)

## Whether the connection is sealed.
var seals: bool = true
## Keeps the session's token, so that a client whose program crashed can come back; null keeps it in
## memory only.
var token_file: SessionTokenFile = null
## Whether the server took us back into the session before, in the last welcome.
var came_back: bool = false
## Decides which keys of servers are trusted.
var trust: ServerTrust = ServerTrust.new()

var _api: SceneMultiplayer = null
var _peer: ThreadedPeer = null
var _where: String = ""
var _request: JoinRequest = null
var _password: String = ""
var _locked: bool = false
# The server's, or what stands for it where the connection is sealed; empty until it is known.
var _challenge: PackedByteArray = PackedByteArray()
var _said: Array[PackedByteArray] = []
# Kept with its salt: to derive it takes long.
var _key: PackedByteArray = PackedByteArray()
var _key_salt: PackedByteArray = PackedByteArray()
var _token: PackedByteArray = PackedByteArray()
var _return_tag: PackedByteArray = PackedByteArray()
# The server that gave us the token and the tag.
var _given_by: String = ""


## Prepares for a connection to a server: see [method sealing] and [method attach].
func prepare(p_where: String, p_request: JoinRequest, p_password: String) -> void:
	if p_password != _password:
		_key = PackedByteArray()
	_where = p_where
	_request = p_request
	_password = p_password
	_locked = false
	_challenge = PackedByteArray()
	if _given_by != _where:
		_token = token_file.token() if token_file != null else PackedByteArray()
		_return_tag = PackedByteArray()
		_given_by = _where
	_request.token = _token


## How the connection is to be sealed, and which key the server has to prove.
func sealing() -> TransportSealing:
	var made: TransportSealing = TransportSealing.new()
	made.seals = seals
	made.version = _request.version
	made.role = _request.role
	made.password = _password
	made.return_tag = _return_tag
	made.known_key = trust.expect(_where)
	return made


## Does the handshake through the authentication of an API, whose peer is given.
func attach(p_api: SceneMultiplayer, p_peer: ThreadedPeer) -> void:
	_api = p_api
	_peer = p_peer
	_api.auth_timeout = 0.0
	_api.auth_callback = _on_message
	_api.peer_authenticating.connect(_on_authenticating)


## The connection is over, or will be: nothing more of it is processed.
func detach() -> void:
	_api = null
	_peer = null


## The server has shown another key than the expected one: says so, and what is to be done.
func explain_other_key(p_shown: PackedByteArray) -> String:
	trust.refuse(_where, p_shown)
	return trust.other.describe()


## How well the connection is protected, for the log.
func describe_security() -> String:
	var made: TransportSealing = TransportSealing.new()
	made.seals = seals
	made.password = _password if _locked else ""
	return made.describe()


## Lets us come back into our session; empty if there is none.
func token() -> PackedByteArray:
	return _token


## The session is over for good: there is nothing to come back to.
func forget_session() -> void:
	_token = PackedByteArray()
	if token_file != null:
		token_file.forget()


## A sealed connection needs no challenge: both ends know a key already, and nobody else does.
func _on_authenticating(_peer_id: int) -> void:
	var joined: TransportEvent = _peer.sealed_join() if _peer != null else null
	if joined == null:
		return
	# Before anything is sent: what follows is for this server alone.
	if not trust.take(_where, joined.server_key, _password != ""):
		refused.emit(trust.other.describe())
		return
	_key = joined.exporter
	_key_salt = PackedByteArray()
	_locked = joined.locked
	_return_tag = joined.return_tag
	_challenge = Challenge.SEALED.to_ascii_buffer()
	_send_join_request()


func _on_message(p_peer: int, p_bytes: PackedByteArray) -> void:
	if p_peer != MultiplayerPeer.TARGET_PEER_SERVER or _api == null:
		return
	if _challenge.is_empty():
		_take_challenge(p_bytes)
		return
	var reply: JoinReply = JoinReply.decode(p_bytes)
	match reply.kind:
		JoinReply.Kind.WELCOME:
			_take_welcome(reply)
		JoinReply.Kind.WAIT:
			waiting.emit(reply.position, reply.waits_for)
		JoinReply.Kind.LATER:
			put_off.emit(reply.why)
		_:
			refused.emit(reply.why)


func _take_challenge(p_bytes: PackedByteArray) -> void:
	var challenge: Challenge = Challenge.decode(p_bytes)
	if challenge.error != "":
		refused.emit(challenge.error)
		return
	_locked = challenge.is_locked(_request.role)
	if _password != "" and not _locked:
		# What was given must be proven: anybody can send a challenge, and the token goes to its
		# sender.
		refused.emit(TransportSealing.ASKS_FOR_NO_PASSWORD)
		return
	_challenge = p_bytes
	if _key.is_empty() or _key_salt != challenge.salt:
		_key = PasswordKey.derive(_password, challenge.salt, challenge.rounds)
		_key_salt = challenge.salt
	_send_join_request()


func _send_join_request() -> void:
	var bytes: PackedByteArray = _request.encode(_challenge, _key)
	_said = [_challenge, bytes]
	_api.send_auth(MultiplayerPeer.TARGET_PEER_SERVER, bytes)


func _take_welcome(p_reply: JoinReply) -> void:
	var must_prove: bool = _locked or seals
	if must_prove and not p_reply.is_proven(_key, _said):
		refused.emit("the server does not know the password")
		return
	came_back = p_reply.token == _token
	_token = p_reply.token
	if token_file != null:
		token_file.keep(_token)
	welcomed.emit(p_reply)
	_api.complete_auth(MultiplayerPeer.TARGET_PEER_SERVER)
