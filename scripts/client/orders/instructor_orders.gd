class_name InstructorOrders
extends RefCounted
## What an instructor without a keyboard does: orders such as [code]admit:*,kick:Bob[/code] or
## [code]calibrate-full:Ada[/code], each carried out when somebody of that name is there to whom it
## applies, and [code]world:yard[/code],
## [code]time:18:30[/code] or [code]weather:rain 0.5[/code], carried out at once;
## [code]upright:Tank[/code] or [code]repair:*[/code], once there is such a thing.

## The orders, and the state that their target must be in.
const STATES: Dictionary[String, RosterRow.State] = {
	"admit": RosterRow.State.WAITING,
	"refuse": RosterRow.State.WAITING,
	"kick": RosterRow.State.HERE,
	"ban": RosterRow.State.HERE,
}
## Prefix of an order that has a trainee calibrated; a name of
## [method ClientCalibration.orders] follows.
const CALIBRATE: String = "calibrate-"
## The order that loads another level.
const WORLD: String = "world"
## The orders that change time of day and weather.
const CONDITIONS: PackedStringArray = ["time", "weather"]

## Why the orders are invalid, or an empty text.
var error: String = ""

var _orders: Array[PackedStringArray] = []
var _control: InstructorControl = null
var _things: ThingOrders = null


func _init(p_text: String = "") -> void:
	for part: String in p_text.split(",", false):
		var order: PackedStringArray = part.strip_edges().split(":", true, 1)
		if order.size() != 2 or not _is_known(order[0]):
			var others: Array = (
				[CALIBRATE + "KIND", WORLD] + Array(CONDITIONS) + Array(ThingOrders.COMMANDS)
			)
			var known: String = ", ".join(STATES.keys() + others)
			error = "an order is one of %s, a colon and a name or *, found '%s'" % [known, part]
			return
		if CONDITIONS.has(order[0]) and WorldConditions.parse(order[0], order[1]).is_empty():
			var choice: String = WorldConditions.describe(order[0])
			error = "%s is one of %s; found '%s'" % [order[0], choice, order[1]]
			return
		_orders.append(order)


## Whether there are no orders.
func is_empty() -> bool:
	return _orders.is_empty()


## Gives the orders through a control, those about things of the level through [param p_things].
func attach(p_control: InstructorControl, p_things: ThingOrders = null) -> void:
	_control = p_control
	_things = p_things
	_control.roster_changed.connect(_on_roster_changed)
	_control.answered.connect(func(answer: AnswerMessage) -> void: Log.info("client", answer.text))


## Gives those about things of the level, once there are any. Call it in every frame.
func advance() -> void:
	for order: PackedStringArray in _orders.duplicate():
		var is_due: bool = _things != null and ThingOrders.COMMANDS.has(order[0])
		if is_due and not _things.names(order[0]).is_empty():
			_orders.erase(order)
			Log.info("client", _things.give(order[0], order[1]))


func _on_roster_changed() -> void:
	for order: PackedStringArray in _orders.duplicate():
		if order[0] == WORLD:
			_orders.erase(order)
			_control.change_level(order[1])
			continue
		if ThingOrders.COMMANDS.has(order[0]):
			continue
		if CONDITIONS.has(order[0]):
			_orders.erase(order)
			_control.set_fields(WorldConditions.parse(order[0], order[1]))
			continue
		for row: RosterRow in _control.roster:
			if _is_meant(order, row):
				_give(order[0], row)
				if order[1] != "*":
					_orders.erase(order)


func _is_known(p_order: String) -> bool:
	return (
		p_order == WORLD
		or ThingOrders.COMMANDS.has(p_order)
		or CONDITIONS.has(p_order)
		or STATES.has(p_order)
		or _calibration(p_order) >= 0
	)


func _is_meant(p_order: PackedStringArray, p_row: RosterRow) -> bool:
	if Roles.can(p_row.role, Roles.Capability.MODERATE):
		return false
	var named: bool = p_order[1] == "*" or p_order[1] == p_row.name
	if _calibration(p_order[0]) >= 0 and not Roles.can(p_row.role, Roles.Capability.SEND_MOTION):
		return false
	return named and p_row.state == STATES.get(p_order[0], RosterRow.State.HERE)


func _give(p_order: String, p_row: RosterRow) -> void:
	match p_order:
		"admit":
			_control.admit(p_row.peer)
		"refuse":
			_control.refuse(p_row.peer, "")
		"kick":
			_control.kick(p_row.session, "")
		"ban":
			_control.ban(p_row.session, "")
		_:
			_control.calibrate(p_row.session, 0, _calibration(p_order))


## The kind of calibration that an order asks for, or -1.
static func _calibration(p_order: String) -> int:
	var kind: String = p_order.trim_prefix(CALIBRATE)
	return ClientCalibration.orders().get(kind, -1) if p_order.begins_with(CALIBRATE) else -1
