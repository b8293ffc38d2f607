class_name ClientLevels
extends ClientPart
## Loads the server's levels over several frames, and gets them from it where they are not on this
## machine: see [LevelArrival].

var _arrival: LevelArrival = null


func open(p_context: ClientContext) -> String:
	super(p_context)
	var store: ReceivedLevels = ReceivedLevels.new()
	store.room = context.options.number("level-store") << 20
	context.scene.get_level().store = store
	_arrival = LevelArrival.new(context.scene, store, context.link.send_reliably)
	_arrival.hold_shared = context.link.hold_shared
	_arrival.progressed.connect(context.hud.show_message)
	context.keeper = _arrival.keeps
	context.stream.restarted.connect(_arrival.restart)
	context.link.handle(
		Protocol.Message.LEVEL_DATA,
		MessageHandlers.Path.RELIABLE,
		func(bytes: PackedByteArray, _arrival_usec: int) -> bool: return _arrival.take_data(bytes)
	)
	return ""


func advance(p_delta_s: float) -> void:
	_arrival.advance(p_delta_s, context.take)
	context.arrived = _arrival.first_progress()


func report() -> Dictionary:
	return {"level": _arrival.report()}


func finish() -> void:
	await _arrival.end_reading(get_tree())


func close() -> void:
	_arrival.close()
