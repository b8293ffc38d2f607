extends TestCase
## Proves that the runner catches what it promises to catch, by running it on the fixtures.

const RUNNER: String = "res://tests/framework/test_runner.gd"
const FIXTURES: String = "res://tests/framework/fixtures/"

var _output: String = ""
var _exit_code: int = 0


func test_passes_what_is_good() -> void:
	_run_on([FIXTURES + "good.gd"])
	equal(_exit_code, 0, _output)
	contains(_output, "ok   framework/fixtures/good.gd  test_waits_for_physics  (")
	contains(_output, "7 passed, 0 failed")


func test_frames_of_who_goes_by_the_clock_take_their_time() -> void:
	_run_on([FIXTURES + "clock.gd"])
	equal(_exit_code, 0, _output)


func test_fails_each_kind_of_fault() -> void:
	_run_on([FIXTURES + "bad.gd"])
	equal(_exit_code, 1)
	contains(_output, "0 passed, 17 failed")
	_has_fault(
		"test_false_check", "the note: expected 2, got 1 (tests/framework/fixtures/bad.gd:6)"
	)
	_has_fault("test_type_differs", "expected 1.0, got 1")
	_has_fault("test_nan_is_not_almost_equal", "difference nan")
	_has_fault("test_nan_in_vector", "difference nan")
	_has_fault("test_vector_too_far", "within 0.01")
	_has_fault("test_array_sizes_differ", "difference inf")
	_has_fault("test_fails_by_hand", "by hand (tests/framework/fixtures/bad.gd:")
	_has_fault("test_checks_nothing", "checks nothing")
	_has_fault("test_script_error", "Nonexistent function 'call_it'")
	_has_fault("test_script_error", "(tests/framework/fixtures/bad.gd:40)")
	_has_fault("test_script_error_after_await", "Invalid assignment of index '3'")
	_has_fault("test_pushed_error", "error: pushed (tests/framework/fixtures/bad.gd:")
	_has_fault("test_engine_error", "no_such_file.tres")
	_has_fault("test_error_in_thread", "error: from a thread")
	_has_fault("test_deferred_error", "error: later")
	_has_fault("test_missing_error", 'the expected error "never comes" was not reported')
	_has_fault("test_wrong_error", "error: that one")
	_has_fault("test_many_failures", "and 30 more")


func test_names_what_is_left() -> void:
	_run_on([FIXTURES + "leaky.gd"])
	equal(_exit_code, 1)
	contains(_output, "1 passed, 1 failed")
	_has_fault("test_leaves_a_node", "left 1 node outside the tree")
	# What ./test takes for a failure, see find_leaks in tools/toolchain/testing.py.
	contains(_output, "WARNING: ObjectDB instances leaked at exit")


func test_fails_set_up_and_tear_down() -> void:
	_run_on([FIXTURES + "bad_setup.gd"])
	equal(_exit_code, 1)
	_has_fault("test_itself_is_fine", "error: before")
	_has_fault("test_itself_is_fine", "after (tests/framework/fixtures/bad_setup.gd:")


func test_stops_what_takes_too_long() -> void:
	_run_on([FIXTURES + "slow.gd"])
	equal(_exit_code, 1)
	_has_fault("test_awaits_for_ever", "took longer than 0.3 s")
	_has_fault("test_blocks_a_little", "took longer than 0.3 s")
	contains(_output, "ok   framework/fixtures/slow.gd  test_runs_after_it")
	contains(_output, "1 passed, 2 failed")


func test_names_what_hangs() -> void:
	var current: String = "user://current_test.txt"
	_run_on([FIXTURES + "hang.gd", "--current=" + current])
	not_equal(_exit_code, 0)
	contains(_output, "FAIL framework/fixtures/hang.gd  test_blocks_for_ever  blocks the main")
	var name: String = FileAccess.get_file_as_string(current)
	equal(name, "framework/fixtures/hang.gd  test_blocks_for_ever")


func test_fails_files_that_are_no_tests() -> void:
	var broken: String = "user://broken_test.gd"
	var file: FileAccess = FileAccess.open(broken, FileAccess.WRITE)
	file.store_string("extends TestCase\n\nfunc test_x( -> void:\n\tpass\n")
	file.close()
	var missing: String = FIXTURES + "missing.gd"
	_run_on([broken, missing, FIXTURES + "empty.gd", FIXTURES + "no_case.gd", "res://no_folder"])
	equal(_exit_code, 1)
	_has_fault("user://broken_test.gd", "cannot be loaded")
	_has_fault("missing.gd", "cannot be loaded")
	_has_fault("empty.gd", "has no test_ method")
	_has_fault("no_case.gd", "does not extend TestCase")
	_has_fault("no_folder", "there is no such file or folder")
	contains(_output, "0 passed, 5 failed")


func test_fails_when_nothing_matches() -> void:
	_run_on([FIXTURES + "good.gd", "--filter=no such test"])
	equal(_exit_code, 1)
	contains(_output, "no test matches")


func test_shares_files_with_other_runners() -> void:
	var claims: String = "user://claims_%d" % OS.get_process_id()
	DirAccess.make_dir_absolute(claims)
	_run_on([FIXTURES + "good.gd", "--claims=" + claims])
	equal(_exit_code, 0)
	_run_on([FIXTURES + "good.gd", "--claims=" + claims])
	contains(_output, "no test matches")
	for folder: String in DirAccess.get_directories_at(claims):
		DirAccess.remove_absolute(claims.path_join(folder))
	DirAccess.remove_absolute(claims)


func test_rejects_unknown_options() -> void:
	_run_on(["--fliter=x"])
	equal(_exit_code, 2)
	contains(_output, "unknown option --fliter=x")


func test_filters_and_writes_junit() -> void:
	var report: String = "user://junit.xml"
	_run_on([FIXTURES + "bad.gd", "--filter=test_false_check", "--junit=" + report])
	contains(_output, "0 passed, 1 failed")
	var xml: XMLParser = XMLParser.new()
	equal(xml.open(report), OK)
	var seen: PackedStringArray = PackedStringArray()
	while xml.read() == OK:
		if xml.get_node_type() == XMLParser.NODE_ELEMENT:
			seen.append(xml.get_node_name())
			if xml.get_node_name() == "testcase":
				equal(xml.get_named_attribute_value("name"), "test_false_check")
	equal(seen, PackedStringArray(["testsuite", "testcase", "failure"]))


func _run_on(p_arguments: Array[String]) -> void:
	var command: PackedStringArray = [
		"--headless", "--fixed-fps", "60", "--path", ProjectSettings.globalize_path("res://")
	]
	command.append_array(["-s", RUNNER, "--"])
	command.append_array(p_arguments)
	var lines: Array = []
	_exit_code = OS.execute(OS.get_executable_path(), command, lines, true)
	_output = "\n".join(lines)


func _has_fault(p_test: String, p_text: String) -> void:
	var inside: bool = false
	for line: String in _output.split("\n"):
		if line.begins_with("FAIL ") or line.begins_with("ok   "):
			inside = line.begins_with("FAIL ") and line.contains(p_test + "  (")
		elif inside and line.contains(p_text):
			is_true(true)
			return
	fail("%s does not fail with '%s' in\n%s" % [p_test, p_text, _output])
