class_name InstructorDesk
extends ClientPart
## What an instructor's client does beside watching: it carries out --orders, or takes commands from
## the terminal.

var _control: InstructorControl = null
var _orders: InstructorOrders = null
var _terminal: InstructorTerminal = null


func open(p_context: ClientContext) -> String:
	super(p_context)
	var things: ThingOrders = ThingOrders.new(context.scene.replica, context.scene.entities)
	_control = InstructorControl.new(context.link)
	_orders = InstructorOrders.new(context.options.text("orders"))
	if not _orders.is_empty():
		_orders.attach(_control, things)
	elif _orders.error == "":
		_terminal = InstructorTerminal.new()
		_terminal.quit_wanted.connect(context.leave_wanted.emit.bind(StateStream.EXIT_DONE))
		_terminal.open(InstructorConsole.new(_control, things))
	return _orders.error


func begin_frame() -> void:
	_orders.advance()
	if _terminal != null:
		var is_ready: bool = context.link.is_joined() and not _control.roster.is_empty()
		_terminal.advance(ClientContext.ui_s(), is_ready)


## Gives the terminal back.
func close() -> void:
	if _terminal != null:
		_terminal.close()
