class_name Options
extends RefCounted
## The user's options: arguments after [code]--[/code], environment variables of the same meaning
## ([code]--max-clients=8[/code] is [code]DISMOUNT_MAX_CLIENTS=8[/code]), or lines of the file that
## [code]--config[/code] names ([OptionsFile]). Arguments win over the environment, and that over
## the file.
##
## The program defines the options: it passes an [OptionRow] for each.

## Name of the option that names the file of options; rows need not have it.
const CONFIG: String = "config"

## What is wrong with the arguments, or an empty text.
var error: String = ""
## The role that they are for, or an empty text: then options of all roles are accepted.
var role: String = ""

var _arguments: PackedStringArray = []
var _values: Dictionary[String, Variant] = {}
var _rows: Dictionary[String, OptionRow] = {}


## Reads arguments such as [code]--port=7777[/code] or [code]--port 7777[/code], and the
## environment.
##
## An argument that [param p_role] does not take is refused; in the environment, which several
## programs share, it is ignored.
static func parse(
	p_rows: Array[OptionRow], p_arguments: PackedStringArray, p_role: String = ""
) -> Options:
	var options: Options = Options.new()
	options.role = p_role
	options._arguments = p_arguments
	for row: OptionRow in p_rows:
		options._rows[row.name] = row
		options._values[row.name] = row.default_value
	options._read_file()
	for row: OptionRow in p_rows:
		var value: String = OS.get_environment(row.variable())
		if value != "" and options._takes(row):
			options._set_option(row, value, row.variable())
	options._read(p_arguments)
	return options


## The same arguments, with the environment and the file as they are now.
func reread() -> Options:
	return parse(_rows.values(), _arguments, role)


## Names of the options whose values differ from those of others of the same rows.
func find_changes(p_other: Options) -> PackedStringArray:
	var names: PackedStringArray = []
	for name: String in _values:
		if _values[name] != p_other._values[name]:
			names.append(name)
	return names


## The value of an option, for people.
func describe(p_name: String) -> String:
	return str(_values[p_name])


## The value of a text option.
func text(p_name: String) -> String:
	return _values[p_name]


## The value of an option that names a file, as a full path: a relative one counts from where the
## program was started, not from the program's folder. Empty if there is none.
func file(p_name: String) -> String:
	return full_path(_values[p_name])


## The values of an option that names files with commas between; a file whose own name has commas is
## one file.
func files(p_name: String) -> PackedStringArray:
	var paths: PackedStringArray = []
	if FileAccess.file_exists(file(p_name)):
		return [file(p_name)]
	for part: String in text(p_name).split(",", false):
		paths.append(full_path(part))
	return paths


## A path as a full one, see [method file].
static func full_path(p_path: String) -> String:
	if p_path.begins_with("~/"):
		return OS.get_environment("HOME").path_join(p_path.trim_prefix("~/"))
	if p_path == "" or not p_path.is_relative_path() or p_path.contains("://"):
		return p_path
	return OS.get_environment("PWD").path_join(p_path)


## The value of a whole-number option.
func number(p_name: String) -> int:
	return _values[p_name]


## The value of an option that has no unit, such as a share.
func decimal(p_name: String) -> float:
	return _values[p_name]


## Whether an option is switched on.
func is_on(p_name: String) -> bool:
	return number(p_name) != 0


## The value of an option in degrees.
func degrees(p_name: String) -> float:
	return _values[p_name]


## The value of an option in metres.
func metres(p_name: String) -> float:
	return _values[p_name]


## The value of an option in seconds.
func seconds(p_name: String) -> float:
	return _values[p_name]


## Refuses the arguments; only the first reason is kept.
func refuse(p_why: String) -> void:
	if error == "" and p_why != "":
		error = p_why


func _takes(p_row: OptionRow) -> bool:
	return role == "" or p_row.roles.has(role)


## Reads the file that the arguments name, else the environment.
func _read_file() -> void:
	if not _rows.has(CONFIG):
		return
	var path: String = OS.get_environment(_rows[CONFIG].variable())
	for i: int in _arguments.size():
		if _arguments[i].begins_with("--config="):
			path = _arguments[i].trim_prefix("--config=")
		elif _arguments[i] == "--config" and i + 1 < _arguments.size():
			path = _arguments[i + 1]
	if path == "":
		return
	var file: OptionsFile = OptionsFile.read(full_path(path), _rows, role)
	if not file.faults.is_empty():
		refuse(file.describe_faults())
	for name: String in file.values:
		_set_option(_rows[name], file.values[name], name)


## The nearest option that the role takes.
func _suggest(p_name: String) -> String:
	var names: PackedStringArray = []
	for row: OptionRow in _rows.values():
		if _takes(row):
			names.append(row.name)
	return Nearest.suggest(p_name, names, "--")


func _read(p_arguments: PackedStringArray) -> void:
	# Of options that may be given again: those that were.
	var given: Dictionary[String, bool] = {}
	var i: int = 0
	while i < p_arguments.size():
		var argument: String = p_arguments[i]
		i += 1
		if not argument.begins_with("--"):
			refuse("'%s' is no option: write --name=value" % argument)
			continue
		var parts: PackedStringArray = argument.trim_prefix("--").split("=", true, 1)
		var row: OptionRow = _rows.get(parts[0])
		if row == null:
			refuse("there is no option --%s%s" % [parts[0], _suggest(parts[0])])
			continue
		var is_next_mine: bool = parts.size() == 1 and row.kind != OptionRow.Kind.FLAG
		if is_next_mine and i < p_arguments.size() and not p_arguments[i].begins_with("--"):
			parts.append(p_arguments[i])
			i += 1
		elif parts.size() == 1 and row.bare != "":
			parts.append(row.bare)
		if parts.size() == 1:
			refuse("--%s expects a value: %s" % [row.name, row.usage()])
		elif not _takes(row):
			refuse("--%s is for %s, not for %s" % [row.name, ", ".join(row.roles), role])
		else:
			var before: String = str(_values[row.name]) + "," if given.has(row.name) else ""
			if row.is_repeatable:
				given[row.name] = true
			_set_option(row, before + parts[1], "--" + row.name)


func _set_option(p_row: OptionRow, p_value: String, p_source: String) -> void:
	var fault: String = p_row.find_fault(p_value)
	if fault == "":
		_values[p_row.name] = p_row.parse(p_value)
	else:
		refuse("%s %s" % [p_source, fault])
