class_name Options
extends RefCounted
## What the user asked for: arguments after [code]--[/code], or environment variables of the same
## meaning ([code]--max-clients=8[/code] is [code]DISMOUNT_MAX_CLIENTS=8[/code]). Arguments win.
##
## Which options there are is the program's business: it hands in a table with a row for each, its
## name, default (whose type it has) and what it means.

## What is wrong with the arguments, or an empty text.
var error: String = ""

var _values: Dictionary[String, Variant] = {}


## Reads arguments such as [code]--port=7777[/code] and the environment.
## [param p_bare] has what options mean that are given without a value.
static func parse(
	p_table: Array[Array], p_bare: Dictionary[String, String], p_arguments: PackedStringArray
) -> Options:
	var options: Options = Options.new()
	for row: Array in p_table:
		options._values[row[0]] = row[1]
	for row: Array in p_table:
		var variable: String = "DISMOUNT_" + (row[0] as String).to_upper().replace("-", "_")
		if OS.get_environment(variable) != "":
			options._set_option(row[0], OS.get_environment(variable), variable)
	for argument: String in p_arguments:
		var parts: PackedStringArray = argument.trim_prefix("--").split("=", true, 1)
		if parts.size() == 1 and p_bare.has(parts[0]):
			parts.append(p_bare[parts[0]])
		if not argument.begins_with("--") or parts.size() != 2:
			options.refuse("'%s' is not of the form --name=value" % argument)
		else:
			options._set_option(parts[0], parts[1], "--" + parts[0])
	return options


## The options, a line each, for people.
static func describe(p_table: Array[Array]) -> String:
	var lines: PackedStringArray = []
	for row: Array in p_table:
		var shown: String = "--%s=%s" % [row[0], row[1]]
		lines.append("  %-28s %s" % [shown, row[2]])
	return "\n".join(lines)


## The value of a text option.
func text(p_name: String) -> String:
	return _values[p_name]


## The value of an option that names a file, as a full path: a relative one counts from where the
## program was started, not from where it lies. Empty if there is none.
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
	if p_path == "" or not p_path.is_relative_path() or p_path.contains("://"):
		return p_path
	return OS.get_environment("PWD").path_join(p_path)


## The value of a whole-number option.
func number(p_name: String) -> int:
	return _values[p_name]


## The value of an option in degrees.
func degrees(p_name: String) -> float:
	return _values[p_name]


## The value of an option in seconds.
func seconds(p_name: String) -> float:
	return _values[p_name]


## Refuses the arguments if a whole number is not within these limits; [param p_what] names it.
func check_range(p_name: String, p_what: String, p_min: int, p_max: int) -> void:
	var value: int = number(p_name)
	if value < p_min or value > p_max:
		var limits: String = "between %d and %d" % [p_min, p_max]
		if p_min == 0:
			limits = "at most %d" % p_max
		refuse("%s is %s, found %d" % [p_what, limits, value])


## Refuses the arguments if a text is none of these.
func check_choice(p_name: String, p_known: Array) -> void:
	if not text(p_name) in p_known:
		var known: String = ", ".join(p_known.filter(func(name: String) -> bool: return name != ""))
		refuse("--%s is one of %s, found '%s'" % [p_name, known, text(p_name)])


## Refuses the arguments; only the first reason is kept.
func refuse(p_why: String) -> void:
	if error == "":
		error = p_why


func _set_option(p_name: String, p_value: String, p_source: String) -> void:
	if not _values.has(p_name):
		refuse("there is no option --%s" % p_name)
	elif _values[p_name] is int:
		# Longer ones do not fit a number, and the engine reports an error of its own.
		if p_value.is_valid_int() and p_value.length() < 10 and p_value.to_int() >= 0:
			_values[p_name] = p_value.to_int()
		else:
			refuse("%s expects a whole number, found '%s'" % [p_source, p_value])
	elif _values[p_name] is float:
		var seconds_asked: float = p_value.to_float() if p_value.is_valid_float() else -1.0
		if seconds_asked >= 0.0 and is_finite(seconds_asked):
			_values[p_name] = seconds_asked
		else:
			refuse("%s expects %s, found '%s'" % [p_source, _unit_of(p_name), p_value])
	else:
		_values[p_name] = p_value


static func _unit_of(p_name: String) -> String:
	return "degrees" if p_name == "pose-error" else "seconds"
