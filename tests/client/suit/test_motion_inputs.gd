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


func test_who_names_no_source_walks_by_keys() -> void:
	equal(_open([]), "")
	equal(_appeared.size(), 1)
	is_true(_appeared[0][0] is WalkerSource)
	contains(_inputs.open_source("walker"), "is a source already")


func test_nothing_moves_who_waits_for_a_headset() -> void:
	for options: Array in [[], ["--source=xr"]]:
		_again()
		_inputs.awaits_headset = true
		equal(_open(options), "", str(options))
		equal(_appeared.size(), 0, str(options))
	_again()
	_inputs.awaits_headset = true
	equal(_open(["--bvh=" + CLIP]), "")
	equal(_appeared.size(), 1, "a motion that is asked for is there at once")


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
	var fault: String = _open(["--source=mvn:%d" % port])
	contains(fault, str(port))
	contains(fault, "--source=mvn")
	other.close()
	_again()
	equal(_open(["--source=mvn:%d" % port]), "", "free again")
	contains(_inputs.guide(0.0), "no MVN on UDP port %d" % port)
	equal(_inputs.list_devices().size(), 1)


func test_one_option_names_all_kinds_of_sources() -> void:
	equal(_open(["--source=bvh:" + CLIP, "--source=tracker:/user/nobody,bvh:" + BOXER]), "")
	equal(_appeared.size(), 3)
	is_true(_appeared[0][0] is BvhSource and _appeared[1][0] is TrackerSource)
	equal(_inputs.list_sources().size(), 3)
	equal(_inputs.list_sources()[1]["name"], "tracker")


func test_a_source_that_is_none_is_told_with_all_kinds() -> void:
	for text: String in ["vcm", "vmc:0", "axis:tcp:", "natnet:", "tracker", "xbus:3"]:
		var fault: String = _open(["--source=" + text])
		for kind: String in SourceAddress.KINDS:
			contains(fault, kind, text)
		_again()
	contains(_open(["--source=xr"]), "no headset")


func test_a_stream_s_port_in_use_is_told_and_a_free_one_waited_at() -> void:
	var other: PacketPeerUDP = PacketPeerUDP.new()
	equal(other.bind(0, "0.0.0.0"), OK)
	var port: int = other.get_local_port()
	contains(_open(["--source=vmc:%d" % port]), str(port))
	other.close()
	_again()
	equal(_open(["--source=vmc:%d" % port]), "")
	contains(_inputs.guide(0.0), "no VMC on UDP port %d" % port)
	equal(_inputs.list_devices().size(), 1)
	equal(_inputs.open_source("bvh:" + CLIP), "", "more while it runs")
	equal(_appeared.size(), 1)
	contains(_inputs.open_source("bvh:/no/such.bvh"), "such.bvh")
	equal(_inputs.list_sources().size(), 2)


func test_limbs_of_another_source_complete_the_first() -> void:
	equal(_open(["--source=bvh:%s" % CLIP, "--source=bvh:%s" % BOXER, "--fuse=arms:2"]), "")
	equal(_appeared.size(), 1, "one body of two sources")
	var fused: LimbFusion = _appeared[0][0]
	equal(fused.choice(LimbFusion.Group.ARMS), 2)
	not_null(fused.sample(1_700_000_000_000_000))
	equal(_inputs.people.choose(LimbFusion.Group.HEAD, 2), "")
	equal(fused.choice(LimbFusion.Group.HEAD), 2)
	_again()
	contains(_open(["--source=bvh:" + CLIP, "--fuse=feet:2"]), "source 2")
	_again()
	contains(_open(["--source=bvh:" + CLIP, "--fuse=tail:1"]), "fingers")


func test_poses_are_sent_to_other_programs() -> void:
	contains(_open(["--bvh=" + CLIP, "--vmc-out=nowhere:0"]), "--vmc-out")
	_again()
	equal(_open(["--bvh=" + CLIP, "--vmc-out"]), "")
	equal([_inputs.vmc_out.address, _inputs.vmc_out.port], ["127.0.0.1", 39539])


func test_a_tracker_that_is_not_there_is_told_and_waited_for() -> void:
	equal(_open(["--source=tracker:/user/nobody"]), "")
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


func test_sources_that_are_opened_later_come_after_the_first() -> void:
	equal(_open(["--bvh=" + CLIP]), "")
	equal(_inputs.list_sources().size(), 1)
	equal(_inputs.open_source("bvh:" + BOXER), "")
	equal(_inputs.list_sources().size(), 2)
	equal(_inputs.people.choose(LimbFusion.Group.ARMS, 2), "")
	not_null(_inputs.people.fusion, "the second completes the first")
	contains(_inputs.open_source("bvh:" + BOXER), "is a source already")
