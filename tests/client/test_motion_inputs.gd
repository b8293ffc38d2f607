extends TestCase
## What a client's options give as sources of motion, and what is said where they give none.

const CLIP: String = "res://assets/motion/01_01.bvh"
const BOXER: String = "res://assets/motion/Boxing_Toes.bvh"

var _inputs: MotionInputs = null
var _appeared: Array[Array] = []
var _vanished: Array[MotionSource] = []


func before_each() -> void:
	_inputs = MotionInputs.new()
	_appeared.clear()
	_vanished.clear()
	_inputs.appeared.connect(
		func(source: MotionSource, name: String) -> void: _appeared.append([source, name])
	)
	_inputs.vanished.connect(_vanished.append)


func after_each() -> void:
	_inputs.close()


func test_without_a_source_the_options_are_named() -> void:
	var fault: String = _open([])
	for option: String in ["--bvh", "--xbus", "--mvn", "--tracker", "--suit-play"]:
		contains(fault, option)


func test_one_file_is_one_person_with_the_client_s_name() -> void:
	equal(_open(["--bvh=" + CLIP]), "")
	equal(_appeared.size(), 1)
	equal(_appeared[0][1], "")
	not_null((_appeared[0][0] as MotionSource).sample(1000000))


func test_several_files_are_people_with_the_files_names() -> void:
	equal(_open(["--bvh=%s,%s" % [CLIP, BOXER]]), "")
	var names: Array = _appeared.map(func(row: Array) -> String: return row[1])
	equal(names, ["01_01", "Boxing_Toes"])


func test_faults_name_the_file() -> void:
	contains(_open(["--bvh=%s,/no/such.bvh" % CLIP]), "such.bvh")
	_again()
	contains(_open(["--suit-play=/no/such.raw"]), "/no/such.raw")
	_again()
	contains(_open(["--bvh=" + CLIP, "--suit-record=/no/such/folder/file.raw"]), "/no/such/folder")
	_again()
	var path: String = "user://no-recording-%d.raw" % OS.get_process_id()
	var file: FileAccess = FileAccess.open(path, FileAccess.WRITE)
	file.store_string("this is no recording of a suit".repeat(100))
	file.close()
	not_equal(_open(["--suit-play=" + path]), "")
	DirAccess.remove_absolute(path)


func test_a_port_for_mvn_that_is_in_use() -> void:
	var other: MvnStream = MvnStream.new()
	equal(other.open(0), "")
	var port: int = other.receiver.get_port()
	var fault: String = _open(["--mvn=%d" % port])
	contains(fault, str(port))
	contains(fault, "--mvn")
	other.close()
	_again()
	equal(_open(["--mvn=%d" % port]), "", "free again")
	contains(_inputs.guide(0.0), "no MVN on UDP port %d" % port)
	equal(_inputs.list_devices().size(), 1)


func test_a_tracker_that_is_not_there_is_told_and_waited_for() -> void:
	equal(_open(["--tracker=/user/nobody"]), "")
	equal(_appeared.size(), 1)
	_inputs.advance(1.0)
	is_null((_appeared[0][0] as MotionSource).sample(1000000))
	contains(_inputs.guide(1.0), "/user/nobody")


func test_motion_that_comes_calibrated_is_not_calibrated() -> void:
	equal(_open(["--bvh=" + CLIP]), "")
	_inputs.calibrate(_appeared[0][0], CalibrationGuide.Kind.FULL, 1.0)
	is_false(_inputs.calibration.is_running())
	contains(_inputs.guide(1.5), "comes calibrated")
	equal(_inputs.guide(60.0), "")


func _open(p_arguments: PackedStringArray) -> String:
	var options: Options = ProgramOptions.parse(p_arguments)
	equal(options.error, "")
	return _inputs.open(options)


func _again() -> void:
	after_each()
	before_each()
