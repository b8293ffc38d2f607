extends SceneTree
## Runs the project's GDScript tests; see README.md beside this file.
##
## [codeblock lang=text]
## godot --headless --path . -s tests/framework/test_runner.gd -- [options] [file or folder ...]
##   --filter=TEXT      only tests whose "file test_name" contains TEXT
##   --junit=FILE       also write a JUnit XML report
##   --current=FILE     keep the name of the test that runs in FILE
##   --claims=FOLDER    share the files with other runners that are given the same empty folder
##   --time-limit=S     time limit of tests that do not set one, s (600)
## [/codeblock]
## Exit code: 0 if every test passed, 1 if any failed, 2 if the call is wrong.

const ErrorTrap: GDScript = preload("error_trap.gd")
const HangGuard: GDScript = preload("hang_guard.gd")
const JunitReport: GDScript = preload("junit_report.gd")
const OWN_FILES: PackedStringArray = ["test_case.gd", "test_runner.gd"]
const CLASS_CACHE: String = "res://.godot/global_script_class_cache.cfg"
## A test that blocks the main thread may take this many times its limit before the run is killed.
const HANG_FACTOR: float = 2.0
## A frame of a test that goes by the clock, µs.
const FRAME_USEC: int = 16667

var _paths: PackedStringArray = PackedStringArray()
var _filter: String = ""
var _junit_path: String = ""
var _current_path: String = ""
var _claims: String = ""
var _default_limit: float = 600.0
var _trap: Logger = ErrorTrap.new()
var _guard: RefCounted = HangGuard.new()
var _results: Array[Dictionary] = []
# Frames of the test that runs wait for the clock.
var _is_paced: bool = false
var _frame_usec: int = 0


func _initialize() -> void:
	if not _read_arguments():
		quit(2)
		return
	if not FileAccess.file_exists(CLASS_CACHE):
		printerr("test runner: no class cache; run 'godot --headless --path . --import' first")
		quit(2)
		return
	OS.add_logger(_trap)
	_guard.call("start")
	_run()


func _process(_p_delta: float) -> bool:
	if _is_paced:
		OS.delay_usec(maxi(0, _frame_usec + FRAME_USEC - Time.get_ticks_usec()))
		_frame_usec = Time.get_ticks_usec()
	return false


func _run() -> void:
	await process_frame
	for path: String in _find_files():
		if _may_match(path) and _claim(path):
			await _run_file(path)
	await _await_mixer()
	_guard.call("stop")
	OS.remove_logger(_trap)
	if _results.is_empty():
		printerr("test runner: no test matches")
	var failed: int = 0
	for result: Dictionary in _results:
		failed += 0 if result["message"].is_empty() else 1
	if not _junit_path.is_empty() and not JunitReport.write(_junit_path, _results):
		printerr("test runner: %s cannot be written" % _junit_path)
		failed += 1
	_note_current("")
	print("%d passed, %d failed" % [_results.size() - failed, failed])
	quit(0 if failed == 0 and not _results.is_empty() else 1)


## The mixer, a thread of its own, lets go of a sound that has ended when it mixes next, and the
## main thread frees it in the frame after that: what plays when the engine ends counts as leaked.
func _await_mixer() -> void:
	for _mix: int in 2:
		var before: float = -1.0
		while AudioServer.get_time_since_last_mix() > before:
			before = AudioServer.get_time_since_last_mix()
			await process_frame
	await process_frame


func _read_arguments() -> bool:
	for argument: String in OS.get_cmdline_user_args():
		var value: String = argument.get_slice("=", 1)
		if argument.begins_with("--filter="):
			_filter = value
		elif argument.begins_with("--junit="):
			_junit_path = value
		elif argument.begins_with("--current="):
			_current_path = value
		elif argument.begins_with("--claims="):
			_claims = value
		elif argument.begins_with("--time-limit=") and value.is_valid_float():
			_default_limit = value.to_float()
		elif argument.begins_with("-"):
			printerr("test runner: unknown option %s" % argument)
			return false
		else:
			_paths.append(argument if argument.contains("://") else "res://" + argument)
	if _paths.is_empty():
		_paths.append("res://tests")
	return true


func _find_files() -> PackedStringArray:
	var files: PackedStringArray = PackedStringArray()
	for path: String in _paths:
		if path.get_extension() == "gd":
			files.append(path)
		elif DirAccess.dir_exists_absolute(path):
			_collect(path.trim_suffix("/"), files)
		else:
			_report(path, "(folder)", 0.0, "there is no such file or folder")
	return files


func _collect(p_folder: String, p_files: PackedStringArray) -> void:
	var names: PackedStringArray = DirAccess.get_files_at(p_folder)
	names.sort()
	for file: String in names:
		var is_test: bool = file.begins_with("test_") and file.get_extension() == "gd"
		if is_test and not file in OWN_FILES:
			p_files.append(p_folder.path_join(file))
	var folders: PackedStringArray = DirAccess.get_directories_at(p_folder)
	folders.sort()
	for folder: String in folders:
		_collect(p_folder.path_join(folder), p_files)


## Whether this runner is the first of those who share the files to come to this one.
func _claim(p_path: String) -> bool:
	# Making a folder is atomic.
	return (
		_claims.is_empty()
		or DirAccess.make_dir_absolute(_claims.path_join(p_path.md5_text())) != ERR_ALREADY_EXISTS
	)


## Whether a file may hold a test that matches: to load them all takes longer than most tests.
func _may_match(p_path: String) -> bool:
	if _filter.is_empty():
		return true
	for line: String in FileAccess.get_file_as_string(p_path).split("\n"):
		var words: PackedStringArray = line.split(" ")
		if line.begins_with('extends "'):
			# What it inherits are its own tests too.
			var base: String = words[1].replace('"', "")
			if _may_match(
				base if base.is_absolute_path() else p_path.get_base_dir().path_join(base)
			):
				return true
		elif line.begins_with("func test_"):
			if ("%s %s" % [_short(p_path), words[1].get_slice("(", 0)]).contains(_filter):
				return true
	return false


func _run_file(p_path: String) -> void:
	_guard.call("begin", p_path, _default_limit * HANG_FACTOR)
	var script: GDScript = null
	if FileAccess.file_exists(p_path):
		script = load(p_path) as GDScript
	_guard.call("end")
	var fault: String = _find_fault(script)
	var errors: PackedStringArray = _trap.call("take")
	if fault.is_empty() and not errors.is_empty():
		fault = "errors while it was loaded"
	if not fault.is_empty():
		errors.insert(0, fault)
		_report(p_path, "(file)", 0.0, "\n".join(errors))
		return
	for test: String in _test_names(script):
		if _filter.is_empty() or ("%s %s" % [_short(p_path), test]).contains(_filter):
			await _run_test(p_path, script, test)


func _find_fault(p_script: GDScript) -> String:
	if p_script == null or not p_script.can_instantiate():
		return "cannot be loaded"
	var base: Script = p_script
	while base != null and not base.resource_path.ends_with("tests/framework/test_case.gd"):
		base = base.get_base_script()
	if base == null:
		return "does not extend TestCase"
	return "has no test_ method" if _test_names(p_script).is_empty() else ""


func _test_names(p_script: GDScript) -> PackedStringArray:
	var names: PackedStringArray = PackedStringArray()
	for method: Dictionary in p_script.get_script_method_list():
		var name: String = method["name"]
		if name.begins_with("test_") and not name in names:
			names.append(name)
	return names


func _run_test(p_path: String, p_script: GDScript, p_test: String) -> void:
	var test: TestCase = p_script.new()
	var limit: float = test.time_limit() if test.time_limit() > 0.0 else _default_limit
	var full_name: String = "%s  %s" % [_short(p_path), p_test]
	_note_current(full_name)
	_guard.call("begin", full_name, limit * HANG_FACTOR)
	var nodes: int = _orphans() - 1
	# What the tests before have logged leaves no less room for this one's lines.
	Log.forget()
	root.add_child(test)
	_is_paced = test.goes_by_clock()
	var started: int = Time.get_ticks_usec()
	var in_time: bool = await _call_within("before_each", test, limit)
	if in_time:
		in_time = await _call_within(p_test, test, limit)
	var seconds: float = (Time.get_ticks_usec() - started) * 1e-6
	in_time = await _call_within("after_each", test, limit) and in_time
	var faults: PackedStringArray = _faults_of(test)
	if not in_time or seconds > limit:
		faults.append("took longer than %s s" % limit)
	_is_paced = false
	var expected: PackedStringArray = test._case_expected_errors
	var allowed: PackedStringArray = test._case_allowed_errors
	test.free()
	# What is queued for deletion or deferred still belongs to this test.
	await process_frame
	faults.append_array(_sift_errors(_trap.call("take"), expected, allowed))
	if _orphans() > nodes:
		var left: int = _orphans() - nodes
		faults.append("left %d node%s outside the tree" % [left, "s" if left > 1 else ""])
	_guard.call("end")
	_report(p_path, p_test, seconds, "\n".join(faults))


## Nodes that are in no tree; somebody must still free them.
func _orphans() -> int:
	return int(Performance.get_monitor(Performance.OBJECT_ORPHAN_NODE_COUNT))


func _call_within(p_method: String, p_test: TestCase, p_limit: float) -> bool:
	var state: Dictionary = {"done": false}
	var started: int = Time.get_ticks_msec()
	_call_and_note(p_method, p_test, state)
	while not state["done"]:
		if Time.get_ticks_msec() - started > p_limit * 1000.0:
			return false
		await process_frame
	return true


func _call_and_note(p_method: String, p_test: TestCase, p_state: Dictionary) -> void:
	await p_test.call(p_method)
	p_state["done"] = true


func _faults_of(p_test: TestCase) -> PackedStringArray:
	var faults: PackedStringArray = p_test._case_failures.duplicate()
	if p_test._case_failure_count > faults.size():
		faults.append("and %d more" % (p_test._case_failure_count - faults.size()))
	if p_test._case_checks == 0:
		faults.append("checks nothing")
	return faults


func _sift_errors(
	p_errors: PackedStringArray, p_expected: PackedStringArray, p_allowed: PackedStringArray
) -> PackedStringArray:
	var faults: PackedStringArray = PackedStringArray()
	var forgiven: PackedStringArray = p_expected + p_allowed
	for error: String in p_errors:
		if not Array(forgiven).any(func(text: String) -> bool: return error.contains(text)):
			faults.append("error: " + error)
	for text: String in p_expected:
		if not Array(p_errors).any(func(error: String) -> bool: return error.contains(text)):
			faults.append('the expected error "%s" was not reported' % text)
	return faults


func _report(p_path: String, p_test: String, p_seconds: float, p_message: String) -> void:
	var file: String = _short(p_path)
	var entry: Dictionary = {
		"file": file, "test": p_test, "seconds": p_seconds, "message": p_message
	}
	_results.append(entry)
	var verdict: String = "ok  " if p_message.is_empty() else "FAIL"
	print("%s %s  %s  (%d ms)" % [verdict, file, p_test, roundi(p_seconds * 1000.0)])
	if not p_message.is_empty():
		print(p_message.indent("     "))


func _short(p_path: String) -> String:
	return p_path.trim_prefix("res://").trim_prefix("tests/")


func _note_current(p_test: String) -> void:
	if _current_path.is_empty():
		return
	var file: FileAccess = FileAccess.open(_current_path, FileAccess.WRITE)
	if file != null:
		file.store_string(p_test)
		file.close()
