extends TestCase
## One body of several sources: limbs, times, headings, and sources that fall silent.

const BEGIN: int = 1_700_000_000_000_000


## A person who turns and swings, sampled at a rate, late by a while, with another north.
class Swinging:
	extends MotionSource
	var period_usec: int = 10000
	var late_usec: int = 0
	var north: float = 0.0
	var bend: float = 0.0
	var bent: int = Limbs.LEFT_FOOT
	var is_silent: bool = false
	var measured: PackedByteArray = PackedByteArray()
	var _poses: LivePoses = LivePoses.new()
	var _next_usec: int = BEGIN

	static func turn_at(p_usec: int, p_north: float, p_bend: float) -> Quaternion:
		var time_s: float = (p_usec - BEGIN) / 1e6
		var swing: Quaternion = Quaternion(Vector3.RIGHT, 0.5 * sin(3.0 * time_s) + p_bend)
		return Rotations.yaw(0.3 * time_s + p_north) * swing

	func _read(p_time_usec: int) -> PoseSample:
		while not is_silent and _next_usec + late_usec <= p_time_usec:
			var pose: PoseSample = PoseSample.new()
			pose.time_usec = _next_usec
			for limb: int in Limbs.COUNT:
				var own: float = bend if limb == bent else 0.0
				pose.set_orientation(limb, turn_at(_next_usec, north, own))
			pose.root = Vector3(north, 1.0, 0.0)
			pose.details = MotionDetails.new()
			pose.details.measured = measured
			pose.details.joints[XRBodyTracker.JOINT_LEFT_TOES] = turn_at(_next_usec, north, bend)
			_poses.push(pose)
			_next_usec += period_usec
		return _poses.at(p_time_usec)


func test_feet_of_another_source_with_another_north_and_rate() -> void:
	var suit: Swinging = Swinging.new()
	var feet: Swinging = Swinging.new()
	feet.north = 1.2
	feet.bend = 0.4
	feet.period_usec = 4167
	feet.late_usec = 12000
	var fusion: LimbFusion = LimbFusion.new(suit)
	fusion.set_source(2, feet)
	fusion.choose(LimbFusion.Group.FEET, 2)
	var worst: float = 0.0
	var count: int = 0
	for step: int in 200:
		var pose: PoseSample = fusion.sample(BEGIN + 50000 + step * 16667)
		if pose == null:
			continue
		count += 1
		equal(pose.find_fault(), "")
		if count < 4:
			# The other source has just come.
			continue
		var truth: Quaternion = Swinging.turn_at(pose.time_usec, 0.0, 0.0)
		var foot: Quaternion = Swinging.turn_at(pose.time_usec, 0.0, 0.4)
		worst = maxf(worst, Rotations.between_deg(pose.orientation(Limbs.CHEST), truth))
		worst = maxf(worst, Rotations.between_deg(pose.orientation(Limbs.LEFT_FOOT), foot))
		worst = maxf(worst, Rotations.between_deg(pose.orientation(Limbs.RIGHT_FOOT), truth))
		var toes: Quaternion = pose.details.joints[XRBodyTracker.JOINT_LEFT_TOES]
		worst = maxf(worst, Rotations.between_deg(toes, foot))
	is_true(count > 190, "%d poses" % count)
	is_true(worst < 0.1, "%f deg" % worst)
	almost_equal(fusion.heading_of(2), -1.2, 0.002)


func test_a_source_without_a_trunk_is_taken_as_it_is() -> void:
	var suit: Swinging = Swinging.new()
	var head: Swinging = Swinging.new()
	head.north = 0.2
	head.measured.resize(Limbs.COUNT)
	head.measured[Limbs.LEFT_FOOT] = 1
	var fusion: LimbFusion = LimbFusion.new(suit)
	fusion.set_source(2, head)
	fusion.choose(LimbFusion.Group.FEET, 2)
	var pose: PoseSample = null
	for step: int in 30:
		var next: PoseSample = fusion.sample(BEGIN + 50000 + step * 16667)
		pose = next if next != null else pose
	var truth: Quaternion = Swinging.turn_at(pose.time_usec, 0.2, 0.0)
	almost_equal(pose.orientation(Limbs.RIGHT_FOOT), truth, 1e-3)
	equal(pose.details.measured[Limbs.RIGHT_FOOT], 0)
	equal(pose.details.measured[Limbs.LEFT_FOOT], 1)


func test_a_silent_source_is_left_out_until_it_comes_again() -> void:
	var suit: Swinging = Swinging.new()
	var other: Swinging = Swinging.new()
	other.bend = 0.5
	other.bent = Limbs.HEAD
	var fusion: LimbFusion = LimbFusion.new(suit)
	fusion.set_source(2, other)
	fusion.choose(LimbFusion.Group.HEAD, 2)
	var bends: PackedFloat32Array = []
	for step: int in 300:
		other.is_silent = step >= 60 and step < 180
		var pose: PoseSample = fusion.sample(BEGIN + 50000 + step * 16667)
		var bend: float = NAN
		if pose != null:
			bend = Rotations.between(pose.orientation(Limbs.HEAD), pose.orientation(Limbs.CHEST))
		bends.append(bend)
	almost_equal(bends[50], 0.5, 0.01)
	almost_equal(bends[120], 0.0, 0.01)
	almost_equal(bends[290], 0.5, 0.01)
	var gaps: int = 0
	for bend: float in bends.slice(5):
		gaps += 1 if is_nan(bend) else 0
	is_true(gaps < 25, "%d samples were left out" % gaps)


func test_the_root_of_a_source_that_knows_where_it_is() -> void:
	var suit: Swinging = Swinging.new()
	var cameras: Swinging = Swinging.new()
	cameras.north = 2.0
	var fusion: LimbFusion = LimbFusion.new(suit)
	fusion.set_source(3, cameras)
	fusion.choose(LimbFusion.Group.ROOT, 3)
	var pose: PoseSample = null
	for step: int in 30:
		var next: PoseSample = fusion.sample(BEGIN + 50000 + step * 16667)
		pose = next if next != null else pose
	almost_equal(pose.root, Rotations.yaw(-2.0) * Vector3(2.0, 1.0, 0.0), 0.01)


func test_choices_are_read_and_told() -> void:
	var choices: Dictionary[LimbFusion.Group, int] = {}
	equal(LimbFusion.parse("feet:2,head:3", choices), "")
	equal(
		choices,
		{LimbFusion.Group.FEET: 2, LimbFusion.Group.HEAD: 3} as Dictionary[LimbFusion.Group, int]
	)
	for text: String in ["tail:1", "feet", "feet:0", "feet:x", "feet:2:3", "feet:-1"]:
		contains(LimbFusion.parse(text, choices), "fingers")
