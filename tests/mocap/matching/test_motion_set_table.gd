extends TestCase
## Tables of motion sets: what they say, and what is no table.


func test_lines_are_clips() -> void:
	var text: String = "# clips\n\na.bvh stand 0.5 2 walk slowly\n\tb.bvh\tprone 0 0 crawl # on\n"
	var table: MotionSetTable = MotionSetTable.parse(text, "set.txt")
	equal(table.error, "")
	equal(table.rows.size(), 2)
	equal(table.rows[0].file, "a.bvh")
	equal(table.rows[0].name, "walk slowly")
	equal(table.rows[0].from_s, 0.5)
	equal(table.rows[0].to_s, 2.0)
	equal(table.rows[1].stance, MotionMatcher.PRONE)
	equal(table.rows[1].name, "crawl")


func test_faults_name_the_line() -> void:
	for fault: Array in [
		["a.bvh stand 0 2", "set.txt:2: expected: FILE STANCE FROM_S TO_S NAME"],
		[
			"a.bvh fly 0 2 x",
			"set.txt:2: a stance is stand, crouch, prone, ladder, vault; found 'fly'",
		],
		["a.bvh stand -1 2 x", "set.txt:2: a time is 0 to 600 s; found '-1'"],
		["a.bvh stand 0 nan x", "set.txt:2: a time is 0 to 600 s; found 'nan'"],
	]:
		equal(MotionSetTable.parse("# a set\n" + fault[0], "set.txt").error, fault[1])
	equal(MotionSetTable.parse("# nothing", "set.txt").error, "set.txt: no clips")


func test_the_walkers_table_is_one() -> void:
	var path: String = "res://tools/assets/motion_set/walker.txt"
	var table: MotionSetTable = MotionSetTable.parse(FileAccess.get_file_as_string(path), path)
	equal(table.error, "")
	var motion: MotionSet = MotionSet.new()
	equal(motion.load_file("res://assets/motion/walker.motionset"), "")
	equal(motion.get_clip_count(), table.rows.size())
	for clip: int in table.rows.size():
		equal(motion.get_clip_name(clip), table.rows[clip].name)
