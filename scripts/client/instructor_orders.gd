class_name InstructorOrders
extends RefCounted
## What an instructor without a keyboard does: orders such as [code]admit:*,kick:Bob[/code] or
## [code]calibrate-full:Ada[/code], each carried out when somebody of that name is there to whom it
## applies, and [code]world:yard[/code], carried out at once.

## What can be ordered, and the state in which somebody must be for it.
const STATES: Dictionary[String, String] = {
	"admit": "waiting",
	"refuse": "waiting",
	"kick": "here",
	"ban": "here",
}
## Prefix of an order that has a trainee calibrated; one of [constant ClientCalibration.KINDS]
## follows.
const CALIBRATE: String = "calibrate-"
## The order that loads another level.
const WORLD: String = "world"

## What a row of a roster holds, and of which type: a server may send anything.
const _ROW: Dictionary[String, Variant.Type] = {
	"role": TYPE_INT,
	"state": TYPE_STRING,
	"name": TYPE_STRING,
	"peer": TYPE_INT,
	"session": TYPE_INT,
}

## Why the orders are invalid, or an empty text.
var error: String = ""

var _orders: Array[PackedStringArray] = []
var _control: SessionControl = null


func _init(p_text: String = "") -> void:
	for part: String in p_text.split(",", false):
		var order: PackedStringArray = part.strip_edges().split(":", true, 1)
		if order.size() != 2 or not _is_known(order[0]):
			var known: String = ", ".join(STATES.keys() + [CALIBRATE + "KIND", WORLD])
			error = "an order is one of %s, a colon and a name or *, found '%s'" % [known, part]
			return
		_orders.append(order)


## Gives the orders through a control.
func attach(p_control: SessionControl) -> void:
	if _control == null:
		p_control.roster_changed.connect(_on_roster_changed)
		p_control.answered.connect(func(text: String) -> void: Log.info("client", text))
	_control = p_control


func _on_roster_changed(p_roster: Array[Dictionary]) -> void:
	for order: PackedStringArray in _orders.duplicate():
		if order[0] == WORLD:
			_orders.erase(order)
			_control.change_level(order[1])
		for row: Dictionary in p_roster:
			if _is_meant(order, row):
				_give(order[0], row)
				if order[1] != "*":
					_orders.erase(order)


func _is_known(p_order: String) -> bool:
	return p_order == WORLD or STATES.has(p_order) or _calibration(p_order) >= 0


func _is_meant(p_order: PackedStringArray, p_row: Dictionary) -> bool:
	for key: String in _ROW:
		if typeof(p_row.get(key)) != _ROW[key]:
			return false
	if Roles.can(p_row["role"], Roles.Capability.MODERATE):
		return false
	if p_order[0] == WORLD:
		return false
	var named: bool = p_order[1] == "*" or p_order[1] == p_row["name"]
	if _calibration(p_order[0]) >= 0 and not Roles.can(p_row["role"], Roles.Capability.SEND_MOTION):
		return false
	return named and p_row["state"] == STATES.get(p_order[0], "here")


func _give(p_order: String, p_row: Dictionary) -> void:
	var peer: int = p_row["peer"]
	var session: int = p_row["session"]
	match p_order:
		"admit":
			_control.admit(peer)
		"refuse":
			_control.refuse(peer, "")
		"kick":
			_control.kick(session, "")
		"ban":
			_control.ban(session, "")
		_:
			_control.calibrate(session, 0, _calibration(p_order))


## The kind of calibration that an order asks for, or -1.
static func _calibration(p_order: String) -> int:
	var kind: String = p_order.trim_prefix(CALIBRATE)
	if not p_order.begins_with(CALIBRATE) or not ClientCalibration.KINDS.has(kind):
		return -1
	return ClientCalibration.KINDS[kind]
