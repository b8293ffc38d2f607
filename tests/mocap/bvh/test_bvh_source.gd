extends TestCase
## A clip that is played for ever: valid samples, no jumps, and errors that tell.

const People: GDScript = preload("res://tests/mocap/people_samples.gd")
const CLIPS: PackedStringArray = ["01_01.bvh", "01_03.bvh", "Boxing_Toes.bvh"]
const FOLDER: String = "res://assets/motion/"
const STEP_USEC: int = 16667
## Moment at which playing begins: some time in 2026, Unix µs.
const BEGIN_USEC: int = 1780000000000000


func test_samples_are_valid_and_the_loop_has_no_seam() -> void:
	for file: String in CLIPS:
		var source: BvhSource = BvhSource.new()
		source.open(FOLDER + file)
		equal(source.error, "", file)
		var stats: Dictionary = _play_two_rounds(source)
		equal(stats["fault"], "", file)
		# The clips themselves have a few unsteady feet and hands.
		is_true(stats["any_deg"] < 60.0, "%s turns by %f deg" % [file, stats["any_deg"]])
		is_true(stats["seam_deg"] < 25.0, "%s turns by %f deg" % [file, stats["seam_deg"]])
		is_true(stats["any_m"] < 0.3, "%s jumps by %f m" % [file, stats["any_m"]])
		is_true(stats["any_deg"] > 1.0 and stats["any_m"] > 0.001, "%s is still" % file)


func test_half_a_turn_at_the_seam() -> void:
	for end: float in [PI - 0.05, PI, PI + 0.05, -PI + 0.02, 1.5 * PI]:
		var person: People.Person = People.Person.new()
		person.frames = []
		for i: int in 181:
			person.frames.append({"Hips": Quaternion(Vector3.UP, end * i / 180.0)})
		var source: BvhSource = BvhSource.new()
		source.use(People.make(person))
		var stats: Dictionary = _play_two_rounds(source)
		is_true(stats["any_deg"] < 25.0, "%f: by %f deg" % [end, stats["any_deg"]])


func test_rest_pose_before_the_motion_is_left_out() -> void:
	var person: People.Person = People.Person.new()
	person.frames = [{}]
	for i: int in 120:
		var swing: Quaternion = Quaternion(Vector3.BACK, -1.2 + 0.01 * i)
		person.frames.append({"LeftUpperArm": swing})
	var source: BvhSource = BvhSource.new()
	source.use(People.make(person))
	var wanted: Quaternion = Quaternion(Vector3.BACK, -1.2)
	almost_equal(source.sample(BEGIN_USEC).orientation(4), wanted, 1e-3)


func test_numbers_and_times() -> void:
	var source: BvhSource = _walk()
	for step: int in 300:
		var time: int = BEGIN_USEC + step * STEP_USEC
		var sample: PoseSample = source.sample(time)
		equal(sample.id, step)
		equal(sample.time_usec, time)


func test_number_wraps() -> void:
	var source: BvhSource = _walk()
	source._next_id = 0xFFFFFFFF
	equal(source.sample(BEGIN_USEC).id, 0xFFFFFFFF)
	equal(source.sample(BEGIN_USEC + STEP_USEC).id, 0)


func test_plays_from_its_beginning_at_the_clips_speed() -> void:
	var source: BvhSource = _walk()
	for time: float in [0.0, 0.5, 1.0, 1.4]:
		var sample: PoseSample = source.sample(BEGIN_USEC + int(time * 1e6))
		var wanted: Vector3 = source.rig.hips_position(time)
		wanted.y = sample.root.y
		almost_equal(sample.root, wanted, 1e-4)
		almost_equal(sample.orientation(4), source.rig.limb_rotation(4, time), 1e-4)


func test_stands_on_the_ground() -> void:
	for file: String in CLIPS:
		var source: BvhSource = BvhSource.new()
		source.open(FOLDER + file)
		var heights: Statistics = Statistics.new()
		for step: int in int(source.rig.clip.duration() * 10.0):
			var pose: BvhClip.Pose = source.rig.clip.sample_at(step / 10.0)
			var lowest: float = INF
			for place: Vector3 in pose.positions:
				lowest = minf(lowest, place.y)
			var hips: float = pose.positions[source.rig.map.joints[0]].y
			heights.add(lowest - hips + source.pose_at(step / 10.0).root.y)
		is_true(absf(heights.percentile(0.3)) < 0.1, "%s: feet at %f m" % [file, heights.mean()])
		is_true(source.get_hip_height() > 0.7 and source.get_hip_height() < 1.2, file)


func test_very_short_clips() -> void:
	for frames: int in [1, 2, 3, 10]:
		var list: Array[Dictionary] = []
		for i: int in frames:
			list.append({"Hips": Quaternion(Vector3.UP, 0.01 * i)})
		var person: People.Person = People.Person.new()
		person.frames = list
		var source: BvhSource = BvhSource.new()
		source.use(People.make(person))
		equal(source.error, "")
		for step: int in 200:
			var sample: PoseSample = source.sample(BEGIN_USEC + step * STEP_USEC)
			equal(sample.find_fault(), "", "%d frames" % frames)


func test_clock_that_is_set_back() -> void:
	var source: BvhSource = _walk()
	source.sample(BEGIN_USEC)
	equal(source.sample(BEGIN_USEC - 3600000000).find_fault(), "")


func test_errors() -> void:
	var source: BvhSource = BvhSource.new()
	source.open("res://assets/motion/missing.bvh")
	contains(source.error, "missing.bvh")
	source = BvhSource.new()
	source.open(FOLDER + CLIPS[0], "parsec")
	contains(source.error, "a unit is m, cm, mm, inch, cmu, dm, foot or metres, found 'parsec'")
	source = BvhSource.new()
	source.open(FOLDER + CLIPS[0], "", "w")
	contains(source.error, "an up axis is y, z, x, -y, -z, -x, found 'w'")
	source = BvhSource.new()
	source.open(FOLDER + CLIPS[0], "cmu", "Y")
	equal(source.error, "")


func test_unit_scales() -> void:
	var metres: BvhSource = BvhSource.new()
	metres.open(FOLDER + CLIPS[0], "0.05")
	var twice: BvhSource = BvhSource.new()
	twice.open(FOLDER + CLIPS[0], "0.1")
	almost_equal(twice.pose_at(1.0).root, metres.pose_at(1.0).root * 2.0, 1e-4)


func test_describes_itself() -> void:
	var source: BvhSource = BvhSource.new()
	source.open(FOLDER + CLIPS[0])
	contains(source.describe(), "01_01.bvh")
	contains(source.describe(), "120 Hz")
	equal(MotionSource.new().sample(5), null)


## A person who walks ahead for 2 s and swings an arm.
func _walk() -> BvhSource:
	var person: People.Person = People.Person.new()
	person.frames = []
	for i: int in 121:
		var swing: Quaternion = Quaternion(Vector3.RIGHT, sin(i * 0.1))
		var place: Vector3 = Vector3(0.0, 100.0, i * 2.0)
		person.frames.append({"root": place, "LeftUpperArm": swing})
	var source: BvhSource = BvhSource.new()
	source.use(People.make(person))
	equal(source.error, "")
	return source


## Plays a source from its start; tells the first fault and the largest changes of a sample, at any
## time and where a round passes into the next.
func _play_two_rounds(p_source: BvhSource) -> Dictionary:
	var before: PoseSample = null
	var stats: Dictionary = {"fault": "", "any_deg": 0.0, "seam_deg": 0.0, "any_m": 0.0}
	var round_s: float = p_source.rig.clip.duration() - BvhSource.BLEND_S
	for step: int in int(round_s * 2.2 * 60.0):
		var sample: PoseSample = p_source.sample(BEGIN_USEC + step * STEP_USEC)
		if stats["fault"] == "":
			stats["fault"] = sample.find_fault()
		if before != null:
			stats["any_m"] = maxf(stats["any_m"], sample.root.distance_to(before.root))
			var seam: bool = step < 3 or fposmod(step / 60.0 + 0.1, round_s) < 0.7
			for limb: int in Limbs.COUNT:
				var turn: float = sample.orientation(limb).angle_to(before.orientation(limb))
				stats["any_deg"] = maxf(stats["any_deg"], rad_to_deg(turn))
				if seam:
					stats["seam_deg"] = maxf(stats["seam_deg"], rad_to_deg(turn))
		before = sample
	return stats
