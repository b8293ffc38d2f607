@tool
class_name EffectHeader
extends RefCounted
## Reads the [code]// @key value[/code] lines of an effect's file into [EffectSettings].

const MARK: String = "// @"

var problems: Array[EffectProblem] = []

var _settings: EffectSettings = null
## On which line each setting stands.
var _lines: Dictionary[String, int] = {}


func _init(p_settings: EffectSettings) -> void:
	_settings = p_settings


func read(p_text: String) -> void:
	var lines: PackedStringArray = p_text.split("\n")
	for i: int in lines.size():
		if problems.size() >= EffectLimits.MAX_PROBLEMS:
			break
		var line: String = lines[i].strip_edges()
		if line.begins_with(MARK):
			_read_line(i + 1, line.substr(MARK.length()))
	_check_distances()


func _problem(p_line: int, p_text: String) -> void:
	problems.append(EffectProblem.new(p_line, p_text))


func _read_line(p_number: int, p_line: String) -> void:
	var words: PackedStringArray = p_line.replace("\t", " ").split(" ", false)
	var name: String = words[0] if not words.is_empty() else ""
	if name == "input":
		_read_input(p_number, words.slice(1))
		return
	var key: EffectKey = EffectSettings.keys().get(name)
	if key == null:
		_problem(p_number, _unknown(name))
		return
	if _lines.has(name):
		_problem(p_number, "'%s' already stands on line %d." % [name, _lines[name]])
		return
	_lines[name] = p_number
	var value: Variant = key.read(words.slice(1))
	if value is EffectProblem:
		_problem(p_number, (value as EffectProblem).text)
	else:
		_settings.set(name, value)


func _unknown(p_name: String) -> String:
	var names: Array = EffectSettings.keys().keys()
	names.append("input")
	# Comparing words takes long: a file of nothing but wrong names must not wait for all of them.
	var near: String = ""
	if problems.is_empty():
		near = Nearest.find(p_name, PackedStringArray(names))
	if near != "":
		return "There is no setting '%s'. Did you mean '%s'?" % [p_name.left(40), near]
	return "There is no setting '%s'. There are: %s." % [p_name.left(40), ", ".join(names)]


func _read_input(p_number: int, p_words: PackedStringArray) -> void:
	var input: EffectInput = EffectInput.new()
	if p_words.size() < 4 or not p_words[0].is_valid_ascii_identifier():
		_problem(p_number, "An input reads // @input rpm 600 2600 800 what it is.")
		return
	if _settings.inputs.size() >= EffectSettings.MAX_INPUTS:
		_problem(p_number, "An effect has at most %d inputs." % EffectSettings.MAX_INPUTS)
		return
	for word: String in p_words.slice(1, 4):
		if not word.is_valid_float() or not absf(word.to_float()) <= 1e6:
			_problem(p_number, "'%s' is no number of an input: from, to, default." % word.left(40))
			return
	input.name = p_words[0].left(40)
	input.minimum = p_words[1].to_float()
	input.maximum = p_words[2].to_float()
	input.default = p_words[3].to_float()
	input.meaning = " ".join(p_words.slice(4)).left(80)
	if input.minimum >= input.maximum or input.default != input.clamped(input.default):
		_problem(p_number, "The default of an input lies between its lowest and highest value.")
		return
	_settings.inputs.append(input)


func _check_distances() -> void:
	if _settings.fade[0] > _settings.fade[1]:
		_problem(_lines["fade"], "'fade' is the distance where it begins, then where it is gone.")
	if _settings.speed[0] > _settings.speed[1]:
		_problem(_lines["speed"], "'speed' is the lowest, then the highest speed.")
