class_name ClientStreams
extends RefCounted
## Makes the [StateStream] that a client's options ask for.

## Role of a client that plays a recording; it never joins a session.
const REPLAY: String = "replay"

## The stream; never null.
var stream: StateStream = null
## The stream if it is a server's, otherwise null.
var live: LiveStream = null
## What is wrong with the options, or an empty text.
var error: String = ""


## The stream for a role.
static func make(p_role: String, p_options: Options) -> ClientStreams:
	var made: ClientStreams = ClientStreams.new()
	if p_role == REPLAY:
		made.stream = RecordedStream.of_file(p_options.file("file"), p_options.seconds("from"))
		return made
	made.live = LiveStream.new()
	made.stream = made.live
	made._set_up(p_role, p_options)
	return made


func _set_up(p_role: String, p_options: Options) -> void:
	live.host = p_options.text("host")
	live.port = p_options.number("port")
	live.password = p_options.text("password")
	live.patience_s = p_options.seconds("connect-timeout")
	live.request.role = Roles.find(p_role) as Roles.Role
	live.request.name = p_options.text("name") if p_options.text("name") != "" else p_role
	live.request.rate = p_options.number("snapshot-rate")
	live.request.version = p_options.number("protocol")
	var where: String = "%s:%d" % [live.host, live.port]
	var whose: JoinRequest = live.request
	live.link.token_file = SessionTokenFile.claim(where, whose.role, whose.name)
	live.link.trust = ServerTrust.of_options(p_options)
	error = live.link.trust.find_fault()
	live.link.seals = p_options.is_on("sealing")
	if error == "" and not live.link.seals and live.link.trust.pin != "":
		error = "--server-fingerprint: without sealing (--sealing=0) no server proves its key"
