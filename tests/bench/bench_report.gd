class_name BenchReport
extends RefCounted
## Stats of a benchmark: a table for people, or a JSON object a line for programs.
##
## Keys of an object: bench, case, metric, value, unit, goal (null if there is none), holds (null
## likewise).

## How a goal is meant.
enum Goal {
	## There is none.
	NONE,
	## The value shall not be above it.
	AT_MOST,
	## The value shall not be below it.
	AT_LEAST,
}

## What a program exits with where a goal is missed: ./run bench knows it.
const GOALS_MISSED: int = 5

var _bench: String = ""
var _json: bool = false
var _missed: int = 0
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
		holds = p_value <= p_goal if p_kind == Goal.AT_MOST else p_value >= p_goal
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
	var sign: String = "<= " if p_kind == Goal.AT_MOST else ">= "
	var goal_text: String = "" if goal == null else sign + String.num(p_goal, 3)
	var holds_text: String = "" if holds == null else ("yes" if holds else "NO")
	var value: String = String.num(p_value, 3)
	_rows.append(PackedStringArray([p_case, p_metric, value, p_unit, goal_text, holds_text]))


## Prints the table, if it is not JSON that is wanted. Returns the exit code of the program.
func finish() -> int:
	if not _json:
		_print_table()
	return GOALS_MISSED if _missed > 0 else 0


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
