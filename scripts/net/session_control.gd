class_name SessionControl
extends Node
## What instructors can do with a session: remote calls over Godot's multiplayer API. The server
## checks the caller's role and every argument.
##
## The same node, under the same name, belongs on both sides: [method serve] on the server,
## [method follow] on an instructor's client, whose [member roster] is kept up to date.

## Who is here, lost or waiting has changed; see [method ServerLink.roster]. On clients.
signal roster_changed(p_roster: Array[Dictionary])
## An instructor asks for another level; the callable gets the reason why not, or an empty text. On
## the server.
signal level_requested(p_name: String, p_answer: Callable)
## The result of a request, for the instructor who made it. On clients.
signal answered(p_text: String)

## Name of the node on both sides.
const NODE_NAME: StringName = &"SessionControl"
## Seconds between two notices about one session.
const NOTICE_S: float = 5.0
## Longest reason, characters.
const MAX_REASON: int = 120

## Who is here, lost or waiting, on an instructor's client.
var roster: Array[Dictionary] = []

var _link: ServerLink = null
var _noticed_s: Dictionary[int, float] = {}


## Adds the node to a server, below a node of its own.
static func serve(p_parent: Node, p_link: ServerLink) -> SessionControl:
	var control: SessionControl = _attach(p_parent, p_link.api())
	control._link = p_link
	p_link.roster_changed.connect(control._push)
	p_link.client_left.connect(control._forget)
	return control


## Adds the node to an instructor's client, below a node of its own; again after each
## [method ClientLink.open].
static func follow(p_parent: Node, p_link: ClientLink) -> SessionControl:
	return _attach(p_parent, p_link.api())


## Asks the server to admit a waiting peer, by its id in the [member roster].
func admit(p_peer: int) -> void:
	_admit.rpc_id(MultiplayerPeer.TARGET_PEER_SERVER, p_peer)


## Asks the server to refuse a waiting peer, by its id in the [member roster].
func refuse(p_peer: int, p_why: String) -> void:
	_refuse.rpc_id(MultiplayerPeer.TARGET_PEER_SERVER, p_peer, p_why)


## Asks the server to dismiss a client.
func kick(p_session: int, p_why: String) -> void:
	_kick.rpc_id(MultiplayerPeer.TARGET_PEER_SERVER, p_session, p_why)


## Asks the server to dismiss a client and ban its address.
func ban(p_session: int, p_why: String) -> void:
	_ban.rpc_id(MultiplayerPeer.TARGET_PEER_SERVER, p_session, p_why)


## Asks the server to have one of a trainee's people calibrated: thesis 6.1's "Reset Pose" button.
## [param p_pose] is one of those that clients know.
func calibrate(p_session: int, p_index: int, p_pose: int) -> void:
	_calibrate.rpc_id(MultiplayerPeer.TARGET_PEER_SERVER, p_session, p_index, p_pose)


## Asks the server for another level, by its name.
func change_level(p_name: String) -> void:
	_change_level.rpc_id(MultiplayerPeer.TARGET_PEER_SERVER, p_name)


## Tells all instructors what a session did wrong: on the server. Each session is named at most once
## in [constant NOTICE_S].
func tell_instructors(p_session: int, p_text: String) -> void:
	var now: float = Time.get_ticks_usec() / 1e6
	if now - _noticed_s.get(p_session, -NOTICE_S) < NOTICE_S:
		return
	_noticed_s[p_session] = now
	for row: Dictionary in _link.roster():
		if _is_reachable_moderator(row):
			_tell.rpc_id(row["peer"], p_text)


static func _attach(p_parent: Node, p_api: SceneMultiplayer) -> SessionControl:
	var control: SessionControl = p_parent.get_node_or_null(NodePath(NODE_NAME))
	if control == null:
		control = SessionControl.new()
		control.name = NODE_NAME
		p_parent.add_child(control)
	control.get_tree().multiplayer_poll = false
	control.get_tree().set_multiplayer(p_api, p_parent.get_path())
	return control


@rpc("any_peer", "call_remote", "reliable")
func _admit(p_peer: Variant = null) -> void:
	var caller: Session = _caller(Roles.Capability.MODERATE)
	if caller != null and p_peer is int:
		_answer(caller, _link.admit(p_peer), "%s let '%s' in" % [caller.name, p_peer])


@rpc("any_peer", "call_remote", "reliable")
func _refuse(p_peer: Variant = null, p_why: Variant = null) -> void:
	var caller: Session = _caller(Roles.Capability.MODERATE)
	if caller != null and p_peer is int and p_why is String:
		var why: String = "refused by %s" % _sign(caller, p_why)
		_answer(caller, _link.refuse(p_peer, why), why)


@rpc("any_peer", "call_remote", "reliable")
func _kick(p_session: Variant = null, p_why: Variant = null) -> void:
	var caller: Session = _caller(Roles.Capability.MODERATE)
	if caller != null and p_session is int and p_why is String:
		var why: String = "kicked by %s" % _sign(caller, p_why)
		_answer(caller, _link.kick(p_session, why), "session %d was %s" % [p_session, why])


@rpc("any_peer", "call_remote", "reliable")
func _ban(p_session: Variant = null, p_why: Variant = null) -> void:
	var caller: Session = _caller(Roles.Capability.MODERATE)
	if caller != null and p_session is int and p_why is String:
		var why: String = "banned by %s" % _sign(caller, p_why)
		_answer(caller, _link.ban(p_session, why), "session %d was %s" % [p_session, why])


@rpc("any_peer", "call_remote", "reliable")
func _calibrate(p_session: Variant = null, p_index: Variant = null, p_pose: Variant = null) -> void:
	var caller: Session = _caller(Roles.Capability.DIRECT)
	if caller != null and p_session is int and p_index is int and p_pose is int:
		var done: String = "session %d was asked to calibrate" % p_session
		_answer(caller, _link.ask_calibration(p_session, p_index, p_pose), done)


@rpc("any_peer", "call_remote", "reliable")
func _change_level(p_name: Variant = null) -> void:
	var caller: Session = _caller(Roles.Capability.DIRECT)
	if caller != null and p_name is String:
		var name_asked: String = ByteReader.clean((p_name as String).left(Protocol.MAX_LEVEL_NAME))
		var answer: Callable = _answer.bind("the world is now '%s'" % name_asked)
		level_requested.emit(name_asked, func(fault: String) -> void: answer.call(caller, fault))


@rpc("authority", "call_remote", "reliable")
func _show(p_roster: Variant = null) -> void:
	roster = []
	if _link == null and p_roster is Array:
		for row: Variant in p_roster:
			if row is Dictionary:
				roster.append(row)
		roster_changed.emit(roster)


@rpc("authority", "call_remote", "reliable")
func _tell(p_text: Variant = null) -> void:
	if _link == null and p_text is String:
		answered.emit(ByteReader.clean((p_text as String).left(400)))


## The client that calls, or null if it may not.
func _caller(p_capability: Roles.Capability) -> Session:
	if _link == null:
		return null
	var session: Session = _link.session_of_peer(multiplayer.get_remote_sender_id())
	if session != null and session.is_here and session.can(p_capability):
		return session
	Log.limited("net", "instructor", "somebody who may not gives orders")
	return null


func _sign(p_caller: Session, p_why: String) -> String:
	var why: String = ByteReader.clean(p_why.left(MAX_REASON)).strip_edges()
	return "instructor '%s'%s" % [p_caller.name, ": " + why if why != "" else ""]


func _answer(p_caller: Session, p_fault: String, p_done: String) -> void:
	Log.info("net", "%s asked: %s" % [p_caller.describe(), p_fault if p_fault != "" else p_done])
	if p_caller.is_here:
		_tell.rpc_id(p_caller.peer, p_fault if p_fault != "" else p_done)


func _forget(p_session: int) -> void:
	_noticed_s.erase(p_session)


func _push() -> void:
	var rows: Array[Dictionary] = _link.roster()
	for row: Dictionary in rows:
		if _is_reachable_moderator(row):
			_show.rpc_id(row["peer"], rows)


func _is_reachable_moderator(p_row: Dictionary) -> bool:
	var moderates: bool = Roles.can(p_row["role"], Roles.Capability.MODERATE)
	var is_here: bool = p_row["state"] == "here"
	return moderates and is_here and multiplayer.get_peers().has(p_row["peer"])
