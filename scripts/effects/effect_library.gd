@tool
class_name EffectLibrary
extends RefCounted
## All effects of a program: the shipped files in [code]assets/effects[/code], and what has replaced
## them or was added since ([method set_text]).
##
## Whatever shows an effect shows the newest text: a broken one is refused and takes nothing down.

## Files of an effect have changed so that what shows it must be set up anew: another header, or
## another layer. (New code alone goes onto running particles without it.)
signal changed(p_effect: String)
## The text of a file has changed.
signal text_changed(p_name: String)

## Most files, the shipped ones included: who sends more of them is refused.
const MAX_FILES: int = 256

static var _shared: EffectLibrary = null

var _layers: Dictionary[String, EffectLayer] = {}
## Texts that are not the shipped ones, by file.
var _edited: Dictionary[String, String] = {}


func _init() -> void:
	for file: String in ResourceLoader.list_directory(EffectFile.FOLDER):
		if file.get_extension() == EffectFile.EXTENSION:
			_load(file.get_basename())


## The one that everything uses.
static func shared() -> EffectLibrary:
	if _shared == null:
		_shared = EffectLibrary.new()
	return _shared


## Lets go all effects; what is shown keeps its own. For the end of a program and for tests.
static func forget() -> void:
	_shared = null
	EffectDrawing.forget()


## Names of all effects, in order; files that are layers of others are not named.
func names() -> PackedStringArray:
	var found: PackedStringArray = []
	for name: String in _layers:
		if _layers[name].file.settings.layer_of == "":
			found.append(name)
	found.sort()
	return found


## Names of all files, in order.
func files() -> PackedStringArray:
	var found: PackedStringArray = PackedStringArray(_layers.keys())
	found.sort()
	return found


## Whether there is an effect of a name.
func has(p_effect: String) -> bool:
	return _layers.has(p_effect) and _layers[p_effect].file.settings.layer_of == ""


## The files of an effect, its own first; empty if there is none.
func layers(p_effect: String) -> Array[EffectLayer]:
	var found: Array[EffectLayer] = []
	if not has(p_effect):
		return found
	found.append(_layers[p_effect])
	for name: String in files():
		if _layers[name].file.settings.layer_of == p_effect and name != p_effect:
			found.append(_layers[name])
	return found


## A file by its name, or null.
func find(p_name: String) -> EffectLayer:
	return _layers.get(p_name)


## The text of a file; empty if there is none.
func text_of(p_name: String) -> String:
	return _layers[p_name].file.text if _layers.has(p_name) else ""


## Texts that are not the shipped ones, by file: what who comes later must get.
func edited() -> Dictionary[String, String]:
	return _edited.duplicate()


## Shows another text of a file from now on, or adds a file. Returns what is wrong with it; then
## everything stays as it was. [param p_quietly]: see [method ShaderCheck.problems].
func set_text(p_name: String, p_text: String, p_quietly: bool = false) -> Array[EffectProblem]:
	return set_file(p_name, EffectFile.read(p_text), p_quietly)


## The same with a text that has been read already.
func set_file(p_name: String, p_file: EffectFile, p_quietly: bool = false) -> Array[EffectProblem]:
	var fault: String = ""
	if not EffectLimits.is_name(p_name):
		fault = "'%s' is no name: small letters, digits and _." % p_name.left(40)
	elif not _layers.has(p_name) and _layers.size() >= MAX_FILES:
		fault = "There are already %d effects." % MAX_FILES
	if fault != "":
		return [EffectProblem.new(1, fault)]
	if text_of(p_name) == p_file.text and p_file.text != "":
		return []
	var problems: Array[EffectProblem] = ShaderCheck.problems(p_file, p_quietly)
	if problems.is_empty():
		_edited[p_name] = p_file.text
		_take(p_name, p_file)
	return problems


## Shows the shipped files again, and forgets those that were added.
func reset() -> void:
	var names_edited: Array = _edited.keys()
	_edited.clear()
	for name: String in names_edited:
		var file: EffectFile = EffectFile.open(EffectFile.path_of(name))
		if file.problems.is_empty():
			_take(name, file)
			continue
		var effect: String = _layers[name].effect()
		_layers.erase(name)
		changed.emit(effect)
		text_changed.emit(name)


func _take(p_name: String, p_file: EffectFile) -> void:
	var layer: EffectLayer = _layers.get(p_name)
	if layer == null:
		layer = EffectLayer.make(p_name, p_file)
		_layers[p_name] = layer
		changed.emit(layer.effect())
	else:
		var before: String = layer.effect()
		var is_new: bool = layer.take(p_file)
		if layer.effect() != before:
			changed.emit(before)
		if is_new or layer.effect() != before:
			changed.emit(layer.effect())
	text_changed.emit(p_name)


## A shipped file. It has been checked by a test; what somebody has put there since may be broken.
func _load(p_name: String) -> void:
	var file: EffectFile = EffectFile.open(EffectFile.path_of(p_name))
	if file.problems.is_empty() and EffectLimits.is_name(p_name):
		_layers[p_name] = EffectLayer.make(p_name, file)
	else:
		var path: String = EffectFile.path_of(p_name)
		Log.warning("effects", "%s is not used: %s" % [path, file.first_problem()])
