extends TestCase
## What instructors order by options, and to whom it goes.

const TRAINEE: Roles.Role = Roles.Role.TRAINEE
const OBSERVER: Roles.Role = Roles.Role.OBSERVER
const INSTRUCTOR: Roles.Role = Roles.Role.INSTRUCTOR

var _control: Listener = null
var _orders: InstructorOrders = null


## Writes down what would be asked of a server.
class Listener:
	extends InstructorControl
	var asked: Array[Array] = []

	func _init() -> void:
		super(ClientLink.new())

	func admit(p_peer: int) -> int:
		asked.append(["admit", p_peer])
		return asked.size()

	func refuse(p_peer: int, _p_why: String) -> int:
		asked.append(["refuse", p_peer])
		return asked.size()

	func kick(p_session: int, _p_why: String) -> int:
		asked.append(["kick", p_session])
		return asked.size()

	func ban(p_session: int, _p_why: String) -> int:
		asked.append(["ban", p_session])
		return asked.size()

	func set_fields(p_values: Dictionary[StringName, float]) -> int:
		asked.append(["fields", OrderMessage.write_fields(p_values)])
		return asked.size()

	func calibrate(p_session: int, p_index: int, p_pose: int) -> int:
		asked.append(["calibrate", p_session, p_index, p_pose])
		return asked.size()


func before_each() -> void:
	_control = Listener.new()


func test_each_kind_of_calibration_can_be_ordered() -> void:
	for kind: String in ClientCalibration.KINDS:
		_control = Listener.new()
		_order("calibrate-%s:Ada" % kind)
		_tell([_row("Ada", TRAINEE, 7)])
		equal(_control.asked, [["calibrate", 7, 0, ClientCalibration.KINDS[kind]]])


func test_time_and_weather_are_ordered_once() -> void:
	_order("time:18:30,weather:rain 0.5")
	_tell([])
	_tell([])
	var rain: Array = ["fields", "weather=3.0 weather_strength=0.5"]
	equal(_control.asked, [["fields", "time_of_day=18.5"], rain] as Array[Array])
	contains(InstructorOrders.new("time:25").error, "hours from 0 to 24")
	contains(InstructorOrders.new("weather:snow").error, "clear, haze, dust, rain")


func test_only_trainees_who_are_here_are_calibrated() -> void:
	_order("calibrate-full:*")
	var lost: RosterRow = _row("Cid", TRAINEE, 5)
	lost.state = RosterRow.State.LOST
	_tell([_row("Eve", OBSERVER, 3), _row("Ida", INSTRUCTOR, 4), lost, _row("Ada", TRAINEE, 7)])
	var full: int = ClientCalibration.KINDS["full"]
	equal(_control.asked, [["calibrate", 7, 0, full]])


func test_a_name_is_asked_once() -> void:
	_order("calibrate-quick:Ada,kick:Bob")
	for _time: int in 3:
		_tell([_row("Ada", TRAINEE, 7)])
	_tell([_row("Ada", TRAINEE, 7), _row("Bob", TRAINEE, 8)])
	var quick: int = ClientCalibration.KINDS["quick"]
	equal(_control.asked, [["calibrate", 7, 0, quick], ["kick", 8]])


func test_orders_that_make_no_sense_are_reported() -> void:
	for text: String in [
		"calibrate:Ada", "calibrate-:Ada", "calibrate-dance:Ada", "calibrate-full", "full:Ada", ":"
	]:
		contains(InstructorOrders.new(text).error, "calibrate-KIND", text)
	for text: String in ["", "calibrate-full:Ada", " calibrate-n_pose:* , admit:*"]:
		equal(InstructorOrders.new(text).error, "", text)


func _order(p_text: String) -> void:
	_orders = InstructorOrders.new(p_text)
	equal(_orders.error, "")
	_orders.attach(_control)


func _tell(p_rows: Array[RosterRow]) -> void:
	_control.roster = p_rows
	_control.roster_changed.emit()


func _row(p_name: String, p_role: Roles.Role, p_session: int) -> RosterRow:
	var row: RosterRow = RosterRow.new()
	row.name = p_name
	row.role = p_role
	row.session = p_session
	row.peer = 99
	row.state = RosterRow.State.HERE
	return row
