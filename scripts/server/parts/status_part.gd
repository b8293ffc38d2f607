class_name StatusPart
extends ServerPart
## Says how the server is: in the log, and by [StatusEndpoint] to whoever asks on this machine.

## Seconds between two lines of stats in the log.
const _LINE_S: float = 10.0

var _endpoint: StatusEndpoint = StatusEndpoint.new()


func open(p_context: ServerContext) -> String:
	super(p_context)
	context.speed_changed.connect(_on_speed_changed)
	return ""


func begin() -> String:
	var port: int = context.options.number("status-port")
	if port == 0:
		port = context.options.number("port")
	if _endpoint.open(port) != OK:
		Log.warning("server", "TCP port %d is in use: there is no status (--status-port)" % port)
	else:
		Log.info("server", "status at http://127.0.0.1:%d/" % port)
	return ""


func frame() -> void:
	_endpoint.poll(context.make_report)
	if context.stats.since_status() > _LINE_S:
		Log.info("server", context.stats.describe(_count_clients(), _count_people()))


func report() -> Dictionary:
	return {"status_requests": _endpoint.counts}


func close() -> void:
	_endpoint.close()


func _on_speed_changed() -> void:
	if not context.stats.watch.is_slow:
		Log.info("server", "the world runs at full speed again")
		return
	var parts: Array = [100.0 * context.stats.watch.speed, _count_people(), _count_clients()]
	var text: String = "the world runs at %.0f %% of its speed (%d people, %d clients): "
	Log.warning("server", text % parts + "the machine is too slow for it")


func _count_clients() -> int:
	return context.link.session_ids().size()


func _count_people() -> int:
	return context.people.list().size()
