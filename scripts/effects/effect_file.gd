@tool
class_name EffectFile
extends RefCounted
## One particle effect as one text: a Godot particle shader whose [code]// @key value[/code] lines
## say how it is drawn.
##
## [method read] says what is wrong with the text as far as that shows without a compiler;
## [ShaderCheck] compiles [method code] too. docs/effects.md describes the file.

## Largest file, bytes.
const MAX_BYTES: int = 65536
const FOLDER: String = "res://assets/effects"
const EXTENSION: String = "gdshader"
const MAX_NAME: int = 40
## Greatest number of problems that are reported at once; one mistake often makes many.
const MAX_PROBLEMS: int = 20
## A uniform of every effect: if the compiler does not list it, it has not understood the code.
const MARK: String = "effect_compiled"
## What the code may use, and what it stands for. It is put onto the line of
## [code]shader_type[/code], so that the compiler counts lines as the file does, and only what is
## used is: less to compile.
const HELPERS: Dictionary[String, String] = {
	"wind": "global uniform vec3 wind; ",
	"rnd":
	(
		"uint effect_hash(uint x) { x ^= x >> 16u; x *= 0x7feb352du; x ^= x >> 15u; "
		+ "x *= 0x846ca68bu; return x ^ (x >> 16u); } "
		+ "float rnd(inout uint s) { s = effect_hash(s + 0x9e3779b9u); "
		+ "return float(s >> 8u) / 16777216.0; } "
	),
	"rnd_range": "float rnd_range(inout uint s, float a, float b) { return mix(a, b, rnd(s)); } ",
	"rnd_sphere":
	(
		"vec3 rnd_sphere(inout uint s) { float z = rnd(s) * 2.0 - 1.0; "
		+ "float a = rnd(s) * 6.2831853; float r = sqrt(max(1.0 - z * z, 0.0)); "
		+ "return vec3(r * cos(a), r * sin(a), z); } "
	),
	"at":
	(
		"mat4 at(vec3 p, float size) { return mat4(vec4(size, 0.0, 0.0, 0.0), "
		+ "vec4(0.0, size, 0.0, 0.0), vec4(0.0, 0.0, size, 0.0), vec4(p, 1.0)); } "
	),
}

## Begins start(): a share of the particles is left out where there is no room for all of them. The
## engine leaves that to the code. A file that reads AMOUNT_RATIO does it itself.
const _LEAVE_OUT: String = (
	" if (fract(float(INDEX) * 0.618034 + 0.001) >= AMOUNT_RATIO) " + "{ ACTIVE = false; } "
)

static var _colours: RegEx = RegEx.create_from_string("(:\\s*)?\\bsource_color\\b(\\s*,)?")
static var _name: RegEx = RegEx.create_from_string("^[a-z][a-z0-9_]{0,39}$")
static var _start: RegEx = RegEx.create_from_string("\\bvoid\\s+start\\s*\\(\\s*\\)\\s*\\{")
static var _type: RegEx = RegEx.create_from_string("\\bshader_type\\s+particles\\s*;")

## The whole file.
var text: String = ""
var settings: EffectSettings = EffectSettings.new()
## What is wrong, by line; empty if nothing is.
var problems: Array[EffectProblem] = []
## Work of a particle in a frame, tokens (see [CodeCost]).
var work: int = 0

var _tokens: EffectTokens = null


## Reads a text. Any text may be given: what is wrong is in [member problems].
static func read(p_text: String) -> EffectFile:
	var file: EffectFile = EffectFile.new()
	file.text = p_text.replace("\r\n", "\n")
	if file.text.length() > MAX_BYTES or file.text.to_utf8_buffer().size() > MAX_BYTES:
		file.text = ""
		file._add(EffectProblem.new(1, "An effect has at most %d bytes." % MAX_BYTES))
	else:
		file._read()
	return file


## Reads bytes that came from a file or over the network.
static func from_bytes(p_bytes: PackedByteArray) -> EffectFile:
	var error: String = "An effect has at most %d bytes." % MAX_BYTES
	if p_bytes.size() <= MAX_BYTES:
		var decoded: EffectText = EffectText.new(p_bytes)
		if not decoded.failed:
			return read(decoded.text)
		error = "This is not a text in UTF-8."
	var file: EffectFile = EffectFile.new()
	file._add(EffectProblem.new(1, error))
	return file


## Reads a file; one that cannot be read has a problem that says so.
static func open(p_path: String) -> EffectFile:
	var access: FileAccess = FileAccess.open(p_path, FileAccess.READ)
	if access == null:
		var file: EffectFile = EffectFile.new()
		var why: String = error_string(FileAccess.get_open_error())
		file._add(EffectProblem.new(1, "%s cannot be read: %s." % [p_path, why]))
		return file
	return from_bytes(access.get_buffer(MAX_BYTES + 1))


## Whether an effect can have this name: small letters, digits and _, at most
## [constant MAX_NAME] of them.
static func is_name(p_name: String) -> bool:
	return _name.search(p_name) != null and not p_name.contains("\n")


## Where the file of a shipped effect is.
static func path_of(p_name: String) -> String:
	return "%s/%s.%s" % [FOLDER, p_name, EXTENSION]


## What the engine compiles. Colours stay as they were picked (no [code]source_color[/code]): the
## drawing converts them, the same in every renderer.
func code() -> String:
	var found: RegExMatch = _type.search(_tokens.bare) if _tokens != null else null
	if found == null:
		return text
	var end: int = found.get_end()
	var start: RegExMatch = _start.search(_tokens.bare, end)
	if start == null or _tokens.words.has("AMOUNT_RATIO"):
		return text.left(end) + _helpers() + _without_hints(text.substr(end))
	var body: int = start.get_end()
	return (
		text.left(end)
		+ _helpers()
		+ _without_hints(text.substr(end, body - end))
		+ _LEAVE_OUT
		+ _without_hints(text.substr(body))
	)


## Whether there are loops in the code.
func has_loops() -> bool:
	return _tokens != null and _tokens.words.has("for")


## The first problem as "line 3: ..."; empty if there is none.
func first_problem() -> String:
	return "" if problems.is_empty() else str(problems[0])


## Blanks the hint out wherever it stands, and keeps the lines.
static func _without_hints(p_code: String) -> String:
	var parts: PackedStringArray = []
	var from: int = 0
	for found: RegExMatch in _colours.search_all(p_code):
		parts.append(p_code.substr(from, found.get_start() - from))
		# ": source_color, filter_linear" keeps its colon.
		var keeps: bool = found.get_string(1) != "" and found.get_string(2) != ""
		parts.append((":" if keeps else "") + "\n".repeat(found.get_string().count("\n")))
		from = found.get_end()
	parts.append(p_code.substr(from))
	return "".join(parts)


func _add(p_problem: EffectProblem) -> void:
	if problems.size() < MAX_PROBLEMS:
		problems.append(p_problem)


func _helpers() -> String:
	var helpers: String = " uniform float %s; " % MARK
	for name: String in HELPERS:
		# "rnd" is part of every name that uses it; so is start_speed's.
		if text.contains(name) or (name == "rnd" and text.contains("start_speed")):
			helpers += HELPERS[name]
	return helpers + settings.helpers(text)


func _read() -> void:
	var reader: EffectHeader = EffectHeader.new(settings)
	reader.read(text)
	_tokens = EffectTokens.new(text)
	for problem: EffectProblem in reader.problems:
		_add(problem)
	if _type.search(_tokens.bare) == null:
		_add(EffectProblem.new(1, "An effect begins with 'shader_type particles;'."))
	var cost: CodeCost = CodeCost.measure(_tokens)
	# What is not built as code is not searched for loops: in brackets without end that takes long.
	if cost.is_well_formed:
		for problem: EffectProblem in LoopRule.check(_tokens):
			_add(problem)
		_check_numbers()
	work = cost.work
	if problems.is_empty() and cost.problems.is_empty() and work == 0:
		_add(EffectProblem.new(1, "There is no 'void process() { }', which moves the particles."))
	cost.check_count(settings.count, settings.preprocess)
	for problem: EffectProblem in cost.problems:
		_add(problem)


## Of numbers that a float cannot hold the engine makes code that no driver compiles.
func _check_numbers() -> void:
	for i: int in _tokens.size():
		if problems.size() >= MAX_PROBLEMS:
			return
		var word: String = _tokens.words[i].to_lower()
		if not "0123456789.".contains(word[0]) or word.begins_with("0x"):
			continue
		var exponent: String = word.get_slice("e", 1) if word.contains("e") else "0"
		if exponent == "" and _tokens.at(i + 1) == "+":
			exponent = _tokens.at(i + 2)
		if word.get_slice("e", 0).length() > 30 or exponent.trim_suffix("f").to_int() > 30:
			_add(EffectProblem.new(_tokens.line(i), "This number is too large."))
