class_name StatusLines
extends ClientPart
## What the screen says of the session all the time: frames, traffic, latencies, views, keys. It
## also writes each latency to a file, if the options ask for it.

## Frames between two updates.
const _PERIOD: int = 10

var _keys: String = ""


func open(p_context: ClientContext) -> String:
	super(p_context)
	_keys = KeyGuide.hint(context.can(Roles.Capability.SEND_MOTION))
	context.hud.show_probe(context.stats.probe)
	context.scene.replica.wants_marks = context.options.file("latency-csv") != ""
	context.scene.replica.marked.connect(_on_marked)
	context.stream.restarted.connect(context.stats.probe.restart)
	context.scene.level_noted.connect(context.hud.show_note.bind(&"level"))
	context.scene.notified.connect(context.hud.show_news)
	return ""


func begin() -> String:
	var path: String = context.options.file("latency-csv")
	return context.stats.probe.write_to(context.fresh_file.call(path)) if path != "" else ""


func end_frame(_delta_s: float) -> void:
	if Engine.get_process_frames() % _PERIOD != 0:
		return
	var stream: StateStream = context.stream
	var text: String = context.stats.describe(context.role, stream.traffic, stream.security())
	context.hud.show_status(text, context.scene.describe_views() + "   " + _keys)
	context.hud.show_screen(context.stats.describe_screen() if context.link != null else "")


func report() -> Dictionary:
	var people: Array[Dictionary] = []
	if context.people != null:
		people = context.people.stats()
	return context.stats.report(context.role, context.stream.traffic, people)


func close() -> void:
	context.stats.probe.close()


func _on_marked(p_mark: LatencyMark) -> void:
	if not context.stream.knows_server_clock():
		return
	p_mark.arrival_usec = context.stream.server_usec(p_mark.arrival_usec)
	context.stats.probe.arrived(p_mark)
	if context.people != null:
		context.people.note_trip(p_mark)
