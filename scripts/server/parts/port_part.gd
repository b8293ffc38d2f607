class_name PortPart
extends ServerPart
## The server's port: whom it admits, what has arrived, and which of its rules may change while it
## runs.

var _reload: ServerReload = null
var _rules: ServerRules = ServerRules.new()
var _shared: SharedServer = null


func open(p_context: ServerContext) -> String:
	super(p_context)
	var options: Options = context.options
	ServerReload.apply(options, _rules)
	_rules.bans = BanList.open(options.file("ban-file"))
	_rules.seals = options.is_on("sealing")
	if _rules.bans.error != "":
		return _rules.bans.error
	if _rules.seals:
		var key: ServerKeyFile = ServerKeyFile.open(options.file("server-key"))
		if key.error != "":
			return key.error
		_rules.server_key = key.key_seed
	context.link.rules = _rules
	_reload = ServerReload.new(options, _rules)
	context.reload_wanted.connect(_on_reload_wanted)
	_shared = SharedServer.new(context.link)
	context.level.shared = _shared.api
	return ""


func begin() -> String:
	var port: int = context.options.number("port")
	if context.link.listen(port, _rules) != OK:
		return "UDP port %d is in use: choose another with --port" % port
	Log.info("net", _rules.sealing().describe())
	if _rules.seals:
		Log.info("net", "the server's key is %s" % _rules.fingerprint())
	return ""


func receive(p_now_usec: int) -> void:
	context.network_usec -= ThreadClock.get_usec()
	context.link.publish_tick(context.tick + 1, p_now_usec, context.rate())
	context.link.poll()
	context.control.advance()
	context.network_usec += ThreadClock.get_usec()


func report() -> Dictionary:
	var link: ServerLink = context.link
	return {
		"clients": link.session_ids().size(),
		"sent_bytes_per_second": link.traffic.sent_per_second(),
		"received_bytes_per_second": link.traffic.received_per_second(),
		"sealing": link.rules.seals,
		"server_key": link.rules.fingerprint(),
		"transport": link.stats(),
		"refused": link.refused,
	}


func finish() -> void:
	if _shared != null:
		_shared.api.close()


func close() -> void:
	context.link.close()


func _on_reload_wanted() -> void:
	context.options = _reload.reload()
	context.link.renew_passwords()
