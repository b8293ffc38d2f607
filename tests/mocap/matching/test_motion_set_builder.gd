extends TestCase
## Motion sets are made of motion files.

const FOLDER: String = "res://assets/motion"


func test_a_set_of_a_file() -> void:
	var text: String = "01_01.bvh stand 0.74 1.24 stand\n01_01.bvh stand 2 5 jumps\n"
	var table: MotionSetTable = MotionSetTable.parse(text, "set.txt")
	var builder: MotionSetBuilder = MotionSetBuilder.new()
	builder.add_table(table, FOLDER)
	equal(builder.error, "")
	var motion: MotionSet = MotionSet.new()
	equal(motion.load_bytes(builder.motion_set.to_bytes()), "")
	equal(motion.get_clip_count(), 2)
	equal(motion.get_clip_frame_count(0), 30)
	equal(motion.get_clip_frame_count(1), 180)
	is_true(motion.get_clip_speed(0) < 0.1)
	equal(motion.get_clip_contact_share(0), 1.0)
	# Those that stand have no reversed twins.
	is_true(motion.get_frame_count() > 2 * 210 - 1)


func test_files_and_times_that_are_not_there() -> void:
	for fault: Array in [
		["none.bvh stand 0 1 x", "none.bvh"], ["01_01.bvh stand 599 600 late", "late: a clip has"]
	]:
		var builder: MotionSetBuilder = MotionSetBuilder.new()
		builder.add_table(MotionSetTable.parse(fault[0], "set.txt"), FOLDER)
		contains(builder.error, fault[1])


func test_clips_of_another_set_are_taken_as_they_are() -> void:
	var text: String = "walker.motionset stand 0 0 jog 02_03\n01_01.bvh stand 2 5 jumps\n"
	var builder: MotionSetBuilder = MotionSetBuilder.new()
	builder.add_table(MotionSetTable.parse(text, "set.txt"), FOLDER)
	equal(builder.error, "")
	var motion: MotionSet = MotionSet.new()
	equal(motion.load_bytes(builder.motion_set.to_bytes()), "")
	var whole: MotionSet = MotionSet.new()
	equal(whole.load_file(FOLDER.path_join("walker.motionset")), "")
	var jog: int = range(whole.get_clip_count()).find_custom(
		func(clip: int) -> bool: return whole.get_clip_name(clip) == "jog 02_03"
	)
	equal(motion.get_clip_count(), 2)
	equal(motion.get_clip_name(0), "jog 02_03")
	equal(motion.get_clip_frame_count(0), whole.get_clip_frame_count(jog))
	equal(motion.get_clip_speed(0), whole.get_clip_speed(jog))
	contains(motion.add_clip_of(whole, -1), "no clip -1")


func test_clips_that_a_set_has_not() -> void:
	for fault: Array in [
		["none.motionset stand 0 0 x", "none.motionset"],
		["walker.motionset crouch 0 0 jog 02_03", "no clip 'jog 02_03' of that stance"],
	]:
		var builder: MotionSetBuilder = MotionSetBuilder.new()
		builder.add_table(MotionSetTable.parse(fault[0], "set.txt"), FOLDER)
		contains(builder.error, fault[1])
