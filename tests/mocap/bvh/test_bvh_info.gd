extends TestCase
## The command line tool bvh_info.gd, as a process of its own.

const SCRIPT: String = "res://scripts/mocap/bvh/bvh_info.gd"

var _lines: PackedStringArray = PackedStringArray()
var _exit_code: int = 0


func test_prints_a_clip() -> void:
	_call_on(["assets/motion/01_01.bvh"])
	equal(_exit_code, 0)
	for line: String in [
		"file: assets/motion/01_01.bvh",
		"joints: 31",
		"end_sites: 7",
		"channels: 96",
		"frames: 2751",
		"frame_time: 0.008333 s",
		"duration: 22.92 s"
	]:
		contains(_lines, line)
	contains("\n".join(_lines), "\nunit: CMU (guess: ")
	contains("\n".join(_lines), "\nup: Y (guess: ")


func test_says_how_tall_the_person_is() -> void:
	_call_on(["assets/motion/Boxing_Toes.bvh"])
	contains("\n".join(_lines), "\nperson: 1.7")


func test_refuses_what_is_no_person() -> void:
	for file: String in ["joint_positions.bvh", "utf8_name.bvh"]:
		_call_on(["tests/data/bvh/" + file])
		equal(_exit_code, 2, file)
		contains(_lines, "file: tests/data/bvh/" + file)
		contains(_lines[-1], file + ": no joint is recognised as LeftUpperArm")


func test_takes_unit_and_axis() -> void:
	_call_on(["tests/data/bvh/thesis_example.bvh", "--unit=0.02", "--up=z"])
	contains(_lines, "unit: 0.02 m (as given)")
	contains(_lines, "up: Z (as given)")
	_call_on(["tests/data/bvh/thesis_example.bvh", "--unit=dm", "--up=-Y"])
	contains(_lines, "unit: decimetre (as given)")
	contains(_lines, "up: -Y (as given)")


func test_notes() -> void:
	_call_on(["assets/motion/Boxing_Toes.bvh", "--unit=cm"])
	equal(_exit_code, 0)
	contains(_lines, "unit: centimetre (as given)")
	equal(
		_lines[-1],
		"note: Boxing_Toes.bvh:128: 3069 frames declared, 3070 found; the last one is left out"
	)


func test_wrong_calls_and_files() -> void:
	_fails([], "no file given; usage: bvh FILE")
	_fails(["a.bvh", "b.bvh"], "more than one file; usage: ")
	_fails(["a.bvh", "--unit=league"], "unknown unit 'league'; usage: ")
	_fails(["a.bvh", "--up=w"], "unknown option '--up=w'; usage: ")
	_fails(["missing.bvh"], "missing.bvh: expected a readable file")
	_fails(["assets"], "assets: expected a BVH file, found a folder")
	_fails(["assets/avatar/soldier.glb"], "soldier.glb:1: expected UTF-8 text")
	var empty: String = "user://empty.bvh"
	FileAccess.open(empty, FileAccess.WRITE).close()
	_fails([empty], "empty.bvh:1: expected 'HIERARCHY', found the end of the file")


func _fails(p_arguments: Array[String], p_error: String) -> void:
	_call_on(p_arguments)
	equal(_exit_code, 2)
	is_true(_lines.size() == 1 and _lines[0].begins_with(p_error), "\n".join(_lines))


func _call_on(p_arguments: Array[String]) -> void:
	var command: PackedStringArray = ["--headless", "--no-header", "--path"]
	command.append_array([ProjectSettings.globalize_path("res://"), "-s", SCRIPT, "--"])
	command.append_array(p_arguments)
	var output: Array = []
	_exit_code = OS.execute(OS.get_executable_path(), command, output, true)
	_lines = (output[0] as String).strip_edges().split("\n", false)
