extends TestCase
## The command that starts the program again, with a headset or as a window.


func test_a_users_arguments_stay_as_they_are() -> void:
	var user: PackedStringArray = ["--", "--display=hmd", "--name=A B", "--xr-mode", "x"]
	var command: HmdCommand = HmdCommand.of("/opt/game", user, "/home/me")
	var with_headset: PackedStringArray = command.with_headset()
	equal(with_headset[0], "/opt/game")
	equal(with_headset.slice(-5), user)
	equal(" ".join(with_headset.slice(1, 5)), "--xr-mode on --rendering-method mobile")


func test_flags_of_an_earlier_start_are_replaced() -> void:
	var arguments: PackedStringArray = [
		"--rendering-method", "gl_compatibility", "--xr-mode", "off", "--resolution", "640x360"
	]
	var made: PackedStringArray = HmdCommand.of("/g", arguments, "/").with_headset()
	equal(made.count("--xr-mode"), 1)
	equal(made.count("--rendering-method"), 1)
	is_false(made.has("gl_compatibility"))
	equal(made.slice(-2), PackedStringArray(["--resolution", "640x360"]))
	var again: PackedStringArray = HmdCommand.of("/g", made.slice(1), "/").with_window()
	equal(again.count("--xr-mode"), 1)
	is_true(again.has("off") and not again.has("on"))


func test_a_window_has_the_users_own_renderer() -> void:
	var arguments: PackedStringArray = ["--rendering-method", "gl_compatibility"]
	var command: HmdCommand = HmdCommand.of("/g", arguments, "/")
	equal(command.renderer, "gl_compatibility")
	is_true(command.with_window().has("gl_compatibility"))
	var plain: HmdCommand = HmdCommand.of("/g", [], "/")
	equal(plain.renderer, "")
	is_true(plain.with_window().has("mobile"))


func test_the_process_with_the_headset_knows_the_users_renderer() -> void:
	OS.set_environment(HmdCommand.RENDERER, "forward_plus")
	is_true(HmdCommand.of_this_process().with_window().has("forward_plus"))
	OS.unset_environment(HmdCommand.RENDERER)


func test_a_program_that_is_gone_is_not_started() -> void:
	is_false(HmdCommand.of("/nonexistent/game", [], "/").is_there())
	is_true(HmdCommand.of_this_process().is_there())


func test_relative_folders_are_those_of_the_user() -> void:
	var arguments: PackedStringArray = ["--path", "../project", "scene.tscn"]
	var made: PackedStringArray = HmdCommand.of("/g", arguments, "/home/me/x").with_window()
	equal(made.slice(-3), PackedStringArray(["--path", "/home/me/project", "scene.tscn"]))


func test_this_process_knows_how_it_was_started() -> void:
	var made: PackedStringArray = HmdCommand.of_this_process().with_window()
	equal(made[0], OS.get_executable_path())
	is_true(made.has("--headless"), " ".join(made))
