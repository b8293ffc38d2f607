extends TestCase
## What the user asked for, by arguments and by the environment.

const VARIABLES: PackedStringArray = [
	"DISMOUNT_PORT", "DISMOUNT_MAX_CLIENTS", "DISMOUNT_NAME", "DISMOUNT_DURATION"
]


func after_each() -> void:
	for variable: String in VARIABLES:
		OS.unset_environment(variable)


func test_defaults() -> void:
	var options: Options = ProgramOptions.parse([])
	equal(options.error, "")
	equal(options.number("port"), 7777)
	equal(options.text("host"), "127.0.0.1")
	equal(options.seconds("duration"), 0.0)
	equal(options.text("views"), "mesh,static")


func test_arguments() -> void:
	var options: Options = ProgramOptions.parse(
		["--port=1234", "--name=Ada = Bob", "--duration=2.5", "--bvh=/a b/c.bvh", "--host="]
	)
	equal(options.error, "")
	equal(options.number("port"), 1234)
	equal(options.text("name"), "Ada = Bob")
	equal(options.seconds("duration"), 2.5)
	equal(options.text("bvh"), "/a b/c.bvh")
	equal(options.text("host"), "")


func test_environment_and_arguments_win() -> void:
	OS.set_environment("DISMOUNT_PORT", "2000")
	OS.set_environment("DISMOUNT_MAX_CLIENTS", "8")
	OS.set_environment("DISMOUNT_NAME", "Ada")
	OS.set_environment("DISMOUNT_DURATION", "3")
	var options: Options = ProgramOptions.parse(["--port=3000"])
	equal(options.error, "")
	equal([options.number("port"), options.number("max-clients")], [3000, 8])
	equal([options.text("name"), options.seconds("duration")], ["Ada", 3.0])


func test_every_option_has_both_forms() -> void:
	var choices: Dictionary[String, String] = {
		"codec": "float",
		"feedback": "server",
		"smoothing": "linear",
		"pose-error": "0.5",
		"suit-rate": "50",
		"calibrate": "full",
	}
	for row: Array in ProgramOptions.TABLE:
		var value: String = choices.get(row[0], "7" if row[1] is not String else "x")
		var options: Options = ProgramOptions.parse(["--%s=%s" % [row[0], value]])
		equal(options.error, "", row[0])
		var variable: String = "DISMOUNT_" + (row[0] as String).to_upper().replace("-", "_")
		OS.set_environment(variable, value)
		var same: Options = ProgramOptions.parse([])
		OS.unset_environment(variable)
		equal(same._values[row[0]], options._values[row[0]], row[0])
		equal(typeof(same._values[row[0]]), typeof(row[1]), row[0])
		not_equal(same._values[row[0]], row[1], row[0])


func test_bad_values_are_named() -> void:
	var cases: Dictionary[String, String] = {
		"--port=abc": "--port expects a whole number, found 'abc'",
		"--port=": "--port expects a whole number, found ''",
		"--port=12.5": "--port expects a whole number, found '12.5'",
		"--port=-1": "--port expects a whole number, found '-1'",
		"--port=0": "a port is between 1 and 65535, found 0",
		"--port=65536": "a port is between 1 and 65535, found 65536",
		"--rate=0": "a rate is between 1 and 240, found 0",
		"--rate=241": "a rate is between 1 and 240, found 241",
		"--max-clients=0": "between 1 and",
		"--max-clients=100000": "between 1 and",
		"--duration=soon": "--duration expects seconds, found 'soon'",
		"--duration=-1": "--duration expects seconds, found '-1'",
		"--duration=1e999": "--duration expects seconds, found '1e999'",
		"--feedback=both": "--feedback is one of local, server, found 'both'",
		"--smoothing=best": "adaptive_low_delay, found 'best'",
		"--fps=2000": "--fps is at most 1000, found 2000",
		"--nonsense=1": "there is no option --nonsense",
		"--port": "'--port' is not of the form --name=value",
		"port=7": "'port=7' is not of the form --name=value",
		"-p=7": "'-p=7' is not of the form --name=value",
		"7777": "'7777' is not of the form --name=value",
		"": "'' is not of the form --name=value",
	}
	for argument: String in cases:
		contains(ProgramOptions.parse([argument]).error, cases[argument], argument)


func test_numbers_too_large_for_the_machine() -> void:
	for argument: String in [
		"--port=99999999999999999999999", "--max-clients=99999999999999999999"
	]:
		not_equal(ProgramOptions.parse([argument]).error, "", argument)


func test_the_first_fault_is_told() -> void:
	contains(ProgramOptions.parse(["--port=x", "--rate=y"]).error, "--port")


func test_bad_environment_names_the_variable() -> void:
	OS.set_environment("DISMOUNT_PORT", "abc")
	contains(ProgramOptions.parse([]).error, "DISMOUNT_PORT expects a whole number, found 'abc'")


func test_help_has_every_option() -> void:
	for row: Array in ProgramOptions.TABLE:
		contains(ProgramOptions.describe(), "--%s=" % row[0])
		contains(ProgramOptions.describe(), row[2])
