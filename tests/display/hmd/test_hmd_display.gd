extends TestCase
## A headset's display without a headset: what who asks for it is told.

var _display: HmdDisplay = null
var _told: PackedStringArray = []


func goes_by_clock() -> bool:
	return true


func before_each() -> void:
	_told = []
	_display = HmdDisplay.new()
	_display.notified.connect(_on_notified)
	add_child(_display)


func after_each() -> void:
	_display.free()
	var path: String = OS.get_environment("XR_RUNTIME_JSON")
	if path.begins_with(OS.get_user_data_dir()):
		DirAccess.remove_absolute(path)
	OS.unset_environment("XR_RUNTIME_JSON")


func test_it_cannot_be_without_a_screen() -> void:
	is_true("start without --headless" in _display.open())
	is_false(_display.is_worn())
	equal(_display.due_usec(), 0)
	is_true(_display.head() == null)
	is_false(_display.report()["waits"])


func test_who_asks_without_a_runtime_is_told_at_once_and_waits() -> void:
	OS.set_environment("XR_RUNTIME_JSON", "/nonexistent/runtime.json")
	is_true("/nonexistent/runtime.json is not there" in _display.enter())
	is_true(_display.report()["waits"])


func test_who_asks_is_told_what_the_runtime_answers() -> void:
	var path: String = OS.get_user_data_dir().path_join("runtime_of_a_display_test.json")
	var file: FileAccess = FileAccess.open(path, FileAccess.WRITE)
	file.store_string(JSON.stringify({"runtime": {"library_path": "libc.so.6"}}))
	file.close()
	OS.set_environment("XR_RUNTIME_JSON", path)
	equal(_display.enter(), "")
	equal(_told.size(), 0, "the frame does not wait for the answer")
	while _told.is_empty():
		await get_tree().process_frame
	is_true(_told[0].begins_with("No headset: libc.so.6"), _told[0])
	equal(_display.report()["lost"], _told[0], "what a window goes on saying")
	is_true(_display.report()["waits"])
	# The same fault by itself is not told again.
	for i: int in 10:
		await get_tree().process_frame
	equal(_told.size(), 1)


func _on_notified(p_text: String) -> void:
	_told.append(p_text)
