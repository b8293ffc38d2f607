extends TestCase
## A client as a whole: it joins, it is left, and another one is begun in the same process, as a way
## back to a start screen needs it.

const LinkPair: GDScript = preload("res://tests/net/link_pair.gd")
const GreetingPart: GDScript = preload("greeting_part.gd")
const CLIENT: PackedScene = preload("res://scenes/client/client.tscn")
const FPS: int = 77

var _pair: LinkPair = null
var _codes: Array[int] = []
## What is listed besides the program's own.
var _more_parts: PackedStringArray = []
var _more_rows: Array[OptionRow] = []


func before_each() -> void:
	_codes.clear()
	_more_parts = []
	_more_rows = []
	_pair = LinkPair.new()
	_pair.rules.level_name = "hall"
	equal(_pair.listen(), OK)


func after_each() -> void:
	_pair.close()


func test_a_client_is_left_and_another_one_begun() -> void:
	var usual_fps: int = Engine.max_fps
	for time: int in 3:
		var client: Client = _begin("observer", ["--port=%d" % _pair.port, "--fps=%d" % FPS])
		await _until(func() -> bool: return _pair.joined.size() == time + 1)
		equal(Engine.max_fps, FPS)
		# As the window's menu does.
		(client.get_node(^"WindowControls/WindowMenu") as WindowMenu).leave_wanted.emit()
		await _until(func() -> bool: return _codes.size() == time + 1)
		equal(_codes[-1], StateStream.EXIT_DONE)
		client.free()
		equal(Engine.max_fps, usual_fps, "what it had set is as before")
		await _until(func() -> bool: return _pair.left.size() == time + 1)


func test_a_fault_of_any_part_ends_the_client_and_all_that_was_open() -> void:
	allow_error("--drive is")
	var client: Client = _begin("observer", ["--port=%d" % _pair.port, "--drive=1:2"])
	await _until(func() -> bool: return not _codes.is_empty())
	equal(_codes, [StateStream.EXIT_OPTIONS])
	client.free()
	equal(_pair.joined.size(), 0)


func test_a_part_needs_only_to_be_listed() -> void:
	var greeted: PackedStringArray = []
	_pair.server.handle(
		GreetingPart.KIND,
		MessageHandlers.Path.RELIABLE,
		func(session: Session, bytes: PackedByteArray, _arrival_usec: int) -> String:
			greeted.append(bytes.slice(1).get_string_from_utf8())
			_pair.server.send_reliably([session.id], bytes)
			return ""
	)
	_more_parts = [GreetingPart.resource_path]
	_more_rows = GreetingPart.rows()
	var client: Client = _begin("observer", ["--port=%d" % _pair.port, "--greet=Ada"])
	var note: Label = client.get_node(^"Hud").get(&"_note")
	await _until(func() -> bool: return note.text.contains("Greetings, Ada"))
	equal(greeted, PackedStringArray(["Ada"]))
	client.free()
	allow_error("--greet")
	client = _begin("observer", ["--port=%d" % _pair.port, "--greet=a/b"])
	await _until(func() -> bool: return not _codes.is_empty())
	equal(_codes, [StateStream.EXIT_OPTIONS])
	client.free()


func test_a_replay_without_a_file_says_what_it_lacks() -> void:
	allow_error("--file=FILE")
	var client: Client = _begin(ProgramRoles.REPLAY, [])
	await _until(func() -> bool: return not _codes.is_empty())
	equal(_codes, [StateStream.EXIT_FAILED])
	client.free()


func _begin(p_role: String, p_arguments: PackedStringArray) -> Client:
	var rows: Array[OptionRow] = ProgramOptions.rows() + _more_rows
	var options: Options = Options.parse(rows, p_arguments, p_role)
	equal(options.error, "")
	var client: Client = CLIENT.instantiate()
	client.configure(p_role, options, ProgramParts.of_client(p_role) + _more_parts)
	client.left.connect(func(code: int) -> void: _codes.append(code))
	add_child(client)
	return client


func _until(p_is_so: Callable) -> void:
	var end_msec: int = Time.get_ticks_msec() + int(LinkPair.PATIENCE_S * 1000.0)
	while not p_is_so.call() and Time.get_ticks_msec() < end_msec:
		_pair.server.poll()
		await process_frames(1)
	is_true(p_is_so.call())
