extends TestCase
## What a host chooses becomes the server's options.

var _server: HostedServer = null
var _choice: SessionChoice = null


func test_a_host_gets_the_server_that_the_screen_shows() -> void:
	var screen: HostScreen = HostScreen.new()
	add_child(screen)
	screen.host_wanted.connect(_on_wanted)
	_picker(screen).choose("yard")
	_option(screen, "Time").select(WorldConditions.TIMES.keys().find("night") + 1)
	_option(screen, "Weather").select(WorldConditions.WEATHERS.find("rain") + 1)
	_edit(screen, "Password").text = "two words"
	_edit(screen, "YourName").text = " Ann "
	(screen.find_child("OthersOnThisNetworkCanJoin", true, false) as Button).button_pressed = false
	(screen.find_child("Begin", true, false) as Button).pressed.emit()
	equal(_server.world, "yard")
	equal(_server.password, "two words")
	is_false(_server.is_on_network)
	is_false(_server.stays)
	equal(_server.more, PackedStringArray(["--time=night", "--weather=rain"]))
	equal(_choice.role, "trainee")
	equal(_choice.name, "Ann")
	equal(_choice.password, "two words")
	var options: Options = ProgramOptions.parse(_choice.arguments(), _choice.role)
	equal(options.error, "")
	options = ProgramOptions.parse(_server.more, "server")
	equal(options.error, "")
	screen.free()


func test_a_session_as_it_comes_needs_no_choice() -> void:
	var screen: HostScreen = HostScreen.new()
	add_child(screen)
	screen.host_wanted.connect(_on_wanted)
	screen.focus_first()
	equal(str(get_viewport().gui_get_focus_owner().name), "Begin")
	(screen.find_child("Begin", true, false) as Button).pressed.emit()
	equal(_server.world, LevelStore.DEFAULT)
	is_true(_server.is_on_network)
	equal(_server.more, PackedStringArray())
	screen.free()


func test_recordings_have_names_of_their_own() -> void:
	var first: String = SessionFiles.new_recording("yard")
	FileAccess.open(first, FileAccess.WRITE).store_string("x")
	var second: String = SessionFiles.new_recording("yard")
	is_true(first != second)
	is_true(SessionFiles.recordings().has(first))
	DirAccess.remove_absolute(first)
	is_false(SessionFiles.recordings().has(first))


func _on_wanted(p_server: HostedServer, p_choice: SessionChoice) -> void:
	_server = p_server
	_choice = p_choice


func _picker(p_screen: HostScreen) -> WorldPicker:
	return p_screen.find_children("*", "WorldPicker", true, false)[0]


func _option(p_screen: HostScreen, p_row: String) -> OptionButton:
	return p_screen.find_child(p_row, true, false).get_child(1)


func _edit(p_screen: HostScreen, p_row: String) -> LineEdit:
	return p_screen.find_child(p_row, true, false).get_child(1)
