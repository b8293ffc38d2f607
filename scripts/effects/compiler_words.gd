@tool
class_name CompilerWords
extends RefCounted
## Says in plain words what the compiler of the shading language says in its own.

## What an effect's code can name, besides what it declares itself.
const NAMES: PackedStringArray = [
	"TRANSFORM",
	"VELOCITY",
	"COLOR",
	"CUSTOM",
	"ACTIVE",
	"DELTA",
	"LIFETIME",
	"TIME",
	"NUMBER",
	"INDEX",
	"RANDOM_SEED",
	"EMISSION_TRANSFORM",
	"EMITTER_VELOCITY",
	"INTERPOLATE_TO_END",
	"AMOUNT_RATIO",
	"RESTART",
	"RESTART_POSITION",
	"RESTART_ROT_SCALE",
	"RESTART_VELOCITY",
	"RESTART_COLOR",
	"RESTART_CUSTOM",
	"COLLIDED",
	"COLLISION_NORMAL",
	"COLLISION_DEPTH",
	"ATTRACTOR_FORCE",
	"MASS",
	"PI",
	"TAU",
	"E",
	"wind",
	"rnd",
	"rnd_range",
	"rnd_sphere",
	"at",
	"gravity",
	"start_speed",
	"size_over_life",
	"colour_over_life",
	"abs",
	"acos",
	"all",
	"any",
	"asin",
	"atan",
	"ceil",
	"clamp",
	"cos",
	"cross",
	"degrees",
	"distance",
	"dot",
	"exp",
	"exp2",
	"floor",
	"fract",
	"inversesqrt",
	"length",
	"log",
	"log2",
	"max",
	"min",
	"mix",
	"mod",
	"normalize",
	"pow",
	"radians",
	"reflect",
	"round",
	"sign",
	"sin",
	"smoothstep",
	"sqrt",
	"step",
	"tan",
	"float",
	"int",
	"uint",
	"bool",
	"vec2",
	"vec3",
	"vec4",
	"mat3",
	"mat4",
	"uniform",
	"const",
	"varying",
	"void",
	"return",
	"true",
	"false",
]

## What the compiler says, and what it means. A group of the pattern stands for {0}, {1}.
const _WORDS: Dictionary[String, String] = {
	"Unknown identifier in expression: '(\\w+)'": "'{0}' is not known here.",
	"No matching function found for: '(\\w+)'": "There is no function '{0}' with such arguments.",
	"No matching constructor found for: '([^']+)'":
	"'{0}' cannot be made of these values: count the numbers in its brackets.",
	'Invalid arguments for the built-in function: "([^"]+)"': "{0} does not exist.",
	"Invalid arguments to (?:unary )?operator '([^']+)': '([^']+)'":
	"'{0}' does not work between these types: {1}.",
	"Invalid assignment of '([^']+)' to '([^']+)'":
	"A value of type {0} stands where a {1} belongs.",
	"Expected a '([^']+)'(?:.*)": "Here a '{0}' is missing, or something before it is unfinished.",
	"Expected '([^']+)'(?:.*)": "Here a '{0}' is missing, or something before it is unfinished.",
	"Unexpected end of file in (?:block|function)?.*":
	"The text ends inside of { }: a } is missing.",
	"Expected expression, found: '?([^']+)'?": "A value is missing before {0}.",
	"Redefinition of '([^']+)'": "There is already something named '{0}'.",
	"Constants cannot be modified": "This can be read, but not changed.",
	"Assignment to (?:constant|uniform).*": "This can be read, but not changed.",
	"Invalid member for '([^']+)' expression: '\\.?([^']+)'": "A {0} has no part '{1}'.",
	"Global uniform '([^']+)' does not exist.*": "There is no global value '{0}'; there is wind.",
	"Using 'return' in the.*": "'return' has no value here.",
	"Expected a boolean expression.*": "A question belongs here, such as a < 1.0.",
	"Expected constant, function, uniform or varying.*":
	"Outside of { } stand only uniforms, constants and functions.",
	"A constant value cannot be passed for the '([^']+)'.*":
	"The function changes this: it needs a variable, as in uint s = RANDOM_SEED.",
	"Tokenizer: Unknown character.*": "There is a character here that the language does not know.",
}

static var _patterns: Dictionary[String, RegEx] = {}
static var _words: RegEx = RegEx.create_from_string("\\b[A-Za-z_]\\w*\\b")


## The same problem, in plain words where there are such.
static func explain(p_problem: EffectProblem, p_file: EffectFile) -> EffectProblem:
	var line: int = p_problem.line
	var text: String = p_problem.text
	for pattern: String in _WORDS:
		var found: RegExMatch = _pattern(pattern).search(p_problem.text)
		if found == null:
			continue
		text = _WORDS[pattern].format(Array(found.strings.slice(1)))
		if text.contains("int") and (text.contains("float") or text.contains("vec")):
			text += " Write numbers with a point: 1.0, not 1."
		if pattern.begins_with("Unknown") or pattern.begins_with("No matching function"):
			text += _suggestion(found.get_string(1), p_file)
		if text.begins_with("Here a ';'"):
			line = _unfinished_line(line, p_file.text)
			text = "At the end of this line a ';' is missing."
		break
	var last: int = p_file.text.count("\n") + 1
	return EffectProblem.new(clampi(line, 1, last), text)


static func _pattern(p_text: String) -> RegEx:
	if not _patterns.has(p_text):
		_patterns[p_text] = RegEx.create_from_string(p_text)
	return _patterns[p_text]


static func _suggestion(p_word: String, p_file: EffectFile) -> String:
	# Any single letter is as near to any other.
	if p_word.length() < 3:
		return ""
	var known: Dictionary[String, bool] = {}
	for name: String in NAMES:
		known[name] = true
	for found: RegExMatch in _words.search_all(p_file.text.left(20000)):
		known[found.get_string()] = true
	known.erase(p_word)
	# Comparing takes its time, in which somebody types: only those that begin alike are compared.
	var names: PackedStringArray = []
	for name: String in known:
		var differs: int = absi(name.length() - p_word.length())
		if differs <= maxi(p_word.length() / 3, 1) and name[0].to_lower() == p_word[0].to_lower():
			names.append(name)
	var near: String = Nearest.find(p_word, names)
	return "" if near == "" else " Did you mean '%s'?" % near


## The compiler notices a missing ; only at what comes next: the line before it that has code is
## meant.
static func _unfinished_line(p_line: int, p_text: String) -> int:
	var lines: PackedStringArray = EffectTokens.new(p_text).bare.split("\n")
	var line: int = mini(p_line, lines.size()) - 1
	while line > 1 and lines[line - 1].strip_edges() == "":
		line -= 1
	return maxi(line, 1)
