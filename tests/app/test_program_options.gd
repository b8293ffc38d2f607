extends TestCase
## What the user asked for, by arguments and by the environment.

const VARIABLES: PackedStringArray = [
	"DISMOUNT_PORT", "DISMOUNT_MAX_CLIENTS", "DISMOUNT_NAME", "DISMOUNT_DURATION", "DISMOUNT_BVH"
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
	for row: OptionRow in ProgramOptions.rows():
		equal(options._values[row.name], row.default_value, row.name)
		if row.kind != OptionRow.Kind.TEXT and row.describe_default() != "":
			equal(row.find_fault(str(row.default_value)), "", row.name)


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


func test_values_may_stand_by_themselves() -> void:
	var options: Options = ProgramOptions.parse(
		["--port", "1234", "--vmc-out", "--xbus", "--rate", "30", "--name", "Ada = Bob"]
	)
	equal(options.error, "")
	equal([options.number("port"), options.number("rate")], [1234, 30])
	equal([options.text("vmc-out"), options.is_on("xbus")], ["127.0.0.1:39539", true])
	equal(options.text("name"), "Ada = Bob")
	equal(ProgramOptions.parse(["--vmc-out", "host:50"]).text("vmc-out"), "host:50")


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
	for row: OptionRow in ProgramOptions.rows():
		var value: String = _another_value(row)
		var options: Options = ProgramOptions.parse(["--%s=%s" % [row.name, value]])
		equal(options.error, "", row.name)
		OS.set_environment(row.variable(), value)
		var same: Options = ProgramOptions.parse([])
		OS.unset_environment(row.variable())
		equal(same._values[row.name], options._values[row.name], row.name)
		equal(typeof(same._values[row.name]), typeof(row.default_value), row.name)
		not_equal(same._values[row.name], row.default_value, row.name)


func test_every_option_refuses_what_is_out_of_range() -> void:
	for row: OptionRow in ProgramOptions.rows():
		var bad: PackedStringArray = []
		match row.kind:
			OptionRow.Kind.NUMBER, OptionRow.Kind.FLAG:
				bad = [
					str(int(row.lowest) - 1),
					str(int(row.highest) + 1),
					"",
					"x",
					"1.5",
					"9".repeat(30)
				]
			OptionRow.Kind.DECIMAL:
				bad = [str(row.lowest - 0.01), str(row.highest * 1.01), "", "x", "1e999", "nan"]
			OptionRow.Kind.CHOICE, OptionRow.Kind.CHOICES:
				bad = ["nothing of the kind", "%s,sky" % row.choices[0]]
		for value: String in bad:
			var error: String = ProgramOptions.parse(["--%s=%s" % [row.name, value]]).error
			is_true(error.begins_with("--%s " % row.name), "%s=%s: %s" % [row.name, value, error])
			contains(error, "found '%s'" % value, row.name)
			contains(error, row.describe_range() if row.kind != OptionRow.Kind.FLAG else "0 or 1")


func test_bad_values_are_named() -> void:
	var cases: Dictionary[String, String] = {
		"--port=abc": "--port expects a whole number, 1 to 65535, found 'abc'",
		"--port=0": "--port is 1 to 65535, found '0'",
		"--port=-1": "--port is 1 to 65535, found '-1'",
		"--duration=soon": "--duration expects a number, 0 to 10000000 s, found 'soon'",
		"--pose-error=9": "--pose-error is 0.02 to 5 degrees, found '9'",
		"--feedback=both": "--feedback is one of local, server, found 'both'",
		"--views=mesh,sky": "--views is any of mesh, static, physics, with commas between, found",
		"--xbus=2": "--xbus is 0 or 1, found '2'",
		"--name=" + "a".repeat(33): "--name has at most 32 characters, found 33",
		"--nonsense=1": "there is no option --nonsense",
		"--port": "--port expects a value: --port=NUMBER",
		"port=7": "'port=7' is no option: write --name=value",
		"-p=7": "'-p=7' is no option",
		"7777": "'7777' is no option",
		"": "'' is no option",
	}
	for argument: String in cases:
		contains(ProgramOptions.parse([argument]).error, cases[argument], argument)


func test_a_role_refuses_what_is_not_for_it() -> void:
	var error: String = ProgramOptions.parse(["--bvh=a.bvh"], "server").error
	equal(error, "--bvh is for trainee, load, not for server")
	for role: String in ProgramRoles.names():
		for row: OptionRow in ProgramOptions.rows():
			var option: String = "--%s=%s" % [row.name, _another_value(row)]
			error = ProgramOptions.parse([option], role).error
			if row.roles.has(role):
				equal(error, "", role + row.name)
			else:
				contains(error, "--%s is for " % row.name, role)


func test_a_role_passes_over_the_environment_of_others() -> void:
	OS.set_environment("DISMOUNT_BVH", "a.bvh")
	OS.set_environment("DISMOUNT_MAX_CLIENTS", "nonsense")
	OS.set_environment("DISMOUNT_PORT", "2000")
	var options: Options = ProgramOptions.parse([], "observer")
	equal([options.error, options.text("bvh"), options.number("port")], ["", "", 2000])
	equal(ProgramOptions.parse([], "trainee").text("bvh"), "a.bvh")
	contains(ProgramOptions.parse([], "server").error, "DISMOUNT_MAX_CLIENTS expects")


func test_the_first_fault_is_reported() -> void:
	contains(ProgramOptions.parse(["--port=x", "--rate=y"]).error, "--port")


func test_files_count_from_where_the_program_was_started() -> void:
	equal(Options.full_path("a/b.bvh"), OS.get_environment("PWD").path_join("a/b.bvh"))
	equal(Options.full_path("/a/b.bvh"), "/a/b.bvh")
	equal(Options.full_path("~/b.bvh"), OS.get_environment("HOME").path_join("b.bvh"))
	equal(Options.full_path("res://b.bvh"), "res://b.bvh")
	equal(Options.full_path(""), "")


func test_which_role_is_meant() -> void:
	equal(ProgramRoles.find_in(["--role=server", "--port=1"]), "server")
	equal(ProgramRoles.find_in(["--role", "trainee"]), "trainee")
	equal(ProgramRoles.find_in(["--port=1"]), "observer")
	OS.set_environment("DISMOUNT_ROLE", "instructor")
	equal(ProgramRoles.find_in([]), "instructor")
	equal(ProgramRoles.find_in(["--role=server"]), "server")
	OS.unset_environment("DISMOUNT_ROLE")


func test_every_role_has_parts_and_a_meaning() -> void:
	for role: String in ProgramRoles.names():
		var parts: PackedStringArray = ProgramParts.of_client(role)
		if role == ProgramRoles.SERVER:
			parts = ProgramParts.SERVER
		for path: String in parts:
			is_true(ResourceLoader.exists(path), path)
		not_equal(ProgramRoles.describe(role), "", role)


func test_help_of_a_role_has_its_options_and_no_others() -> void:
	for role: String in ProgramRoles.names():
		var help: String = OptionsHelp.describe(role).replace("\n", " \n")
		for line: String in help.split("\n"):
			is_true(line.length() <= 101, line)
		# Meanings are broken into lines.
		var words: String = " ".join(help.replace("\n", " ").split(" ", false))
		for row: OptionRow in ProgramOptions.rows():
			equal(help.contains("\n  %s " % row.usage()), row.roles.has(role), role + row.name)
			if row.roles.has(role):
				contains(words, row.meaning)


func test_help_without_a_role_has_everything() -> void:
	var help: String = OptionsHelp.describe("").replace("\n", " \n")
	for row: OptionRow in ProgramOptions.rows():
		contains(help, "\n  %s " % row.usage())
	for role: String in ProgramRoles.names():
		contains(help, "\n  %s " % role)


## A value that an option can have, and has not by default.
func _another_value(p_row: OptionRow) -> String:
	if p_row.name == Options.CONFIG:
		# It is read: any file without lines will do.
		return ProjectSettings.globalize_path("res://build/.gdignore")
	match p_row.kind:
		OptionRow.Kind.FLAG:
			return "0" if p_row.default_value == 1 else "1"
		OptionRow.Kind.NUMBER, OptionRow.Kind.DECIMAL:
			var other: int = 7 if p_row.default_value != 7 else 5
			var fits: bool = p_row.lowest <= other and p_row.highest >= other
			return str(other if fits else int(p_row.highest))
		OptionRow.Kind.CHOICE, OptionRow.Kind.CHOICES:
			return p_row.choices[-1 if p_row.choices[-1] != p_row.default_value else 0]
	return "x"
