class_name BenchReport
extends RefCounted
## Stats of a benchmark: a table for people, or a JSON object a line for programs.
##
## Keys of an object: bench, case, metric, value, unit, goal (null if there is none), holds (null
## likewise). What could not be measured is an object with bench, case and error.

## How a goal is meant.
enum Goal {
	## There is none.
	NONE,
	## The value shall not be above it.
	AT_MOST,
	## The value shall not be below it.
	AT_LEAST,
	## Its magnitude shall not be above it, whatever its sign.
	WITHIN,
}

## What a program exits with where a goal is missed: ./run bench knows it.
const GOALS_MISSED: int = 5
## And where something could not be measured, whether or not goals are missed besides.
const LEFT_OUT: int = 6

var _bench: String = ""
var _json: bool = false
var _missed: int = 0
var _left_out: Dictionary[String, String] = {}
var _rows: Array[PackedStringArray] = []


func _init(p_bench: String, p_json: bool) -> void:
	_bench = p_bench
	_json = p_json
	_rows.append(PackedStringArray(["case", "metric", "value", "unit", "goal", "holds"]))


## Adds a figure.
func add(
	p_case: String,
	p_metric: String,
	p_value: float,
	p_unit: String,
	p_kind: Goal = Goal.NONE,
	p_goal: float = 0.0
) -> void:
	var goal: Variant = null
	var holds: Variant = null
	if p_kind != Goal.NONE:
		goal = p_goal
		holds = _holds(p_kind, p_value, p_goal)
		_missed += 0 if holds else 1
	if _json:
		var row: Dictionary = {
			"bench": _bench,
			"case": p_case,
			"metric": p_metric,
			"value": p_value,
			"unit": p_unit,
			"goal": goal,
			"holds": holds,
		}
		print(JSON.stringify(row, "", false))
		return
	var signs: PackedStringArray = ["", "<= ", ">= ", "+- "]
	var goal_text: String = "" if goal == null else signs[p_kind] + String.num(p_goal, 3)
	var holds_text: String = "" if holds == null else ("yes" if holds else "NO")
	var value: String = String.num(p_value, 3)
	_rows.append(PackedStringArray([p_case, p_metric, value, p_unit, goal_text, holds_text]))


## Adds a value that shall not be above a goal, where there is one.
func at_most(
	p_case: String,
	p_metric: String,
	p_value: float,
	p_unit: String,
	p_goal: float,
	p_is_goal: bool = true
) -> void:
	add(p_case, p_metric, p_value, p_unit, Goal.AT_MOST if p_is_goal else Goal.NONE, p_goal)


## Adds a value that shall not be below a goal, where there is one.
func at_least(
	p_case: String,
	p_metric: String,
	p_value: float,
	p_unit: String,
	p_goal: float,
	p_is_goal: bool = true
) -> void:
	add(p_case, p_metric, p_value, p_unit, Goal.AT_LEAST if p_is_goal else Goal.NONE, p_goal)


## Adds a value whose magnitude shall not be above a goal.
func within(
	p_case: String, p_metric: String, p_value: float, p_unit: String, p_goal: float
) -> void:
	add(p_case, p_metric, p_value, p_unit, Goal.WITHIN, p_goal)


## Notes, once for each, what could not be measured (a file) and why. The others still are.
func leave_out(p_case: String, p_why: String) -> void:
	if _left_out.has(p_case):
		return
	_left_out[p_case] = p_why
	if _json:
		print(JSON.stringify({"bench": _bench, "case": p_case, "error": p_why}, "", false))


## Opens a motion file; null where it is none, which is noted.
func open_clip(p_file: String) -> BvhSource:
	var source: BvhSource = BvhSource.new()
	source.open(p_file)
	if source.error != "":
		leave_out(p_file, source.error)
		return null
	return source


## Prints the table, if it is not JSON that is wanted, and what was left out. Returns the exit code
## of the program.
func finish() -> int:
	if not _json:
		_print_table()
	for name: String in _left_out:
		printerr("not measured: %s: %s" % [name, _left_out[name].trim_prefix(name + ": ")])
	if not _left_out.is_empty():
		return LEFT_OUT
	return GOALS_MISSED if _missed > 0 else 0


static func _holds(p_kind: Goal, p_value: float, p_goal: float) -> bool:
	# Written so that NaN never holds.
	match p_kind:
		Goal.AT_MOST:
			return p_value <= p_goal
		Goal.AT_LEAST:
			return p_value >= p_goal
	return absf(p_value) <= p_goal


func _print_table() -> void:
	var widths: PackedInt32Array = [0, 0, 0, 0, 0, 0]
	for row: PackedStringArray in _rows:
		for column: int in row.size():
			widths[column] = maxi(widths[column], row[column].length())
	for row: PackedStringArray in _rows:
		var line: String = ""
		for column: int in row.size():
			line += row[column].rpad(widths[column] + 2)
		print(line.strip_edges(false, true))
