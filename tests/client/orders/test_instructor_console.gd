extends TestCase
## What an instructor types, and the answers.

const TRAINEE: Roles.Role = Roles.Role.TRAINEE
const OBSERVER: Roles.Role = Roles.Role.OBSERVER
const INSTRUCTOR: Roles.Role = Roles.Role.INSTRUCTOR

var _control: Listener = null
var _console: InstructorConsole = null
var _said: Array[String] = []
var _quits: int = 0


## Writes down what would be asked of a server.
class Listener:
	extends InstructorControl
	var asked: Array[Array] = []

	func _init() -> void:
		super(ClientLink.new())

	func ask_who() -> int:
		return _note(["who"])

	func admit(p_peer: int) -> int:
		return _note(["admit", p_peer])

	func refuse(p_peer: int, p_why: String) -> int:
		return _note(["refuse", p_peer, p_why])

	func kick(p_session: int, p_why: String) -> int:
		return _note(["kick", p_session, p_why])

	func ban(p_session: int, p_why: String) -> int:
		return _note(["ban", p_session, p_why])

	func calibrate(p_session: int, p_index: int, p_pose: int) -> int:
		return _note(["calibrate", p_session, p_index, p_pose])

	func change_level(p_name: String) -> int:
		return _note(["level", p_name])

	func set_fields(p_values: Dictionary[StringName, float]) -> int:
		return _note(["fields", OrderMessage.write_fields(p_values)])

	func send_effect(p_name: String, p_text: String) -> int:
		return _note(["effect", p_name, p_text.length()])

	func _note(p_what: Array) -> int:
		asked.append(p_what)
		return asked.size()


func before_each() -> void:
	_said.clear()
	_quits = 0
	_control = Listener.new()
	_control.roster = [
		_row("Ada", TRAINEE, 1),
		_row("Ada (2)", TRAINEE, 2),
		_row("Adam Smith", OBSERVER, 3),
		_row("Bob", TRAINEE, 4, RosterRow.State.LOST),
		_row("Ida", INSTRUCTOR, 5),
		_row("Eve", TRAINEE, 0, RosterRow.State.WAITING, 77),
		_row("Zoë", OBSERVER, 0, RosterRow.State.WAITING, 78),
	]
	_console = InstructorConsole.new(_control)
	_console.said.connect(func(line: String) -> void: _said.append(line))
	_console.quit_wanted.connect(func() -> void: _quits += 1)


func test_orders_go_to_whom_they_name() -> void:
	for row: Array in [
		["kick Ada", ["kick", 1, ""]],
		["kick ada too loud", ["kick", 1, "too loud"]],
		["kick Ada (2) too loud", ["kick", 2, "too loud"]],
		["ban adam smith bye", ["ban", 3, "bye"]],
		["k Adam", ["kick", 3, ""]],
		["kick bo gone", ["kick", 4, "gone"]],
		["calibrate Ada", ["calibrate", 1, 0, ClientCalibration.KINDS["t_to_n"]]],
		["cal Ada (2) full", ["calibrate", 2, 0, ClientCalibration.KINDS["full"]]],
		["admit E", ["admit", 77]],
		["refuse zoë not today", ["refuse", 78, "not today"]],
		["level yard", ["level", "yard"]],
		["time 18:30", ["fields", "time_of_day=18.5"]],
		["wea dust 0.5", ["fields", "weather=2.0 weather_strength=0.5"]],
		["  who  ", ["who"]],
	]:
		_control.asked.clear()
		_console.submit(row[0])
		equal(_control.asked, [row[1]] as Array[Array], row[0])
	_control.asked.clear()
	_console.submit("admit *")
	equal(_control.asked, [["admit", 77], ["admit", 78]] as Array[Array])
	_control.asked.clear()
	_console.submit("calibrate * quick")
	equal(_control.asked.size(), 2, "both trainees that are here")


func test_what_makes_no_sense_is_answered_and_asks_nothing() -> void:
	for row: Array in [
		["kick Nobody", "nobody is called Nobody"],
		["kick Nobody too loud", "nobody is called Nobody too loud"],
		["kick", "kick whom?"],
		["kick *", "kick takes one name"],
		["kick Ad", "'Ad' could be Ada, Ada (2), Adam Smith"],
		["admit Ada", "Ada: cannot admit: a trainee, here"],
		["calibrate Adam Smith", "Adam Smith: cannot calibrate: a observer, here"],
		["calibrate Bob", "Bob: cannot calibrate: a trainee, lost"],
		["calibrate Ada dance", "'dance' is no calibration: t_pose"],
		["dance", "'dance' is no command: who, admit"],
		["level", "which level?"],
		["time", "which time? hours from 0 to 24"],
		["time 25", "which time?"],
		["weather snow", "which weather? clear, haze, dust, rain"],
	]:
		_said.clear()
		_console.submit(row[0])
		_control.roster_changed.emit()
		equal(_said.size(), 1, row[0])
		contains(_said[0] if not _said.is_empty() else "", row[1])
	_console.submit("")
	is_true(_control.asked.all(func(order: Array) -> bool: return order == ["who"]))


func test_who_has_just_come_is_found_in_a_newer_list() -> void:
	_console.submit("kick Carl bye")
	equal(_said.size(), 0)
	_control.roster.append(_row("Carl", TRAINEE, 12))
	_control.roster_changed.emit()
	equal(_control.asked, [["who"], ["kick", 12, "bye"]] as Array[Array])


func test_an_order_without_an_answer_is_mentioned_after_a_second() -> void:
	_console.advance(10.0)
	_console.submit("kick Ada")
	_console.submit("kick Bob")
	_answer(1, "Ada: kicked")
	_console.advance(10.9)
	equal(_said, ["Ada: kicked"] as Array[String])
	_console.advance(11.1)
	equal(_said.slice(1), ["Bob: the server has not answered yet"] as Array[String])
	_console.advance(13.0)
	_answer(2, "Bob: kicked")
	equal(_said.slice(2), ["Bob: kicked"] as Array[String])


func test_a_table_that_comes_late_is_shown() -> void:
	_console.advance(10.0)
	_console.submit("who")
	_console.advance(11.1)
	_console.advance(12.0)
	equal(_said, ["who: the server has not answered yet"] as Array[String], "once")
	_control.roster_changed.emit()
	is_true(_said.size() > 1 and _said[1].begins_with("name"), str(_said))
	_console.submit("who")
	_console.submit("quit")
	_console.advance(13.5)
	equal(_quits, 0, "the answer may still come")
	_console.advance(22.5)
	equal(_quits, 1)
	_said.clear()
	_control.roster_changed.emit()
	equal(_said.size(), 0, "nobody waits for it any more")


func test_who_is_a_table_and_other_rosters_are_silent() -> void:
	_control.roster_changed.emit()
	equal(_said.size(), 0)
	_control.roster[0].delay_ms = 18.2
	_control.roster[0].tracking_deg = 0.81
	_control.roster[0].people = 1
	_control.roster[0].suit = "17 trackers on USB, calibrated"
	_console.submit("who")
	_control.roster_changed.emit()
	equal(_said.size(), 8)
	for word: String in ["Ada", "trainee", "here", "18 ms", "0.8°", "17 trackers on USB"]:
		contains(_said[1], word)
	_control.roster_changed.emit()
	equal(_said.size(), 8)


func test_completion() -> void:
	for row: Array in [
		["ki", ["kick "]],
		["k", ["kick "]],
		["wh", ["who"]],
		["kick ad", ["kick Ada", "kick Ada (2)", "kick Adam Smith"]],
		["kick Adam", ["kick Adam Smith"]],
		["admit ", ["admit Eve", "admit Zoë"]],
		["calibrate Ada f", ["calibrate Ada full"]],
		["level hal", ["level hall"]],
		["nonsense A", []],
		["who A", []],
	]:
		equal(Array(_console.completions(row[0])), row[1], row[0])


func test_help_and_quit() -> void:
	_console.submit("help")
	equal(_said.size(), InstructorConsole.COMMANDS.size())
	_console.submit("kick Ada")
	_console.submit("quit")
	_console.advance(0.5)
	equal(_quits, 0, "an answer is to come")
	_answer(1, "Ada: kicked")
	_console.advance(0.6)
	equal(_quits, 1)


func _answer(p_number: int, p_text: String) -> void:
	_control.answered.emit(
		AnswerMessage.decode(AnswerMessage.encode(p_number, AnswerMessage.Outcome.DONE, p_text))
	)


func _row(
	p_name: String,
	p_role: Roles.Role,
	p_session: int,
	p_state: RosterRow.State = RosterRow.State.HERE,
	p_peer: int = 9
) -> RosterRow:
	var row: RosterRow = RosterRow.new()
	row.name = p_name
	row.role = p_role
	row.session = p_session
	row.peer = p_peer
	row.state = p_state
	return row


func test_an_effect_is_read_before_it_is_sent() -> void:
	_console.submit("effect fountain")
	var text: String = FileAccess.get_file_as_string(EffectFile.path_of("fountain"))
	equal(_control.asked, [["effect", "fountain", text.length()]])
	_console.submit("effect /no/such/smoke.gdshader")
	contains(_said[-1], "cannot be read")
	_console.submit("effect ../Bad")
	contains(_said[-1], "which effect?")
	equal(_control.asked.size(), 1)
