class_name ProgramOptions
extends RefCounted
## Every option of the program, from the files that [ProgramParts] lists. Checks,
## [code]--help[/code] and docs/options.md are made from these rows.

static var _rows: Array[OptionRow] = []


## Reads arguments such as [code]--port=7777[/code] and the environment, for a role, or for any.
static func parse(p_arguments: PackedStringArray, p_role: String = "") -> Options:
	return Options.parse(rows(), p_arguments, p_role)


## All options, grouped by topic.
static func rows() -> Array[OptionRow]:
	if _rows.is_empty():
		for path: String in ProgramParts.OPTIONS:
			_rows.append_array((load(path) as GDScript).call("rows"))
	return _rows
