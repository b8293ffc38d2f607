extends TestCase
## What instructors order by options, and to whom it goes.

const TRAINEE: Roles.Role = Roles.Role.TRAINEE
const OBSERVER: Roles.Role = Roles.Role.OBSERVER
const INSTRUCTOR: Roles.Role = Roles.Role.INSTRUCTOR

var _control: Listener = null
var _orders: InstructorOrders = null


## Writes down what would be asked of a server.
class Listener:
	extends SessionControl
	var asked: Array[Array] = []

	func admit(p_peer: int) -> void:
		asked.append(["admit", p_peer])

	func refuse(p_peer: int, _p_why: String) -> void:
		asked.append(["refuse", p_peer])

	func kick(p_session: int, _p_why: String) -> void:
		asked.append(["kick", p_session])

	func ban(p_session: int, _p_why: String) -> void:
		asked.append(["ban", p_session])

	func calibrate(p_session: int, p_index: int, p_pose: int) -> void:
		asked.append(["calibrate", p_session, p_index, p_pose])


func before_each() -> void:
	_control = Listener.new()


func after_each() -> void:
	_control.free()


func test_each_kind_of_calibration_can_be_ordered() -> void:
	for kind: String in ClientCalibration.KINDS:
		_control.free()
		_control = Listener.new()
		_order("calibrate-%s:Ada" % kind)
		_tell([_row("Ada", TRAINEE, 7)])
		equal(_control.asked, [["calibrate", 7, 0, ClientCalibration.KINDS[kind]]])


func test_only_trainees_who_are_here_are_calibrated() -> void:
	_order("calibrate-full:*")
	var lost: Dictionary = _row("Cid", TRAINEE, 5)
	lost["state"] = "lost"
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


func test_orders_that_make_no_sense_are_told() -> void:
	for text: String in [
		"calibrate:Ada", "calibrate-:Ada", "calibrate-dance:Ada", "calibrate-full", "full:Ada", ":"
	]:
		contains(InstructorOrders.new(text).error, "calibrate-KIND", text)
	for text: String in ["", "calibrate-full:Ada", " calibrate-n_pose:* , admit:*"]:
		equal(InstructorOrders.new(text).error, "", text)


func test_rosters_of_a_hostile_server() -> void:
	_order("calibrate-full:*,kick:*,admit:*")
	var odd: Dictionary = _row("Ada", TRAINEE, 7)
	odd["session"] = "7"
	_tell([{}, {"role": "x", "state": 5, "name": null}, {"role": TRAINEE, "state": "here"}, odd])
	equal(_control.asked, [])
	_tell([{5: 7}, _row("Ada", TRAINEE, 7)])
	equal(_control.asked.size(), 2, "calibrated and kicked")


func _order(p_text: String) -> void:
	_orders = InstructorOrders.new(p_text)
	equal(_orders.error, "")
	_orders.attach(_control)


func _tell(p_rows: Array) -> void:
	var rows: Array[Dictionary] = []
	rows.assign(p_rows)
	_control.roster_changed.emit(rows)


func _row(p_name: String, p_role: Roles.Role, p_session: int) -> Dictionary:
	return {"name": p_name, "role": p_role, "session": p_session, "peer": 99, "state": "here"}
