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
	return ""


func begin() -> String:
	var port: int = context.options.number("port")
	var address: String = context.options.text("bind")
	if address != "*" and not address.is_valid_ip_address():
		return "--bind expects an IP address of this machine or *, found '%s'" % address
	if context.link.listen(port, _rules, address) != OK:
		if address != "*" and not IP.get_local_addresses().has(address):
			return "--bind: this machine has no address %s" % address
		return "UDP port %d is in use: choose another with --port" % port
	# Its API is that of the open port; the level, which comes later, has to know it.
	_shared = SharedServer.new(context.link)
	context.level.shared = _shared.api
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


## Reads the options again: the parts behind this one take over what it has read.
func take_options() -> void:
	context.options = _reload.reload()
	context.link.renew_passwords()


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
