class_name InstructorDesk
extends RefCounted
## What an instructor's client does beside watching: it carries out --orders, or takes commands from
## the terminal.

## The instructor wants to leave.
signal quit_wanted

## What is wrong with the orders, or an empty text.
var error: String = ""

var _link: ClientLink = null
var _control: InstructorControl = null
var _orders: InstructorOrders = null
var _terminal: InstructorTerminal = null


## With orders as --orders has them; without any there is a console.
func _init(p_link: ClientLink, p_orders: String, p_things: ThingOrders) -> void:
	_link = p_link
	_control = InstructorControl.new(p_link)
	_orders = InstructorOrders.new(p_orders)
	error = _orders.error
	if not _orders.is_empty():
		_orders.attach(_control, p_things)
	elif error == "":
		_terminal = InstructorTerminal.new()
		_terminal.quit_wanted.connect(quit_wanted.emit)
		_terminal.open(InstructorConsole.new(_control, p_things))


## Goes on; call it in every frame with the time, s.
func advance(p_now_s: float) -> void:
	_orders.advance()
	if _terminal != null:
		_terminal.advance(p_now_s, _link.is_joined() and not _control.roster.is_empty())


## Gives the terminal back.
func close() -> void:
	if _terminal != null:
		_terminal.close()
