class_name BenchArguments
extends RefCounted
## Options of a benchmark: [code]--name=value[/code] or [code]--name value[/code], and
## [code]--json[/code]. An option whose default is a bool needs no value.

## What is wrong, or an empty text.
var error: String = ""

var _values: Dictionary[String, Variant] = {}
var _limits: Dictionary[String, Array] = {}
var _given: PackedStringArray = PackedStringArray()
var _lists: Dictionary[String, PackedStringArray] = {}


## Reads arguments; only the names in the defaults are known, whose types the values take. A default
## may be an array: behind the default come the least and the greatest number, or a list of words.
static func parse(p_arguments: PackedStringArray, p_defaults: Dictionary) -> BenchArguments:
	var result: BenchArguments = BenchArguments.new()
	for name: String in p_defaults:
		var row: Array = p_defaults[name] if p_defaults[name] is Array else [p_defaults[name]]
		result._values[name] = row[0]
		result._limits[name] = row.slice(1)
	result._values["json"] = false
	var at: int = 0
	while at < p_arguments.size() and result.error == "":
		var name: String = p_arguments[at].trim_prefix("--").get_slice("=", 0)
		var value: String = p_arguments[at].substr(p_arguments[at].find("=") + 1)
		if not p_arguments[at].contains("="):
			value = ""
			if not result._values.get(name) is bool and at + 1 < p_arguments.size():
				at += 1
				value = p_arguments[at]
		result._take(name, value)
		at += 1
	return result


## The value of an option.
func value(p_name: String) -> Variant:
	return _values[p_name]


## Whether an option was given.
func is_given(p_name: String) -> bool:
	return _given.has(p_name)


## All values of an option that was given more than once, in order; empty if it was not given.
func list(p_name: String) -> PackedStringArray:
	return _lists.get(p_name, PackedStringArray())


## The motion files that --bvh names, or those of the repository.
static func clips(p_arguments: BenchArguments) -> PackedStringArray:
	var files: PackedStringArray = p_arguments.list("bvh")
	if files.is_empty():
		for file: String in DirAccess.get_files_at("res://assets/motion"):
			if file.ends_with(".bvh"):
				files.append("res://assets/motion/" + file)
	return files


func _take(p_name: String, p_value: String) -> void:
	if not _values.has(p_name):
		error = "there is no option --%s; known: --%s" % [p_name, ", --".join(_values.keys())]
		return
	_given.append(p_name)
	if _values[p_name] is bool:
		_values[p_name] = p_value != "false"
	elif _values[p_name] is String:
		_values[p_name] = p_value
		_lists.get_or_add(p_name, PackedStringArray()).append(p_value)
	elif not p_value.is_valid_float():
		error = "--%s expects a number, found '%s'" % [p_name, p_value]
	else:
		_values[p_name] = p_value.to_int() if _values[p_name] is int else p_value.to_float()
	_check(p_name, p_value)


func _check(p_name: String, p_value: String) -> void:
	var limits: Array = _limits.get(p_name, [])
	if error != "" or limits.is_empty():
		return
	if limits.size() == 1:
		var words: PackedStringArray = PackedStringArray(Array(limits[0]))
		if not words.has(p_value):
			error = "--%s is one of %s; found '%s'" % [p_name, ", ".join(words), p_value]
	elif not p_value.is_valid_float():
		error = "--%s expects a number, found '%s'" % [p_name, p_value]
	elif not (p_value.to_float() >= limits[0] and p_value.to_float() <= limits[1]):
		error = "--%s is between %s and %s, found '%s'" % [p_name, limits[0], limits[1], p_value]
