class_name EffectTexts
extends RefCounted
## Texts of effects for tests.

## A whole effect that uses every helper.
const GOOD: String = """shader_type particles;
// @effect Test fountain
// @count 50
// @life 0.8
// @speed 6 7
// @weight 1
// @size 0.2 0.1
// @colour #8f3403 #8f340300
// @blend add
// @input strength 0 2 1 how strong it is

uniform vec3 tint : source_color = vec3(1.0, 0.5, 0.2);
uniform float drag : hint_range(0, 4) = 0.5;

void start() {
	uint s = RANDOM_SEED + NUMBER;
	TRANSFORM = at(EMISSION_TRANSFORM[3].xyz + 0.1 * rnd_sphere(s), 0.2);
	VELOCITY = vec3(rnd_range(s, -1.0, 1.0), start_speed(s) * strength, 0.0);
	CUSTOM = vec4(0.0);
}

void process() {
	CUSTOM.y += DELTA / LIFETIME;
	VELOCITY += (gravity() + drag * (wind - VELOCITY)) * DELTA;
	TRANSFORM = at(TRANSFORM[3].xyz, size_over_life(CUSTOM.y));
	COLOR = colour_over_life(CUSTOM.y) * vec4(tint, 1.0);
}
"""
const _FRAME: String = "shader_type particles;\n%s\nvoid start() {}\nvoid process() {\n%s\n}\n"


## A short effect: a line of its header (line 2), and what stands in process() (from line 5).
static func of(p_header: String, p_body: String) -> String:
	return _FRAME % [p_header, p_body]


## Texts whose brackets are too deep or whose statements are too long.
static func deep() -> PackedStringArray:
	return [
		of("", "COLOR.r = %s1.0%s;" % ["(".repeat(20000), ")".repeat(20000)]),
		of("", "COLOR.r = 1.0%s;" % "+1.0".repeat(5000)),
		of("", "COLOR.r = %s1.0;" % "-".repeat(20000)),
		of("", "{".repeat(2000) + "}".repeat(2000)),
		of("", "if (true) { } else ".repeat(300) + "{ }"),
		of("", "if (true) ".repeat(2000) + "{ }"),
		of("", "COLOR.r = 1.0;".repeat(3000)),
	]


## Small texts that a careless reader takes seconds for.
static func long() -> PackedStringArray:
	return [
		of("const ".repeat(2900), ""),
		of("// @lifee 1\n".repeat(5000), ""),
		of("// @\n".repeat(12000), ""),
		of("// @inputx a 1 2 3\n".repeat(3000), ""),
		of("[".repeat(2900), ""),
		of("[".repeat(1400) + "]".repeat(1400), ""),
		of("", "for (int i = 0; i < 8; i++) {".repeat(190)),
		of("\n".repeat(55000) + "@;".repeat(1300), ""),
		of("\n".repeat(55000) + "1e99;".repeat(1000), ""),
	]


## [param p_text] with one to three random changes.
static func mutate(p_text: String, p_random: RandomNumberGenerator) -> String:
	var text: String = p_text
	for i: int in p_random.randi_range(1, 3):
		var at: int = p_random.randi_range(0, text.length() - 1)
		var length: int = p_random.randi_range(0, 12)
		match p_random.randi_range(0, 5):
			0:
				text = text.erase(at, length)
			1:
				text = text.insert(
					at, text.substr(p_random.randi_range(0, text.length() - 1), length)
				)
			2:
				text = text.insert(at, _pick(p_random))
			3:
				text = (
					text.left(at) + String.chr(p_random.randi_range(1, 0x2FF)) + text.substr(at + 1)
				)
			4:
				text = text.erase(at, length).insert(at, _pick(p_random))
			5:
				var from: int = p_random.randi_range(0, text.length() - 1)
				text = text.left(at) + text.substr(from, 80) + text.substr(at + length)
	return text


static func _pick(p_random: RandomNumberGenerator) -> String:
	var pieces: PackedStringArray = [
		"while (true) {",
		"for (;;) {",
		"for (int i = 0; i < 9999; i++) {",
		"}",
		"{",
		"(",
		")",
		";",
		"99999999999",
		"-1",
		"1e38",
		"/*",
		"*/",
		"//",
		"// @count 1e9\n",
		"// @texture gone\n",
		"// @",
		"#define X while\n",
		"@@<",
		"uniform",
		"int a[100000];",
		"process",
		"nan",
		"\t",
		"\n",
		"vec3(",
		"TRANSFORM",
		"source_color",
		"shader_type",
		"spatial",
		"discard;",
		"é",
		"\u2028",
	]
	return pieces[p_random.randi_range(0, pieces.size() - 1)]
