extends RefCounted
## Writes results as a JUnit XML file, which continuous integration services show.


## Writes [param p_results] (dictionaries with file, test, seconds and message, the last being
## empty if the test passed) to [param p_path]. Returns whether that worked.
static func write(p_path: String, p_results: Array[Dictionary]) -> bool:
	var file: FileAccess = FileAccess.open(p_path, FileAccess.WRITE)
	if file == null:
		return false
	var failed: int = 0
	var seconds: float = 0.0
	for result: Dictionary in p_results:
		failed += 0 if result["message"].is_empty() else 1
		seconds += result["seconds"]
	file.store_line('<?xml version="1.0" encoding="UTF-8"?>')
	file.store_line(
		(
			'<testsuite name="gdscript" tests="%d" failures="%d" time="%.3f">'
			% [p_results.size(), failed, seconds]
		)
	)
	for result: Dictionary in p_results:
		file.store_line(_test_case(result))
	file.store_line("</testsuite>")
	return file.get_error() == OK


static func _test_case(p_result: Dictionary) -> String:
	var attributes: String = (
		'classname="%s" name="%s" time="%.3f"'
		% [_escape(p_result["file"]), _escape(p_result["test"]), p_result["seconds"]]
	)
	if p_result["message"].is_empty():
		return "  <testcase %s/>" % attributes
	return (
		'  <testcase %s><failure message="%s"/></testcase>'
		% [attributes, _escape(p_result["message"])]
	)


static func _escape(p_text: String) -> String:
	var clean: String = ""
	for letter: String in p_text:
		var code: int = letter.unicode_at(0)
		clean += letter if code >= 32 and code < 0xFFFE or code == 9 or code == 10 else "?"
	return clean.xml_escape(true).replace("\n", "&#10;")
