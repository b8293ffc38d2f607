@tool
class_name EffectSettings
extends RefCounted
## What the header of an effect's file says: one value a setting, the defaults for the rest.

## Textures that an effect may have, by their names in the header.
const TEXTURES: PackedStringArray = ["flare", "puff", "flash", "spark", "chunks"]
const MAX_COUNT: int = 20000
## Values of a setting that changes over the life of a particle.
const MAX_STEPS: int = 8
const MAX_INPUTS: int = 8

static var _keys: Dictionary[String, EffectKey] = {}

## The title, for people.
var effect: String = ""
## Another effect that this file is a layer of: both are played together. Empty for none.
var layer_of: String = ""
## How many particles there are at once.
var count: int = 200
## Time to live of a particle, s.
var life: float = 1.0
## Speeds that a new particle can have, from and to, m/s; for [code]start_speed(s)[/code].
var speed: PackedFloat64Array = [0.0, 0.0]
## How strongly a particle falls: 1 as a stone, 0 not at all, below 0 it rises; for
## [code]gravity()[/code].
var weight: float = 0.0
## Size from birth to death, m; for [code]size_over_life(age)[/code].
var size: PackedFloat64Array = [1.0]
## Colour and opacity from birth to death; for [code]colour_over_life(age)[/code].
var colour: PackedColorArray = [Color.WHITE]
## One of [constant TEXTURES].
var texture: String = "flare"
## alpha (hides what is behind it), add (shines) or fire (both, by its heat).
var blend: String = "alpha"
## quad, or triangle where a third fewer corners count.
var topology: String = "quad"
## viewer (turned to the camera), velocity (a streak along its path) or none (as TRANSFORM says).
var facing: String = "viewer"
## none, or sun: lit by the sun and the sky.
var light: String = "none"
## Over which distance a particle fades in front of something solid, m; 0 for a hard edge.
var soft: float = 0.0
## Distances from the camera at which it begins to fade and is gone, m; 0 0 for never.
var fade: PackedFloat64Array = [0.0, 0.0]
## How far particles can be from the emitter, m.
var bounds: float = 10.0
## How much of the count is born at once: 0 evenly over the life, 1 all in one moment.
var burst: float = 0.0
## Whether it ends when its particles have died.
var once: bool = false
## How much brighter than its colour it shines.
var glow: float = 1.0
## Time by which it is already advanced when it begins, s.
var preprocess: float = 0.0
## none, depth (the far ones first) or age (the old ones first).
var order: String = "none"
## What the emitter sets while the effect runs.
var inputs: Array[EffectInput] = []


## What can stand in a header, by name, in the order of the documentation.
static func keys() -> Dictionary[String, EffectKey]:
	if _keys.is_empty():
		for key: EffectKey in _make_keys():
			_keys[key.name] = key
	return _keys


## Whether both are drawn the same way: then new code goes onto running particles, and nothing has
## to be made anew.
func draws_like(p_other: EffectSettings) -> bool:
	if p_other == null:
		return false
	for name: String in keys():
		if name not in ["effect", "layer_of", "speed", "weight", "size", "colour"]:
			if get(name) != p_other.get(name):
				return false
	return true


## What the settings give to the code that uses it, on one line.
func helpers(p_code: String) -> String:
	var text: String = ""
	for input: EffectInput in inputs:
		text += input.declaration()
	if p_code.contains("start_speed"):
		text += (
			"float start_speed(inout uint s) { return mix(%f, %f, rnd(s)); } "
			% [speed[0], speed[1]]
		)
	if p_code.contains("gravity"):
		text += "vec3 gravity() { return vec3(0.0, %f, 0.0); } " % (-9.81 * weight)
	if p_code.contains("size_over_life"):
		var steps: PackedStringArray = []
		for step: float in size:
			steps.append("%f" % step)
		text += _over_life("float size", steps)
	if p_code.contains("colour_over_life"):
		var steps: PackedStringArray = []
		for step: Color in colour:
			steps.append("vec4(%f, %f, %f, %f)" % [step.r, step.g, step.b, step.a])
		text += _over_life("vec4 colour", steps)
	return text


## A function that goes through values that are evenly spread over the life, without a loop.
static func _over_life(p_what: String, p_steps: PackedStringArray) -> String:
	var value: String = p_steps[0]
	for i: int in range(1, p_steps.size()):
		value = "mix(%s, %s, clamp(x - %d.0, 0.0, 1.0))" % [value, p_steps[i], i - 1]
	return (
		"%s_over_life(float age) { float x = clamp(age, 0.0, 1.0) * %d.0; return %s; } "
		% [p_what, p_steps.size() - 1, value]
	)


static func _make_keys() -> Array[EffectKey]:
	return _motion_keys() + _look_keys()


static func _motion_keys() -> Array[EffectKey]:
	var steps: Vector2i = Vector2i(1, MAX_STEPS)
	return [
		EffectKey.words("effect", false, "the title"),
		EffectKey.words("layer_of", true, "the effect that this file is a layer of"),
		EffectKey.whole("count", 200, 1, MAX_COUNT, "how many particles there are at once"),
		EffectKey.number("life", 1.0, 0.02, 60.0, "s", "how long a particle lives"),
		EffectKey.numbers(
			"speed",
			[0.0, 0.0],
			Vector2(-1000, 1000),
			"m/s",
			Vector2i(2, 2),
			"lowest and highest speed at birth: start_speed(s)"
		),
		EffectKey.number(
			"weight", 0.0, -20.0, 20.0, "", "1 falls like a stone, 0 floats, -1 rises: gravity()"
		),
		EffectKey.numbers(
			"size",
			[1.0],
			Vector2(0, 100),
			"m",
			steps,
			"sizes from birth to death: size_over_life(age)"
		),
		EffectKey.colours(
			"colour", MAX_STEPS, "colours from birth to death: colour_over_life(age)"
		),
		EffectKey.number(
			"burst", 0.0, 0.0, 1.0, "", "how much is born at once: 0 evenly, 1 all in one moment"
		),
		EffectKey.yes_no("once", "whether it ends when its particles have died"),
		EffectKey.number(
			"preprocess", 0.0, 0.0, 10.0, "s", "how much has already happened when it begins"
		),
		EffectKey.number("bounds", 10.0, 0.1, 500.0, "m", "how far particles get from the emitter"),
	]


static func _look_keys() -> Array[EffectKey]:
	return [
		EffectKey.choice("texture", TEXTURES, "the picture of a particle"),
		EffectKey.choice(
			"blend",
			["alpha", "add", "fire"],
			"alpha hides what is behind, add shines, fire does both"
		),
		EffectKey.choice(
			"topology", ["quad", "triangle"], "triangle is cheaper where particles are tiny"
		),
		EffectKey.choice(
			"facing",
			["viewer", "velocity", "none"],
			"viewer turns to the camera, velocity is a streak, none is as TRANSFORM says"
		),
		EffectKey.choice("light", ["none", "sun"], "sun lights it by the sun and the sky"),
		EffectKey.number("soft", 0.0, 0.0, 10.0, "m", "fades this close in front of what is solid"),
		EffectKey.numbers(
			"fade",
			[0.0, 0.0],
			Vector2(0, 10000),
			"m",
			Vector2i(2, 2),
			"distances at which it begins to fade and is gone"
		),
		EffectKey.number("glow", 1.0, 0.0, 20.0, "", "how much brighter than its colour it shines"),
		EffectKey.choice(
			"order", ["none", "depth", "age"], "depth draws the far ones first, age the old ones"
		),
	]
