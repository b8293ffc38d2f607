class_name WorldUpdates
extends ClientPart
## Takes in what the stream says of the world, acknowledges it, and sends the server stats.

var _stats_sent_s: float = 0.0


func open(p_context: ClientContext) -> String:
	super(p_context)
	context.scene.replica.set_smoothing(context.options.text("smoothing"))
	context.scene.entities.use(context.stream)
	context.stream.received.connect(_on_received)
	context.stream.restarted.connect(context.scene.clear)
	context.stream.ended.connect(context.failed.emit)
	context.scene.level_missing.connect(
		func(why: String) -> void: context.failed.emit(StateStream.EXIT_REFUSED, why)
	)
	return ""


func advance(_delta_s: float) -> void:
	var bytes: PackedByteArray = context.scene.replica.acknowledgement(
		Time.get_ticks_usec(), context.scene.viewpoint()
	)
	if not bytes.is_empty() and context.people != null:
		context.people.send_ack(bytes)
	elif not bytes.is_empty():
		context.stream.send_fast(bytes)
	var is_due: bool = context.now_s() - _stats_sent_s > StatsMessage.PERIOD_S
	if context.scene.replica.is_ready() and is_due:
		_stats_sent_s = context.now_s()
		context.stream.send_fast(context.stats.packet())


func _on_received(p_bytes: PackedByteArray, p_time_s: float) -> void:
	if not context.keeper.is_valid() or not context.keeper.call(p_bytes):
		context.take(p_bytes, p_time_s)
