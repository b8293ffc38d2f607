class_name LevelPart
extends ServerPart
## The level of the server: loads it, changes it as instructors ask, sends its files to clients who
## lack them, and keeps time of day and weather.

var _offers: LevelOffers = null
var _orders: LevelOrders = null
var _conditions: ServerConditions = null


func open(p_context: ServerContext) -> String:
	super(p_context)
	var options: Options = context.options
	var level: ServerLevel = context.level
	_offers = LevelOffers.new(context.link, level)
	_orders = LevelOrders.new(level, context.link.rates)
	take_options()
	context.control.level_requested.connect(_on_level_requested)
	context.control.fields_requested.connect(_on_fields_requested)
	level.changed.connect(_on_changed)
	level.share = LevelShare.new(options.file("levels"))
	_conditions = ServerConditions.new(level, options.text("time"), options.text("weather"))
	var fault: String = level.share.find_fault()
	fault = _conditions.error if fault == "" else fault
	return level.find_fault(options.text("world")) if fault == "" else fault


func begin() -> String:
	# A world that cannot be used is a wrong option.
	fault_code = 2
	return context.level.load_level(context.options.text("world"))


func advance(p_now_usec: int, p_delta_s: float) -> void:
	_orders.advance(p_now_usec / 1e6)
	context.level.advance(context.tick)
	_offers.advance(p_delta_s)


func take_options() -> void:
	_offers.bits_per_second = context.options.number("level-bandwidth") * 1000.0


func report() -> Dictionary:
	var about: Dictionary = context.level.report()
	about.merge(_offers.report())
	return {"level": about}


func finish() -> void:
	await context.level.loader.end_reading(get_tree())


func close() -> void:
	_offers.close()


func _on_changed() -> void:
	context.link.rules.level_name = context.level.reference
	context.link.rules.level_fingerprint = context.level.fingerprint
	_conditions.apply()


func _on_level_requested(p_name: String, p_reply: Callable) -> void:
	_orders.ask(p_name, p_reply, Time.get_ticks_usec() / 1e6)


func _on_fields_requested(p_values: Dictionary[StringName, float], p_answer: Callable) -> void:
	p_answer.call(_conditions.change(p_values))
