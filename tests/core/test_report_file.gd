extends TestCase
## Reports are replaced whole, no more often than they are told to, and never end the program.

const PATH: String = "user://test_report.json"


func after_each() -> void:
	for path: String in [PATH, PATH + ".part"]:
		if FileAccess.file_exists(path):
			DirAccess.remove_absolute(path)


func test_writes_and_replaces() -> void:
	var report: ReportFile = ReportFile.new(PATH)
	report.write({"a": 1.5, "list": [1, 2]})
	equal(_read(), {"a": 1.5, "list": [1.0, 2.0]})
	is_false(report.is_due(), "just written")
	report.write({"b": "two"})
	equal(_read(), {"b": "two"})
	is_false(FileAccess.file_exists(PATH + ".part"))


func test_is_due_again_after_a_second() -> void:
	var report: ReportFile = ReportFile.new(PATH)
	report.write({})
	report._written_usec -= int(ReportFile.PERIOD_S * 1e6)
	OS.delay_msec(2)
	is_true(report.is_due())


func test_is_due_as_often_as_it_is_reported() -> void:
	var report: ReportFile = ReportFile.new(PATH, 20.0)
	report.write({})
	report._written_usec -= int(19.0 * 1e6)
	is_false(report.is_due())
	report._written_usec -= int(1.1 * 1e6)
	is_true(report.is_due())


func test_a_reader_never_sees_half_a_report() -> void:
	var report: ReportFile = ReportFile.new(PATH)
	var large: Array = range(5000)
	report.write({"list": large})
	var thread: Thread = Thread.new()
	thread.start(_read_often)
	for _round: int in 30:
		report.write({"list": large})
	equal(thread.wait_to_finish(), 0)


func test_without_a_path_nothing_happens() -> void:
	var report: ReportFile = ReportFile.new("")
	is_false(report.is_due())
	report.write({"a": 1})
	is_false(FileAccess.file_exists(".part"))


func test_path_that_cannot_be_written() -> void:
	var report: ReportFile = ReportFile.new("user://no_such_folder/report.json")
	report.write({"a": 1})
	is_false(report.is_due(), "tried, and tried again a second later")
	is_false(FileAccess.file_exists("user://no_such_folder/report.json"))


func _read() -> Variant:
	return JSON.parse_string(FileAccess.get_file_as_string(PATH))


## Counts the readings that are no whole report.
func _read_often() -> int:
	var broken: int = 0
	for _reading: int in 200:
		var file: FileAccess = FileAccess.open(PATH, FileAccess.READ)
		if file == null or not file.get_as_text().strip_edges().ends_with("}"):
			broken += 1
	return broken
