extends TestCase
## The start screen by keyboard alone: everything can be reached, opened and left.


func after_each() -> void:
	get_window().content_scale_factor = 1.0


func test_the_keyboard_reaches_every_choice() -> void:
	var shell: AppShell = _open()
	var seen: PackedStringArray = []
	for step: int in 20:
		seen.append(str(get_viewport().gui_get_focus_owner().name))
		await _press(KEY_DOWN)
	for choice: String in ["Join", "Host", "Watch", "Instruct", "Review", "TryIt", "Quit"]:
		is_true(seen.has(choice), choice)
	shell.free()


func test_each_screen_opens_and_esc_leads_back_to_its_choice() -> void:
	var shell: AppShell = _open()
	for screen: StringName in AppShell.SCREENS:
		var choice: Button = shell.find_child(str(screen).to_pascal_case(), true, false)
		choice.grab_focus()
		await _press(KEY_ENTER)
		var shown: Array[Node] = shell.find_children("*", "ShellScreen", true, false)
		equal(shown.size(), 1, screen)
		not_null(get_viewport().gui_get_focus_owner(), screen)
		is_true(shown[0].is_ancestor_of(get_viewport().gui_get_focus_owner()), screen)
		await _press(KEY_ESCAPE)
		equal(shell.find_children("*", "ShellScreen", true, false).size(), 0, screen)
		equal(get_viewport().gui_get_focus_owner(), choice, screen)
	shell.free()


func test_esc_leads_back_from_a_text_that_is_being_written() -> void:
	var shell: AppShell = _open()
	shell.open(&"join")
	for field: Node in shell.find_children("*", "LineEdit", true, false):
		if (field as LineEdit).secret:
			(field as LineEdit).grab_focus()
			(field as LineEdit).edit()
	is_true((get_viewport().gui_get_focus_owner() as LineEdit).is_editing())
	await _press(KEY_ESCAPE)
	equal(shell.find_children("*", "ShellScreen", true, false).size(), 0)
	shell.free()


func test_watching_and_instructing_are_joining_as_what_they_say() -> void:
	var shell: AppShell = _open()
	var roles: PackedStringArray = []
	shell.session_wanted.connect(func(choice: SessionChoice) -> void: roles.append(choice.role))
	for screen: StringName in [&"join", &"watch", &"instruct"]:
		shell.open(screen)
		var join: JoinScreen = shell.find_children("*", "JoinScreen", true, false)[0]
		var other: SessionChoice = SessionChoice.new()
		other.host = "127.0.0.1"
		other.role = "nobody"
		join.take(other)
		(join.find_child("Join", true, false) as Button).pressed.emit()
	equal(roles, PackedStringArray(["trainee", "observer", "instructor"]))
	shell.free()


func test_a_refusal_leads_back_to_joining_as_it_was() -> void:
	var shell: AppShell = _open()
	var choice: SessionChoice = SessionChoice.new()
	choice.role = "trainee"
	choice.host = "example.org"
	choice.port = 7790
	choice.name = "Ann"
	shell.show_screen(RefusalScreen.new(choice, "the password is wrong"))
	await _press(KEY_ENTER)
	var joins: Array[Node] = shell.find_children("*", "JoinScreen", true, false)
	equal(joins.size(), 1)
	var texts: PackedStringArray = []
	for edit: Node in joins[0].find_children("*", "LineEdit", true, false):
		texts.append((edit as LineEdit).text)
	is_true(texts.has("example.org:7790"), str(texts))
	is_true(texts.has("Ann"), str(texts))
	shell.free()


func test_quit_and_a_closed_window_end_the_program() -> void:
	var shell: AppShell = _open()
	var codes: PackedInt32Array = []
	shell.left.connect(func(code: int) -> void: codes.append(code))
	(shell.find_child("Quit", true, false) as Button).pressed.emit()
	shell.notification(NOTIFICATION_WM_CLOSE_REQUEST)
	equal(codes, PackedInt32Array([0, 0]))
	shell.free()


func _open() -> AppShell:
	var shell: AppShell = AppShell.new()
	# Tests ask this machine only.
	shell.looks_on_networks = false
	add_child(shell)
	return shell


func _press(p_key: Key) -> void:
	for is_down: bool in [true, false]:
		var event: InputEventKey = InputEventKey.new()
		event.keycode = p_key
		event.physical_keycode = p_key
		event.pressed = is_down
		Input.parse_input_event(event)
		Input.flush_buffered_events()
		await get_tree().process_frame
