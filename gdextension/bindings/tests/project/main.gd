extends Node
## Runs every check and says what it found: a line per check, a summary, and the exit code.

const SUITES: Array[String] = ["values", "objects", "numbers", "physics"]

var _passed := 0
var _failed := 0


func _ready() -> void:
	if not ClassDB.class_exists(&"ValueProbe"):
		# The scripts below would not even parse without the extension.
		print("FAIL extension: its classes are not registered")
		get_tree().quit(1)
		return
	for suite_name in SUITES:
		var script: GDScript = load("res://checks/%s.gd" % suite_name)
		var suite: CheckSuite = script.new()
		suite.checked.connect(_on_checked.bind(suite_name))
		add_child(suite)
		await suite.run()
		suite.queue_free()
	await get_tree().process_frame
	print("%d passed, %d failed" % [_passed, _failed])
	get_tree().quit(1 if _failed > 0 else 0)


func _on_checked(check_name: String, problem: String, suite_name: String) -> void:
	if problem.is_empty():
		_passed += 1
		print("ok %s: %s" % [suite_name, check_name])
	else:
		_failed += 1
		print("FAIL %s: %s: %s" % [suite_name, check_name, problem])
