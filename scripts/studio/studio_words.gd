@tool
class_name StudioWords
extends RefCounted
## What the words of an effect's code mean: for the help line, completion and colours.

## Words that the engine gives to the code.
const BUILT_IN: Dictionary[String, String] = {
	"TRANSFORM": "where the particle is, its turn and size: TRANSFORM[3].xyz is its position, m",
	"VELOCITY": "how fast it moves, m/s; the engine moves it by this",
	"COLOR": "its colour and opacity, 0 to 1",
	"CUSTOM":
	(
		"four numbers of your own; x: turn (radians), y: age 0 to 1 (frame of the texture), "
		+ "z: heat of blend fire"
	),
	"ACTIVE": "false: the particle is gone",
	"DELTA": "time since the last step, s",
	"LIFETIME": "@life, s",
	"TIME": "time since the start, s",
	"NUMBER": "a number that no other particle of the effect has had",
	"INDEX": "number of the particle, from 0 to @count - 1",
	"RANDOM_SEED": "a random number: uint s = RANDOM_SEED + NUMBER;",
	"EMISSION_TRANSFORM": "where the emitter is: EMISSION_TRANSFORM[3].xyz is its position, m",
	"EMITTER_VELOCITY": "how fast the emitter moves, m/s",
	"AMOUNT_RATIO": "share of the particles that is wanted now",
	"COLLIDED": "whether it has just hit something",
	"COLLISION_NORMAL": "which way the surface faces that it has hit",
	"COLLISION_DEPTH": "how deep it is in what it has hit, m",
	"ATTRACTOR_FORCE": "how attractors pull at it, m/s²",
	"PI": "3.14159...: half a turn in radians",
	"TAU": "6.28318...: a whole turn in radians",
}
## What this project gives to the code.
const HELPERS: Dictionary[String, String] = {
	"start": "void start(): once, when a particle is born",
	"process": "void process(): in every step of a particle's life",
	"rnd": "rnd(s): a random number from 0 to 1; s is a uint variable",
	"rnd_range": "rnd_range(s, a, b): a random number from a to b",
	"rnd_sphere": "rnd_sphere(s): a random direction, of length 1",
	"at": "at(position, size): a TRANSFORM there",
	"wind": "the wind of the world, m/s",
	"gravity": "gravity(): how it falls by @weight, m/s²: VELOCITY += gravity() * DELTA;",
	"start_speed": "start_speed(s): a random speed of @speed, m/s",
	"size_over_life": "size_over_life(age): the size of @size at this age, 0 to 1",
	"colour_over_life": "colour_over_life(age): the colour of @colour at this age, 0 to 1",
}
## Functions of the language.
const FUNCTIONS: Dictionary[String, String] = {
	"abs": "abs(x): x without its sign",
	"ceil": "ceil(x): the next whole number above",
	"clamp": "clamp(x, lowest, highest): x within bounds",
	"cos": "cos(angle): cosine, radians",
	"cross": "cross(a, b): the direction at right angles to both",
	"distance": "distance(a, b): how far two points are apart",
	"dot": "dot(a, b): how much two directions agree",
	"exp": "exp(x): e to the power of x; exp(-3.0 * age) dies away",
	"floor": "floor(x): the next whole number below",
	"fract": "fract(x): what is behind the point",
	"length": "length(v): how long it is",
	"max": "max(a, b): the larger one",
	"min": "min(a, b): the smaller one",
	"mix": "mix(a, b, share): between a (share 0) and b (share 1)",
	"mod": "mod(x, y): what is left of x when y is taken away as often as it fits",
	"normalize": "normalize(v): the same direction with length 1",
	"pow": "pow(x, y): x to the power of y",
	"reflect": "reflect(v, normal): v bounced off a surface",
	"sign": "sign(x): -1, 0 or 1",
	"sin": "sin(angle): sine, radians; waves",
	"smoothstep": "smoothstep(from, to, x): 0 below from, 1 above to, smooth between",
	"sqrt": "sqrt(x): square root",
	"step": "step(edge, x): 0 below the edge, else 1",
	"tan": "tan(angle): tangent, radians",
}
## Types of values.
const TYPES: Dictionary[String, String] = {
	"float": "a number, with a point: 1.0",
	"int": "a whole number: 1",
	"uint": "a whole number that is not negative: 1u",
	"bool": "true or false",
	"vec2": "two numbers: vec2(x, y)",
	"vec3": "three numbers, such as a position or a colour: vec3(x, y, z)",
	"vec4": "four numbers, such as a colour with opacity: vec4(r, g, b, a)",
	"mat3": "a turn",
	"mat4": "a position, turn and size, as TRANSFORM is",
	"sampler2D": "a picture",
}
## Words of the language.
const KEYWORDS: Dictionary[String, String] = {
	"shader_type": "the first line: shader_type particles;",
	"particles": "what kind of shader it is",
	"uniform":
	"a value that a slider or the emitter sets: uniform float a : hint_range(0, 1) = 0.5;",
	"hint_range": "hint_range(from, to): the ends of a slider",
	"source_color": "makes a vec3 a colour that can be picked",
	"const": "a value that never changes",
	"void": "a function that gives nothing back",
	"if": "if (a < b) { } does something only then",
	"else": "what is done otherwise",
	"for": "for (int i = 0; i < 8; i++) { } repeats, with numbers only",
	"return": "ends a function and gives a value back",
	"true": "yes",
	"false": "no",
	"inout": "an argument that the function changes",
	"in": "an argument",
	"out": "an argument that the function sets",
}


## What a word means; empty if that is not known. The names of settings stand behind // @.
static func meaning(p_word: String, p_is_setting: bool = false) -> String:
	if p_is_setting:
		var key: EffectKey = EffectSettings.keys().get(p_word)
		if p_word == "input":
			return "// @input rpm 600 2600 800 engine revolutions: a value that the emitter sets"
		return "" if key == null else "%s: %s" % [key.usage(), key.meaning]
	for words: Dictionary[String, String] in [BUILT_IN, HELPERS, FUNCTIONS, TYPES, KEYWORDS]:
		if words.has(p_word):
			return words[p_word]
	return ""


## All help as one text, for the help pane.
static func everything() -> String:
	var text: String = "Settings, at the top of the file\n"
	for name: String in EffectSettings.keys():
		text += "  %s\n" % meaning(name, true)
	text += "  %s\n" % meaning("input", true)
	var groups: Dictionary[String, Dictionary] = {
		"What the engine knows of a particle": BUILT_IN,
		"Helpers of this project": HELPERS,
		"Functions": FUNCTIONS,
		"Types": TYPES,
		"Words of the language": KEYWORDS,
	}
	for title: String in groups:
		text += "\n%s\n" % title
		for word: String in groups[title]:
			text += "  %s: %s\n" % [word, groups[title][word]]
	return text
