extends TestCase
## What is said of a runtime that gives no headset, and the way back to one.

var _manifest: RuntimeManifest = RuntimeManifest.new()
var _way: HmdReturn = null


func before_each() -> void:
	_way = HmdReturn.new(HmdCommand.of("/nonexistent/game", [], "/"))
	_manifest.path = "/etc/runtime.json"
	_manifest.library = "/lib/libxr.so"


func after_each() -> void:
	var path: String = OS.get_environment("XR_RUNTIME_JSON")
	if path.begins_with(OS.get_user_data_dir()):
		DirAccess.remove_absolute(path)
	OS.unset_environment("XR_RUNTIME_JSON")


func test_every_answer_says_what_to_do() -> void:
	equal(HmdReturn.explain(RuntimeProbe.READY, _manifest), "")
	is_true("/lib/libxr.so" in HmdReturn.explain(RuntimeProbe.NO_LIBRARY, _manifest))
	is_true("start it" in HmdReturn.explain(RuntimeProbe.NO_SERVICE, _manifest))
	is_true("plug it in" in HmdReturn.explain(RuntimeProbe.NO_HEADSET, _manifest))
	is_true("start it again" in HmdReturn.explain(RuntimeProbe.STALLED, _manifest))


func test_a_missing_runtime_is_told_at_once_and_asked_again() -> void:
	OS.set_environment("XR_RUNTIME_JSON", "/nonexistent/runtime.json")
	is_true("/nonexistent/runtime.json is not there" in _way.ask())
	var answers: int = 0
	for i: int in 600:
		if _way.advance(0.1):
			answers += 1
			is_false(_way.is_ready())
			is_true("is not there" in _way.fault, _way.fault)
	# A minute: every 2 s at first, then more and more seldom.
	is_true(answers >= 8 and answers <= 20, str(answers))


func test_a_library_without_a_runtime_is_answered_without_waiting() -> void:
	_name_library("libc.so.6")
	is_true(_way.begin(), _way.fault)
	is_false(_way.is_ready())
	while not _way.advance(0.001):
		await get_tree().process_frame
	equal(_way.answer, RuntimeProbe.NO_LIBRARY)
	is_true("libc.so.6" in _way.fault and "cannot be loaded" in _way.fault, _way.fault)


func test_a_program_that_is_gone_is_not_left() -> void:
	var left: Array[bool] = []
	_way.leaving.connect(left.append.bind(true))
	is_true("could not be started again" in _way.enter())
	equal(left.size(), 0)


func test_a_start_that_fails_leaves_nothing_behind() -> void:
	# A file that is there, but no program.
	_way = HmdReturn.new(HmdCommand.of("/etc/passwd", [], "/"))
	var left: Array[bool] = []
	_way.leaving.connect(left.append.bind(true))
	is_true("could not be started again" in _way.enter())
	equal(left.size(), 1)
	is_false(OS.has_environment(HmdCommand.TRIED))
	is_false(OS.has_environment(HmdCommand.RENDERER))


func _name_library(p_library: String) -> void:
	var path: String = OS.get_user_data_dir().path_join("runtime_of_a_test.json")
	var file: FileAccess = FileAccess.open(path, FileAccess.WRITE)
	file.store_string(JSON.stringify({"runtime": {"library_path": p_library}}))
	file.close()
	OS.set_environment("XR_RUNTIME_JSON", path)
