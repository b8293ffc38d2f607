extends TestCase
## A line that is typed in a terminal.

var _editor: LineEditor = null
var _entered: Array[String] = []


func before_each() -> void:
	_editor = LineEditor.new()
	_entered.clear()
	_editor.entered.connect(func(line: String) -> void: _entered.append(line))


func test_editing() -> void:
	for row: Array in [
		["kick Bob\n", "kick Bob"],
		["kicj\u007fk\r", "kick"],
		["ick\u0001k\n", "kick"],
		["kck\u001b[D\u001b[Di\n", "kick"],
		["kkick\u001b[H\u001b[3~\n", "kick"],
		["what\u0015kick\n", "kick"],
		["kick it\u0001\u001b[C\u001b[C\u001b[C\u001b[C\u000b\n", "kick"],
		["Zoë Ωm\n", "Zoë Ωm"],
		["a\u001b[200~b\u001bOFc\n", "abc"],
	]:
		_entered.clear()
		_editor.take((row[0] as String).to_utf8_buffer())
		equal(_entered, [row[1]] as Array[String], row[1])


func test_bytes_may_come_one_by_one() -> void:
	for byte: int in "Zo\u00eb\u001b[D\u001b[D-\n".to_utf8_buffer():
		_editor.take([byte])
	equal(_entered, ["Z-oë"] as Array[String])


func test_history() -> void:
	_editor.take("one\ntwo\ntwo\ndra".to_utf8_buffer())
	_editor.take("\u001b[A\u001b[A\n".to_utf8_buffer())
	equal(_entered[-1], "one")
	_editor.take("dra\u001b[A\u001b[A\u001b[B\u001b[B\u001b[Bft\n".to_utf8_buffer())
	equal(_entered[-1], "draft")


func test_noise_breaks_nothing() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 8
	for _round: int in 3000:
		var noise: PackedByteArray = []
		for _byte: int in 20:
			noise.append(random.randi() % 256)
		_editor.take(noise)
		is_true(_editor.cursor >= 0 and _editor.cursor <= _editor.line.length())
		is_true(_editor.line.length() <= LineEditor.MAX_LENGTH)


func test_the_end() -> void:
	var ends: Array[int] = []
	_editor.ended.connect(func() -> void: ends.append(1))
	_editor.take([0x61, 4])
	equal(ends.size(), 0, "not with something typed")
	_editor.take([127, 4])
	equal(ends.size(), 1)
