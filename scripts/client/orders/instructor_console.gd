class_name InstructorConsole
extends RefCounted
## What an instructor types: commands such as [code]kick Bob too loud[/code], by name, each answered
## by name and outcome. Commands and names may be shortened as long as they are clear.

## A line for the instructor.
signal said(p_line: String)
## The instructor wants to leave.
signal quit_wanted

## Seconds after which an order without an answer is mentioned.
const PATIENCE_S: float = 1.0
## Seconds after which an answer is no longer expected; a later one is shown nevertheless.
const GIVE_UP_S: float = 10.0
## Calibration unless another is named.
const USUAL_CALIBRATION: String = "t_to_n"

## Commands: what follows them, and what they do.
const COMMANDS: Dictionary[String, Array] = {
	"who": ["", "who is here: role, state, delay, tracking and suit"],
	"admit": ["NAME|*", "let somebody in who waits"],
	"refuse": ["NAME|* [WHY]", "send somebody away who waits"],
	"kick": ["NAME [WHY]", "dismiss somebody"],
	"ban": ["NAME [WHY]", "dismiss somebody and ban the address"],
	"calibrate":
	["NAME|* [KIND]", "have a trainee calibrated: t_pose, n_pose, t_to_n, full, quick"],
	"level": ["NAME", "load another level"],
	"time": ["HOURS", "set the time of day: 18.5, 18:30, dawn, noon, dusk, night"],
	"weather": ["KIND [STRENGTH]", "set the weather: clear, haze, dust, rain; 0 to 1"],
	"effect": ["FILE", "show the effect of a .gdshader file at all clients"],
	"upright": ["THING|*", "put a vehicle on its wheels or tracks again"],
	"repair": ["THING|*", "make a vehicle whole again"],
	"help": ["", "these commands"],
	"quit": ["", "leave the session"],
}
## Commands about somebody who waits.
const _ABOUT_WAITING: PackedStringArray = ["admit", "refuse"]

var _control: InstructorControl = null
var _things: ThingOrders = null
## Orders without an answer, by number: their target, their time, s, whether they ask for the list
## of who is here, and whether their delay was mentioned.
var _open: Dictionary[int, Array] = {}
var _wants_table: bool = false
var _wants_quit: bool = false
## An order for a name that was not in the list: it fails only if the newest list does not have it
## either.
var _retried: PackedStringArray = []
var _now_s: float = 0.0


func _init(p_control: InstructorControl, p_things: ThingOrders = null) -> void:
	_control = p_control
	_things = p_things if p_things != null else ThingOrders.new(null, null)
	_control.answered.connect(_on_answered)
	_control.roster_changed.connect(_on_roster_changed)


## Goes on, at a time, s.
func advance(p_now_s: float) -> void:
	_now_s = p_now_s
	for number: int in _open.keys():
		var age_s: float = p_now_s - _open[number][1]
		if age_s > PATIENCE_S and not _open[number][3]:
			_open[number][3] = true
			said.emit("%s: the server has not answered yet" % _open[number][0])
		if age_s > GIVE_UP_S:
			_open.erase(number)
			_wants_table = false
			_retried.clear()
	if _wants_quit and _open.is_empty():
		_wants_quit = false
		quit_wanted.emit()


## Carries out a line.
func submit(p_line: String) -> void:
	var words: PackedStringArray = p_line.strip_edges().split(" ", false, 1)
	if words.is_empty():
		return
	var found: PackedStringArray = _begin_with(COMMANDS.keys(), words[0].to_lower())
	if found.size() != 1:
		var known: String = ", ".join(found)
		if found.is_empty():
			known = ", ".join(COMMANDS.keys())
		said.emit("'%s' is no command: %s" % [words[0], known])
		return
	var rest: String = words[1].strip_edges() if words.size() > 1 else ""
	match found[0]:
		"help":
			for command: String in COMMANDS:
				var usage: String = "%s %s" % [command, _usage(command)]
				said.emit("  %-24s%s" % [usage, COMMANDS[command][1]])
		"quit":
			# Not before what was ordered is answered.
			_wants_quit = true
		"who":
			_wants_table = true
			_note("who", _control.ask_who(), true)
		"level":
			_change_level(rest)
		"effect":
			_send_effect(rest)
		"upright", "repair":
			said.emit(_things.give(found[0], rest))
		"time", "weather":
			_change_conditions(found[0], rest)
		_:
			_order(found[0], rest)


## What a line that is being typed could become, for the Tab key: whole lines.
func completions(p_line: String) -> PackedStringArray:
	var space: int = p_line.find(" ")
	if space < 0:
		var commands: PackedStringArray = _begin_with(COMMANDS.keys(), p_line.to_lower())
		for i: int in commands.size():
			commands[i] += " " if _usage(commands[i]) != "" else ""
		return commands
	var command: PackedStringArray = _begin_with(COMMANDS.keys(), p_line.left(space).to_lower())
	if command.size() != 1:
		return []
	var begun: String = p_line.substr(space + 1)
	var names: PackedStringArray = []
	if command[0] == "level":
		names = LevelStore.names()
	elif command[0] == "time":
		names = PackedStringArray(WorldConditions.TIMES.keys())
	elif command[0] == "weather":
		names = WorldConditions.WEATHERS
	elif ThingOrders.COMMANDS.has(command[0]):
		names = _things.names(command[0])
	elif _usage(command[0]) != "":
		for row: RosterRow in _candidates(command[0]):
			names.append(row.name)
	var whole: PackedStringArray = []
	for name: String in _begin_with(names, begun.to_lower()):
		whole.append(p_line.left(space + 1) + name)
	if command[0] == "calibrate" and whole.is_empty() and begun.contains(" "):
		var cut: int = p_line.rfind(" ") + 1
		var kinds: Array = ClientCalibration.orders().keys()
		for kind: String in _begin_with(kinds, p_line.substr(cut).to_lower()):
			whole.append(p_line.left(cut) + kind)
	return whole


## The lines of a table of who is here.
static func table(p_roster: Array[RosterRow]) -> PackedStringArray:
	var lines: PackedStringArray = []
	var form: String = "%-22s %-10s %-8s %6s %9s %9s  %s"
	lines.append(form % ["name", "role", "state", "people", "delay", "tracking", "suit"])
	for row: RosterRow in p_roster:
		var delay: String = "%.0f ms" % row.delay_ms if row.delay_ms >= 0.0 else "-"
		var tracking: String = "%.1f°" % row.tracking_deg if row.tracking_deg >= 0.0 else "-"
		var people: String = str(row.people) if row.people > 0 else "-"
		var role: String = Roles.name_of(row.role)
		var cells: Array = [row.name, role, row.state_name(), people, delay, tracking, row.suit]
		lines.append((form % cells).strip_edges(false, true))
	return lines


func _change_level(p_name: String) -> void:
	if p_name == "":
		said.emit("which level? %s" % ", ".join(LevelStore.names()))
		return
	_note("level '%s'" % p_name, _control.change_level(p_name))


## A file of the user's folder, or the name of a shipped effect.
func _send_effect(p_file: String) -> void:
	var path: String = Options.full_path(p_file)
	if EffectLimits.is_name(p_file):
		path = EffectFile.path_of(p_file)
	var name: String = path.get_file().get_basename()
	var file: EffectFile = EffectFile.open(path)
	if not EffectLimits.is_name(name):
		said.emit("which effect? effect smoke.gdshader, with small letters, digits and _")
	elif not file.problems.is_empty():
		said.emit("%s: %s" % [path.get_file(), file.first_problem()])
	else:
		_note("effect '%s'" % name, _control.send_effect(name, file.text))


func _change_conditions(p_what: String, p_rest: String) -> void:
	var values: Dictionary[StringName, float] = WorldConditions.parse(p_what, p_rest)
	if values.is_empty():
		said.emit("which %s? %s" % [p_what, WorldConditions.describe(p_what)])
		return
	_note("%s %s" % [p_what, p_rest], _control.set_fields(values))


func _order(p_command: String, p_rest: String) -> void:
	if p_rest == "":
		said.emit("%s whom? %s %s" % [p_command, p_command, _usage(p_command)])
		return
	var rows: Array[RosterRow] = _candidates(p_command)
	var argument: String = p_rest
	if p_rest == "*" or p_rest.begins_with("* "):
		argument = p_rest.substr(1).strip_edges()
		if not _usage(p_command).contains("*"):
			said.emit("%s takes one name" % p_command)
			return
		if rows.is_empty():
			said.emit("there is nobody to %s" % p_command)
	else:
		var named: RosterRow = _find(rows, p_rest)
		if named == null:
			_miss(p_command, rows, p_rest)
			return
		argument = _behind_name(named.name, p_rest)
		rows = [named]
	for row: RosterRow in rows:
		_give(p_command, row, argument)


func _give(p_command: String, p_row: RosterRow, p_argument: String) -> void:
	match p_command:
		"admit":
			_note(p_row.name, _control.admit(p_row.peer))
		"refuse":
			_note(p_row.name, _control.refuse(p_row.peer, p_argument))
		"kick":
			_note(p_row.name, _control.kick(p_row.session, p_argument))
		"ban":
			_note(p_row.name, _control.ban(p_row.session, p_argument))
		"calibrate":
			var kind: String = p_argument if p_argument != "" else USUAL_CALIBRATION
			var orders: Dictionary[String, int] = ClientCalibration.orders()
			if not orders.has(kind):
				said.emit("'%s' is no calibration: %s" % [kind, ", ".join(orders.keys())])
				return
			_note(p_row.name, _control.calibrate(p_row.session, 0, orders[kind]))


func _note(p_about: String, p_number: int, p_is_list: bool = false) -> void:
	if p_number == 0:
		said.emit("%s: there is no connection to the server" % p_about)
	else:
		_open[p_number] = [p_about, _now_s, p_is_list, false]


## The rows that a command can be about.
func _candidates(p_command: String) -> Array[RosterRow]:
	var found: Array[RosterRow] = []
	for row: RosterRow in _control.roster:
		var fits: bool = (row.session == 0) == _ABOUT_WAITING.has(p_command)
		if p_command == "admit":
			fits = row.state == RosterRow.State.WAITING
		if p_command == "calibrate":
			fits = row.can(Roles.Capability.SEND_MOTION)
		if fits:
			found.append(row)
	return found


## The row whose name a text begins with, whole or shortened; null if there is none or several.
func _find(p_rows: Array[RosterRow], p_text: String) -> RosterRow:
	var whole: RosterRow = null
	var lower: String = p_text.to_lower() + " "
	for row: RosterRow in p_rows:
		if lower.begins_with(row.name.to_lower() + " "):
			if whole == null or row.name.length() > whole.name.length():
				whole = row
	if whole != null:
		return whole
	var begun: Array[RosterRow] = _named_like(p_rows, p_text)
	return begun[0] if begun.size() == 1 else null


func _named_like(p_rows: Array[RosterRow], p_text: String) -> Array[RosterRow]:
	var word: String = p_text.to_lower().get_slice(" ", 0)
	return p_rows.filter(func(row: RosterRow) -> bool: return row.name.to_lower().begins_with(word))


## A client that has just come may not be in the list yet.
func _miss(p_command: String, p_rows: Array[RosterRow], p_rest: String) -> void:
	var number: int = _control.ask_who() if _retried.is_empty() else 0
	if number == 0:
		_retried.clear()
		_say_unknown(p_command, p_rows, p_rest)
		return
	_retried = [p_command, p_rest]
	_note(p_rest, number, true)


func _say_unknown(p_command: String, p_rows: Array[RosterRow], p_text: String) -> void:
	var word: String = p_text.get_slice(" ", 0)
	var several: PackedStringArray = []
	for row: RosterRow in _named_like(p_rows, p_text):
		several.append(row.name)
	if not several.is_empty():
		said.emit("'%s' could be %s" % [word, ", ".join(several)])
		return
	var other: RosterRow = _find(_control.roster, p_text)
	if other == null:
		said.emit("nobody is called %s" % p_text)
	else:
		var what: Array = [other.name, p_command, Roles.name_of(other.role), other.state_name()]
		said.emit("%s: cannot %s: a %s, %s" % what)


## What follows a name, whole or shortened, in a text.
static func _behind_name(p_name: String, p_text: String) -> String:
	var is_whole: bool = (p_text.to_lower() + " ").begins_with(p_name.to_lower() + " ")
	if is_whole:
		return p_text.substr(p_name.length()).strip_edges()
	return p_text.substr(p_text.get_slice(" ", 0).length()).strip_edges()


func _on_answered(p_answer: AnswerMessage) -> void:
	_open.erase(p_answer.number)
	said.emit(p_answer.text)


func _on_roster_changed() -> void:
	for number: int in _open.keys():
		if _open[number][2]:
			_open.erase(number)
	if not _retried.is_empty():
		_order(_retried[0], _retried[1])
		_retried.clear()
	if not _wants_table:
		return
	_wants_table = false
	for line: String in table(_control.roster):
		said.emit(line)


## What follows a command.
static func _usage(p_command: String) -> String:
	return COMMANDS[p_command][0]


static func _begin_with(p_words: PackedStringArray, p_begun: String) -> PackedStringArray:
	var found: PackedStringArray = []
	for word: String in p_words:
		if word.to_lower() == p_begun:
			return [word]
		if word.to_lower().begins_with(p_begun):
			found.append(word)
	return found
