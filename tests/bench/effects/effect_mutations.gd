extends SceneTree
## Gives a running session of effects mutated texts, thousands of them; a JSON object at the end,
## for bench_effects.py. Options: --count=10000, --seed=1.

const Stage: GDScript = preload("effect_stage.gd")
const EFFECTS: PackedStringArray = ["smoke", "fire", "sparks", "explosion_debris"]
## So many texts that were accepted are drawn: each may be compiled anew, which takes long.
const DRAW_EVERY: int = 3
const _DEFAULTS: Dictionary = {"count": 10000, "seed": 1}
const _WORDS: PackedStringArray = [
	"for (;;) { }",
	"while (true) { }",
	"@count 2000000000",
	"// @count 99999",
	"// @texture none",
	"int i[999999999];",
	"process();",
	"#include",
	"}",
	"{",
	";",
	"TRANSFORM",
	"0.0 / 0.0",
	"1e38",
	"-1e38",
	"for (int i = 0; i < 4096; i++) { }",
	"// @life 0",
	"// @burst nan",
	"uniform float x;",
	"discard;",
	"ACTIVE = false;",
	"vec4(1.0)",
	"/*",
	"*/",
	"\t",
	"é",
	"void start() { }",
	"return;",
]

var _chance: RandomNumberGenerator = RandomNumberGenerator.new()


func _initialize() -> void:
	_run.call_deferred()


func _run() -> void:
	var arguments: BenchArguments = BenchArguments.parse(OS.get_cmdline_user_args(), _DEFAULTS)
	_chance.seed = arguments.value("seed")
	var stage: Stage = Stage.new(self)
	await stage.frames(3)
	stage.use_plain_sky()
	var library: EffectLibrary = EffectLibrary.shared()
	for effect: String in ["smoke", "fire", "sparks", "explosion"]:
		stage.root.add_child(LayeredEffect.make(effect))
	await stage.frames(10)
	var accepted: int = 0
	var replaced_wrongly: int = 0
	var longest_usec: int = 0
	var longest_frame_usec: int = 0
	for number: int in arguments.value("count") as int:
		var name: String = EFFECTS[number % EFFECTS.size()]
		var before: String = library.text_of(name)
		var original: String = FileAccess.get_file_as_string(EffectFile.path_of(name))
		var text: String = _mutate(before if _chance.randf() < 0.3 else original)
		var begin: int = Time.get_ticks_usec()
		var problems: Array[EffectProblem] = library.set_text(name, text, true)
		longest_usec = maxi(longest_usec, Time.get_ticks_usec() - begin)
		if not problems.is_empty():
			replaced_wrongly += 0 if library.text_of(name) == before else 1
			continue
		accepted += 1
		if accepted % DRAW_EVERY == 0:
			begin = Time.get_ticks_usec()
			await stage.frames(1)
			longest_frame_usec = maxi(longest_frame_usec, Time.get_ticks_usec() - begin)
	library.reset()
	await stage.frames(5)
	var hostile_usec: int = 0
	for text: String in EffectTexts.deep() + EffectTexts.long():
		var begin: int = Time.get_ticks_usec()
		EffectFile.from_bytes(text.to_utf8_buffer())
		hostile_usec = maxi(hostile_usec, Time.get_ticks_usec() - begin)
	var row: Dictionary = {"what": "mutations", "count": arguments.value("count")}
	row.merge({"accepted": accepted, "replaced_wrongly": replaced_wrongly})
	row.merge({"longest_ms": longest_usec / 1000.0, "frame_ms": longest_frame_usec / 1000.0})
	row["hostile_ms"] = hostile_usec / 1000.0
	print(JSON.stringify(row))
	quit()


## One to three changes: characters, words, lines, numbers.
func _mutate(p_text: String) -> String:
	var text: String = p_text
	for _change: int in _chance.randi_range(1, 3):
		var at: int = _chance.randi_range(0, text.length())
		var length: int = _chance.randi_range(1, 24)
		match _chance.randi_range(0, 5):
			0:
				text = text.erase(at, length)
			1:
				text = text.insert(at, _WORDS[_chance.randi_range(0, _WORDS.size() - 1)])
			2:
				text = text.insert(at, char(_chance.randi_range(32, 126)))
			3:
				text = text.insert(at, text.substr(_chance.randi_range(0, text.length()), length))
			4:
				text = _change_number(text)
			5:
				var lines: PackedStringArray = text.split("\n")
				lines.remove_at(_chance.randi_range(0, lines.size() - 1))
				text = "\n".join(lines)
	return text


func _change_number(p_text: String) -> String:
	var numbers: Array[RegExMatch] = RegEx.create_from_string("\\d+(\\.\\d+)?").search_all(p_text)
	if numbers.is_empty():
		return p_text
	var found: RegExMatch = numbers[_chance.randi_range(0, numbers.size() - 1)]
	var others: PackedStringArray = ["0", "0.0", "1", "-1.0", "1e9", "99999999999", "0.0001", "64"]
	var other: String = others[_chance.randi_range(0, others.size() - 1)]
	return p_text.left(found.get_start()) + other + p_text.substr(found.get_end())
