extends TestCase
## New texts of effects in a running session: everybody gets those that are whole, nobody gets a
## broken one, and who comes later gets the newest.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const FOLDER: String = "user://test_effects"

var _pair: LinkPair = null
var _effects: ServerEffects = null
## Lines of the log.
var _lines: Array[String] = []
## Texts that each client has got, by its link.
var _got: Dictionary[ClientLink, Array] = {}
var _answers: PackedStringArray = []


func before_each() -> void:
	_clean_up()
	DirAccess.make_dir_recursive_absolute(FOLDER)
	_got.clear()
	_answers.clear()
	_lines.clear()
	Log.sink = func(line: String) -> void: _lines.append(line)
	_pair = LinkPair.new()
	_effects = _open()
	_pair.on_poll = func() -> void: _effects.advance(0, 1.0 / 60.0)
	equal(_pair.listen(), OK)


func after_each() -> void:
	Log.sink = Callable()
	_effects.close()
	_effects.free()
	_pair.on_poll = Callable()
	_pair.close()
	_clean_up()


func _open() -> ServerEffects:
	var context: ServerContext = ServerContext.new()
	context.link = _pair.server
	var folder: String = ProjectSettings.globalize_path(FOLDER)
	context.options = ProgramOptions.parse(["--effects=" + folder], ProgramRoles.SERVER)
	var effects: ServerEffects = ServerEffects.new()
	equal(effects.open(context), "")
	return effects


func test_what_is_saved_comes_to_all() -> void:
	var ends: Array[LinkPair.End] = [
		_join(Roles.Role.TRAINEE, "Ada"), _join(Roles.Role.OBSERVER, "Bob")
	]
	_save("fountain", EffectTexts.GOOD)
	for end: LinkPair.End in ends:
		is_true(_pair.until(func() -> bool: return _last(end) == EffectTexts.GOOD))
	var changed: String = EffectTexts.GOOD.replace("@count 50", "@count 60")
	_save("fountain", changed)
	for end: LinkPair.End in ends:
		is_true(_pair.until(func() -> bool: return _last(end) == changed))
		equal(_got[end.link].size(), 2)


func test_a_broken_file_changes_nothing_and_is_named_once() -> void:
	var end: LinkPair.End = _join(Roles.Role.OBSERVER, "Bob")
	_save("fountain", EffectTexts.GOOD)
	is_true(_pair.until(func() -> bool: return _last(end) == EffectTexts.GOOD))
	for text: String in ["Shader compilation failed", "Invalid member"]:
		allow_error(text)
	for i: int in 5:
		_save("fountain", EffectTexts.GOOD.replace("CUSTOM.y +=", "CUSTOM.q%d =" % i))
		is_true(_pair.until(func() -> bool: return _effects.refused == i + 1))
	equal(_got[end.link].size(), 1)
	var lines: String = "\n".join(PackedStringArray(_lines))
	equal(lines.count("not taken over"), 1, lines.left(600))
	contains(lines, "line 23: A vec4 has no part 'q0'")


func test_who_comes_later_gets_the_newest_only() -> void:
	var first: LinkPair.End = _join(Roles.Role.OBSERVER, "Bob")
	for i: int in 3:
		_save("fountain", EffectTexts.GOOD.replace("@count 50", "@count 6%d" % i))
		is_true(_pair.until(func() -> bool: return _got[first.link].size() == i + 1))
	var late: LinkPair.End = _join(Roles.Role.OBSERVER, "Cyd")
	is_true(_pair.until(func() -> bool: return not _got[late.link].is_empty()))
	contains(_last(late), "@count 62")
	_pair.run(0.2)
	equal(_got[late.link].size(), 1)


func test_an_instructor_sends_one_and_hears_what_became_of_it() -> void:
	var end: LinkPair.End = _join(Roles.Role.OBSERVER, "Bob")
	var control: InstructorControl = _instructor()
	is_true(control.send_effect("fountain", EffectTexts.GOOD) > 0)
	is_true(_pair.until(func() -> bool: return _last(end) == EffectTexts.GOOD))
	is_true(_pair.until(func() -> bool: return _answers.size() == 1))
	equal(_answers[0], "effect 'fountain': everybody gets it")
	control.send_effect("fountain", EffectTexts.GOOD.replace("@life 0.8", "@life long"))
	is_true(_pair.until(func() -> bool: return _answers.size() == 2))
	contains(_answers[1], "line 4: 'life' is a number, not 'long'")
	equal(_got[end.link].size(), 1)


func test_nobody_else_may_send_one() -> void:
	var trainee: LinkPair.End = _join(Roles.Role.TRAINEE, "Ada")
	InstructorControl.new(trainee.link).send_effect("fountain", EffectTexts.GOOD)
	is_true(_pair.until(func() -> bool: return _pair.server.refused.get("role", 0) > 0))
	equal([_effects.accepted, _effects.refused], [0, 0])


func test_many_at_once_are_refused() -> void:
	var control: InstructorControl = _instructor()
	for i: int in 40:
		control.send_effect("fountain", EffectTexts.GOOD)
	var is_told: Callable = func() -> bool:
		return "\n".join(_answers).contains("too soon: 'effect'")
	is_true(_pair.until(is_told))


func test_hostile_texts_end_at_the_server() -> void:
	var end: LinkPair.End = _join(Roles.Role.OBSERVER, "Bob")
	var hostile: PackedStringArray = [
		EffectTexts.of("", "while (true) { }"),
		EffectTexts.of("// @count 1000000000", ""),
		EffectTexts.of("// @texture ../../secret", ""),
		"(".repeat(60000),
		"",
		"\t".repeat(65536),
		EffectTexts.of('#include "res://x"', ""),
		EffectTexts.of("", "float a[1000000];"),
	]
	for i: int in hostile.size():
		_save("e%d" % i, hostile[i])
	_save("Bad Name", EffectTexts.GOOD)
	is_true(_pair.until(func() -> bool: return _effects.refused == hostile.size()))
	equal(_effects.accepted, 0)
	equal(_got[end.link].size(), 0)


func test_a_folder_that_is_not_there_is_named() -> void:
	equal(EffectFolder.new("/no/such").find_fault(), "--effects: there is no folder /no/such")
	equal(EffectFolder.new("").find_fault(), "")


func _join(p_role: Roles.Role, p_name: String) -> LinkPair.End:
	var end: LinkPair.End = _pair.add(p_role, p_name)
	var parts: EffectParts = EffectParts.new()
	_got[end.link] = []
	var texts: Array = _got[end.link]
	end.link.handle(
		Protocol.Message.EFFECT,
		MessageHandlers.Path.RELIABLE,
		func(bytes: PackedByteArray, _usec: int) -> bool:
			if parts.take(EffectMessage.decode(bytes)):
				texts.append(parts.bytes.get_string_from_utf8())
			return true
	)
	_pair.await_join(end)
	return end


func _instructor() -> InstructorControl:
	var end: LinkPair.End = _join(Roles.Role.INSTRUCTOR, "Ina")
	var control: InstructorControl = InstructorControl.new(end.link)
	control.answered.connect(func(answer: AnswerMessage) -> void: _answers.append(answer.text))
	return control


func _last(p_end: LinkPair.End) -> String:
	return "" if _got[p_end.link].is_empty() else _got[p_end.link][-1]


func _save(p_name: String, p_text: String) -> void:
	var file: FileAccess = FileAccess.open("%s/%s.gdshader" % [FOLDER, p_name], FileAccess.WRITE)
	file.store_string(p_text)
	file.close()


func _clean_up() -> void:
	if not DirAccess.dir_exists_absolute(FOLDER):
		return
	for file: String in DirAccess.get_files_at(FOLDER):
		DirAccess.remove_absolute(FOLDER.path_join(file))
	DirAccess.remove_absolute(FOLDER)
