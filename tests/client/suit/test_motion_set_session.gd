extends TestCase
## A motion set is recorded from a wearer, in fixed steps.

const MadeWearer: GDScript = preload("made_wearer.gd")
const PlainMover: GDScript = preload("res://tests/bench/motion_set/plain_mover.gd")
const PERIOD_USEC: float = 1e6 / 60.0
const CLIP: String = "res://assets/motion/01_01.bvh"

var _out: String = ""
var _session: MotionSetSession = null
var _wearer: MadeWearer = null
var _said: PackedStringArray = PackedStringArray()
var _now_usec: float = 1e12


func before_each() -> void:
	var at: Array = [OS.get_process_id(), Time.get_ticks_usec()]
	_out = OS.get_user_data_dir().path_join("record-%d-%d.motionset" % at)
	_begin()


func after_each() -> void:
	_session.inputs.close()
	var folder: String = _out + MotionSetRecording.FOLDER
	for file: String in DirAccess.get_files_at(folder):
		DirAccess.remove_absolute(folder.path_join(file))
	for path: String in [folder, _out]:
		DirAccess.remove_absolute(path)


func test_a_whole_recording_makes_a_set_of_the_wearer_s_own_that_walks() -> void:
	_wear()
	_go_on(400.0)
	is_true(_session.is_over)
	equal(_left_out(), PackedStringArray())
	equal(_session.finish(), "")
	var motion: MotionSet = MotionSet.new()
	equal(motion.load_file(_out), "")
	var own: PackedStringArray = _own_rows()
	for part: String in [
		"stand stand",
		"stand ahead",
		"turn left",
		"turn right",
		"left curve",
		"right curve",
		"stand back",
		"stand left",
		"stand right",
		"start",
		"stop",
		"crouched stand",
		"crouched ahead"
	]:
		is_true(_has(own, part), part)
	for gait: Array in [
		[0.0, 0.0, 0],
		[0.8, 0.0, 0],
		[1.4, 0.0, 0],
		[3.5, 0.0, 0],
		[0.9, PI, 0],
		[0.9, PI / 2.0, 0],
		[0.8, 0.0, MotionMatcher.CROUCH]
	]:
		var slide: float = _slide(motion, gait)
		is_true(slide <= 0.03, "%s: %.3f m/s" % [gait, slide])
	# Its files make the same set again.
	var path: String = _session.recording.folder().path_join(MotionSetRecording.TABLE)
	var table: MotionSetTable = MotionSetTable.parse(FileAccess.get_file_as_string(path), path)
	equal(table.error, "")
	var builder: MotionSetBuilder = MotionSetBuilder.new()
	builder.add_table(table, path.get_base_dir())
	equal(builder.error, "")
	is_true(builder.motion_set.to_bytes() == FileAccess.get_file_as_bytes(_out))


func test_a_suit_that_does_not_know_where_it_is_travels_by_its_feet() -> void:
	_only(["walk", "left"])
	_wear()
	_wearer.is_placeless = true
	_go_on(100.0)
	equal(_left_out(), PackedStringArray())
	for take: GuidedRecording.Take in _session.guide.takes:
		var track: MotionTrack = take.tracks[0]
		var seconds: float = (track.count() - 61) / 60.0
		var speed: float = (track.hips[-1] - track.hips[60]).length() / seconds
		almost_equal(speed, MadeWearer.SPEEDS[take.phase.name], 0.1, take.phase.name)
	equal(_session.finish(), "")
	is_true(_has(_own_rows(), "stand left 0.9"))
	is_true(_has(_own_rows(), "stand ahead 1.4"))


func test_a_source_that_drops_out_is_waited_for_and_makes_no_clip() -> void:
	_only(["walk"])
	_wear()
	_go_on(5.0)
	_wearer.is_dead = true
	_go_on(10.0)
	contains(_said, "There is no motion: the source is lost, and it waits for it")
	is_false(_session.is_over)
	_wearer.is_dead = false
	_go_on(30.0)
	contains(_said, "The motion is back")
	is_true(_session.is_over)
	var tracks: Array[MotionTrack] = _session.guide.takes[0].tracks
	equal(tracks.size(), 2)
	for track: MotionTrack in tracks:
		for frame: int in range(1, track.count()):
			var step: float = track.hips[frame].distance_to(track.hips[frame - 1])
			is_true(step < 0.06, "a gap in a track")
			if step >= 0.06:
				return
	equal(_session.finish(), "")


func test_a_source_that_dies_ends_it_and_what_there_is_is_kept() -> void:
	_wear()
	_go_on(16.0)
	_wearer.is_dead = true
	_go_on(MotionSetSession.RETURNS_S + 1.0)
	is_true(_session.is_over)
	contains(_said, "No motion has come for 60 s: it ends")
	equal(_session.finish(), "")
	equal(MotionSet.new().load_file(_out), "")
	is_true(_has(_own_rows(), "stand stand"))


func test_who_stands_still_hears_what_was_missing_and_gets_no_walk() -> void:
	_only(["walk"])
	_wear()
	_wearer.is_lazy = true
	_go_on(130.0)
	is_true(_session.is_over)
	var missing: String = "you went straight ahead for 0.0 of 10 s"
	var again: String = "Not enough yet: %s. Once more" % missing
	equal(_left_out(), PackedStringArray([again, again, missing + ": walk is left out"]))
	contains(_session.finish(), "no set is made")
	is_false(FileAccess.file_exists(_out))


func test_who_stops_in_the_middle_keeps_what_there_is() -> void:
	_wear()
	_go_on(16.0)
	equal(_session.guide.phase().name, "walk")
	_session.stop()
	equal(_session.finish(), "")
	equal(MotionSet.new().load_file(_out), "")
	is_true(_has(_own_rows(), "stand stand"))
	is_true(_has(_own_rows(), "stand ahead"))
	is_true(_has(_said, "Taken from the shipped set"))
	contains(_said, "What was recorded is in " + _session.recording.folder())


func test_what_was_written_before_a_kill_is_a_set() -> void:
	_wear()
	_go_on(24.0)
	var path: String = _session.recording.folder().path_join(MotionSetRecording.TABLE)
	var table: MotionSetTable = MotionSetTable.parse(FileAccess.get_file_as_string(path), path)
	equal(table.error, "")
	var builder: MotionSetBuilder = MotionSetBuilder.new()
	builder.add_table(table, path.get_base_dir())
	equal(builder.error, "")
	equal(MotionSet.new().load_bytes(builder.motion_set.to_bytes()), "")


func test_a_file_of_somebody_who_does_something_else() -> void:
	_only(["walk"])
	equal(_open(["--bvh=" + CLIP]), "")
	_go_on(130.0)
	is_true(_session.is_over)
	equal(_session.finish(), "")
	is_true(_has(_own_rows(), "stand ahead"))
	for track: MotionTrack in _session.guide.takes[0].tracks:
		for frame: int in range(1, track.count()):
			var step: float = track.hips[frame].distance_to(track.hips[frame - 1])
			if step > 0.1:
				fail("the file's beginning follows its end in %s" % track.name)
	var motion: MotionSet = MotionSet.new()
	equal(motion.load_file(_out), "")
	for speed: float in [0.0, 0.8, 1.4]:
		is_true(_slide(motion, [speed, 0.0, MotionMatcher.STAND]) <= 0.03, str(speed))


func test_calls_that_are_refused() -> void:
	contains(_open([]), "whose motion?")
	contains(_open(["--source=walker"]), "a walker's motion is made by a set")
	contains(_open(["--source=nothing"]), "--source")
	var out: String = _out
	_out = "/proc/a.motionset"
	contains(_open(["--bvh=" + CLIP]), "cannot write /proc/a.motionset-recording")
	_out = "/proc/none/a.motionset"
	contains(_open(["--bvh=" + CLIP]), "there is no folder /proc/none")
	_out = out
	_begin()
	contains(_open(["--bvh=" + CLIP]), "name another set")


func test_a_wearer_reads_what_to_do() -> void:
	_wear()
	var view: MotionSetView = MotionSetView.new(_session)
	add_child(view)
	_go_on(1.0)
	await process_frames(2)
	contains(view.text(), "\nStand at ease, look ahead\nThen: Walk as you usually do")
	_go_on(8.0)
	await process_frames(2)
	contains(view.text(), "Walk as you usually do")
	_wearer.is_dead = true
	_go_on(1.0)
	await process_frames(2)
	contains(view.text(), "No motion comes")
	view.queue_free()


func _open(p_arguments: PackedStringArray) -> String:
	return _session.open(Options.parse(SuitOptions.rows(), p_arguments), _out)


## Leads through some phases only.
func _only(p_names: PackedStringArray) -> void:
	_begin(
		Array(GuidedPhase.names()).filter(func(name: String) -> bool: return not p_names.has(name))
	)


func _begin(p_skipped: PackedStringArray = []) -> void:
	_session = MotionSetSession.new(p_skipped)
	_said.clear()
	_session.said.connect(_said.append)


func _wear() -> void:
	equal(_session.recording.open(_out), "")
	_wearer = MadeWearer.new()
	equal(_wearer.error, "")
	_wearer.guide = _session.guide
	_session.inputs.appeared.emit(_wearer, "")


func _go_on(p_seconds: float) -> void:
	for _tick: int in roundi(p_seconds * 60.0):
		if _session.is_over:
			return
		_now_usec += PERIOD_USEC
		_session.advance(_now_usec)


func _left_out() -> PackedStringArray:
	var found: PackedStringArray = []
	for text: String in _said:
		if "left out" in text or "Not enough" in text:
			found.append(text)
	return found


## The clips of the set's table that are the wearer's, each as "STANCE NAME".
func _own_rows() -> PackedStringArray:
	var path: String = _session.recording.folder().path_join(MotionSetRecording.TABLE)
	var found: PackedStringArray = []
	for row: MotionSetTable.Row in (
		MotionSetTable.parse(FileAccess.get_file_as_string(path), path).rows
	):
		if row.file.get_extension() == "bvh":
			found.append("%s %s" % [MotionSetTable.STANCES.find_key(row.stance), row.name])
	return found


static func _has(p_texts: PackedStringArray, p_part: String) -> bool:
	for text: String in p_texts:
		if p_part in text:
			return true
	return false


## Speed of the soles on the ground of who goes by a set at a speed, m/s, in a direction, rad, and a
## stance.
static func _slide(p_set: MotionSet, p_gait: Array) -> float:
	var mover: PlainMover = PlainMover.new()
	var matcher: MotionMatcher = MotionMatcher.new()
	matcher.set_motion_set(p_set)
	matcher.set_body(0.95, PackedFloat32Array())
	matcher.reset(Vector3.ZERO, 0.0)
	mover.stance = p_gait[2]
	mover.wish(p_gait[0], p_gait[1], 0.0)
	var slide: SoleSlide = SoleSlide.new()
	for _tick: int in 600:
		mover.advance(1.0 / 60.0)
		mover.show(matcher, 1.0 / 60.0)
		slide.look(matcher.get_soles(), 1.0 / 60.0)
	return slide.mean()
