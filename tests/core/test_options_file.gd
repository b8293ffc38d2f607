extends TestCase
## Files of options: what is read, and that each mistake is named with its line.

var _rows: Dictionary[String, OptionRow] = {}


func before_each() -> void:
	for row: OptionRow in ProgramOptions.rows():
		_rows[row.name] = row


func _parse(p_text: String, p_role: String = "server") -> OptionsFile:
	return OptionsFile.parse(p_text.to_utf8_buffer(), "a.cfg", _rows, p_role)


func test_lines_headings_comments_and_quotation_marks() -> void:
	var file: OptionsFile = _parse(
		(
			'; a comment\n# another\n\nport=7000\n[server]\n  max-clients = 8 \r\npassword="a ; b"\n'
			+ "waiting-room = true\n[trainee]\nname = Ada\n[all]\nduration = 2.5\nviews = mesh\n"
		)
	)
	equal(file.describe_faults(), "")
	equal(
		file.values,
		{
			"port": "7000",
			"max-clients": "8",
			"password": "a ; b",
			"waiting-room": "1",
			"duration": "2.5"
		}
	)
	var other: OptionsFile = _parse(
		"[server]\nport=1\n[trainee]\nname = Ada\nxbus = true", "trainee"
	)
	equal(other.values, {"name": "Ada", "xbus": "1"})


func test_every_mistake_is_named_with_its_line() -> void:
	var file: OptionsFile = _parse(
		(
			"max-client = 8\nport = 99999\nnonsense\n\n[servr]\nport=1\n[server]\nxbus = 1\nport = 2\n"
			+ 'port = 3\npassword = "open\nworld = hal\nrole = server'
		)
	)
	var lines: PackedStringArray = file.faults
	for expected: String in [
		"a.cfg:1: there is no option max-client: did you mean max-clients?",
		"a.cfg:2: port is 1 to 65535, found '99999'",
		"a.cfg:3: write name = value, found 'nonsense'",
		"a.cfg:5: there is no heading [servr]: did you mean server?",
		"a.cfg:8: xbus is for trainee, not for server",
		"a.cfg:10: port is given twice, see line 9",
		"a.cfg:11: a quotation mark is missing",
		"a.cfg:13: role is given in the command line",
	]:
		is_true(lines.has(expected), "%s not in\n%s" % [expected, "\n".join(lines)])
	contains(file.describe_faults(), "more")
	equal(file.describe_faults().split("\n").size(), OptionsFile.MAX_FAULTS + 1)


func test_other_roles_lines_are_checked_too() -> void:
	contains(_parse("[trainee]\nrate = fast").describe_faults(), "a.cfg:2: rate expects")


func test_a_file_that_is_not_there_or_no_text() -> void:
	contains(OptionsFile.read("/no/such", _rows, "server").describe_faults(), "/no/such")
	var noise: PackedByteArray = [0, 1, 2]
	contains(OptionsFile.parse(noise, "a.cfg", _rows, "server").describe_faults(), "no text")
	var long: PackedByteArray = []
	long.resize(OptionsFile.MAX_BYTES + 1)
	long.fill(10)
	contains(OptionsFile.parse(long, "a.cfg", _rows, "server").describe_faults(), "at most")


func test_any_text_is_read_or_refused() -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 5
	var pieces: PackedStringArray = ["[", "]", "=", '"', "\n", ";", "#", "\\", " ", "é", "--"]
	pieces.append_array(["port", "max-clients", "server", "all", "8", "true", "[server]\n"])
	var names: Array[String] = _rows.keys()
	for _round: int in 400:
		var text: String = "%s = 1\n" % names[random.randi() % names.size()]
		for _piece: int in random.randi_range(0, 30):
			text += pieces[random.randi() % pieces.size()]
		var file: OptionsFile = _parse(text)
		for name: String in file.values:
			equal(_rows[name].find_fault(file.values[name]), "", text)


func test_arguments_win_over_environment_and_that_over_the_file() -> void:
	var path: String = ProjectSettings.globalize_path("user://test_options.cfg")
	var file: FileAccess = FileAccess.open(path, FileAccess.WRITE)
	file.store_string("port = 1000\nmax-clients = 5\nduration = 3\n")
	file.close()
	OS.set_environment("DISMOUNT_MAX_CLIENTS", "6")
	OS.set_environment("DISMOUNT_DURATION", "4")
	var options: Options = ProgramOptions.parse(["--config", path, "--duration=5"], "server")
	OS.unset_environment("DISMOUNT_MAX_CLIENTS")
	OS.unset_environment("DISMOUNT_DURATION")
	equal(options.error, "")
	equal([options.number("port"), options.number("max-clients")], [1000, 6])
	equal(options.seconds("duration"), 5.0)
	file = FileAccess.open(path, FileAccess.WRITE)
	file.store_string("port = 1000\nmax-clients = 7\n")
	file.close()
	var again: Options = options.reread()
	equal(again.find_changes(options), PackedStringArray(["max-clients"]))
	equal(again.number("max-clients"), 7)
	DirAccess.remove_absolute(path)
	contains(options.reread().error, "cannot be read")
